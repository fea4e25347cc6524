// SPDX-License-Identifier: MIT
// Where contacts last: a body that is struck by two others in one step, as far apart as it flies in
// a part of that step. Each blow is at its own time and place, with its restitution.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "batuta/world/make_actor.hpp"
#include "batuta/world/scenes.hpp"
#include "batuta/world/world.hpp"

namespace batuta {
namespace {

constexpr SceneOptions flying_options() {
  SceneOptions scene;
  scene.max_bodies = 3;
  scene.max_pairs = 3;
  scene.max_contacts = 16;
  scene.max_events = 16;
  scene.resting = RestingContact::kSettling;
  return scene;
}
using Flying = Scene<flying_options>;

constexpr float kRadius = 0.1F;

template <class SceneT>
Handle<Actor<SceneT>> add_ball(World<SceneT>& world, float y, float density, float v_y) {
  const Capsule<float> ball = {{{0, 0, 0}, {0, 0, 0}}, kRadius};
  auto actor = make_actor<SceneT>(ball, density, {{0, y, 0}, Quat<float>::Identity()},
                                  {{0, v_y, 0}, {0, 0, 0}});
  actor.value.restitution = 1;
  return world.add(actor.value).value;
}

void add_bar(World<Flying>& world, float y) {
  const Capsule<float> bar = {{{-1, y, 0}, {1, y, 0}}, kRadius};
  const auto actor = make_actor<Flying>(bar, std::numeric_limits<float>::infinity(), {});
  ASSERT_TRUE(world.add(actor.value).ok());
}

class BetweenBars : public ::testing::TestWithParam<float> {};

/// 0.1 m of free way, to and fro: the way, unfolded, is a straight line.
TEST_P(BetweenBars, ElasticBall_GoesToAndFro) {
  constexpr double kSpeed = 10;
  constexpr double kWay = 0.1;
  constexpr double kStart = 0.05;
  World<Flying> world;
  add_bar(world, -kRadius);
  add_bar(world, 3 * kRadius + static_cast<float>(kWay));
  const auto ball =
      add_ball(world, kRadius + static_cast<float>(kStart), 1000, -static_cast<float>(kSpeed));
  const float dt = GetParam();
  const int steps = static_cast<int>(0.5F / dt);
  for (int i = 1; i <= steps; ++i) {
    ASSERT_EQ(world.step(dt), Status::kOk);
    EXPECT_TRUE(world.report().complete());
    const auto& body = std::as_const(world).get(ball)->body;
    EXPECT_NEAR(std::abs(body.momentum.linear_W.y() * body.inverse_mass), kSpeed, 1e-3);
    const double unfolded = std::remainder(kStart - kSpeed * static_cast<double>(dt) * i, 2 * kWay);
    // Up to 50 blows, each where a gap of 0.1 mm at most is left.
    EXPECT_NEAR(body.X_WB.p_W.y() - kRadius, std::abs(unfolded), 50e-4) << i;
  }
}
INSTANTIATE_TEST_SUITE_P(Steps, BetweenBars, ::testing::Values(1e-3F, 1.0F / 60, 1.0F / 30));

constexpr SceneOptions falling_options() {
  SceneOptions scene = flying_options();
  scene.gravity = true;
  return scene;
}
using Falling = Scene<falling_options>;

/// Less than four times the speed of rest: too slow for a neighbour to be struck in turn. It meets
/// the first post after 1.3 ms, the second one after 8 ms, and the first one again after 14.7 ms.
TEST(BetweenPosts, SlowElasticBall_GoesToAndFroAsItFalls) {
  constexpr float kDt = 1.0F / 60;
  constexpr float kSpeed = 0.6F;
  constexpr float kWay = 4e-3F;
  constexpr float kStart = 0.8e-3F;
  World<Falling> world;
  for (const float y : {-kRadius, 3 * kRadius + kWay}) {
    const Capsule<float> post = {{{0, y, -9}, {0, y, 9}}, kRadius};
    const auto actor = make_actor<Falling>(post, std::numeric_limits<float>::infinity(), {});
    ASSERT_TRUE(world.add(actor.value).ok());
  }
  const auto ball = add_ball(world, kRadius + kStart, 1000, -kSpeed);
  ASSERT_EQ(world.step(kDt), Status::kOk);
  EXPECT_TRUE(world.report().complete());
  EXPECT_EQ(world.report().collisions, 3U);
  const auto& body = std::as_const(world).get(ball)->body;
  EXPECT_NEAR(body.momentum.linear_W.y() * body.inverse_mass, kSpeed, 1e-3F);
  EXPECT_NEAR(body.X_WB.p_W.y() - kRadius, kSpeed * kDt - kStart - 2 * kWay, 3e-4F);
  const float fall = world.settings().gravity_W.z() * kDt;
  EXPECT_NEAR(body.momentum.linear_W.z() * body.inverse_mass, fall, 1e-4F);
}

/// Balls on a line, in double: from blow to blow.
struct OnALine {
  std::array<double, 3> y;
  std::array<double, 3> v;
  std::array<double, 3> mass;

  double until_blow(std::size_t i) const {
    const double gap = y[i + 1] - y[i] - 2 * static_cast<double>(kRadius);
    const double closing = v[i] - v[i + 1];
    return closing > 0 ? gap / closing : std::numeric_limits<double>::infinity();
  }
  void go_on(double time) {
    while (time > 0) {
      const std::size_t next = until_blow(0) < until_blow(1) ? 0 : 1;
      const double span = std::min(time, until_blow(next));
      for (std::size_t i = 0; i < 3; ++i) y[i] += v[i] * span;
      time -= span;
      if (time > 0) strike(next);
    }
  }
  void strike(std::size_t i) {
    const double common = (mass[i] * v[i] + mass[i + 1] * v[i + 1]) / (mass[i] + mass[i + 1]);
    v[i] = 2 * common - v[i];
    v[i + 1] = 2 * common - v[i + 1];
  }
};

TEST(BetweenFreeBalls, LightBallInARack_KeepsEnergyAndMomentum) {
  constexpr float kDt = 1.0F / 60;
  constexpr float kSpeed = 6;
  static World<Rack> world;
  auto settings = world.settings();
  settings.gravity_W.setZero();
  ASSERT_EQ(world.configure(settings), Status::kOk);
  const std::array<float, 3> y = {0, 0.22F, 0.46F};
  const std::array<float, 3> density = {1e5F, 100, 1e5F};
  std::array<Handle<Actor<Rack>>, 3> balls;
  OnALine truth = {};
  for (std::size_t i = 0; i < 3; ++i) {
    balls[i] = add_ball(world, y[i], density[i], i == 1 ? -kSpeed : 0.0F);
    truth.y[i] = static_cast<double>(y[i]);
    truth.mass[i] = static_cast<double>(density[i]);
  }
  truth.v[1] = -static_cast<double>(kSpeed);
  for (int step = 0; step < 4; ++step) {
    ASSERT_EQ(world.step(kDt), Status::kOk);
    EXPECT_TRUE(world.report().complete());
    truth.go_on(static_cast<double>(kDt));
    for (std::size_t i = 0; i < 3; ++i) {
      const auto& body = std::as_const(world).get(balls[i])->body;
      EXPECT_NEAR(body.momentum.linear_W.y() * body.inverse_mass, truth.v[i], 1e-3) << step << i;
      EXPECT_NEAR(body.X_WB.p_W.y(), truth.y[i], 1e-3) << step << i;
    }
  }
}

}  // namespace
}  // namespace batuta
