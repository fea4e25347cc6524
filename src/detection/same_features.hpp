// SPDX-License-Identifier: MIT
#pragma once
// An upper bound of the distance, a moment after the closest points were known:
// that of the features which were closest then. Derivation: advancement.md,
// "Upper bracket".

#include "edge_pair.hpp"
#include "expansion.hpp"

namespace batuta {

/// Which axes were closest with their inside; the others with the end at `s`,
/// `u`.
template <class Scalar>
struct Features {
  Scalar s;
  Scalar u;
  bool on_A;
  bool on_B;
};

template <class Scalar>
Scalar onto_axis(Scalar parameter) {
  return clamp(parameter, Scalar(0), Scalar(1));
}

/// Moves s and u to where the features are closest now, clamped.
/// @returns whether they are within `limit` of each other, to rounding. Bound: no loop.
template <class Scalar>
bool follow(Features<Scalar>& features, const AxisState<Scalar>& A, const AxisState<Scalar>& B,
            Scalar limit) {
  const Vec3<Scalar> a = A.direction();
  const Vec3<Scalar> b = B.direction();
  const Vec3<Scalar> between = B.p[0] - A.p[0];
  if (features.on_A && features.on_B) {
    const Vec3<Scalar> n = a.cross(b);
    const Scalar square = n.squaredNorm();
    const Scalar apart = between.dot(n);
    if (apart * apart > limit * limit * square) return false;  // even the lines are not
    features.s = onto_axis(between.cross(b).dot(n) / square);
    features.u = onto_axis(between.cross(a).dot(n) / square);
  } else if (features.on_A) {
    features.s = onto_axis((between + features.u * b).dot(a) / a.squaredNorm());
  } else if (features.on_B) {
    features.u = onto_axis((features.s * a - between).dot(b) / b.squaredNorm());
  }
  return (between + (features.u * b - features.s * a)).squaredNorm() <= limit * limit;
}

/// Two points of the axes: the closest ones if the features still are, never
/// closer than those.
template <class Scalar>
ClosestPoints<Scalar> points_at(const Features<Scalar>& features, const Segment<Scalar>& A,
                                const Segment<Scalar>& B) {
  ClosestPoints<Scalar> points;
  points.s = features.s;
  points.u = features.u;
  points.p_A = A.at(points.s);
  points.p_B = B.at(points.u);
  const Vec3<Scalar> apart = points.p_B - points.p_A;
  points.distance = length(apart);
  if (points.distance > Scalar(0)) points.normal_AB = apart / points.distance;
  return points;
}

}  // namespace batuta
