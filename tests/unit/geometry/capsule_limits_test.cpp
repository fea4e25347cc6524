// SPDX-License-Identifier: MIT
// The largest capsule there is, and one bit more.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "batuta/geometry/capsule.hpp"

namespace batuta {
namespace {

template <class Scalar>
class CapsuleLimits : public ::testing::Test {
 protected:
  static constexpr Scalar kLargest = kLargestCoordinate<Scalar>;
  const Scalar beyond = std::nextafter(kLargest, std::numeric_limits<Scalar>::infinity());

  static Capsule<Scalar> with(int place, Scalar value) {
    Capsule<Scalar> capsule{{{1, 2, 3}, {4, 5, 6}}, 7};
    if (place == 6) {
      capsule.radius = value;
    } else {
      (place < 3 ? capsule.axis.a : capsule.axis.b)[place % 3] = value;
    }
    return capsule;
  }
};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(CapsuleLimits, Scalars);

TYPED_TEST(CapsuleLimits, EachNumber_IsValidUpToTheLargestAndNotBeyond) {
  for (int place = 0; place < 7; ++place) {
    EXPECT_TRUE(is_valid(this->with(place, this->kLargest))) << place;
    EXPECT_FALSE(is_valid(this->with(place, this->beyond))) << place;
    const bool is_radius = place == 6;
    EXPECT_EQ(is_valid(this->with(place, -this->kLargest)), !is_radius) << place;
    EXPECT_FALSE(is_valid(this->with(place, -this->beyond))) << place;
    EXPECT_FALSE(is_valid(this->with(place, std::numeric_limits<TypeParam>::quiet_NaN())));
  }
}

}  // namespace
}  // namespace batuta
