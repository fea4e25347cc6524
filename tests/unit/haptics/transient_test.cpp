// SPDX-License-Identifier: MIT

#include "batuta/haptics/transient.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace batuta {
using namespace haptics;
namespace {

using Transient = ImpactTransient<double>;
constexpr double kStep = 1e-3;

Transient transient_of(const TransientSettings<double>& settings) {
  Transient transient;
  EXPECT_EQ(transient.configure(settings), Status::kOk);
  return transient;
}

/// Plays until silence. @returns the area, and in `steps` how long it took
Vec2<double> played(Transient& transient, int& steps) {
  Vec2<double> area = Vec2<double>::Zero();
  steps = 0;
  while (transient.left() != Vec2<double>::Zero() && steps < 1000) {
    area += kStep * transient.advance(kStep);
    ++steps;
  }
  return area;
}

TEST(ImpactTransient, ABlowThatFits_IsPlayedEvenlyInItsDuration) {
  Transient transient = transient_of({});
  ASSERT_EQ(transient.strike({0.08, -0.02}), Status::kOk);
  for (int i = 0; i < 4; ++i) {
    const Vec2<double> force = transient.advance(kStep);
    EXPECT_NEAR(force.x(), 20, 1e-5);  // 4 ms is no float
    EXPECT_NEAR(force.y(), -5, 1e-5);
  }
  EXPECT_EQ(transient.advance(kStep), Vec2<double>::Zero());
  EXPECT_EQ(transient.lost(), 0);
}

TEST(ImpactTransient, ABlowOfNothing_ChangesNothing) {
  Transient transient = transient_of({});
  ASSERT_EQ(transient.strike({0.08, 0}), Status::kOk);
  for (int i = 0; i < 4; ++i) {
    ASSERT_EQ(transient.strike({0, 0}), Status::kOk);
    EXPECT_NEAR(transient.advance(kStep).x(), 20, 1e-5);
  }
  EXPECT_EQ(transient.left(), Vec2<double>::Zero());
}

TEST(ImpactTransient, AHardBlow_IsPlayedLongerAtTheActuatorsLimit) {
  Transient transient = transient_of({});
  ASSERT_EQ(transient.strike({0.4, 0}), Status::kOk);
  int steps = 0;
  const Vec2<double> area = played(transient, steps);
  EXPECT_NEAR(area.x(), 0.4, 1e-15);
  EXPECT_NEAR(steps, 10, 1);  // 0.4 / 40 s, and rounding
}

// 4 ms of 40: 0.176 N m s are beyond it by 0.1, and take 4.4 ms.
TEST(ImpactTransient, ClippedAndExcess_AgreeToTheEndOfThePulse) {
  Transient transient = transient_of({});
  ASSERT_EQ(transient.strike({0.176, 0}), Status::kOk);
  for (int i = 0; i < 5; ++i) {
    (void)transient.advance(kStep);
    EXPECT_EQ(transient.is_clipped(), i < 4) << i;
    EXPECT_NEAR(transient.excess(), i < 4 ? 0.1 : 0, 1e-6) << i;  // 4 ms is a float
  }
}

// What would not fit in 4 ms fits in a step of 10.
TEST(ImpactTransient, StepLongerThanThePulse_IsNotClippedWhereItFits) {
  Transient transient = transient_of({});
  ASSERT_EQ(transient.strike({0.3, 0}), Status::kOk);
  EXPECT_NEAR(transient.advance(0.01).x(), 30, 1e-12);
  EXPECT_FALSE(transient.is_clipped());
  EXPECT_EQ(transient.excess(), 0);
}

TEST(ImpactTransient, TooHardABlow_SaysWhatWasLost) {
  Transient transient = transient_of({});
  ASSERT_EQ(transient.strike({-3, 0}), Status::kOk);
  int steps = 0;
  const Vec2<double> area = played(transient, steps);
  EXPECT_EQ(steps, 30);
  EXPECT_NEAR(area.x(), -1.2, 1e-14);  // 40 x 0.03
  EXPECT_NEAR(transient.lost(), 1.8, 1e-14);
}

/// Where the end lies between two steps, rounding must not let go what the last one is for.
TEST(ImpactTransient, PulseThatMayLastNoLonger_IsPlayedWhole) {
  for (int i = 1; i <= 2000; ++i) {
    const float dt = 1e-6F * static_cast<float>(i);
    for (const float steps : {1.5F, 2.5F, 3.5F}) {
      TransientSettings<float> settings;
      settings.duration = settings.longest = dt * steps;
      ImpactTransient<float> transient;
      ASSERT_EQ(transient.configure(settings), Status::kOk);
      ASSERT_EQ(transient.strike({dt, 0}), Status::kOk);  // fits: below 1 N m for each unit
      for (int step = 0; step < 5; ++step) (void)transient.advance(dt);
      ASSERT_EQ(transient.lost(), 0) << dt << " s, " << steps;
      ASSERT_EQ(transient.left(), (Vec2<float>(0, 0)));
    }
  }
}

RC_GTEST_PROP(ImpactTransient, Area_IsTheSumOfTheBlows, ()) {
  TransientSettings<double> settings;
  settings.gain = 0.5;
  Transient transient = transient_of(settings);
  Vec2<double> struck = Vec2<double>::Zero();
  Vec2<double> area = Vec2<double>::Zero();
  const auto blows = *rc::gen::container<std::vector<int>>(rc::gen::inRange(-100, 101));
  for (const int blow : blows) {
    const Vec2<double> impulse(0.001 * blow, -0.002 * blow);
    RC_ASSERT(transient.strike(impulse) == Status::kOk);
    struck += 0.5 * impulse;
    const Vec2<double> force = transient.advance(kStep);
    RC_ASSERT(force.cwiseAbs().maxCoeff() <= settings.max_force);
    area += kStep * force;
  }
  int steps = 0;
  area += played(transient, steps);
  RC_ASSERT((area - struck).cwiseAbs().sum() <= transient.lost() + 1e-12);
}

TEST(ImpactTransient, StepsLongerThanThePulse_StillGiveItsArea) {
  Transient transient = transient_of({});
  ASSERT_EQ(transient.strike({0.1, 0.2}), Status::kOk);
  const Vec2<double> force = transient.advance(0.01);
  EXPECT_NEAR(0.01 * force.x(), 0.1, 1e-15);
  EXPECT_NEAR(0.01 * force.y(), 0.2, 1e-15);
  EXPECT_EQ(transient.left(), Vec2<double>::Zero());
}

TEST(ImpactTransient, NotFinite_IsRefused) {
  Transient transient = transient_of({});
  ASSERT_EQ(transient.strike({0.1, 0.2}), Status::kOk);
  const Vec2<double> before = transient.left();
  EXPECT_EQ(transient.strike({NAN, 0}), Status::kInvalidArgument);
  EXPECT_EQ(transient.strike({0, INFINITY}), Status::kInvalidArgument);
  EXPECT_EQ(transient.left(), before);
}

TEST(ImpactTransient, SettingsOutOfRange_AreRefused) {
  Transient transient = transient_of({});
  ASSERT_EQ(transient.strike({0.1, 0}), Status::kOk);
  const auto refuses = [&](auto change) {
    TransientSettings<double> settings;
    change(settings);
    return transient.configure(settings) == Status::kInvalidArgument;
  };
  EXPECT_TRUE(refuses([](auto& s) { s.gain = -1; }));
  EXPECT_TRUE(refuses([](auto& s) { s.duration = 0; }));
  EXPECT_TRUE(refuses([](auto& s) { s.longest = s.duration / 2; }));
  EXPECT_TRUE(refuses([](auto& s) { s.longest = INFINITY; }));
  EXPECT_TRUE(refuses([](auto& s) { s.longest = 1.001; }));
  EXPECT_TRUE(refuses([](auto& s) { s.max_force = NAN; }));
  EXPECT_EQ(transient.left(), Vec2<double>(0.1, 0));
}

RC_GTEST_PROP(Mixed, Blow_IsWholeAndTheRestKeepsItsDirection, ()) {
  const auto number = [](double size) {
    return size * (*rc::gen::inRange(-1000000, 1000001)) * 1e-6;
  };
  const double limit = 40;
  const double bx = number(limit);
  const double by = number(limit);
  const double rx = number(200);
  const double ry = number(200);
  const Vec2<double> rest(rx, ry);
  const Vec2<double> sum = mixed<double>({bx, by}, rest, limit);
  RC_ASSERT(sum.cwiseAbs().maxCoeff() <= limit);
  const Vec2<double> added = sum - Vec2<double>(bx, by);
  RC_ASSERT(std::abs(added.x() * ry - added.y() * rx) <= 1e-11 * (1 + rest.norm()));
  RC_ASSERT(added.dot(rest) >= -1e-12);
  const bool whole = (added - rest).norm() <= 1e-12 * (1 + rest.norm());
  RC_ASSERT(whole || std::abs(sum.cwiseAbs().maxCoeff() - limit) <= 1e-12);
}

}  // namespace
}  // namespace batuta
