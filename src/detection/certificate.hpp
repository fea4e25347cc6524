// SPDX-License-Identifier: MIT
#pragma once
// How long a normal that moves proves a pair free. For every path N(h) of a vector that is nowhere
// zero, gap(h) >= min over the ends i of A and j of B of N.(q_j - p_i) / |N| - R. Each N.(q_j -
// p_i)
// - R |N| is bounded from below by a polynomial in h; the pair is free as long as all four are
// positive. Derivation and proof: advancement.md.

#include "expansion.hpp"

namespace batuta {

/// N(h) = n + m h + m2 h^2 / 2, with m and m2 perpendicular to the unit vector n: |N| >= 1.
template <class Scalar>
struct NormalPath {
  Vec3<Scalar> n = Vec3<Scalar>::Zero();
  Vec3<Scalar> m = Vec3<Scalar>::Zero();
  Vec3<Scalar> m2 = Vec3<Scalar>::Zero();
};

/// Two axes at one instant, and what is known of them at all others.
template <class Scalar>
struct PairExpansion {
  AxisExpansion<Scalar> A;
  AxisExpansion<Scalar> B;
  DerivativeBounds<Scalar> bounds;
  Scalar turn = 0;   ///< of both bodies over the whole duration, rad
  Scalar radii = 0;  ///< R: sum of the radii
};

/// c[0] + c[1] h + ... + c[6] h^6.
template <class Scalar>
using Polynomial = std::array<Scalar, 7>;

/// Expansions of the polynomials in one certificate, at most.
inline constexpr int kMaxRounds = 4;

/// Growth of the window from one expansion to the next, over the step that the last one proved.
template <class Scalar>
inline constexpr Scalar kWindowGrowth = Scalar(4);

/// Turn, rad, within which the polynomials say something: the window of the first expansion.
template <class Scalar>
inline constexpr Scalar kWindowTurn = Scalar(2);

/// An expansion that gains less than this share of the step so far is the last one.
template <class Scalar>
inline constexpr Scalar kLeastGain = Scalar(1) / 16;

/// direction . expansion, divided by the factorials: a polynomial of degree 3 in h.
template <class Scalar>
std::array<Scalar, 4> along(const Vec3<Scalar>& direction, const EndExpansion<Scalar>& end) {
  return {direction.dot(end[0]), direction.dot(end[1]), direction.dot(end[2]) / 2,
          direction.dot(end[3]) / 6};
}

/// N(h) . (expansion of the end).
template <class Scalar>
Polynomial<Scalar> height(const NormalPath<Scalar>& N, const EndExpansion<Scalar>& end) {
  const std::array<Scalar, 4> n = along(N.n, end);
  const std::array<Scalar, 4> m = along(N.m, end);
  const std::array<Scalar, 4> m2 = along(N.m2, end);
  return {
      n[0],      n[1] + m[0], n[2] + m[1] + m2[0] / 2, n[3] + m[2] + m2[1] / 2, m[3] + m2[2] / 2,
      m2[3] / 2, Scalar(0)};
}

/// What is taken off every N.(q - p): R |N|, the terms of the motion beyond the third, and what
/// rounding may have done to all of them.
template <class Scalar>
Polynomial<Scalar> toll(const NormalPath<Scalar>& N, const PairExpansion<Scalar>& pair) {
  const Scalar m = kRoundUp<Scalar> * length(N.m);
  const Scalar m2 = kRoundUp<Scalar> * length(N.m2) / 2;
  const Scalar e0 = kInflation<Scalar> * pair.bounds.length;
  const Scalar e1 = kInflation<Scalar> * pair.bounds.speed;
  const Scalar e2 = kInflation<Scalar> * pair.bounds.acceleration / 2;
  const Scalar e3 = kInflation<Scalar> * pair.bounds.jerk / 6;
  const Scalar e4 = pair.bounds.snap / 24;
  const Scalar R = pair.radii;
  return {R + e0,
          e1 + m * e0,
          e2 + m * e1 + m2 * e0 + R * m * m / 2,
          e3 + m * e2 + m2 * e1 + R * m * m2,
          e4 + m * e3 + m2 * e2 + R * m2 * m2 / 2,
          m * e4 + m2 * e3,
          m2 * e4};
}

/// Lower bounds of N.(q_j - p_i) - R |N|.
template <class Scalar>
std::array<Polynomial<Scalar>, 4> clearances(const NormalPath<Scalar>& N,
                                             const PairExpansion<Scalar>& pair) {
  const std::array<Polynomial<Scalar>, 2> p = {height(N, pair.A[0]), height(N, pair.A[1])};
  const std::array<Polynomial<Scalar>, 2> q = {height(N, pair.B[0]), height(N, pair.B[1])};
  const Polynomial<Scalar> off = toll(N, pair);
  std::array<Polynomial<Scalar>, 4> f;
  for (std::size_t i = 0; i < 4; ++i) {    // Bound: four pairs of ends
    for (std::size_t k = 0; k < 7; ++k) {  // Bound: the coefficients
      f[i][k] = (q[i % 2][k] - p[i / 2][k]) - off[k];
    }
  }
  return f;
}

/// A number that (f(h) - f[0] - f[1] h) / h^2 is nowhere below on [0, window].
template <class Scalar>
Scalar least_bend(const Polynomial<Scalar>& f, Scalar window) {
  Scalar sum = 0;
  for (std::size_t k = 6; k > 2; --k) {  // Bound: the coefficients
    sum = (sum + min_of(f[k], Scalar(0))) * window;
  }
  return f[2] + sum;
}

/// First root of c0 + c1 h + bend h^2, without cancellation. @pre c0 > 0, and there is one
template <class Scalar>
Scalar first_root(Scalar c0, Scalar c1, Scalar bend) {
  if (!(bend < Scalar(0))) return -c0 / c1;  // the tangent: below a parabola that opens upwards
  const Scalar root = std::sqrt(c1 * c1 - 4 * (bend * c0));
  return c1 < Scalar(0) ? 2 * c0 / (root - c1) : (c1 + root) / (-2 * bend);
}

/// The longest stretch of [0, window] on which the bound of f from its first three terms is
/// positive.
template <class Scalar>
Scalar positive_stretch(const Polynomial<Scalar>& f, Scalar window) {
  if (!(f[0] > Scalar(0))) return Scalar(0);
  const Scalar bend = least_bend(f, window);
  const Scalar least = f[0] + window * (min_of(f[1], Scalar(0)) + window * min_of(bend, Scalar(0)));
  if (least > Scalar(0)) return window;
  const Scalar root = kRoundDown<Scalar> * first_root(f[0], f[1], bend);
  return root > Scalar(0) ? min_of(root, window) : Scalar(0);
}

/// f(h) -> f(h + step). Bound: the coefficients, twice.
template <class Scalar>
void move_origin(Polynomial<Scalar>& f, Scalar step) {
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t k = 6; k > i; --k) f[k - 1] += step * f[k];
  }
}

/// How long N proves the pair free, at most `rest`; 0: it proves nothing.
/// Bound: kMaxRounds expansions of four polynomials.
template <class Scalar>
Scalar proven_free(const NormalPath<Scalar>& N, const PairExpansion<Scalar>& pair, Scalar rest) {
  std::array<Polynomial<Scalar>, 4> f = clearances(N, pair);
  Scalar proven = 0;
  Scalar window = pair.turn * rest > kWindowTurn<Scalar> ? kWindowTurn<Scalar> / pair.turn : rest;
  for (int round = 0; round < kMaxRounds; ++round) {  // Bound: kMaxRounds
    Scalar step = window;
    for (const Polynomial<Scalar>& g : f) step = positive_stretch(g, step);  // Bound: four
    proven += step;
    if (!(step > kLeastGain<Scalar> * proven) || !(proven < rest)) break;
    for (Polynomial<Scalar>& g : f) move_origin(g, step);  // Bound: four
    window = min_of(rest - proven, kWindowGrowth<Scalar> * step);
  }
  return min_of(proven, rest);
}

}  // namespace batuta
