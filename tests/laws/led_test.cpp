// SPDX-License-Identifier: MIT
// What a hand leads and nothing can push goes on its course, whatever strikes it and whenever: who
// rides with it is at rest as seen from it, and stays so.
#include <gtest/gtest.h>

#include "batuta/world/any_controller.hpp"
#include "law_worlds.hpp"

namespace batuta {
namespace {

using test::Vector;

template <RestingContact kRests>
constexpr SceneOptions led_options() {
  SceneOptions scene;
  scene.max_bodies = 4;
  scene.max_pairs = 6;
  scene.max_contacts = 64;
  scene.resting = kRests;
  return scene;
}
template <class S, RestingContact kRests>
using LedScene =
    Scene<led_options<kRests>, Advancement<S>, AnyController<S, FreeFlight<S>, Hand<S>>>;

template <class S>
class Led : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(Led, Scalars);

constexpr double kStep = 1e-2;
constexpr double kSpeed = 10;  // of the walls, m/s

/// Two walls that move along x with a ball between them, 0.2 mm behind the one in front; a pellet
/// meets that one from outside in the sixth step, at `share` of it.
/// @returns the ball's speed as seen from the walls, after 40 steps, m/s
template <class S, RestingContact kRests>
double speed_in_box(double share, double restitution) {
  using SceneT = LedScene<S, kRests>;
  auto world = std::make_unique<World<SceneT>>();
  const double places[] = {0.3, -0.3};
  typename World<SceneT>::BodyId walls[2];
  for (int i = 0; i < 2; ++i) {
    auto wall = test::fixed_rod<SceneT>(2, 0.05, {places[i], 0, 0}, test::along_y());
    wall.owner = 1;
    wall.restitution = static_cast<S>(restitution);
    wall.controller = Hand<S>{};
    walls[i] = world->add(wall).value;
  }
  auto ball = test::solid_ball<SceneT>(0.1, {0.3 - 0.15 - 2e-4, 0, 0});
  ball.restitution = static_cast<S>(restitution);
  test::throw_body(ball, {kSpeed, 0, 0});
  const auto id = world->add(ball).value;
  constexpr double kMeets = 2;  // m/s
  auto pellet = test::solid_ball<SceneT>(0.01, {0.3 + 0.06 + kMeets * (5 + share) * kStep, 0.5, 0});
  pellet.restitution = static_cast<S>(restitution);
  test::throw_body(pellet, {kSpeed - kMeets, 0, 0});
  (void)world->add(pellet);
  for (int n = 0; n < 40; ++n) {
    for (int i = 0; i < 2; ++i) {
      auto* actor = world->get(walls[i]);
      auto* hand = actor->controller.template as<Hand<S>>();
      hand->step = static_cast<S>(kStep);
      hand->target_W = actor->body.X_WB;
      hand->target_W.p_W.x() = static_cast<S>(places[i] + kSpeed * kStep * (n + 1));
    }
    EXPECT_EQ(world->step(static_cast<S>(kStep)), Status::kOk);
    EXPECT_TRUE(world->report().complete()) << n;
  }
  const auto& body = std::as_const(*world).get(id)->body;
  return static_cast<double>(body.inverse_mass * body.momentum.linear_W.x()) - kSpeed;
}

// Targets of float are rounded: the walls' speed changes by 6e-8 of 4 m in each step.
TYPED_TEST(Led, WallThatIsStruckLate_DoesNotBrake) {
  const double rounding = 4 * 4 * static_cast<double>(kRoundOff<TypeParam>) / kStep;
  for (const double share : {0.5, 0.85, 0.9, 0.95, 0.99}) {
    for (const double C : {0.0, 1.0}) {
      const double none = speed_in_box<TypeParam, RestingContact::kNone>(share, C);
      const double settling = speed_in_box<TypeParam, RestingContact::kSettling>(share, C);
      EXPECT_NEAR(none, 0, rounding + 1e-12) << share << ' ' << C;
      EXPECT_NEAR(settling, 0, rounding + 1e-12) << share << ' ' << C;
    }
  }
}

}  // namespace
}  // namespace batuta
