// SPDX-License-Identifier: MIT
#pragma once
// Worlds drawn from bytes, and what they weigh in double. Every number is drawn on a grid, so that
// bodies stand in rows, touch, overlap and meet head on; a scene is drawn in any units whose ratios
// are powers of two, in which all of it is the same to the last bit that does not vanish.

#include <algorithm>

#include "batuta/world/scenes.hpp"
#include "bytes.hpp"
#include "oracle.hpp"

namespace batuta::fuzz {

/// Factors from the units that the bytes speak of to those of a world: powers of two.
struct Units {
  float length = 1;
  float time = 1;
  float mass = 1;

  float speed() const { return length / time; }
};

/// Rods that fly, rub, lie along each other and are filtered; nothing pulls them.
constexpr SceneOptions rods_options() {
  SceneOptions scene;
  scene.max_bodies = 4;
  scene.max_pairs = 6;
  scene.max_contacts = 24;
  scene.friction = true;
  scene.line_contact = true;
  scene.filters = true;
  scene.resting = RestingContact::kSettling;
  return scene;
}
using Rods = Scene<rods_options>;

/// Bodies of two capsules that fall on each other and go to sleep, with too little room for all.
constexpr SceneOptions heap_options() {
  SceneOptions scene;
  scene.max_bodies = 4;
  scene.capsules_per_body = 2;
  scene.max_pairs = 10;
  scene.max_events = 8;
  scene.sleep_time = 0.01F;
  scene.friction = true;
  scene.gravity = true;
  scene.sleep = true;
  scene.resting = RestingContact::kSettling;
  return scene;
}
using Heap = Scene<heap_options>;

/// A general world in which nothing turns.
constexpr SceneOptions sliders_options() {
  SceneOptions scene;
  scene.max_bodies = 3;
  scene.max_pairs = 3;
  scene.rotation = false;
  scene.resting = RestingContact::kNone;
  return scene;
}
using Sliders = Scene<sliders_options, Translation<float>>;

/// A capsule along z, so that its body is one of revolution about it.
inline Capsule<float> draw_shape(Bytes& bytes, const Units& units) {
  const float half = bytes.share() * units.length;
  const float radius = bytes.share() * 0.25F * units.length;
  return {{{0, 0, -half}, {0, 0, half}}, radius};
}

template <class SceneT>
void draw_body(Bytes& bytes, const Units& units, Actor<SceneT>& actor) {
  const float spread = std::ldexp(units.length, -bytes.choice(6));
  const Vec3<float> place = spread * bytes.vector(Numbers::kGrid);
  const Quat<float> turn = bytes.turn();
  const float mass = std::ldexp(units.mass, bytes.choice(21) - 10);
  const float speed = std::ldexp(units.speed(), bytes.choice(8));
  const Vec3<float> velocity = speed * bytes.vector(Numbers::kGrid);
  const bool is_fixed = bytes.choice(4) == 3;
  if constexpr (SceneT::kRotation) {
    const float across = mass * units.length * units.length * (0.01F + bytes.share());
    const float along = across * (0.01F + bytes.share());
    const auto made = make_body<float>({place, turn}, mass, {across, across, along});
    require(made.ok(), "ordinary bodies can be made");
    actor.body = made.value;
    actor.body.momentum.linear_W = mass * velocity;
    actor.body.momentum.angular_W = (across / units.time) * bytes.vector(Numbers::kGrid);
    if (!is_fixed) return;
    actor.body.inverse_mass = 0;
    actor.body.inverse_moments.setZero();
  } else {
    actor.body = make_straight_body<float>(place, mass).value;
    actor.body.momentum_W = mass * velocity;
    if (is_fixed) actor.body.inverse_mass = 0;
  }
}

template <class SceneT>
Actor<SceneT> draw_actor(Bytes& bytes, const Units& units) {
  Actor<SceneT> actor;
  const Capsule<float> shape = draw_shape(bytes, units);
  if constexpr (SceneT::Search::kForSpheres) {
    actor.radius = shape.radius;
  } else if constexpr (SceneT::kCapsulesPerBody == 1) {
    actor.capsule_B = shape;
  } else {
    (void)actor.capsules_B.push(shape);
    if (bytes.flag()) (void)actor.capsules_B.push(draw_shape(bytes, units));
  }
  draw_body<SceneT>(bytes, units, actor);
  if constexpr (SceneT::kRestitution) actor.restitution = bytes.share();
  if constexpr (SceneT::kFriction) actor.friction = 4 * bytes.share();
  if constexpr (SceneT::kOwners) actor.owner = static_cast<std::uint16_t>(bytes.choice(8) / 6);
  if constexpr (SceneT::kFilters)
    actor.filter = {1, bytes.choice(8) == 7 ? std::uint16_t{2} : std::uint16_t{0xFFFF}};
  return actor;
}

/// The scene's default settings in other units.
template <class SceneT>
WorldSettings<SceneT> settings_in(const Units& units) {
  WorldSettings<SceneT> settings;
  if constexpr (detail::kKnowsRest<SceneT>) {
    settings.rest_speed *= units.speed();
    settings.separation *= units.length;
    settings.min_separation_time *= units.time;
  }
  if constexpr (SceneT::kGravity) settings.gravity_W *= units.speed() / units.time;
  return settings;
}

/// What a world's bodies that can move carry together, in double.
struct Load {
  Real3 momentum = Real3::Zero();
  Real3 angular = Real3::Zero();  ///< about the origin
  double largest = 0;             ///< |p| of one body
  double turning = 0;             ///< |b| of one body
  double arm = 0;                 ///< from the origin to the furthest surface
  double softest = 0;             ///< the largest inverse mass
  int fixed = 0;                  ///< bodies that momentum does not move
  bool lossless = true;           ///< all bounce back, nobody rubs
  double energy = 0;
  double soft = 0;       ///< the energy if each turned about its softest axis
  double sharpness = 1;  ///< how much a rounding of a lever counts: 1 + 2 |r| sqrt(m / J)

