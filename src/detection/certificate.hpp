// SPDX-License-Identifier: MIT
#pragma once
// How long a normal that moves proves a pair free. For every path N(h) of a vector that is nowhere
// zero, gap(h) >= min over the ends i of A and j of B of N.(q_j - p_i) / |N| - R. Each N.(q_j -
// p_i)
// - R |N| is bounded from below by a polynomial in h; the pair is free as long as all four are
// positive. Derivation and proof: advancement.md.

#include "expansion.hpp"

namespace batuta {

/// N(h) = n + m h + m2 h^2 / 2, n a unit vector.
template <class Scalar>
struct NormalPath {
  Vec3<Scalar> n = Vec3<Scalar>::Zero();
  Vec3<Scalar> m = Vec3<Scalar>::Zero();
  Vec3<Scalar> m2 = Vec3<Scalar>::Zero();
};

/// Two axes at one instant, and what is known of them at all others.
template <class Scalar>
struct PairState {
  AxisState<Scalar> A;
  AxisState<Scalar> B;
  DerivativeBounds<Scalar> bounds;      ///< of the motion
  DerivativeBounds<Scalar> magnitudes;  ///< of what is rounded: the same with reaches for arms
  Scalar turn = 0;                      ///< of both bodies over the whole duration, rad
  Scalar inflation = 0;                 ///< kInflation; tests try less, to see that it is needed
};

/// Expansions of the polynomials in one certificate, at most.
inline constexpr int kMaxRounds = 4;

/// Growth of the window from one expansion to the next, over the step that the last one proved.
template <class Scalar>
inline constexpr Scalar kWindowGrowth = Scalar(4);

/// Turn, rad, within which the polynomials say something: no certificate goes beyond.
template <class Scalar>
inline constexpr Scalar kHorizonTurn = Scalar(3);

/// An expansion that gains less than this share of the step so far is the last one.
template <class Scalar>
inline constexpr Scalar kLeastGain = Scalar(1) / 16;

/// c[0] + c[1] h + c[2] h^2 + c[3] h^3.
template <class Scalar>
using Cubic = std::array<Scalar, 4>;

/// Heights of the ends along a normal path: N(h) . p(h), without what toll() accounts for.
template <class Scalar>
struct Heights {
  std::array<Cubic<Scalar>, 2> A;
  std::array<Cubic<Scalar>, 2> B;
};

/// Of both ends of an axis along n, held fixed.
template <class Scalar>
std::array<Cubic<Scalar>, 2> axis_heights(const Vec3<Scalar>& n, const AxisState<Scalar>& axis) {
  const Scalar travel = n.dot(axis.travel);
  const Scalar square = axis.turn * axis.turn;
  std::array<Cubic<Scalar>, 2> heights;
  for (std::size_t i = 0; i < 2; ++i) {  // Bound: two ends
    const EndState<Scalar>& end = axis.ends[i];
    const Scalar swing = axis.turn * n.dot(end.side);
    heights[i] = {n.dot(end.p), travel + swing, -square * n.dot(end.arm) / 2, -square * swing / 6};
  }
  return heights;
}

template <class Scalar>
Heights<Scalar> heights(const Vec3<Scalar>& n, const PairState<Scalar>& pair) {
  return {axis_heights(n, pair.A), axis_heights(n, pair.B)};
}

/// What the motion of the normal adds to the heights of an axis.
template <class Scalar>
void add_motion(std::array<Cubic<Scalar>, 2>& heights, const NormalPath<Scalar>& N,
                const AxisState<Scalar>& axis) {
  const Scalar travel = N.m.dot(axis.travel);
  const Scalar travel2 = N.m2.dot(axis.travel);
  const Scalar square = axis.turn * axis.turn;
  for (std::size_t i = 0; i < 2; ++i) {  // Bound: two ends
    const EndState<Scalar>& end = axis.ends[i];
    heights[i][1] += N.m.dot(end.p);
    heights[i][2] += travel + axis.turn * N.m.dot(end.side) + N.m2.dot(end.p) / 2;
    heights[i][3] += (travel2 + axis.turn * N.m2.dot(end.side) - square * N.m.dot(end.arm)) / 2;
  }
}

/// Along N, from the heights along N.n held fixed.
template <class Scalar>
Heights<Scalar> moved(const Heights<Scalar>& fixed, const NormalPath<Scalar>& N,
                      const PairState<Scalar>& pair) {
  Heights<Scalar> heights = fixed;
  add_motion(heights.A, N, pair.A);
  add_motion(heights.B, N, pair.B);
  return heights;
}

/// t[0] + t[1] h + ... + t[4] h^4.
template <class Scalar>
using Quartic = std::array<Scalar, 5>;

/// What is taken off every height difference: R |N|, all terms that heights leave out, and what
/// rounding may have done to the others. Along a fixed normal.
/// @param R  what the distance of the axes has to exceed: the sum of the radii, or more
template <class Scalar>
Quartic<Scalar> toll(const PairState<Scalar>& pair, Scalar R) {
  const DerivativeBounds<Scalar>& size = pair.magnitudes;
  const Scalar eps = pair.inflation;
  return {R + eps * size.length, eps * size.speed, eps * size.acceleration / 2, eps * size.jerk / 6,
          (1 + eps) * pair.bounds.snap / 24};
}

/// The same on [0, horizon] along a normal path; `fixed` is that of N.n. Terms beyond the fourth
/// are taken at the horizon.
template <class Scalar>
Quartic<Scalar> toll(const Quartic<Scalar>& fixed, const NormalPath<Scalar>& N,
                     const PairState<Scalar>& pair, Scalar R, Scalar horizon) {
  const DerivativeBounds<Scalar>& bounds = pair.bounds;
  const DerivativeBounds<Scalar>& size = pair.magnitudes;
  const Scalar m = kRoundUp<Scalar> * N.m.norm();
  const Scalar half_m2 = kRoundUp<Scalar> * N.m2.norm() / 2;
  const Scalar eps = pair.inflation;
  const Scalar fourth = m * bounds.jerk / 6 + half_m2 * bounds.acceleration / 2;
  const Scalar fifth = m * bounds.snap / 24 + half_m2 * bounds.jerk / 6;
  const Scalar sixth = half_m2 * bounds.snap / 24;
  return {
      fixed[0], fixed[1] + eps * m * size.length + R * N.n.dot(N.m),
      fixed[2] + eps * (m * size.speed + half_m2 * size.length) + R * (m * m + N.n.dot(N.m2)) / 2,
      fixed[3] + eps * (m * size.acceleration / 2 + half_m2 * size.speed) + R * m * half_m2,
      fixed[4] + (1 + eps) * (fourth + horizon * (fifth + horizon * sixth)) +
          R * half_m2 * half_m2 / 2};
}

/// One number for each of the four pairs of ends.
template <class Scalar>
using Four = std::array<Scalar, 4>;

/// Lower bounds of N.(q_j - p_i) - R |N| on [0, horizon]: for each pair of ends a polynomial in h,
/// its coefficients side by side. The fourth is the same for all.
template <class Scalar>
struct Clearances {
  std::array<Four<Scalar>, 4> c;
  Scalar fourth = 0;
};

template <class Scalar>
Clearances<Scalar> clearances(const Heights<Scalar>& heights, const Quartic<Scalar>& toll) {
  Clearances<Scalar> f;
  for (std::size_t k = 0; k < 4; ++k) {    // Bound: the coefficients
    for (std::size_t i = 0; i < 4; ++i) {  // Bound: four pairs of ends
      f.c[k][i] = (heights.B[i % 2][k] - heights.A[i / 2][k]) - toll[k];
    }
  }
  f.fourth = -toll[4];
  return f;
}

/// First root of c0 + c1 h + bend h^2, without cancellation. @pre c0 > 0, and there is one
template <class Scalar>
Scalar first_root(Scalar c0, Scalar c1, Scalar bend) {
  if (!(bend < Scalar(0))) return -c0 / c1;  // the tangent: below a parabola that opens upwards
  const Scalar root = std::sqrt(c1 * c1 - 4 * (bend * c0));
  return c1 < Scalar(0) ? 2 * c0 / (root - c1) : (c1 + root) / (-2 * bend);
}

/// A stretch of [0, window] on which all are positive: where the tangent of each, and the least
/// bend that it has on the window, say so.
template <class Scalar>
Scalar positive_stretch(const Clearances<Scalar>& f, Scalar window) {
  Four<Scalar> bend;
  Four<Scalar> least;
  for (std::size_t i = 0; i < 4; ++i) {  // Bound: four pairs of ends
    bend[i] = f.c[2][i] + window * (min_of(f.c[3][i], Scalar(0)) + window * f.fourth);
    least[i] =
        f.c[0][i] + window * (min_of(f.c[1][i], Scalar(0)) + window * min_of(bend[i], Scalar(0)));
  }
  Scalar stretch = window;
  for (std::size_t i = 0; i < 4; ++i) {  // Bound: four pairs of ends
    if (least[i] > Scalar(0)) continue;
    if (!(f.c[0][i] > Scalar(0))) return Scalar(0);
    const Scalar root = kRoundDown<Scalar> * first_root(f.c[0][i], f.c[1][i], bend[i]);
    stretch = root > Scalar(0) ? min_of(root, stretch) : Scalar(0);
  }
  return stretch;
}

/// f(h) -> f(h + step).
template <class Scalar>
void move_origin(Clearances<Scalar>& f, Scalar step) {
  for (std::size_t i = 0; i < 4; ++i) {  // Bound: four pairs of ends
    Scalar c3 = f.c[3][i] + step * f.fourth;
    Scalar c2 = f.c[2][i] + step * c3;
    Scalar c1 = f.c[1][i] + step * c2;
    f.c[0][i] += step * c1;
    c3 += step * f.fourth;
    c2 += step * c3;
    f.c[1][i] = c1 + step * c2;
    c3 += step * f.fourth;
    f.c[2][i] = c2 + step * c3;
    f.c[3][i] = c3 + step * f.fourth;
  }
}

/// The part of [0, rest] that one certificate looks at.
template <class Scalar>
Scalar horizon_of(const PairState<Scalar>& pair, Scalar rest) {
  const bool turns_far = pair.turn * rest > kHorizonTurn<Scalar>;
  return turns_far ? kHorizonTurn<Scalar> / pair.turn : rest;
}

/// How much of [0, horizon] is proven free by these clearances. Bound: kMaxRounds expansions.
template <class Scalar>
Scalar proven_free(Clearances<Scalar> f, Scalar horizon) {
  Scalar step = positive_stretch(f, horizon);
  Scalar proven = step;
  for (int round = 1; round < kMaxRounds; ++round) {  // Bound: kMaxRounds
    if (!(step > kLeastGain<Scalar> * proven) || !(proven < horizon)) break;
    move_origin(f, step);
    step = positive_stretch(f, min_of(horizon - proven, kWindowGrowth<Scalar> * step));
    proven += step;
  }
  return min_of(proven, horizon);
}

}  // namespace batuta
