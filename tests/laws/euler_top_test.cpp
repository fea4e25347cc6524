// SPDX-License-Identifier: MIT
// Whether the truths are true: the integrator against closed forms, and these against each other.
#include "euler_top.hpp"

#include <gtest/gtest.h>

namespace batuta::laws {
namespace {

constexpr double kTruth = 1e-12;  ///< of the integrator, after a second at 10 rad/s

TEST(EulerTop, JacobisFunctions_AreThoseOfTheTables) {
  // m = 1/2: K = Gamma(1/4)^2 / (4 sqrt(pi)); sn, cn, dn at K/2 in closed form [A & S 16.5].
  const Real gamma = std::tgamma(Real(0.25));
  const Real quarter = gamma * gamma / (4 * std::sqrt(kPi));
  const Jacobi half = jacobi(quarter / 2, 0.5L);
  EXPECT_NEAR(static_cast<double>(half.quarter / quarter), 1, 1e-15);
  const Real k1 = std::sqrt(0.5L);  // the complementary modulus
  EXPECT_NEAR(static_cast<double>(half.sn * half.sn * (1 + k1)), 1, 1e-15);
  EXPECT_NEAR(static_cast<double>(half.cn * half.cn * (1 + k1) / k1), 1, 1e-15);
  EXPECT_NEAR(static_cast<double>(half.dn * half.dn / k1), 1, 1e-15);
}

/// Angular velocity at `time` where b is around the axis of the largest moment (|b|^2 > 2 E I_2),
/// moments ascending, and w = (w_1, 0, w_3) at time 0 with both above zero.
WideVec closed_form(const WideVec& I, const WideVec& w, Real time) {
  const Real E2 = I.dot(w.cwiseProduct(w));
  const Real M2 = I.cwiseProduct(w).squaredNorm();
  const Real low = E2 * I[2] - M2, high = M2 - E2 * I[0];
  const Real pace = std::sqrt((I[2] - I[1]) * high / (I[0] * I[1] * I[2]));
  const Jacobi at = jacobi(pace * time, (I[1] - I[0]) * low / ((I[2] - I[1]) * high));
  return {std::sqrt(low / (I[0] * (I[2] - I[0]))) * at.cn,
          std::sqrt(low / (I[1] * (I[2] - I[1]))) * at.sn,
          std::sqrt(high / (I[2] * (I[2] - I[0]))) * at.dn};
}

TEST(EulerTop, AngularVelocity_IsThatOfTheClosedForm) {
  for (const WideVec& I : {WideVec(1, 2, 3), WideVec(7e-4L, 0.112L, 0.1124L)}) {
    const WideVec w(1.5L, 0, 9.5L);
    const Top start = {I.cwiseInverse(), WideQuat::Identity(), I.cwiseProduct(w)};
    for (const Real time : {0.1L, 0.5L, 1.0L}) {
      const Top end = turned(start, time);
      const WideVec found = end.inverse_moments.cwiseProduct(end.b_B);
      EXPECT_LE((found - closed_form(I, w, time)).norm(), 1e-10L) << static_cast<double>(time);
    }
  }
}

TEST(EulerTop, AngularMomentumInTheWorld_Stays) {
  const Top start = {WideVec(1, 0.5L, 0.3L), WideQuat::Identity(), WideVec(5, 14, 15)};
  const Top end = turned(start, 1);
  EXPECT_LE((end.q_WB * end.b_B - start.b_B).norm(), kTruth * 21);
  EXPECT_NEAR(static_cast<double>(turning_energy(end) / turning_energy(start)), 1, kTruth);
}

TEST(EulerTop, AxisymmetricOrientation_IsThatOfTheClosedForm) {
  // Steadily about b by b / I_t, and about its own axis by the rest.
  const WideVec J(2, 0.5L, 0.5L);
  const Top start = {J, WideQuat::Identity(), WideVec(3, 4, -5)};
  const Real time = 0.75L;
  const WideVec steady = J[1] * time * start.b_B;
  const WideQuat about_b(Eigen::AngleAxis<Real>(steady.norm(), steady.normalized()));
  const Real spin = (J[0] - J[1]) * start.b_B[0] * time;
  const WideQuat own(Eigen::AngleAxis<Real>(spin, WideVec::UnitX()));
  EXPECT_LE(angle_between(Quat<Real>(about_b * own), turned(start, time).q_WB), kTruth);
}

}  // namespace
}  // namespace batuta::laws
