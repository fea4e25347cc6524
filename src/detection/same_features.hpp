// SPDX-License-Identifier: MIT
#pragma once
// An upper bound of the distance, a moment after the closest points were known: that of the
// features which were closest then. Derivation: advancement.md, "Upper bracket".

#include "edge_pair.hpp"
#include "expansion.hpp"

namespace batuta {

/// Which axes were closest with their inside; the others with the end at `s`, `u`.
template <class Scalar>
struct Features {
  bool on_A = false;
  bool on_B = false;
  Scalar s = 0;
  Scalar u = 0;
};

template <class Scalar>
Scalar onto_axis(Scalar parameter) {
  return clamp(parameter, Scalar(0), Scalar(1));
}

/// Two points of the axes: the closest ones if the features still are, never closer than those.
/// Bound: no loop.
template <class Scalar>
ClosestPoints<Scalar> on_same_features(const Features<Scalar>& features, const AxisState<Scalar>& A,
                                       const AxisState<Scalar>& B) {
  const Vec3<Scalar> a = A.direction();
  const Vec3<Scalar> b = B.direction();
  const Vec3<Scalar> between = B.ends[0].p - A.ends[0].p;
  ClosestPoints<Scalar> points;
  points.s = features.s;
  points.u = features.u;
  if (features.on_A && features.on_B) {
    const Vec3<Scalar> n = a.cross(b);
    const Scalar square = n.squaredNorm();
    points.s = onto_axis(between.cross(b).dot(n) / square);
    points.u = onto_axis(between.cross(a).dot(n) / square);
  } else if (features.on_A) {
    points.s = onto_axis((between + points.u * b).dot(a) / a.squaredNorm());
  } else if (features.on_B) {
    points.u = onto_axis((points.s * a - between).dot(b) / b.squaredNorm());
  }
  const Segment<Scalar> axis_A{A.ends[0].p, A.ends[1].p};
  const Segment<Scalar> axis_B{B.ends[0].p, B.ends[1].p};
  points.p_A = axis_A.at(points.s);
  points.p_B = axis_B.at(points.u);
  const Vec3<Scalar> apart = points.p_B - points.p_A;
  points.distance = length(apart);
  if (points.distance > Scalar(0)) points.normal_AB = apart / points.distance;
  return points;
}

}  // namespace batuta
