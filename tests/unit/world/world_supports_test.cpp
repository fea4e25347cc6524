// SPDX-License-Identifier: MIT
// A body between neighbours: a shift by separation is cut short only by those it leads towards.
#include <gtest/gtest.h>

#include <memory>

#include "scenes.hpp"

namespace batuta {
namespace {

template <class S>
class WorldSupports : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(WorldSupports, Scalars);

constexpr double kRadius = 0.05;
constexpr double kNear = 1e-5;  // gap between the rod and each post, m

/// A rod along z at x = 0 that drifts slowly towards -x, and a post on the side `x` of it at z.
template <class S>
struct Rack {
  using SceneT = test::FlightScene<S>;
  using BodyId = typename World<SceneT>::BodyId;
  World<SceneT> world;
  BodyId rod;

  Rack() {
    auto actor = test::rod<SceneT>(0, 0.5, kRadius);
    actor.body.momentum.linear_W = test::vec<S>(-2e-3, 0, 0);
    rod = world.add(actor).value;
  }
  BodyId add_post(double side, double z) {
    auto post = test::post<SceneT>(side * (2 * kRadius + kNear), kRadius);
    post.body.X_WB.p_W.z() = static_cast<S>(z);
    return world.add(post).value;
  }
  double gap_to(BodyId post) {
    const auto shape = [this](BodyId id) {
      return to_world(world.get(id)->body.X_WB, world.get(id)->capsule_B);
    };
    return static_cast<double>(capsule_gap(shape(rod), shape(post)).gap);
  }
};

TYPED_TEST(WorldSupports, TwoOnOneSide_BothGapsOpenToD) {
  Rack<TypeParam> rack;
  const auto low = rack.add_post(-1, -0.3);
  const auto high = rack.add_post(-1, 0.3);
  const auto D = static_cast<double>(WorldSettings<test::FlightScene<TypeParam>>{}.separation);
  for (int step = 0; step < 20; ++step) {
    ASSERT_EQ(rack.world.step(TypeParam(1e-2)), Status::kOk);
    ASSERT_TRUE(rack.world.report().complete()) << step;
    ASSERT_GT(rack.gap_to(low), 0) << step;
    ASSERT_GT(rack.gap_to(high), 0) << step;
    if (rack.world.report().separations == 0) continue;
    // The centre is pushed out by D; what a tilt takes from one end it gives to the other.
    EXPECT_GT(rack.gap_to(low) + rack.gap_to(high), D);
    return;
  }
  FAIL() << "the rod never came to rest on its posts";
}

TYPED_TEST(WorldSupports, OneOnEachSide_NeverPushedIntoTheOther) {
  Rack<TypeParam> rack;
  const auto below = rack.add_post(-1, 0);
  const auto above = rack.add_post(1, 0);
  std::uint32_t separations = 0;
  for (int step = 0; step < 20; ++step) {
    ASSERT_EQ(rack.world.step(TypeParam(1e-2)), Status::kOk);
    separations += rack.world.report().separations;
    ASSERT_GT(rack.gap_to(below), 0) << step;
    ASSERT_GT(rack.gap_to(above), 0) << step;
  }
  EXPECT_GT(separations, 0U);
}

constexpr SceneOptions carrying_options() {
  SceneOptions scene = test::flight_scene_options();
  scene.gravity = true;
  scene.resting = RestingContact::kNone;
  return scene;
}

/// A rod of 1 kg begins to tip over a fixed ball, d off its middle, which pushes it with
/// s = g / (1 / m + d^2 / I). After t a ball from below strikes it at the other side, a off its
/// middle, with J, and it leaves both. It keeps what the support has given by then, s t and its
/// moment, and no more.
TYPED_TEST(WorldSupports, StruckUp_KeepsWhatTheSupportHasGiven) {
  using S = TypeParam;
  using SceneT = Scene<carrying_options, Advancement<S>, test::AnyFlight<S>>;
  constexpr double kG = 10, kD = 0.2, kA = 0.3, kMass = 0.25, kT = 0.004, kStep = 0.01;
  for (const double side : {-1.0, 1.0}) {
    auto world = std::make_unique<World<SceneT>>();
    auto settings = world->settings();
    settings.gravity_W = test::vec<S>(-kG, 0, 0);
    ASSERT_EQ(world->configure(settings), Status::kOk);
    const auto add = [&world](Actor<SceneT> actor, double z) {
      actor.body.X_WB.p_W.z() = static_cast<S>(z);
      actor.restitution = 0;
      return world->add(actor).value;
    };
    const auto rod = add(test::rod<SceneT>(0, 0.5, kRadius), 0);
    auto support = test::ball<SceneT>(-0.1 - kRadius, 0.1, 0);
    support.body.inverse_mass = 0;
    support.body.inverse_moments.setZero();
    add(support, side * kD);
    auto striker = test::ball<SceneT>(-kRadius - 0.01 - kT, 0.01, 1);  // at 1 m/s
    striker.body.inverse_mass /= S(kMass);
    striker.body.inverse_moments /= S(kMass);
    striker.body.momentum.linear_W *= S(kMass);
    const auto struck_by = add(striker, -side * kA);
    ASSERT_EQ(world->step(S(kStep)), Status::kOk);
    const auto& after = world->get(struck_by)->body.momentum.linear_W;
    const double J = kMass * (1 - kG * kStep) - static_cast<double>(after.x());
    const auto& body = world->get(rod)->body;
    const double I = 1 / static_cast<double>(body.inverse_moments.y());
    const double s = kG / (1 + kD * kD / I);
    const double given = s * kD * kT / I;  // rad/s
    // What the two move before they meet is some hundredths of the way that they have.
    const Twist<S> twist = twist_of(body);
    EXPECT_NEAR(static_cast<double>(twist.v_W.x()), J - kG * kStep + s * kT, 0.05 * s * kT);
    EXPECT_NEAR(static_cast<double>(twist.w_W.y()), side * (given - J * kA / I), 0.05 * given);
  }
}

}  // namespace
}  // namespace batuta
