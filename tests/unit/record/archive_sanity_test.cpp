// SPDX-License-Identifier: MIT
// Archive::all_sane(): what it lets pass, to the last bit, in both scalars (src/record/archive.md).
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "batuta/record/archive.hpp"

namespace batuta {
namespace {

template <class T>
bool is_sane(const T& value) {
  ArchiveHash hash;
  hash.look_at(value);
  return hash.all_sane();
}

template <class Scalar>
class ArchiveSanity : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(ArchiveSanity, Scalars);

TYPED_TEST(ArchiveSanity, Numbers_UpToTwoToThe30) {
  using Limits = std::numeric_limits<TypeParam>;
  const TypeParam largest = 1073741824;
  for (const TypeParam good : {TypeParam(0), Limits::denorm_min(), TypeParam(-3), largest}) {
    EXPECT_TRUE(is_sane(good)) << good;
    EXPECT_TRUE(is_sane(-good)) << good;
  }
  for (const TypeParam bad : {std::nextafter(largest, Limits::infinity()), Limits::max(),
                              Limits::infinity(), Limits::quiet_NaN()}) {
    EXPECT_FALSE(is_sane(bad)) << bad;
    EXPECT_FALSE(is_sane(-bad)) << bad;
  }
}

/// Lengths of 1 to within 2^-10, squares to within 2^-9; `little` is far more than the root rounds.
TYPED_TEST(ArchiveSanity, Quaternions_OfUnitLength) {
  const auto of_square = [](TypeParam square) {
    return Quat<TypeParam>(std::sqrt(square), 0, 0, 0);
  };
  const TypeParam edge = TypeParam(1) / 512;
  const TypeParam little = edge / 1024;
  EXPECT_TRUE(is_sane(of_square(1)));
  EXPECT_TRUE(is_sane(of_square(1 + edge - little)));
  EXPECT_TRUE(is_sane(of_square(1 - edge + little)));
  EXPECT_FALSE(is_sane(of_square(1 + edge + little)));
  EXPECT_FALSE(is_sane(of_square(1 - edge - little)));
  EXPECT_FALSE(is_sane(of_square(0)));
}

}  // namespace
}  // namespace batuta
