// SPDX-License-Identifier: MIT
#pragma once
// How the normal of a pair moves: so that the edges that are closest stay
// level, to second order. Any choice is safe; this one makes long steps.
// Derivation: advancement.md, "Which normal".

#include "certificate.hpp"
#include "edge_pair.hpp"

namespace batuta {

/// A normal that moves faster than this, per duration, is not followed: its
/// powers might overflow, and a fixed one proves as much.
template <class Scalar>
inline constexpr Scalar kFastest = Scalar(16777216);

template <class Scalar>
inline Vec3<Scalar> across(const Vec3<Scalar>& x, const Vec3<Scalar>& n) {
  return x - n * n.dot(x);
}

/// How the material points at the closest parameters part.
template <class Scalar>
inline Vec3<Scalar> relative_rate(Scalar s, Scalar u, const PairState<Scalar>& pair) {
  return pair.travel +
         (pair.turn_B.turn * between(pair.B.side, u) - pair.turn_A.turn * between(pair.A.side, s));
}

/// By how much the second end of an axis is above the first, in the coefficient
/// `order`.
template <class Scalar>
Scalar tilt(const EndCubics<Scalar>& heights, std::size_t order) {
  return heights[1][order] - heights[0][order];
}

/// The rate of the normal n: it turns with the closest points, and the edges
/// stay level.
/// @param f     clearances along n, held fixed
/// @param rate  relative_rate() of the closest points, over their distance
template <class Scalar>
Vec3<Scalar> tracking_rate(const Clearances<Scalar>& f, const Vec3<Scalar>& n,
                           const EdgePair<Scalar>& edges, const Vec3<Scalar>& rate) {
  if (edges.none_holds()) return across(rate, n);
  // Edges are perpendicular to n but for rounding, and nearly parallel ones
  // come with large factors: the certificate needs the vectors themselves
  // perpendicular.
  // What is left of the rate between two edges counts where they are parallel.
  const Scalar level_A = tilt(f.A, 1) + rate.dot(edges.a);
  const Scalar level_B = tilt(f.B, 1) + rate.dot(edges.b);
  return across<Scalar>(rate - edges.solve(level_A, level_B), n);
}

/// Whether its powers are harmless.
template <class Scalar>
bool can_be_followed(const NormalMotion<Scalar>& N) {
  return detail::largest_component(N.m) <= kFastest<Scalar> &&
         detail::largest_component(N.m2) <= kFastest<Scalar> * kFastest<Scalar>;
}

/// What a certificate is asked.
template <class Scalar>
struct Demand {
  Scalar R;        ///< what the distance of the axes has to exceed
  Scalar horizon;  ///< how far it looks
};

/// From the clearances along n, held fixed, to those along n moved, on [0,
/// demand.horizon].
/// @param rate  see tracking_rate()
/// @returns false if n moves too fast to be followed; then they are not to be
/// used
template <class Scalar>
bool track(Clearances<Scalar>& f, const Vec3<Scalar>& n, const EdgePair<Scalar>& edges,
           const Vec3<Scalar>& rate, const PairState<Scalar>& pair, const Demand<Scalar>& demand) {
  NormalMotion<Scalar> N = {tracking_rate(f, n, edges, rate), Vec3<Scalar>::Zero()};
  add_rate(f.A, N.m, Scalar(0), pair.A, pair.turn_A);
  add_rate(f.B, N.m, N.m.dot(pair.travel), pair.B, pair.turn_B);
  if (!edges.none_holds()) {
    N.m2 = across<Scalar>(-edges.solve(tilt(f.A, 2), tilt(f.B, 2)), n);
    add_bend(f.A, N.m2, Scalar(0), pair.A, pair.turn_A);
    add_bend(f.B, N.m2, N.m2.dot(pair.travel), pair.B, pair.turn_B);
  }
  if (!can_be_followed(N)) return false;
  take_toll(f, n, N, pair, demand.R, demand.horizon);
  return true;
}

}  // namespace batuta
