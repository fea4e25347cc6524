// SPDX-License-Identifier: MIT
// A simulated stick coupled to a rod that a fixed post holds back, at 1 kHz: a hand presses the rod
// against the post and feels it. What the advisor allows comes to rest; what it does not, shakes.
#include <gtest/gtest.h>

#include "batuta/haptics/coupling.hpp"
#include "batuta/haptics/gain_advisor.hpp"
#include "resting.hpp"
#include "shared/simulated/axis.hpp"

namespace batuta {
using namespace haptics;
namespace {

constexpr SceneOptions bench_options() {
  SceneOptions scene = test::rest_scene_options();
  scene.max_bodies = 2;
  scene.max_pairs = 1;
  scene.gravity = false;
  return scene;
}
using Bench = Scene<bench_options, Advancement<double>, test::FreeOrHand<double>>;

constexpr double kPeriod = test::kTick;
constexpr double kDamping = 0.8;        // of the stick, N s/m
constexpr double kRodMass = 0.1;        // kg
constexpr double kHandStiffness = 200;  // N/m
constexpr double kPostFace = 0.05;      // x at which the middle of the rod is held back, m
constexpr double kPressed = 0.1;        // where the hand wants it, m
constexpr double kGoing = 0.5;          // s until it wants that
constexpr int kSteps = 4000;

/// Metres and newtons: u = m.
DeviceProfile<double> profile() {
  return {kPeriod, 0, kDamping, 0, 0, 100, 1};
}

port_simulated::SimulatedAxis stick() {
  port_simulated::AxisSettings settings;
  settings.period = kPeriod;
  settings.mass = 0.05;
  settings.damping = kDamping;
  settings.hand_stiffness = kHandStiffness;
  port_simulated::SimulatedAxis axis;
  EXPECT_EQ(axis.configure(settings), Status::kOk);
  return axis;
}

/// A rod along y that flies freely, and a post along z in its way.
void furnish(World<Bench>& world) {
  auto rod = test::rod_at<Bench>(Vec3<double>::Zero(), Vec3<double>::UnitY());
  rod.body = make_body<double>(rod.body.X_WB, kRodMass, Vec3<double>(0.01, 0.01, 0.01)).value;
  rod.restitution = 0;
  EXPECT_TRUE(world.add(rod).ok());
  const Vec3<double> place(kPostFace + 2 * test::kRodRadius, 0, 0);
  auto post = test::post_at<Bench>(place, Vec3<double>::UnitZ());
  post.restitution = 0;
  EXPECT_TRUE(world.add(post).ok());
}

enum class Law : std::uint8_t { kNow, kForeseen };

struct Felt {
  double shake = 0;      ///< of the stick over the last fifth, from end to end, m
  double position = 0;   ///< of the stick at the end, m
  double force = 0;      ///< on the stick at the end, N
  double least_gap = 1;  ///< m
};

/// On the stick, and the opposite on the rod: as coupling_wrench() says now, or couple() foresees.
double pull(const CouplingSettings<double>& coupling, const MovingFrame<double>& commanded,
            Body<double>& body, Law law) {
  if (law == Law::kForeseen) {
    const auto wrench = couple(coupling, commanded, body, kPeriod);
    EXPECT_EQ(wrench.status, Status::kOk);
    return wrench.value.force_W.x();
  }
  const auto wrench = coupling_wrench(coupling, commanded, {body.X_WB, twist_of(body)});
  body.momentum.linear_W -= kPeriod * wrench.force_W;
  return wrench.force_W.x();
}

Felt press(const Gains<double>& gains, Law law) {
  auto axis = stick();
  World<Bench> world;
  furnish(world);
  CouplingSettings<double> coupling;
  coupling.stiffness = gains.stiffness;
  coupling.damping = gains.damping;
  coupling.max_force = 1000;
  Felt felt;
  double low = 1;
  double high = -1;
  double before = 0;
  for (int i = 0; i < kSteps; ++i) {
    MovingFrame<double> commanded;
    commanded.X_W.p_W.x() = axis.position();
    commanded.twist.v_W.x() = (axis.position() - before) / kPeriod;
    before = axis.position();
    auto& body = world.get(world.id_at(0))->body;
    felt.force = pull(coupling, commanded, body, law);
    EXPECT_EQ(world.step(kPeriod), Status::kOk);
    axis.advance(felt.force, kPressed * std::min(1.0, i * kPeriod / kGoing));
    felt.least_gap = std::min(felt.least_gap, test::least_gap(world));
    if (i < kSteps / 5 * 4) continue;
    low = std::min(low, axis.position());
    high = std::max(high, axis.position());
  }
  felt.position = axis.position();
  felt.shake = high - low;
  return felt;
}

/// Hand and coupling pull against each other.
void expect_spring(const Felt& felt, double K) {
  const double rest = (kHandStiffness * kPressed + K * kPostFace) / (kHandStiffness + K);
  EXPECT_LT(felt.shake, 1e-4);
  EXPECT_GT(felt.least_gap, 0);
  EXPECT_NEAR(felt.position, rest, 1e-4);
  EXPECT_NEAR(felt.force, -kHandStiffness * (kPressed - rest), 0.1);
}

TEST(HapticCoupling, WithinTheAdvice_ThePostIsFeltAsASpring) {
  for (const double damping : {0.0, 0.2}) {
    const double K = 0.7 * largest_stiffness(profile(), damping).value.largest;
    ASSERT_EQ(check(profile(), {K, damping}), GainVerdict::kInside);
    expect_spring(press({K, damping}, Law::kNow), K);
  }
}

TEST(HapticCoupling, BeyondTheAdvice_TheStickShakesAndTheRodStillStaysOut) {
  const double K = 1.3 * largest_stiffness(profile(), 0.0).value.largest;
  ASSERT_EQ(check(profile(), {K, 0}), GainVerdict::kBeyondSampling);
  const Felt felt = press({K, 0}, Law::kNow);
  EXPECT_GT(felt.shake, 1e-2);
  EXPECT_GT(felt.least_gap, 0);
}

// couple() asks for the force at the end of the step: against a rod that is held back it is a
// spring and a damper of other gains, and those are to be checked.
TEST(HapticCoupling, Foreseen_IsASpringOfOtherGains) {
  const double K = 480;
  const double softer = 1 + kPeriod * kPeriod * K / kRodMass;
  const Gains<double> felt_gains{K / softer, K * kPeriod / softer};
  ASSERT_EQ(check(profile(), felt_gains), GainVerdict::kInside);
  expect_spring(press({K, 0}, Law::kForeseen), felt_gains.stiffness);
}

}  // namespace
}  // namespace batuta
