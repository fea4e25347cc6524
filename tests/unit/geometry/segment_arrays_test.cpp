// SPDX-License-Identifier: MIT
// Closest points of many pairs at once: the bits of one at a time, whatever the numbers and the
// width.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wpsabi"  // lanes wider than this machine's are never passed on
#endif

#include <gtest/gtest.h>

#include "draws.hpp"
#include "hostile_numbers.hpp"
#include "segment_columns.hpp"

namespace batuta {
namespace {

template <class Scalar>
class SegmentArraysOf : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(SegmentArraysOf, Scalars);

constexpr std::size_t kPairs = 50'000;

/// One pair after the other from a rule for a coordinate.
template <class Scalar, class Coordinate>
test::SegmentColumns<Scalar> pairs_of(std::size_t count, Coordinate&& coordinate) {
  const auto point = [&] {
    const Scalar x = coordinate();
    const Scalar y = coordinate();
    return Vec3<Scalar>(x, y, coordinate());
  };
  const auto segment = [&] {
    const Vec3<Scalar> a = point();
    return Segment<Scalar>{a, point()};
  };
  test::SegmentColumns<Scalar> pairs;
  for (std::size_t i = 0; i < count; ++i) {
    const Segment<Scalar> A = segment();
    pairs.push(A, segment());
  }
  return pairs;
}

TYPED_TEST(SegmentArraysOf, GenericPairs_HaveTheBitsOfOneAtATime) {
  test::Draws draws(1, 0, 0);
  const auto pairs =
      pairs_of<TypeParam>(kPairs, [&] { return static_cast<TypeParam>(draws.between(-1, 1)); });
  EXPECT_EQ(test::count_unlike_at_any_width(pairs), 0U);
}

// Parallel, crossing, touching, of no length, equal in some coordinates: from a grid of five.
TYPED_TEST(SegmentArraysOf, TiesAndDegenerates_HaveTheBitsOfOneAtATime) {
  test::Draws draws(2, 0, 0);
  const auto pairs = pairs_of<TypeParam>(
      kPairs, [&] { return static_cast<TypeParam>(static_cast<int>(draws.between(0, 5)) - 2); });
  EXPECT_EQ(test::count_unlike_at_any_width(pairs), 0U);
}

// Lengths of every scale up to the largest coordinate, beside ordinary ones in the same lanes.
TYPED_TEST(SegmentArraysOf, HostileScales_HaveTheBitsOfOneAtATime) {
  test::Draws draws(3, 0, 0);
  constexpr std::size_t kFirstAllowed = 6;  // those before are beyond kLargestCoordinate
  const auto pairs = pairs_of<TypeParam>(kPairs, [&]() -> TypeParam {
    const double kind = draws.between(0, 3);
    const auto which = static_cast<std::size_t>(draws.between(double{kFirstAllowed}, 17));
    if (kind < 0.3) return test::kHostile<TypeParam>[which];
    return kind < 1 ? TypeParam(0) : static_cast<TypeParam>(draws.between(-1, 1));
  });
  EXPECT_EQ(test::count_unlike_at_any_width(pairs), 0U);
}

// A few pairs fewer and more than a whole number of lanes; nothing behind the last is written.
TYPED_TEST(SegmentArraysOf, AnyCount_IsAnsweredAndNothingBehind) {
  test::Draws draws(4, 0, 0);
  for (std::size_t count = 0; count < 40; ++count) {
    const auto pairs = pairs_of<TypeParam>(
        count + 1, [&] { return static_cast<TypeParam>(draws.between(-1, 1)); });
    test::ClosestColumns<TypeParam> found(count + 1);
    ClosestPointsArrays<TypeParam> arrays = found.arrays();
    closest_points(pairs.A(), pairs.B(), count, arrays);
    for (std::size_t i = 0; i < count; ++i) {
      EXPECT_TRUE(found.has_bits_of(closest_points(pairs.A(i), pairs.B(i)), i)) << i;
    }
    EXPECT_EQ(arrays.distance[count], TypeParam(-77));
    EXPECT_EQ(arrays.s[count], TypeParam(-77));
  }
}

}  // namespace
}  // namespace batuta
