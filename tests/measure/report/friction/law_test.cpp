// SPDX-License-Identifier: MIT
#include "law.hpp"

#include <gtest/gtest.h>

#include "one_body.hpp"

namespace batuta::report {
namespace {

constexpr double kRounding = 1e-12;

Effect effect_on_ball(const Vec3<double>& v, const Law& law) {
  Collider<double> ball = rod_on_floor(0, 0, 1);
  ball.twist.v_W = v;
  const test::Strike strike = strike_on_floor(ball);
  return effect_of(strike, law, answer(strike, law));
}

TEST(Law, BallThatSlides_IsPushedByTheConeOrByItsBox) {
  for (const int rounds : kRounds) {
    const Law law{{1, 0.5, 0}, rounds};
    const Effect effect = effect_on_ball({6, 8, -1}, law);
    EXPECT_NEAR(effect.normal, 2, kRounding);
    EXPECT_LE(effect.rebound_error, kRounding);
    EXPECT_LT(effect.gain, 0);
    // Each tangent by itself lets the corner of a square through.
    EXPECT_GE(effect.tangential, 1 - kRounding);
    EXPECT_LE(effect.tangential, (rounds == 0 ? 1 : std::sqrt(2.0)) + kRounding);
  }
}

TEST(Law, Ball_SticksUpToSevenHalvesOfItsFriction) {
  for (const double friction : {0.2, 0.5, 1.0}) {
    for (const double restitution : {0.0, 0.5, 1.0}) {
      // To stop the slip of a solid ball takes 2/7 of its mass; the normal impulse is 1 + C.
      const double most_slip = 3.5 * friction * (1 + restitution);
      for (const double slip : {0.99 * most_slip, 1.01 * most_slip}) {
        const Effect effect = effect_on_ball({slip, 0, -1}, {{restitution, friction, 0}, 0});
        const double wanted = std::fmin(2.0 / 7 * slip, friction * (1 + restitution));
        EXPECT_NEAR(effect.tangential, wanted, kRounding);
      }
    }
  }
}

TEST(Law, ElasticLeaningRod_GainsByIterationAlone) {
  Collider<double> rod = rod_on_floor(0.785, 0.5, 0.01);
  rod.twist.v_W = {0, 0, -1};
  const test::Strike strike = strike_on_floor(rod);
  const Law closed{{1, 1, 0}, 0};
  const Law iterated{{1, 1, 0}, 50};
  EXPECT_LT(effect_of(strike, closed, answer(strike, closed)).gain, 0);
  rod.twist.v_W = {-0.4, 0, -0.9};
  const test::Strike slanting = strike_on_floor(rod);
  EXPECT_LE(effect_of(slanting, closed, answer(slanting, closed)).gain, test::kGain);
  EXPECT_GT(effect_of(slanting, iterated, answer(slanting, iterated)).gain, 0.1);
}

}  // namespace
}  // namespace batuta::report
