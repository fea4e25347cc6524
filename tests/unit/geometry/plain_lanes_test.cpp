// SPDX-License-Identifier: MIT
// Segment arrays as a compiler without vectors has them. In a namespace of their own: the copies of
// other files must not take their place.
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <cstring>

#include "draws.hpp"

#define BATUTA_VECTORS 0
#define lanes lanes_without_vectors
#include "../../../src/geometry/segment_arrays_lanes.hpp"
#undef lanes
#undef BATUTA_VECTORS

namespace batuta {
namespace {

static_assert(lanes_without_vectors::kMachineBytes == 0);
static_assert(lanes_without_vectors::kWidth<float> == 1 &&
              lanes_without_vectors::kWidth<double> == 1);

constexpr std::size_t kPairs = 1000;
using Column = std::array<float, kPairs>;
using Point = std::array<Column, 3>;

PointArrays<const float> read(const Point& point) {
  return {point[0].data(), point[1].data(), point[2].data()};
}
PointArrays<float> write(Point& point) {
  return {point[0].data(), point[1].data(), point[2].data()};
}
Vec3<float> at(const Point& point, std::size_t i) {
  return {point[0][i], point[1][i], point[2][i]};
}

struct Answers {
  Column s, u, distance;
  Point p_A, p_B, normal_AB;
  std::array<bool, kPairs> arbitrary;

  ClosestPointsArrays<float> arrays() {
    return {s.data(),         u.data(),        write(p_A),      write(p_B),
            write(normal_AB), distance.data(), arbitrary.data()};
  }
};

bool is_same(float x, float y) {
  return std::memcmp(&x, &y, sizeof(x)) == 0;
}

bool has_bits_of(const ClosestPoints<float>& x, const Answers& found, std::size_t i) {
  bool same = is_same(x.s, found.s[i]) && is_same(x.u, found.u[i]) &&
              is_same(x.distance, found.distance[i]) && x.arbitrary == found.arbitrary[i];
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto k = static_cast<Eigen::Index>(axis);
    same = same && is_same(x.p_A[k], found.p_A[axis][i]) && is_same(x.p_B[k], found.p_B[axis][i]) &&
           is_same(x.normal_AB[k], found.normal_AB[axis][i]);
  }
  return same;
}

using Ends = std::array<Point, 4>;  // of A, of B

Ends drawn(std::uint32_t seed) {
  test::Draws draws(seed, 0, 0);
  Ends ends;
  for (Point& point : ends) {
    for (Column& column : point) {
      for (float& x : column) x = static_cast<float>(draws.between(-1, 1));
    }
  }
  return ends;
}

SegmentArrays<float> first_of(const Ends& ends) {
  return {read(ends[0]), read(ends[1])};
}
SegmentArrays<float> second_of(const Ends& ends) {
  return {read(ends[2]), read(ends[3])};
}

std::size_t count_unlike(const Ends& ends, const Answers& found) {
  std::size_t unlike = 0;
  for (std::size_t i = 0; i < kPairs; ++i) {
    const Segment<float> A = {at(ends[0], i), at(ends[1], i)};
    const Segment<float> B = {at(ends[2], i), at(ends[3], i)};
    unlike += !has_bits_of(closest_points(A, B), found, i);
  }
  return unlike;
}

TEST(PlainLanes, Arrays_HaveTheBitsOfOneAtATime) {
  const Ends ends = drawn(3);
  Answers found{};
  lanes_without_vectors::closest_points<lanes_without_vectors::kWidth<float>>(
      first_of(ends), second_of(ends), kPairs, found.arrays());
  EXPECT_EQ(count_unlike(ends, found), 0U);
}

TEST(PlainLanes, KernelOfOneNumber_HasTheBitsOfOneAtATime) {
  const Ends ends = drawn(4);
  Answers found{};
  for (std::size_t i = 0; i < kPairs; ++i) {
    lanes_without_vectors::closest_points_of_lanes<1>(first_of(ends), second_of(ends), i,
                                                      found.arrays());
  }
  EXPECT_EQ(count_unlike(ends, found), 0U);
}

}  // namespace
}  // namespace batuta
