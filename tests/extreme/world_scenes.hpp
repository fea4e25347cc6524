// SPDX-License-Identifier: MIT
#pragma once
// Scenes of every kind of world, and bodies for them.

#include "batuta/record/world.hpp"
#include "batuta/world/scenes.hpp"
#include "batuta/world/world.hpp"
#include "hostile.hpp"

namespace batuta::test {

/// Everything that turning bodies can have.
constexpr SceneOptions rich_options() {
  SceneOptions scene;
  scene.max_bodies = 4;
  scene.max_pairs = 6;
  scene.max_contacts = 16;
  scene.max_events = 32;
  scene.friction = true;
  scene.gravity = true;
  scene.line_contact = true;
  scene.resting = RestingContact::kSettling;
  return scene;
}
template <class S>
using Rich = Scene<rich_options, Advancement<S>>;
/// The paper's own: separations, no friction, its search.
constexpr SceneOptions paper_options() {
  SceneOptions scene;
  scene.max_bodies = 4;
  scene.max_pairs = 6;
  return scene;
}
template <class S>
using Paper = Scene<paper_options, Stepping<S>>;
/// Nothing turns, few bodies: the small world.
constexpr SceneOptions balls_options() {
  SceneOptions scene = straight_spheres();
  scene.gravity = true;
  return scene;
}
template <class S>
using Balls = Scene<balls_options, Spheres<S>>;
/// Nothing turns, with events: the general world.
constexpr SceneOptions straight_options() {
  SceneOptions scene;
  scene.max_bodies = 4;
  scene.max_pairs = 6;
  scene.rotation = false;
  scene.gravity = true;
  scene.resting = RestingContact::kNone;
  return scene;
}
template <class S>
using Straight = Scene<straight_options, Translation<S>>;
static_assert(Balls<float>::kEngine == Engine::kSmall &&
              Straight<float>::kEngine == Engine::kGeneral);

using Worlds = testing::Types<Rich<float>, Paper<double>, Balls<float>, Straight<float>>;

/// A body of 1 kg and 1/8 m on the x axis that flies along it; with an axis along z where the
/// scene has capsules.
/// @param size  all lengths and velocities are multiples of it
template <class SceneT>
Actor<SceneT> flyer(double x, double v, double size = 1) {
  using S = typename SceneT::Scalar;
  Actor<SceneT> actor;
  const Vec3<S> place(static_cast<S>(x * size), 0, 0);
  const Vec3<S> momentum(static_cast<S>(v * size), 0, 0);
  const S radius = static_cast<S>(size / 8);
  if constexpr (SceneT::kRotation) {
    const S moment = radius * radius / 4;
    actor.body.X_WB.p_W = place;
    actor.body.inverse_mass = 1;
    actor.body.inverse_moments = {1 / moment, 1 / moment, 2 / moment};
    actor.body.momentum.linear_W = momentum;
    actor.body.momentum.angular_W = {0, moment, moment};
  } else {
    actor.body.p_W = place;
    actor.body.inverse_mass = 1;
    actor.body.momentum_W = momentum;
  }
  if constexpr (SceneT::Search::kForSpheres) {
    actor.radius = radius;
  } else {
    actor.capsule_B = {{{0, 0, -2 * radius}, {0, 0, 2 * radius}}, radius};
  }
  if constexpr (SceneT::kRestitution) actor.restitution = S(0.5);
  if constexpr (SceneT::kFriction) actor.friction = S(0.5);
  return actor;
}

template <class SceneT>
Vec3<typename SceneT::Scalar>& own_place_of(Actor<SceneT>& actor) {
  if constexpr (SceneT::kRotation) {
    return actor.body.X_WB.p_W;
  } else {
    return actor.body.p_W;
  }
}

/// Whether all that a body can be moved by is finite.
template <class SceneT>
bool is_sound(const Actor<SceneT>& actor) {
  const auto& body = actor.body;
  if constexpr (SceneT::kRotation) {
    return is_finite(body.X_WB.p_W) && is_finite(body.X_WB.q_WB) &&
           is_finite(body.momentum.linear_W) && is_finite(body.momentum.angular_W);
  } else {
    return is_finite(body.p_W) && is_finite(body.momentum_W);
  }
}

/// Scalars of a body; what is behind them is no scalar.
template <class SceneT>
constexpr std::size_t kBodyScalars = SceneT::kRotation ? 17 : 7;

/// Calls judge(actor, is_number) with each hostile number in each scalar of body and shape.
template <class SceneT, class Judge>
void for_each_spoiled_actor(const Actor<SceneT>& good, const Judge& judge) {
  using S = typename SceneT::Scalar;
  for (std::size_t place = 0; place < kBodyScalars<SceneT>; ++place) {
    for (const S number : kHostile<S>) {
      Actor<SceneT> spoiled = good;
      put(spoiled.body, place, number);
      SCOPED_TRACE(testing::Message() << "body " << place << " number " << number);
      judge(spoiled, is_finite(number));
    }
  }
  if constexpr (!SceneT::Search::kForSpheres) {
    for_each_spoiled<S>(good.capsule_B, 0, [&](const Capsule<S>& shape, bool is_number) {
      Actor<SceneT> spoiled = good;
      spoiled.capsule_B = shape;
      judge(spoiled, is_number);
    });
  } else {
    for (const S number : kHostile<S>) {
      Actor<SceneT> spoiled = good;
      spoiled.radius = number;
      judge(spoiled, is_finite(number));
    }
  }
}

}  // namespace batuta::test
