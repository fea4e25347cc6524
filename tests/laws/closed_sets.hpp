// SPDX-License-Identifier: MIT
#pragma once
// Sets of bodies that nobody holds, flying together along x: what jams, and what touches.

#include <gtest/gtest.h>

#include "law_worlds.hpp"

namespace batuta::test {

/// A fork round a rod, with `room` between them.
template <class SceneT>
void add_fork(World<SceneT>& world, double room, double speed) {
  using S = typename SceneT::Scalar;
  const double side = 0.03 + room / 2 + 0.005;
  const auto capsule = [](const Vector& a, const Vector& b, double r) {
    return CapsulePart<S>{{{a.cast<S>(), b.cast<S>()}, static_cast<S>(r)}, S(1000)};
  };
  const CapsulePart<S> fork[] = {capsule({-side, 0, 0}, {-side, 0, 0.3}, 0.005),
                                 capsule({side, 0, 0}, {side, 0, 0.3}, 0.005),
                                 capsule({-0.03, 0, 0}, {0.03, 0, 0}, 0.005)};
  const CapsulePart<S> rod[] = {capsule({0, -0.3, 0.15}, {0, 0.3, 0.15}, 0.03)};
  const auto add = [&world](const auto& compound, const Vector& v, const Vector& w) {
    Actor<SceneT> actor;
    actor.body = compound.body;
    for (const auto& part : compound.capsules_B) (void)actor.capsules_B.push(part);
    actor.restitution = S(0.5);
    throw_body(actor, v, w);
    ASSERT_TRUE(world.add(actor).ok());
  };
  add(make_compound<3>(&fork[0], 3, Pose<S>{}).value, {speed + 0.01, 0.003, 0}, {0, 0, 0.3});
  add(make_compound<3>(&rod[0], 1, Pose<S>{}).value, {speed - 0.02, 0.002, 0.01}, {0, 0, 0});
}

/// Twelve rods crosswise on each other, or balls, that touch.
/// @param noise  of their velocities across, m/s
template <class SceneT>
void add_cluster(World<SceneT>& world, bool are_balls, double noise, double speed) {
  using S = typename SceneT::Scalar;
  for (int i = 0; i < 12; ++i) {
    const Vector place(0, 0, ((are_balls ? 0.1 : 0.04) + 1e-4) * i);
    auto body = are_balls ? solid_ball<SceneT>(0.05, place)
                          : solid_rod<SceneT>(0.5, 0.02, place, i % 2 == 0 ? along_x() : along_y());
    body.restitution = S(0.3);
    if constexpr (SceneT::kFriction) body.friction = S(0.5);
    throw_body(body, {speed, noise * ((i * 7) % 5 - 2), noise * ((i * 3) % 7 - 3)});
    ASSERT_TRUE(world.add(body).ok());
  }
}

}  // namespace batuta::test
