// SPDX-License-Identifier: MIT
#pragma once
// The normal of a pair at one instant, and how it moves: so that it stays perpendicular to the
// edges that are closest, to second order. Any choice is safe; this one makes long steps.
// Derivation: advancement.md, "Which normal".

#include "certificate.hpp"
#include "edge_pair.hpp"

namespace batuta {

/// A normal that moves faster than this, per duration, is not followed: its powers might overflow,
/// and a fixed one proves as much.
template <class Scalar>
inline constexpr Scalar kFastest = Scalar(16777216);

template <class Scalar>
Vec3<Scalar> across(const Vec3<Scalar>& x, const Vec3<Scalar>& n) {
  return x - n * n.dot(x);
}

/// The path of the normal n: it turns with the closest points, and stays perpendicular to the edges
/// that hold, to second order.
/// @param rate  relative_rate() of the closest points
/// @param distance  of the axes, > 0
template <class Scalar>
NormalPath<Scalar> tracking_path(const Vec3<Scalar>& n, const EdgePair<Scalar>& edges,
                                 const PairState<Scalar>& pair, const Vec3<Scalar>& rate,
                                 Scalar distance) {
  NormalPath<Scalar> N;
  N.n = n;
  N.m = across(rate, n) / distance;  // between two edges: what is left where they are parallel
  if (edges.none_holds()) return N;
  const Vec3<Scalar> a1 = pair.A.direction_rate();
  const Vec3<Scalar> b1 = pair.B.direction_rate();
  N.m -= edges.solve(n.dot(a1) + N.m.dot(edges.a), n.dot(b1) + N.m.dot(edges.b));
  // Edges are perpendicular to n but for rounding, and nearly parallel ones come with large
  // factors: the certificate needs the vectors themselves perpendicular.
  N.m = across(N.m, n);
  N.m2 = across<Scalar>(-edges.solve(2 * N.m.dot(a1) + n.dot(pair.A.direction_bend()),
                                     2 * N.m.dot(b1) + n.dot(pair.B.direction_bend())),
                        n);
  return N;
}

/// How the material points at the closest parameters part.
template <class Scalar>
Vec3<Scalar> relative_rate(const ClosestPoints<Scalar>& closest, const PairState<Scalar>& pair) {
  return pair.B.rate(closest.u) - pair.A.rate(closest.s);
}

/// Whether its powers are harmless.
template <class Scalar>
bool can_be_followed(const NormalPath<Scalar>& N) {
  return largest_component(N.m) <= kFastest<Scalar> &&
         largest_component(N.m2) <= kFastest<Scalar> * kFastest<Scalar>;
}

}  // namespace batuta
