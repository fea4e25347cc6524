// SPDX-License-Identifier: MIT
// What is driven and turns, and whom it turns: surface runs on surface, whatever the gap of rest.
#include <gtest/gtest.h>

#include <cmath>

#include "batuta/world/any_controller.hpp"
#include "law_worlds.hpp"

namespace batuta {
namespace {

/// Leads a body with a twist that stays.
template <class S>
struct Turning {
  Vec3<S> w_W = Vec3<S>::Zero();

  PlannedMotion<S> plan(const Body<S>& body, S /*start*/, S duration) const {
    PlannedMotion<S> planned{still(body.X_WB, duration), false};
    planned.motion.twist.w_W = w_W;
    return planned;
  }
  void on_contact(const Body<S>& /*body*/, const Feedback<S>& /*feedback*/) {}
  void on_step_end(const Body<S>& /*body*/, S /*duration*/) {}
  template <class Archive>
  void archive(Archive& archive) {
    archive(w_W);
  }
};

template <class S>
using WheelScene = Scene<test::law_options<RestingContact::kSettling, test::kFalling>,
                         Advancement<S>, AnyController<S, FreeFlight<S>, Turning<S>>>;

/// A rod of radius r in the groove between two wheels of radius R, both driven at `spin`.
/// @returns how fast it turns in the end, over what its surface on theirs makes of that
template <class S>
double turned(double r, double R, double spin, double dt) {
  using SceneT = WheelScene<S>;
  World<SceneT> world;
  auto settings = world.settings();
  settings.gravity_W = Vec3<S>(0, 0, S(-9.81));
  EXPECT_EQ(world.configure(settings), Status::kOk);
  const double aside = 1.2 * R;
  for (const double y : {-aside, aside}) {
    auto wheel = test::fixed_rod<SceneT>(8 * r, R, {0, y, 0}, test::along_x());
    wheel.friction = S(0.5);
    Turning<S> drive;
    drive.w_W.x() = static_cast<S>(spin);
    wheel.controller = drive;
    EXPECT_TRUE(world.add(wheel).ok());
  }
  const double gap = 0.3 * max_of(1e-4, 9.81 * dt * dt / 4);
  const double apart = R + r + gap;
  auto rod = test::solid_rod<SceneT>(6 * r, r, {0, 0, std::sqrt(apart * apart - aside * aside)},
                                     test::along_x());
  rod.friction = S(0.5);
  const auto id = world.add(rod).value;
  for (int i = 0; i < std::lround(2 / dt); ++i) {
    EXPECT_EQ(world.step(static_cast<S>(dt)), Status::kOk);
    EXPECT_TRUE(world.report().complete()) << i;
  }
  const auto& body = std::as_const(world).get(id)->body;
  return -static_cast<double>(twist_of(body).w_W.x()) * r / (spin * R);
}

template <class S>
class Wheels : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(Wheels, Scalars);

TYPED_TEST(Wheels, RodInTheirGroove_TurnsByTheRadii) {
  for (const double r : {0.005, 0.02}) {
    for (const double R : {r, 3 * r}) {
      for (const double dt : {1e-3, 1.0 / 60, 1.0 / 30}) {
        EXPECT_NEAR(turned<TypeParam>(r, R, 2, dt), 1, 0.01) << r << ' ' << R << ' ' << dt;
      }
    }
  }
}

// The point of an event is midway between the surfaces, whoever is led.
TYPED_TEST(Wheels, EventBesideAFixedBody_TellsTheMiddle) {
  using SceneT = test::Settling<TypeParam, test::kFalling>;
  World<SceneT> world;
  ASSERT_TRUE(world.add(test::fixed_rod<SceneT>(1, 0.05, {0, 0, -0.05}, test::along_y())).ok());
  const double gap = 1e-3;
  ASSERT_TRUE(world.add(test::solid_ball<SceneT>(0.02, {0, 0, 0.02 + gap})).ok());
  int begun = 0;
  for (int i = 0; i < 10; ++i) {
    ASSERT_EQ(world.step(TypeParam(1) / 30), Status::kOk);
    for (const auto& event : world.events()) {
      if (event.kind != EventKind::kBegin) continue;
      ++begun;
      EXPECT_NEAR(static_cast<double>(event.contact.point_W.z()),
                  static_cast<double>(event.contact.gap) / 2, 1e-6);
      EXPECT_GT(event.contact.gap, TypeParam(1e-4)) << "else nothing is told apart";
    }
  }
  EXPECT_EQ(begun, 1);
}

}  // namespace
}  // namespace batuta
