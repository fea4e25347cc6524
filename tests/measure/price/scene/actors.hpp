// SPDX-License-Identifier: MIT
#pragma once
// The bodies of runs.hpp as actors of a scene, whatever features it has.

#include "batuta/world/world.hpp"
#include "runs.hpp"

namespace batuta::price {

/// One capsule, its two halves, or a ball.
template <class SceneT>
void put_shape(Actor<SceneT>& actor, const Vec3<float>& half, float radius) {
  if constexpr (SceneT::Search::kForSpheres) {
    actor.radius = kBallRadius;
  } else if constexpr (SceneT::kCapsulesPerBody == 1) {
    actor.capsule_B = {{-half, half}, radius};
  } else {
    actor.capsules_B.push({{-half, Vec3<float>::Zero()}, radius});
    actor.capsules_B.push({{Vec3<float>::Zero(), half}, radius});
  }
}

/// Eight thick fixed logs side by side, and layers of eight bars on top, crosswise.
template <class SceneT>
void put_log(Actor<SceneT>& actor, int i) {
  constexpr float kHalfRight = 0.70710678F;
  const int row = i / 8;
  const float across = 0.1F * (static_cast<float>(i % 8) - 3.5F);
  const float height = 0.055F * static_cast<float>(row);
  if (row % 2 == 1) {
    actor.body.X_WB = {{0, across, height}, Quat<float>(kHalfRight, 0, kHalfRight, 0)};
  } else {
    actor.body.X_WB = {{across, 0, height}, Quat<float>(kHalfRight, -kHalfRight, 0, 0)};
  }
  if (row > 0) {
    actor.body.inverse_mass = 2;
    actor.body.inverse_moments = {30, 30, 3000};
  }
  put_shape(actor, {0, 0, kBladeHalf}, row == 0 ? 0.03F : 0.02F);
}

/// The i-th body of a scene: of two blades, of eight balls or of a rack.
template <class SceneT>
Actor<SceneT> actor_of(int i) {
  Actor<SceneT> actor;
  if constexpr (SceneT::kMaxBodies > kBalls) {
    put_log(actor, i);
  } else if constexpr (SceneT::kRotation) {
    actor.body = turning_blade(i, !SceneT::Search::kForStraightFlight);
    put_shape(actor, {0, 0, kBladeHalf}, kBladeRadius);
  } else {
    const Start& start = SceneT::kMaxBodies == kBalls ? ball_start(i) : blade_start(i);
    actor.body = straight_body(start);
    put_shape(actor, kBladeHalf * start.axis_W, kBladeRadius);
  }
  return actor;
}

/// What a scene knows of the surface.
template <class SceneT>
void put_surface(Actor<SceneT>& actor, float restitution) {
  if constexpr (SceneT::kRestitution) actor.restitution = restitution;
  if constexpr (SceneT::kFriction) actor.friction = 0.3F;
}

template <class SceneT>
std::uint32_t contacts_of(const World<SceneT>& world) {
  if constexpr (SceneT::kMaxEvents > 0) {
    return static_cast<std::uint32_t>(world.events().size());
  } else {
    return world.report().collisions + world.report().separations;
  }
}

}  // namespace batuta::price
