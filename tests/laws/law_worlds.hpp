// SPDX-License-Identifier: MIT
#pragma once
// Worlds in which the laws of motion are looked at: scenes by resting rule and scalar, bodies, and
// what is summed over them. All sums in double, from poses and momenta alone.

#include <memory>
#include <utility>

#include "batuta/mechanics/compound.hpp"
#include "batuta/mechanics/solid.hpp"
#include "batuta/world/scenes.hpp"
#include "batuta/world/world.hpp"

namespace batuta::test {

/// What a law's scene has besides its resting rule.
struct LawFeatures {
  bool gravity = false;
  bool sleep = false;
  bool rolling = false;
  int parts = 1;
  int bodies = 80;
};
inline constexpr LawFeatures kFloating = {};
inline constexpr LawFeatures kFalling = {true};
inline constexpr LawFeatures kSleeping = {true, true};
inline constexpr LawFeatures kRolling = {true, true, true};
inline constexpr LawFeatures kRollingAwake = {true, false, true};
inline constexpr LawFeatures kSleepingParts = {true, true, false, 3};
inline constexpr LawFeatures kHeaps = {true, false, true, 3};
inline constexpr LawFeatures kCompound = {false, false, false, 3, 4};
inline constexpr LawFeatures kFallingCompound = {true, false, false, 3, 4};

template <RestingContact kRests, const LawFeatures& kFeatures>
constexpr SceneOptions law_options() {
  SceneOptions scene;
  const bool settles = kRests == RestingContact::kSettling;
  scene.max_bodies = kFeatures.bodies;
  scene.capsules_per_body = kFeatures.parts;
  scene.max_pairs = kFeatures.bodies == 80 ? 700 : 60;
  scene.max_contacts = kFeatures.bodies == 80 ? 512 : 64;
  scene.max_events = 1024;
  scene.resting = kRests;
  scene.friction = scene.line_contact = settles;
  scene.gravity = kFeatures.gravity;
  scene.sleep = kFeatures.sleep;
  scene.rolling_resistance = kFeatures.rolling;
  return scene;
}
/// A scene in which a law is looked at.
template <class S, RestingContact kRests, const LawFeatures& kFeatures>
using LawScene = Scene<law_options<kRests, kFeatures>, Advancement<S>>;
template <class S, const LawFeatures& kFeatures>
using Settling = LawScene<S, RestingContact::kSettling, kFeatures>;

using Vector = Vec3<double>;
using Rotation = Quat<double>;

inline Rotation about(const Vector& axis, double angle) {
  const double half = angle / 2;
  const Vector v = std::sin(half) * axis;
  return {std::cos(half), v.x(), v.y(), v.z()};
}
/// From the z axis, along which a rod is made, to the x axis.
inline Rotation along_x() {
  return about(Vector::UnitY(), std::acos(-1.0) / 2);
}
/// From the z axis to the y axis.
inline Rotation along_y() {
  return about(Vector::UnitX(), -std::acos(-1.0) / 2);
}

/// A solid rod along its z axis; length 0: a ball.
template <class SceneT>
Actor<SceneT> solid_rod(double length, double radius, const Vector& place,
                        const Rotation& q_WB = Rotation::Identity(), double density = 1000) {
  using S = typename SceneT::Scalar;
  const Vector end(0, 0, length / 2);
  const Capsule<double> shape = {{-end, end}, radius};
  const auto mass = solid_capsule(shape, density).value;
  Actor<SceneT> actor;
  const Vec3<S> moments = mass.inertia_S.diagonal().template cast<S>();
  actor.body =
      make_body<S>({place.cast<S>(), q_WB.cast<S>()}, static_cast<S>(mass.mass), moments).value;
  const Capsule<S> own = {{shape.axis.a.cast<S>(), shape.axis.b.cast<S>()}, static_cast<S>(radius)};
  if constexpr (SceneT::kCapsulesPerBody == 1) {
    actor.capsule_B = own;
  } else {
    (void)actor.capsules_B.push(own);
  }
  return actor;
}
/// The same, nailed down.
template <class SceneT>
Actor<SceneT> fixed_rod(double length, double radius, const Vector& place,
                        const Rotation& q_WB = Rotation::Identity()) {
  auto actor = solid_rod<SceneT>(length, radius, place, q_WB);
  actor.body.inverse_mass = 0;
  actor.body.inverse_moments.setZero();
  return actor;
}
template <class SceneT>
Actor<SceneT> solid_ball(double radius, const Vector& place) {
  return solid_rod<SceneT>(0, radius, place);
}
/// Gives a body a velocity and a spin.
template <class SceneT>
void throw_body(Actor<SceneT>& actor, const Vector& v_W, const Vector& w_W = Vector::Zero()) {
  using S = typename SceneT::Scalar;
  actor.body.momentum = momentum_of(actor.body, Twist<S>{v_W.cast<S>(), w_W.cast<S>()});
}

/// What the search cannot tell from contact, twice, between bars whose lengths and distance come to
/// `scale`; and what places `far` from the origin are rounded by (src/world/detail/margin.md), m.
template <class S>
double margin_of(double scale, double far) {
  const double u = static_cast<double>(kRoundOff<S>);
  return 2 * (1e-6 + 72 * u) * scale + 2 * 64 * u * far;
}

/// Sums over all bodies that can be moved, in double.
struct Sums {
  double mass = 0;
  Vector place = Vector::Zero();     ///< of the common centre
  Vector momentum = Vector::Zero();  ///< N s
  Vector spin = Vector::Zero();      ///< angular momentum about the origin
  double kinetic = 0;                ///< J
  double spread = 0;                 ///< summed |p| |x| + |b|, N s m
  double pushes = 0;                 ///< summed |p|, N s
};
template <class SceneT>
Sums sums_of(const World<SceneT>& world) {
  Sums sums;
  for (int i = 0; i < SceneT::kMaxBodies; ++i) {
    const auto* actor = world.get(world.id_at(static_cast<std::uint16_t>(i)));
    if (actor == nullptr || !(actor->body.inverse_mass > 0)) continue;
    const auto& body = actor->body;
    const double mass = 1 / static_cast<double>(body.inverse_mass);
    const Vector p = body.momentum.linear_W.template cast<double>();
    const Vector b = body.momentum.angular_W.template cast<double>();
    const Vector x = body.X_WB.p_W.template cast<double>();
    Rotation q = body.X_WB.q_WB.template cast<double>();
    q.normalize();
    const Vector b_B = q.conjugate() * b;
    const Vector inverse = body.inverse_moments.template cast<double>();
    sums.mass += mass;
    sums.place += mass * x;
    sums.momentum += p;
    sums.spin += x.cross(p) + b;
    sums.kinetic += (p.squaredNorm() / mass + b_B.dot(inverse.cwiseProduct(b_B))) / 2;
    sums.spread += x.norm() * p.norm() + b.norm();
    sums.pushes += p.norm();
  }
  sums.place /= sums.mass;
  return sums;
}

/// A push of each body towards the common centre, over dt: pull * mass * distance, a central force.
/// @param pull  1/s^2  @returns the angular momentum about the origin that it gives, as rounded
template <class SceneT>
Vector pull_together(World<SceneT>& world, double pull, double dt) {
  Vector given = Vector::Zero();
  const Vector center = sums_of(std::as_const(world)).place;
  for (std::uint16_t i = 0; i < SceneT::kMaxBodies; ++i) {
    auto* actor = world.get(world.id_at(i));
    if (actor == nullptr || !(actor->body.inverse_mass > 0)) continue;
    auto& body = actor->body;
    const Vector x = body.X_WB.p_W.template cast<double>();
    const double push = pull * dt / static_cast<double>(body.inverse_mass);
    const Vector before = body.momentum.linear_W.template cast<double>();
    body.momentum.linear_W += (push * (center - x)).template cast<typename SceneT::Scalar>();
    given += x.cross(body.momentum.linear_W.template cast<double>() - before);
  }
  return given;
}

/// The smallest gap between any two bodies, m.
template <class SceneT>
double smallest_gap(const World<SceneT>& world) {
  double least = 1e9;
  for (int i = 0; i < SceneT::kMaxBodies; ++i) {
    const auto* A = world.get(world.id_at(static_cast<std::uint16_t>(i)));
    if (A == nullptr) continue;
    for (int k = i + 1; k < SceneT::kMaxBodies; ++k) {
      const auto* B = world.get(world.id_at(static_cast<std::uint16_t>(k)));
      if (B == nullptr || !(A->body.inverse_mass + B->body.inverse_mass > 0)) continue;
      for (int p = 0; p < parts_of(*A); ++p) {
        for (int q = 0; q < parts_of(*B); ++q) {
          const auto gap = capsule_gap(to_world(A->body.X_WB, part_of(*A, p)),
                                       to_world(B->body.X_WB, part_of(*B, q)));
          least = std::min(least, static_cast<double>(gap.gap));
        }
      }
    }
  }
  return least;
}

}  // namespace batuta::test

