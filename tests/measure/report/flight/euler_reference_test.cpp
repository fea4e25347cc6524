// SPDX-License-Identifier: MIT
#include "euler_reference.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace batuta::report {
namespace {

struct Jacobi {
  Wide sn;
  Wide cn;
  Wide dn;
};

/// Jacobi's elliptic functions by arithmetic-geometric means. @pre 0 <= m < 1
Jacobi jacobi(Wide u, Wide m) {
  constexpr std::size_t kMeans = 10;  // each doubles the digits
  std::array<Wide, kMeans + 1> a{1};
  std::array<Wide, kMeans + 1> c{std::sqrt(m)};
  Wide b = std::sqrt(1 - m);
  for (std::size_t n = 0; n < kMeans; ++n) {
    a[n + 1] = (a[n] + b) / 2;
    c[n + 1] = (a[n] - b) / 2;
    b = std::sqrt(a[n] * b);
  }
  Wide phi = std::ldexp(a[kMeans] * u, static_cast<int>(kMeans));
  for (std::size_t n = kMeans; n > 0; --n) phi = (phi + std::asin(c[n] / a[n] * std::sin(phi))) / 2;
  const Wide sn = std::sin(phi);
  return {sn, std::cos(phi), std::sqrt(1 - m * sn * sn)};
}

/// The closed form [Landau and Lifshitz, Mechanics, §37] for a start at (w1, 0, w3).
/// @pre I1 < I2 < I3; |b|^2 > 2 E I2
Vec3<Wide> closed_form(const Vec3<Wide>& I, Wide w1, Wide w3, Wide t) {
  const Wide energy2 = I(0) * w1 * w1 + I(2) * w3 * w3;
  const Wide square = I(0) * I(0) * w1 * w1 + I(2) * I(2) * w3 * w3;
  const Wide low = energy2 * I(2) - square;
  const Wide high = square - energy2 * I(0);
  const Wide rate = std::sqrt((I(2) - I(1)) * high / (I(0) * I(1) * I(2)));
  const Jacobi f = jacobi(rate * t, (I(1) - I(0)) * low / ((I(2) - I(1)) * high));
  return {std::sqrt(low / (I(0) * (I(2) - I(0)))) * f.cn,
          std::sqrt(low / (I(1) * (I(2) - I(1)))) * f.sn,
          std::sqrt(high / (I(2) * (I(2) - I(0)))) * f.dn};
}

const Vec3<Wide> kMoments(1, 1.5L, 2.2L);
constexpr Wide kEnd = 3;
constexpr long kSteps = 30000;

TEST(EulerReference, Spin_IsThatOfTheClosedForm) {
  for (const Wide w1 : {0.1L, 2.0L, 6.0L}) {
    Spin spin;
    spin.w_B = {w1, 0, 7};
    const Vec3<Wide> expected = closed_form(kMoments, w1, 7, kEnd);
    EXPECT_LT((closed_form(kMoments, w1, 7, 0) - spin.w_B).norm(), 1e-15L);
    const Spin end = turned_by_euler(spin, kMoments, kEnd, kSteps);
    EXPECT_LT((end.w_B - expected).norm(), 1e-12L) << static_cast<double>(w1);
  }
}

TEST(EulerReference, AngularMomentum_StaysInTheWorld) {
  Spin spin;
  spin.w_B = {2, -3, 7};
  const Vec3<Wide> before = spin.q_WB * Vec3<Wide>(kMoments.cwiseProduct(spin.w_B));
  const Spin end = turned_by_euler(spin, kMoments, kEnd, kSteps);
  const Vec3<Wide> after = end.q_WB * Vec3<Wide>(kMoments.cwiseProduct(end.w_B));
  EXPECT_LT((after - before).norm(), 1e-12L);
  // Against a quarter of the steps, the orientation changes by what is left of a fourth order.
  const Spin coarse = turned_by_euler(spin, kMoments, kEnd, kSteps / 4);
  const Wide off = 2 * (coarse.q_WB.conjugate() * end.q_WB).vec().norm();
  EXPECT_GT(off, 0);
  EXPECT_LT(off, 1e-10L);
}

TEST(EulerReference, SpinAboutAPrincipalAxis_IsSteady) {
  Spin spin;
  spin.w_B = {0, 0, 2};
  const Spin end = turned_by_euler(spin, kMoments, 1, kSteps);
  const Quat<Wide> turned(Eigen::AngleAxis<Wide>(2, Vec3<Wide>::UnitZ()));
  EXPECT_LT((turned.conjugate() * end.q_WB).vec().norm(), 1e-15L);
}

}  // namespace
}  // namespace batuta::report
