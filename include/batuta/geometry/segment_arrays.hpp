// SPDX-License-Identifier: MIT
#pragma once
// Closest points of many pairs of segments at once, for planners and robots that ask thousands of
// them: coordinates in arrays of their own (structure of arrays), as many pairs at a time as the
// machine that is compiled for has lanes. Each answer has the bits of closest_points() of that
// pair. How: src/geometry/segment_arrays.md.

#include <cstddef>

#include "batuta/geometry/segment.hpp"

namespace batuta {

/// Coordinates of many points: those of point i are x[i], y[i], z[i], m.
/// @tparam Number  `const Scalar` for what is only read
template <class Number>
struct PointArrays {
  Number* x = nullptr;  ///< m
  Number* y = nullptr;  ///< m
  Number* z = nullptr;  ///< m
};

/// Ends of many segments, m.
template <class Scalar>
struct SegmentArrays {
  PointArrays<const Scalar> a;  ///< as Segment::a
  PointArrays<const Scalar> b;  ///< as Segment::b
};

/// Where the members of ClosestPoints go, an array each.
template <class Scalar>
struct ClosestPointsArrays {
  Scalar* s = nullptr;            ///< parameter on A in [0, 1]
  Scalar* u = nullptr;            ///< parameter on B in [0, 1]
  PointArrays<Scalar> p_A;        ///< point of A
  PointArrays<Scalar> p_B;        ///< point of B
  PointArrays<Scalar> normal_AB;  ///< unit, from p_A to p_B
  Scalar* distance = nullptr;     ///< between the points, m
  bool* arbitrary = nullptr;      ///< the normal is one of several
};

/// closest_points() of segment i of A and segment i of B, for i = 0 ... count - 1, bit for bit.
/// @param result  none of its arrays overlaps another one or what is read
/// @pre every array has at least `count` elements; each pair as closest_points() asks it
/// Bound: count pairs. A pair that is in a rare case (lengths out of the ordinary, points that
/// coincide) costs as much as one at a time.
template <class Scalar>
void closest_points(const SegmentArrays<Scalar>& A, const SegmentArrays<Scalar>& B,
                    std::size_t count, const ClosestPointsArrays<Scalar>& result);

}  // namespace batuta
