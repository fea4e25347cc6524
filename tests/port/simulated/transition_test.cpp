// SPDX-License-Identifier: MIT
// The exponential of a period against the textbook's solutions.
#include "shared/simulated/transition.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace batuta::port_simulated {
namespace {

constexpr double kMass = 0.3;
constexpr double kRounding = 1e-12;

Vec2<double> after(const Oscillator& oscillator, double span, double q, double v, double u,
                   double growth) {
  return transition_of(oscillator, span) * Eigen::Vector4d(q, v, u, growth);
}

TEST(Transition, FreeMass_FollowsTheParabolaAndTheCubic) {
  for (const double t : {1e-6, 1e-3, 0.5, 20.0}) {
    const Vec2<double> state = after({kMass, 0, 0}, t, 2, -3, 5, 7);
    const double q = 2 - 3 * t + 5 / kMass * t * t / 2 + 7 / kMass * t * t * t / 6;
    const double v = -3 + 5 / kMass * t + 7 / kMass * t * t / 2;
    EXPECT_NEAR(state[0], q, kRounding * (std::abs(q) + 1));
    EXPECT_NEAR(state[1], v, kRounding * (std::abs(v) + 1));
  }
}

TEST(Transition, DampedMass_ComesToItsSpeed) {
  const double c = 0.7;
  for (const double t : {1e-4, 0.1, 3.0}) {
    const Vec2<double> state = after({kMass, 0, c}, t, 0, 0, 5, 0);
    const double decay = std::exp(-c / kMass * t);
    EXPECT_NEAR(state[1], 5 / c * (1 - decay), kRounding);
    EXPECT_NEAR(state[0], 5 / c * (t - kMass / c * (1 - decay)), kRounding);
  }
}

// Below, at and above critical damping, over less than a radian and over many turns.
TEST(Transition, Spring_SwingsOrCreeps) {
  const double k = 40;
  const double critical = 2 * std::sqrt(k * kMass);
  for (const double share : {0.0, 0.1, 1.0, 3.0}) {
    const double a = share * critical / kMass / 2;
    const double square = k / kMass - a * a;
    for (const double t : {1e-3, 0.1, 1.0}) {
      const double w = std::sqrt(std::abs(square));
      const double C = share > 1 ? std::cosh(w * t) : std::cos(w * t);
      const double S = share == 1 ? t : (share > 1 ? std::sinh(w * t) : std::sin(w * t)) / w;
      const double q = std::exp(-a * t) * (2 * C + (-3 + a * 2) * S);
      const Vec2<double> state = after({kMass, k, share * critical}, t, 2, -3, 0, 0);
      EXPECT_NEAR(state[0], q, kRounding) << share << ' ' << t;
    }
  }
}

TEST(Transition, TwoHalves_AreTheWhole) {
  const Oscillator oscillator{kMass, 4000, 2};
  const double t = 0.7;
  const Vec2<double> half = after(oscillator, t / 2, 1, 2, 3, 4);
  const Vec2<double> both = after(oscillator, t / 2, half[0], half[1], 3 + 4 * t / 2, 4);
  const Vec2<double> whole = after(oscillator, t, 1, 2, 3, 4);
  EXPECT_NEAR(both[0], whole[0], kRounding);
  EXPECT_NEAR(both[1], whole[1], 1e2 * kRounding);
}

}  // namespace
}  // namespace batuta::port_simulated