  /// Nobody is faster without more energy.
  double fastest() const { return std::sqrt(2 * energy * softest); }
};

inline void add_linear(Load& load, const Vec3<float>& momentum, float inverse_mass) {
  if (!(inverse_mass > 0)) return;
  const Real3 p = momentum.cast<double>();
  load.momentum += p;
  load.largest = std::max(load.largest, p.norm());
  const double energy = 0.5 * static_cast<double>(inverse_mass) * p.squaredNorm();
  load.energy += energy;
  load.soft += energy;
}

inline void add_body(Load& load, const StraightBody<float>& body, double /*reach*/) {
  add_linear(load, body.momentum_W, body.inverse_mass);
  if (!(body.inverse_mass > 0)) ++load.fixed;
}

inline void add_body(Load& load, const Body<float>& body, double reach) {
  add_linear(load, body.momentum.linear_W, body.inverse_mass);
  const Real3 b = body.momentum.angular_W.cast<double>();
  const Real3 inverse = body.inverse_moments.cast<double>();
  const Eigen::Quaterniond q = body.X_WB.q_WB.cast<double>().normalized();
  load.energy += 0.5 * inverse.dot((q.conjugate() * b).cwiseAbs2());
  load.soft += 0.5 * inverse.maxCoeff() * b.squaredNorm();
  const Real3 c = body.X_WB.p_W.cast<double>();
  load.angular += c.cross(body.momentum.linear_W.cast<double>()) + b;
  load.turning = std::max(load.turning, b.norm());
  load.arm = std::max(load.arm, c.norm() + reach);
  load.softest = std::max(load.softest, static_cast<double>(body.inverse_mass));
  if (!(body.inverse_mass > 0)) {
    ++load.fixed;
    return;
  }
  const double ratio = inverse.maxCoeff() / static_cast<double>(body.inverse_mass);
  load.sharpness = std::max(load.sharpness, 1 + 2 * reach * std::sqrt(ratio));
}

/// The furthest that a surface is from its body's point.
template <class SceneT>
double bounding_radius_of(const Actor<SceneT>& actor) {
  double reach = 0;
  if constexpr (SceneT::Search::kForSpheres) {
    reach = static_cast<double>(actor.radius);
  } else {
    for (int i = 0; i < parts_of(actor); ++i) {
      const Capsule<float>& part = part_of(actor, i);
      const float end = max_of(part.axis.a.norm(), part.axis.b.norm());
      reach = std::max(reach, static_cast<double>(end) + static_cast<double>(part.radius));
    }
  }
  return reach;
}

/// It bounces back as fast as it came, and does not rub.
template <class SceneT>
bool is_lossless(const Actor<SceneT>& actor) {
  bool rubs = false;
  bool bounces = false;
  if constexpr (SceneT::kFriction) rubs = actor.friction != 0;
  if constexpr (SceneT::kRestitution) bounces = actor.restitution == 1;
  return bounces && !rubs;
}

template <class SceneT>
Load load_of(const World<SceneT>& world) {
  Load load;
  for (std::uint16_t slot = 0; slot < SceneT::kMaxBodies; ++slot) {
    const Actor<SceneT>* const actor = world.get(world.id_at(slot));
    if (actor == nullptr) continue;
    add_body(load, actor->body, bounding_radius_of(*actor));
    load.lossless = load.lossless && is_lossless(*actor);
  }
  return load;
}

}  // namespace batuta::fuzz
