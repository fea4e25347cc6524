// SPDX-License-Identifier: MIT
#pragma once
// Pairs of segments as arrays, and whether what is answered for all of them at once has the bits of
// one at a time.

#include <array>
#include <cstring>
#include <memory>
#include <vector>

#include "../../src/geometry/segment_arrays_lanes.hpp"

namespace batuta::test {

/// Pairs, an array for each coordinate.
template <class Scalar>
class SegmentColumns {
 public:
  void push(const Segment<Scalar>& A, const Segment<Scalar>& B) {
    const std::array<const Vec3<Scalar>*, 4> ends = {&A.a, &A.b, &B.a, &B.b};
    for (std::size_t i = 0; i < 12; ++i) {
      columns_[i].push_back((*ends[i / 3])[static_cast<Eigen::Index>(i % 3)]);
    }
  }
  std::size_t size() const { return columns_[0].size(); }
  SegmentArrays<Scalar> A() const { return {points(0), points(3)}; }
  SegmentArrays<Scalar> B() const { return {points(6), points(9)}; }
  Segment<Scalar> A(std::size_t at) const { return {point(0, at), point(3, at)}; }
  Segment<Scalar> B(std::size_t at) const { return {point(6, at), point(9, at)}; }

 private:
  PointArrays<const Scalar> points(std::size_t i) const {
    return {columns_[i].data(), columns_[i + 1].data(), columns_[i + 2].data()};
  }
  Vec3<Scalar> point(std::size_t i, std::size_t at) const {
    return {columns_[i][at], columns_[i + 1][at], columns_[i + 2][at]};
  }
  std::array<std::vector<Scalar>, 12> columns_;
};

/// Where answers go.
template <class Scalar>
class ClosestColumns {
 public:
  explicit ClosestColumns(std::size_t size) : arbitrary_(new bool[size]) {
    for (std::vector<Scalar>& column : columns_) column.assign(size, Scalar(-77));
  }
  ClosestPointsArrays<Scalar> arrays() {
    return {columns_[0].data(), columns_[1].data(),  points(2),       points(5),
            points(8),          columns_[11].data(), arbitrary_.get()};
  }
  bool has_bits_of(const ClosestPoints<Scalar>& x, std::size_t at) const {
    const std::array<Scalar, 12> numbers = {
        x.s,       x.u,       x.p_A.x(),       x.p_A.y(),       x.p_A.z(),       x.p_B.x(),
        x.p_B.y(), x.p_B.z(), x.normal_AB.x(), x.normal_AB.y(), x.normal_AB.z(), x.distance};
    for (std::size_t i = 0; i < 12; ++i) {
      if (std::memcmp(&columns_[i][at], &numbers[i], sizeof(Scalar)) != 0) return false;
    }
    return arbitrary_[at] == x.arbitrary;
  }

 private:
  PointArrays<Scalar> points(std::size_t i) {
    return {columns_[i].data(), columns_[i + 1].data(), columns_[i + 2].data()};
  }
  std::array<std::vector<Scalar>, 12> columns_;
  std::unique_ptr<bool[]> arbitrary_;
};

/// How many pairs are answered otherwise than one at a time, W at once.
template <int W, class Scalar>
std::size_t count_unlike(const SegmentColumns<Scalar>& pairs) {
  ClosestColumns<Scalar> found(pairs.size());
  lanes::closest_points<W>(pairs.A(), pairs.B(), pairs.size(), found.arrays());
  std::size_t unlike = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    unlike += !found.has_bits_of(closest_points(pairs.A(i), pairs.B(i)), i);
  }
  return unlike;
}

/// The same for every width that a machine may have, and through the public function.
template <class Scalar>
std::size_t count_unlike_at_any_width(const SegmentColumns<Scalar>& pairs) {
  ClosestColumns<Scalar> found(pairs.size());
  closest_points(pairs.A(), pairs.B(), pairs.size(), found.arrays());
  std::size_t unlike = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    unlike += !found.has_bits_of(closest_points(pairs.A(i), pairs.B(i)), i);
  }
  return unlike + count_unlike<1>(pairs) + count_unlike<4>(pairs) + count_unlike<8>(pairs) +
         count_unlike<16>(pairs);
}

}  // namespace batuta::test
