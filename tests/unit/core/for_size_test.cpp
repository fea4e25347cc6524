// SPDX-License-Identifier: MIT
// Compiled for size, as firmware is: eigen.hpp then puts its own products of quaternions in place
// of Eigen's. Whole numbers and halves, so that each answer is exact and was found with a pencil.
#include <gtest/gtest.h>

#include "batuta/core/types.hpp"

#if defined(__GNUC__) && !defined(__OPTIMIZE_SIZE__)
#error "this file is to be compiled for size"
#endif

namespace batuta {
namespace {

TEST(ForSize, ProductOfQuaternions_IsHamiltons) {
  const Quat<float> a(1, 2, 3, 4);
  const Quat<float> b(5, 6, 7, 8);
  // i j = k, j k = i, k i = j, and the other way round with the other sign.
  EXPECT_EQ((a * b).coeffs(), Quat<float>(-60, 12, 30, 24).coeffs());
  EXPECT_EQ((b * a).coeffs(), Quat<float>(-60, 20, 14, 32).coeffs());
}

TEST(ForSize, ThirdOfATurnAboutTheDiagonal_ExchangesTheAxes) {
  const Quat<float> third(0.5F, 0.5F, 0.5F, 0.5F);
  EXPECT_EQ(third * Vec3<float>(1, 2, 3), Vec3<float>(3, 1, 2));
  EXPECT_EQ(third.conjugate() * Vec3<float>(1, 2, 3), Vec3<float>(2, 3, 1));
  const Quat<float> other(0.5F, -0.5F, 0.5F, 0.5F);  // about (-1, 1, 1): x to -z to -y
  EXPECT_EQ(other * Vec3<float>(1, 0, 0), Vec3<float>(0, 0, -1));
  EXPECT_EQ(other * Vec3<float>(0, 0, -1), Vec3<float>(0, -1, 0));
  EXPECT_EQ(other * Vec3<float>(0, -1, 0), Vec3<float>(1, 0, 0));
}

}  // namespace
}  // namespace batuta
