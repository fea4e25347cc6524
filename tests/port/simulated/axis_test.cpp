// SPDX-License-Identifier: MIT
#include "shared/simulated/axis.hpp"

#include <gtest/gtest.h>

#include "draws.hpp"
#include "heap_trap.hpp"
#include "shared/simulated/encoder.hpp"

namespace batuta::port_simulated {
namespace {

SimulatedAxis axis_with(const AxisSettings& settings) {
  SimulatedAxis axis;
  EXPECT_EQ(axis.configure(settings), Status::kOk);
  return axis;
}

AxisSettings rubbing(double friction) {
  AxisSettings settings;
  settings.friction = friction;
  return settings;
}

TEST(SimulatedAxis, Friction_StopsAThrownStickWhereItShould) {
  SimulatedAxis axis = axis_with(rubbing(0.4));
  axis.place(0, 0.8, 0);
  for (int i = 0; i < 200; ++i) axis.advance(0, 0);
  EXPECT_EQ(axis.velocity(), 0);
  EXPECT_NEAR(axis.position(), 0.05 * 0.8 * 0.8 / 2 / 0.4, 1e-14);  // m v^2 / 2 = f_c way
  EXPECT_NEAR(axis.rubbed(), 0.05 * 0.8 * 0.8 / 2, 1e-14);
}

TEST(SimulatedAxis, Friction_HoldsUpToItsForceAndNotBeyond) {
  SimulatedAxis axis = axis_with(rubbing(0.4));
  for (const double force : {0.4, -0.4}) {
    for (int i = 0; i < 100; ++i) axis.advance(force, 0);
    EXPECT_EQ(axis.position(), 0);
  }
  axis.advance(0.5, 0);
  EXPECT_NEAR(axis.velocity(), 0.1 / 0.05 * 1e-3, 1e-15);
}

// A hand that goes evenly drags the stick by a spring: it sticks until the spring pulls enough.
TEST(SimulatedAxis, SlowHand_ReleasesTheStickWhenItsSpringPullsEnough) {
  AxisSettings settings = rubbing(0.4);
  settings.hand_stiffness = 100;
  SimulatedAxis axis = axis_with(settings);
  int periods = 0;
  while (axis.position() == 0 && periods < 1000) axis.advance(0, 1e-4 * ++periods);
  EXPECT_EQ(periods, 41);  // 100 x 0.0041 > 0.4
}

// A swing with friction alone: each half turn loses 2 f_c / k of its amplitude.
TEST(SimulatedAxis, Swing_LosesTheSameAtEachTurn) {
  AxisSettings settings = rubbing(0.1);
  settings.hand_stiffness = 50;
  SimulatedAxis axis = axis_with(settings);
  axis.place(0.05, 0, 0);
  double furthest = 0.05;
  int turns = 0;
  for (int i = 0; i < 2000; ++i) {
    const double before = axis.velocity();
    axis.advance(0, 0);
    if (before * axis.velocity() >= 0 && !(before != 0 && axis.velocity() == 0)) continue;
    ++turns;
    furthest -= 2 * 0.1 / 50;
  }
  EXPECT_EQ(turns, 12);  // 0.05 - 12 x 0.004 = 0.002: within the reach of friction
  EXPECT_NEAR(std::abs(axis.position()), furthest, 1e-12);
  EXPECT_EQ(axis.velocity(), 0);
}

/// Work of the force and of the hand's end, less what friction took, is what is there. Without
/// viscous damping nothing else goes anywhere.
TEST(SimulatedAxis, Energy_IsWhatCameInLessFriction) {
  test::Draws draws(71, 0, 0);
  for (int run = 0; run < 50; ++run) {
    AxisSettings settings = rubbing(run % 2 == 0 ? 0 : draws.between(0.01, 1));
    settings.hand_stiffness = draws.between(0, 2000);
    settings.hand_mass = draws.between(0, 1);
    SimulatedAxis axis = axis_with(settings);
    axis.place(draws.between(-1, 1), draws.between(-1, 1), 0);
    double expected = axis.energy();
    for (int i = 0; i < 300; ++i) {
      const double before = axis.position();
      const double rubbed = axis.rubbed();
      const double force = draws.between(-5, 5);
      axis.advance(force, 0);
      expected += force * (axis.position() - before) - (axis.rubbed() - rubbed);
    }
    EXPECT_NEAR(axis.energy(), expected, 1e-10);
  }
}

TEST(SimulatedAxis, Damping_OnlyTakes) {
  test::Draws draws(72, 0, 0);
  AxisSettings settings = rubbing(0.2);
  settings.damping = 0.5;
  settings.hand_stiffness = 300;
  settings.hand_damping = 1;
  SimulatedAxis axis = axis_with(settings);
  axis.place(1, 0, 0);
  for (int i = 0; i < 1000; ++i) {
    const double before = axis.energy();
    axis.advance(0, 0);
    EXPECT_LE(axis.energy(), before);
  }
}

TEST(SimulatedAxis, HandsDamper_TakesTheStickAlong) {
  AxisSettings settings;
  settings.hand_mass = 0.15;
  settings.hand_damping = 2;
  SimulatedAxis axis = axis_with(settings);
  constexpr int kPeriods = 150;
  constexpr double kSpeed = 0.3;
  for (int i = 1; i <= kPeriods; ++i) axis.advance(0, kSpeed * 1e-3 * i);
  EXPECT_NEAR(axis.velocity(), kSpeed * (1 - std::exp(-2 / 0.2 * 1e-3 * kPeriods)), 1e-12);
}

TEST(SimulatedAxis, Stop_TakesTheSpeed) {
  AxisSettings settings;
  settings.travel = 0.1;
  SimulatedAxis axis = axis_with(settings);
  axis.place(0.0999, 1, 0);
  axis.advance(0, 0);
  EXPECT_EQ(axis.position(), 0.1);
  EXPECT_EQ(axis.velocity(), 0);
  axis.advance(-1, 0);
  EXPECT_LT(axis.position(), 0.1);
}

TEST(SimulatedAxis, OutOfRange_IsRefusedAndChangesNothing) {
  SimulatedAxis axis = axis_with({});
  axis.place(0.5, 0.25, 0.125);
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  using Field = double AxisSettings::*;
  for (const Field field :
       {&AxisSettings::period, &AxisSettings::mass, &AxisSettings::damping, &AxisSettings::friction,
        &AxisSettings::hand_mass, &AxisSettings::hand_stiffness, &AxisSettings::hand_damping,
        &AxisSettings::travel}) {
    for (const double bad : {-1.0, kNan}) {
      AxisSettings settings;
      settings.*field = bad;
      EXPECT_EQ(axis.configure(settings), Status::kInvalidArgument);
    }
  }
  AxisSettings fine = rubbing(0.1);
  fine.hand_stiffness = fine.mass * 15.9e3 * 15.9e3;  // 15.9 rad in a period
  EXPECT_EQ(validate(fine), Status::kOk);
  fine.hand_stiffness = fine.mass * 16.1e3 * 16.1e3;
  EXPECT_EQ(validate(fine), Status::kInvalidArgument);
  fine = {};
  fine.hand_damping = 0.99e14 * fine.mass;  // over a period of 1 ms
  EXPECT_EQ(validate(fine), Status::kOk);
  for (const double stiff : {1.01e14, 1e300}) {
    fine.hand_damping = stiff * fine.mass;
    EXPECT_EQ(validate(fine), Status::kInvalidArgument);
  }
  EXPECT_EQ(axis.position(), 0.5);
  EXPECT_EQ(axis.velocity(), 0.25);
  EXPECT_EQ(axis.hand(), 0.125);
}

TEST(SimulatedAxis, Advancing_AllocatesNothing) {
  AxisSettings settings = rubbing(0.1);
  settings.hand_stiffness = 5000;
  SimulatedAxis axis = axis_with(settings);
  axis.place(1, 0, 0);
  const test::HeapTrap trap;
  for (int i = 0; i < 100; ++i) axis.advance(0.05, 0);
  EXPECT_EQ(trap.allocations(), 0);
}

TEST(Encoder, ShowsTheNearestStep) {
  EXPECT_EQ(encoded(0.3, 0.25), 0.25);
  EXPECT_EQ(encoded(-0.3, 0.25), -0.25);
  EXPECT_EQ(encoded(0.4, 0.25), 0.5);
  EXPECT_EQ(encoded(0.4, 0), 0.4);
}

}  // namespace
}  // namespace batuta::port_simulated
