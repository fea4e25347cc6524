// SPDX-License-Identifier: MIT
#include "beat_truth.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace batuta::report {
using namespace fencing;
namespace {

constexpr std::uint64_t kPlans = 6;

/// How far a play is from the truth.
struct Error {
  double time = 0;
  double impulse = 0;
  double tip = 0;

  void at_least(const Error& other) {
    time = std::max(time, other.time);
    impulse = std::max(impulse, other.impulse);
    tip = std::max(tip, other.tip);
  }
};

Error error_of(const BeatPlan& plan, std::int32_t step_us) {
  const BeatTruth truth(plan);
  Play<double, Advancement<double>> duel(step_us);
  Error error;
  play_beat(duel, plan, [&] {
    const double now = 1e-6 * static_cast<double>(duel.now_us());
    if (duel.at_mark()) error.tip = std::max(error.tip, tip_error(duel.tips(), truth.tips(now)));
    EXPECT_NEAR(duel.duel().stick(Side::kLeft).position().y(),
                truth.blade(Side::kLeft).stick(now - 1e-12).y(), 1e-9);
  });
  EXPECT_EQ(duel.blows().size(), 1U);
  if (duel.blows().size() != 1) return error;
  error.time = std::abs(duel.blows()[0].time - truth.time());
  error.impulse = std::abs(duel.blows()[0].impulse / truth.impulse() - 1);
  return error;
}

Error worst_error(std::int32_t step_us) {
  Error worst;
  for (std::uint64_t i = 0; i < kPlans; ++i)
    worst.at_least(error_of(beat_plan(i, kPlans), step_us));
  return worst;
}

/// Of both blades after the contact, m/s.
double fastest_tip() {
  double fastest = 0;
  for (std::uint64_t i = 0; i < kPlans; ++i) {
    const BeatTruth truth(beat_plan(i, kPlans));
    for (const Side side : {Side::kLeft, Side::kRight}) {
      const BladeState& state = truth.after()[index_of(side)];
      const Vec3<Wide> lever = truth.blade(side).ends(state)[1] - state.center;
      const Wide speed = (state.v_W + state.w_W.cross(lever)).norm();
      fastest = std::max(fastest, static_cast<double>(speed));
    }
  }
  return fastest;
}

/// Momentum about the world's origin.
Vec3<Wide> angular_momentum(const LedBlade& blade, const BladeState& state) {
  return blade.angular_momentum(state) +
         static_cast<Wide>(blade.weapon().mass) * state.center.cross(state.v_W);
}

TEST(BeatTruth, Blades_TouchAtTheContactAndNotBefore) {
  for (std::uint64_t i = 0; i < kPlans; ++i) {
    const BeatTruth truth(beat_plan(i, kPlans));
    ASSERT_GT(truth.time(), 0.06);
    EXPECT_NEAR(static_cast<double>(truth.held_gap(static_cast<Wide>(truth.time()))), 0, 1e-13);
    for (int k = 0; k < 1000; ++k) {
      EXPECT_GT(truth.held_gap(static_cast<Wide>(truth.time()) * k / 1000), 0);
    }
  }
}

TEST(BeatTruth, Velocities_AreThoseOfThePlaces) {
  const BeatTruth truth(beat_plan(1, kPlans));
  constexpr double kStep = 2e-6;  // the square of it is seen, times the third derivative
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const LedBlade& blade = truth.blade(side);
    const double t = truth.time();
    const BladeState state = blade.held(t);
    for (const std::size_t end : {0U, 1U}) {
      const Vec3<Wide> lever = blade.ends(state)[end] - state.center;
      const Vec3<Wide> velocity = state.v_W + state.w_W.cross(lever);
      const Vec3<Wide> moved =
          blade.ends(blade.held(t + kStep))[end] - blade.ends(blade.held(t - kStep))[end];
      EXPECT_LT((moved / (2 * static_cast<Wide>(kStep)) - velocity).norm(), 1e-7);
    }
  }
}

TEST(BeatTruth, Blow_KeepsMomentaAndReturnsTheApproach) {
  for (std::uint64_t i = 0; i < kPlans; ++i) {
    const BeatTruth truth(beat_plan(i, kPlans));
    Vec3<Wide> linear = Vec3<Wide>::Zero();
    Vec3<Wide> angular = Vec3<Wide>::Zero();
    std::array<Wide, 2> closing{};
    for (const Side side : {Side::kLeft, Side::kRight}) {
      const std::size_t k = index_of(side);
      const LedBlade& blade = truth.blade(side);
      const BladeState& before = truth.before()[k];
      const BladeState& after = truth.after()[k];
      linear += static_cast<Wide>(blade.weapon().mass) * (after.v_W - before.v_W);
      angular += angular_momentum(blade, after) - angular_momentum(blade, before);
      const Vec3<Wide> lever = truth.point() - before.center;
      const Wide sign = k == 0 ? 1 : -1;
      closing[0] += sign * truth.normal().dot(before.v_W + before.w_W.cross(lever));
      closing[1] += sign * truth.normal().dot(after.v_W + after.w_W.cross(lever));
    }
    EXPECT_LT(linear.norm(), 1e-15);
    EXPECT_LT(angular.norm(), 1e-15);
    EXPECT_LT(closing[0], -0.5);
    const double bounce = first_fencer<double>().weapon.restitution;
    EXPECT_NEAR(static_cast<double>(closing[1] / closing[0]), -bounce, 1e-12);
  }
}

TEST(BeatTruth, ShorterSteps_ComeToIt) {
  const Error coarse = worst_error(4000);
  const Error fine = worst_error(400);
  const Error finest = worst_error(100);
  // A tenth of the step: a tenth of the error of what is of first order, a hundredth of the rest.
  EXPECT_LT(fine.impulse, coarse.impulse / 4);
  EXPECT_LT(fine.tip, coarse.tip / 4);
  EXPECT_LT(finest.impulse, 2e-3);
  EXPECT_LT(finest.tip, fine.tip / 3);
  // The hand pulls from the end of the step of the blow (src/fencing/grip.md): up to a step late.
  EXPECT_LT(finest.tip, 100e-6 * fastest_tip());
  EXPECT_LT(finest.time, 5e-6);
}

}  // namespace
}  // namespace batuta::report
