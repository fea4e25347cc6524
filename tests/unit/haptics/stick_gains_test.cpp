// SPDX-License-Identifier: MIT
#include "batuta/haptics/stick_gains.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "draws.hpp"

namespace batuta::haptics {
namespace {

template <class S>
class StickGains : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(StickGains, Scalars);

/// Any map: J as it may be, entries within 2.
template <class S>
StickJacobian<S> any_jacobian(test::Draws& draws) {
  StickJacobian<S> J;
  for (int i = 0; i < J.rows(); ++i) {
    for (int k = 0; k < J.cols(); ++k) J(i, k) = static_cast<S>(draws.between(-2, 2));
  }
  return J;
}

template <class S>
CouplingSettings<S> any_coupling(test::Draws& draws) {
  CouplingSettings<S> settings;
  settings.stiffness = static_cast<S>(draws.between(0, 2000));
  settings.damping = static_cast<S>(draws.between(0, 5));
  settings.turn_stiffness = static_cast<S>(draws.between(0, 20));
  settings.turn_damping = static_cast<S>(draws.between(0, 0.1));
  return settings;
}

/// By an eigenvalue solver, in double.
template <class S>
double largest_eigenvalue(const StickJacobian<S>& J, S along, S about) {
  Eigen::Matrix<double, 6, 1> K;
  K.head<3>().setConstant(static_cast<double>(along));
  K.tail<3>().setConstant(static_cast<double>(about));
  const auto wide = J.template cast<double>().eval();
  const Eigen::Matrix2d at_stick = wide.transpose() * K.asDiagonal() * wide;
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(at_stick).eigenvalues().maxCoeff();
}

TYPED_TEST(StickGains, AreTheLargestEigenvalues) {
  using S = TypeParam;
  constexpr double kError = 16 * static_cast<double>(kRoundOff<S>);  // sums of six products
  for (std::uint64_t i = 0; i < 1000; ++i) {
    test::Draws draws(15, 1, i);
    const auto J = any_jacobian<S>(draws);
    const auto settings = any_coupling<S>(draws);
    const Gains<S> gains = gains_at_stick(J, settings);
    const double K = largest_eigenvalue(J, settings.stiffness, settings.turn_stiffness);
    const double B = largest_eigenvalue(J, settings.damping, settings.turn_damping);
    EXPECT_NEAR(static_cast<double>(gains.stiffness), K, kError * K) << i;
    EXPECT_NEAR(static_cast<double>(gains.damping), B, kError * B) << i;
  }
}

// What a coupling does to the stick is the slope of its force: J^T w, w the springs' wrench for a
// small way of the hand, is no more in any direction.
TYPED_TEST(StickGains, NoWayOfTheStickIsStiffer) {
  using S = TypeParam;
  test::Draws draws(15, 2, 1);
  const auto J = any_jacobian<S>(draws);
  CouplingSettings<S> settings;
  const double K = static_cast<double>(gains_at_stick(J, settings).stiffness);
  double most = 0;
  for (int i = 0; i < 360; ++i) {
    const double angle = i * 3.14159265 / 360;
    const Vec2<S> way(static_cast<S>(std::cos(angle)), static_cast<S>(std::sin(angle)));
    const Eigen::Matrix<S, 6, 1> hand = J * way;
    const Wrench<S> wrench{settings.stiffness * hand.template head<3>(),
                           settings.turn_stiffness * hand.template tail<3>()};
    most = max_of(most, static_cast<double>(stick_force(J, wrench).dot(way)));
  }
  EXPECT_LE(most, K * (1 + 64 * static_cast<double>(kRoundOff<S>)));
  EXPECT_GE(most, K * (1 - 1e-4));  // one of 360 ways is within half a degree of it
}

TYPED_TEST(StickGains, BeyondTheRim_OneCoordinateIsLeft) {
  using S = TypeParam;
  StickJacobian<S> J = StickJacobian<S>::Zero();
  J(0, 1) = S(0.5);  // m along x for a unit of the second coordinate
  CouplingSettings<S> settings;
  settings.stiffness = 400;
  settings.damping = 2;
  EXPECT_EQ(gains_at_stick(J, settings).stiffness, S(100));
  EXPECT_EQ(gains_at_stick(J, settings).damping, S(0.5));
}

TYPED_TEST(StickGains, WhatIsNoNumber_IsSaidByCheck) {
  using S = TypeParam;
  StickJacobian<S> J = StickJacobian<S>::Ones();
  J(2, 0) = std::numeric_limits<S>::quiet_NaN();
  DeviceProfile<S> profile;
  profile.period = S(0.001);
  profile.damping = S(0.1);
  profile.force_limit = 1;
  profile.travel = 1;
  EXPECT_EQ(check(profile, gains_at_stick(J, CouplingSettings<S>{})), GainVerdict::kInvalidGains);
}

}  // namespace
}  // namespace batuta::haptics
