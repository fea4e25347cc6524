// SPDX-License-Identifier: MIT
// Power that the stick gives is power that the hand gets, for key poses that turn and shift.

#include "batuta/haptics/force_map.hpp"

#include <gtest/gtest.h>

#include "batuta/fencing/fencer.hpp"

namespace batuta {
using namespace haptics;
using namespace fencing;
namespace {

const Wrench<double> kWrench{{3, -7, 2}, {0.4, 0.9, -0.6}};

/// A way over all cells, through the centre.
Vec2<double> stick_at(double t) {
  return {0.95 * std::sin(2.1 * t), 0.95 * std::sin(3.3 * t)};
}

/// The work that kWrench, about the hand's origin, does on the hand in [t, t + h]: from poses
/// alone.
double work_on_hand(const FencerMap<double>& map, double t, double h) {
  const Motion<double> motion =
      motion_between(hand_at(map, stick_at(t)).X_WH, hand_at(map, stick_at(t + h)).X_WH, h);
  return h * (kWrench.force_W.dot(motion.twist.v_W) + kWrench.moment_W.dot(motion.twist.w_W));
}

/// The work of the stick's force over the same time: that of its middle.
double work_on_stick(const FencerMap<double>& map, double t, double h) {
  const Vec2<double> force = stick_force(hand_at(map, stick_at(t + h / 2)).jacobian, kWrench);
  return force.dot(Vec2<double>(stick_at(t + h) - stick_at(t)));
}

TEST(ForceMap, OneColumn_IsTheWorkOfAUnitRate) {
  StickJacobian<double> jacobian = StickJacobian<double>::Zero();
  jacobian.col(0) << 1, 2, 3, 4, 5, 6;
  const Wrench<double> wrench{{1, 10, 100}, {1000, 10000, 100000}};
  const Vec2<double> force = stick_force(jacobian, wrench);
  EXPECT_EQ(force.x(), 654321);
  EXPECT_EQ(force.y(), 0);
}

/// Whether the way between two times crosses a border of cells: nine columns, five rows.
bool crosses_a_border(double t, double h) {
  const auto cell = [](double time) {
    const Vec2<double> stick = stick_at(time);
    return std::pair{std::floor(4 * stick.x()), std::floor(2 * stick.y())};
  };
  return cell(t) != cell(t + h);
}

TEST(ForceMap, PowerOfTheStick_IsThatOfTheHand) {
  for (const auto& fencer : {first_fencer<double>(), second_fencer<double>()}) {
    const auto& map = fencer.map;
    for (int i = 0; i < 3000; ++i) {
      const double t = 0.01 * i;
      const double h = 1e-4;
      // Middle against chord: of third order in h, with derivatives of the way below 100; where the
      // second one jumps, of second order.
      const double slack = crosses_a_border(t, h) ? 100 * h * h : 1e4 * h * h * h;
      EXPECT_NEAR(work_on_stick(map, t, h), work_on_hand(map, t, h), slack) << t;
    }
  }
}

TEST(ForceMap, StepsOfTheSimulation_ConvergeWithTheSquareOfTheStep) {
  const auto map = first_fencer<double>().map;
  const auto worst = [&](double h) {
    double error = 0;
    for (double t = 0; t < 6; t += 0.05) {
      error = std::max(error, std::abs(work_on_stick(map, t, h) - work_on_hand(map, t, h)) / h);
    }
    return error;
  };
  // The grid is C1: across a border of cells only the first order is sure.
  EXPECT_LT(worst(5e-4), worst(1e-3) / 2 * 1.01);
  EXPECT_LT(worst(1e-3), 0.02);  // W, of some 20: what a duel's step of 1 ms comes to
}

TEST(ForceMap, AcrossABorderOfCells_DoesNotJump) {
  const auto map = second_fencer<double>().map;
  const double step = 1e-9;
  for (double along = -0.95; along < 1; along += 0.1) {
    for (const auto& [from, to] :
         {std::pair<Vec2<double>, Vec2<double>>{{-step, along}, {step, along}},
          {{along, -step}, {along, step}}}) {
      const Vec2<double> before = stick_force(hand_at(map, from).jacobian, kWrench);
      const Vec2<double> after = stick_force(hand_at(map, to).jacobian, kWrench);
      EXPECT_LT((after - before).norm(), 1e3 * step) << along;
    }
  }
}

TEST(ForceMap, BeyondTheRim_NothingIsFelt) {
  const auto map = first_fencer<double>().map;
  const Vec2<double> force = stick_force(hand_at(map, Vec2<double>(1.5, 0)).jacobian, kWrench);
  EXPECT_EQ(force.x(), 0);
  EXPECT_NE(force.y(), 0);
}

TEST(ForceMap, MovedWrench_DoesTheSameWork) {
  const Vec3<double> p_from(1, 2, 3);
  const Vec3<double> p_to(-2, 0.5, 4);
  const Twist<double> twist{{0.3, -1, 2}, {5, -0.2, 0.7}};  // of the point p_from
  const Vec3<double> v_to = twist.v_W + twist.w_W.cross(Vec3<double>(p_to - p_from));
  const Wrench<double> there = moved(kWrench, p_from, p_to);
  const double power = kWrench.force_W.dot(twist.v_W) + kWrench.moment_W.dot(twist.w_W);
  EXPECT_NEAR(there.force_W.dot(v_to) + there.moment_W.dot(twist.w_W), power, 1e-12);
}

}  // namespace
}  // namespace batuta