namespace batuta {

/// The steps of scenes that several files look at: most of what these files would compile, and
/// compiled once, in law_steps_*.cpp.
#define BATUTA_LAW_STEP(declared, S, ...) \
  declared template Status detail::GeneralWorld<test::LawScene<S, __VA_ARGS__>>::step(S);
#define BATUTA_STEPS_WITH_BLOWS(declared, S)                           \
  BATUTA_LAW_STEP(declared, S, RestingContact::kNone, test::kFloating) \
  BATUTA_LAW_STEP(declared, S, RestingContact::kNone, test::kFalling)  \
  BATUTA_LAW_STEP(declared, S, RestingContact::kSeparation, test::kFalling)
#define BATUTA_STEPS_THAT_SETTLE(declared, S)                              \
  BATUTA_LAW_STEP(declared, S, RestingContact::kSettling, test::kFloating) \
  BATUTA_LAW_STEP(declared, S, RestingContact::kSettling, test::kFalling)  \
  BATUTA_LAW_STEP(declared, S, RestingContact::kSettling, test::kSleeping) \
  BATUTA_LAW_STEP(declared, S, RestingContact::kSettling, test::kRolling)  \
  BATUTA_LAW_STEP(declared, S, RestingContact::kSettling, test::kHeaps)
BATUTA_STEPS_WITH_BLOWS(extern, float)
BATUTA_STEPS_WITH_BLOWS(extern, double)
BATUTA_STEPS_THAT_SETTLE(extern, float)
BATUTA_STEPS_THAT_SETTLE(extern, double)

}  // namespace batuta
