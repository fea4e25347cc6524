// SPDX-License-Identifier: MIT
#pragma once
// How long a normal that moves proves a pair free. For every path N(h) of a
// vector that is nowhere zero, gap(h) >= min over the ends i of A and j of B of
// N.(q_j - p_i) / |N| - R. Each N.(q_j - p_i) - R |N| is bounded from below by
// a polynomial in h; the pair is free as long as all four are positive.
// Derivation and proof: advancement.md.

#include "expansion.hpp"

namespace batuta {

/// Two axes at one instant, and what is known of them at all others.
template <class Scalar>
struct PairState {
  AxisState<Scalar> A;
  AxisState<Scalar> B;
  Vec3<Scalar> travel;  ///< of B over the duration
  TurnPowers<Scalar> turn_A;
  TurnPowers<Scalar> turn_B;
  TermBounds<Scalar> bounds;      ///< of the motion
  TermBounds<Scalar> magnitudes;  ///< inflated: what rounding may do to each term
};

/// Expansions of the polynomials in one certificate, at most.
inline constexpr int kMaxRounds = 4;

/// Growth of the window from one expansion to the next, over the step that the
/// last one proved.
template <class Scalar>
inline constexpr Scalar kWindowGrowth = Scalar(4);

/// Turn, rad, within which the polynomials say something: no certificate goes
/// beyond.
template <class Scalar>
inline constexpr Scalar kHorizonTurn = Scalar(3);

/// An expansion that gains less than this share of the step so far is the last
/// one.
template <class Scalar>
inline constexpr Scalar kLeastGain = Scalar(1) / 16;

/// c[0] + c[1] h + c[2] h^2 + c[3] h^3.
template <class Scalar>
using Cubic = std::array<Scalar, 4>;

/// One for each end of an axis.
template <class Scalar>
using EndCubics = std::array<Cubic<Scalar>, 2>;

/// Lower bounds of N.(q_j - p_i) - R |N|: the polynomial of end j of B less
/// that of end i of A, and `fourth` h^4.
template <class Scalar>
struct Clearances {
  EndCubics<Scalar> A;  ///< heights N.p of the ends
  EndCubics<Scalar> B;  ///< the same, less a toll
  Scalar fourth;
};

/// Heights of both ends of an axis along n, held fixed.
template <class Scalar>
void set_heights(EndCubics<Scalar>& heights, const Vec3<Scalar>& n, Scalar travel,
                 const AxisState<Scalar>& state, const TurnPowers<Scalar>& turn) {
  for (std::size_t i = 0; i < 2; ++i) {  // Bound: two ends
    const Scalar side = n.dot(state.side[i]);
    heights[i][0] = n.dot(state.p[i]);
    heights[i][1] = travel + turn.turn * side;
    heights[i][2] = -turn.half_square * n.dot(state.arm[i]);
    heights[i][3] = -turn.sixth_cube * side;
  }
}

/// What a rate m of the normal adds to them.
template <class Scalar>
void add_rate(EndCubics<Scalar>& heights, const Vec3<Scalar>& m, Scalar travel,
              const AxisState<Scalar>& state, const TurnPowers<Scalar>& turn) {
  for (std::size_t i = 0; i < 2; ++i) {  // Bound: two ends
    heights[i][1] += m.dot(state.p[i]);
    heights[i][2] += travel + turn.turn * m.dot(state.side[i]);
    heights[i][3] -= turn.half_square * m.dot(state.arm[i]);
  }
}

/// What a bend m2 h^2 of the normal adds to them.
template <class Scalar>
void add_bend(EndCubics<Scalar>& heights, const Vec3<Scalar>& m2, Scalar travel,
              const AxisState<Scalar>& state, const TurnPowers<Scalar>& turn) {
  for (std::size_t i = 0; i < 2; ++i) {  // Bound: two ends
    heights[i][2] += m2.dot(state.p[i]);
    heights[i][3] += travel + turn.turn * m2.dot(state.side[i]);
  }
}

/// The clearances along a unit vector n, held fixed.
/// @param R  what the distance of the axes has to exceed: the sum of the radii,
/// or more
template <class Scalar>
void hold(Clearances<Scalar>& f, const Vec3<Scalar>& n, const PairState<Scalar>& pair, Scalar R) {
  set_heights(f.A, n, Scalar(0), pair.A, pair.turn_A);
  set_heights(f.B, n, n.dot(pair.travel), pair.B, pair.turn_B);
  for (Cubic<Scalar>& b : f.B) {  // Bound: two ends
    b[0] -= R + pair.magnitudes.length;
    b[1] -= pair.magnitudes.speed;
    b[2] -= pair.magnitudes.half_second;
    b[3] -= pair.magnitudes.sixth_third;
  }
  f.fourth = -(pair.bounds.last_fourth + pair.magnitudes.last_fourth);
}

/// N(h) = n + m h + m2 h^2, n a unit vector: what is taken off for m and m2 on
/// [0, horizon], R |N| and all terms that heights leave out. Terms beyond the
/// fourth are taken at the horizon.
template <class Scalar>
struct NormalMotion {
  Vec3<Scalar> m;
  Vec3<Scalar> m2;
};

template <class Scalar>
void take_toll(Clearances<Scalar>& f, const Vec3<Scalar>& n, const NormalMotion<Scalar>& N,
               const PairState<Scalar>& pair, Scalar R, Scalar horizon) {
  const TermBounds<Scalar>& bounds = pair.bounds;
  const TermBounds<Scalar>& size = pair.magnitudes;
  const Scalar m = kRoundUp<Scalar> * std::sqrt(N.m.squaredNorm());
  const Scalar m2 = kRoundUp<Scalar> * std::sqrt(N.m2.squaredNorm());
  const Scalar first = m * size.length + R * n.dot(N.m);
  const Scalar second = m * size.speed + m2 * size.length + R * (m * m / 2 + n.dot(N.m2));
  const Scalar third = m * size.half_second + m2 * size.speed + R * m * m2;
  for (Cubic<Scalar>& b : f.B) {  // Bound: two ends
    b[1] -= first;
    b[2] -= second;
    b[3] -= third;
  }
  const Scalar all_third = bounds.sixth_third + size.sixth_third;
  const Scalar all_second = bounds.half_second + size.half_second;
  const Scalar all_fourth = -f.fourth;
  const Scalar fourth = m * all_third + m2 * all_second;
  const Scalar fifth = m * all_fourth + m2 * all_third;
  const Scalar sixth = m2 * all_fourth;
  f.fourth -= fourth + horizon * (fifth + horizon * sixth) + R * m2 * m2 / 2;
}

/// First root of c0 + c1 h + bend h^2, without cancellation; no number, or none that is finite,
/// where a coefficient or the discriminant is not. @pre c0 > 0, and there is one
template <class Scalar>
Scalar first_root(Scalar c0, Scalar c1, Scalar bend) {
  if (bend >= Scalar(0)) return -c0 / c1;  // the tangent: below a parabola that opens upwards
  const Scalar root = std::sqrt(c1 * c1 - 4 * (bend * c0));
  return c1 < Scalar(0) ? 2 * c0 / (root - c1) : (c1 + root) / (-2 * bend);
}

/// min(x, 0), without a comparison; exact.
template <class Scalar>
inline Scalar falling(Scalar x) {
  return (x - std::abs(x)) * Scalar(0.5);
}

template <class Scalar>
inline Cubic<Scalar> difference(const Cubic<Scalar>& x, const Cubic<Scalar>& y) {
  return {x[0] - y[0], x[1] - y[1], x[2] - y[2], x[3] - y[3]};
}

/// A stretch of [0, window] on which a polynomial is positive: where its
/// tangent, and the least bend that it has on the window, say so.
template <class Scalar>
[[gnu::noinline]] Scalar positive_stretch(Cubic<Scalar> c, Scalar fourth, Scalar window) {
  const Scalar zero = 0;
  const Scalar bend = c[2] + window * (falling(c[3]) + window * fourth);
  const Scalar least = c[0] + window * (falling(c[1]) + window * falling(bend));
  if (least > zero) return window;
  if (!(c[0] > zero)) return zero;
  const Scalar root = kRoundDown<Scalar> * first_root(c[0], c[1], bend);
  // A discriminant that overflows makes a root of infinity, which proves nothing.
  const bool proves = root > zero && root <= std::numeric_limits<Scalar>::max();
  return proves ? min_of(root, window) : zero;
}

/// Whether a polynomial is nowhere negative on [0, window], told by its first coefficient alone.
template <class Scalar>
bool stays_above(const Cubic<Scalar>& c, Scalar window) {
  const Scalar lost =
      window * (std::abs(c[1]) + window * (std::abs(c[2]) + window * std::abs(c[3])));
  return kRoundDown<Scalar> * c[0] >= lost;
}

/// The same of all four, the least at the start first: what that proves is window enough for the
/// others, and an end that stays behind the other one of its axis need not be asked.
template <class Scalar>
Scalar positive_stretch(const Clearances<Scalar>& f, Scalar window) {
  const std::size_t low = f.B[1][0] < f.B[0][0] ? 1 : 0;
  const std::size_t high = f.A[0][0] < f.A[1][0] ? 1 : 0;
  const Cubic<Scalar>& a = f.A[high];
  const Cubic<Scalar>& b = f.B[low];
  const Cubic<Scalar>& other_a = f.A[1 - high];
  const Cubic<Scalar>& other_b = f.B[1 - low];
  window = positive_stretch(difference(b, a), f.fourth, window);
  const bool asks_a = !stays_above(difference(a, other_a), window);
  const bool asks_b = !stays_above(difference(other_b, b), window);
  if (asks_a) window = positive_stretch(difference(b, other_a), f.fourth, window);
  if (asks_b) window = positive_stretch(difference(other_b, a), f.fourth, window);
  if (!asks_a || !asks_b) return window;
  return positive_stretch(difference(other_b, other_a), f.fourth, window);
}

/// c(h) + fourth h^4 -> the same of h + step, in powers of h.
template <class Scalar>
void move_origin(Cubic<Scalar>& c, Scalar fourth, Scalar step) {
  Scalar c3 = c[3] + step * fourth;
  Scalar c2 = c[2] + step * c3;
  Scalar c1 = c[1] + step * c2;
  c[0] += step * c1;
  c3 += step * fourth;
  c2 += step * c3;
  c[1] = c1 + step * c2;
  c3 += step * fourth;
  c[2] = c2 + step * c3;
  c[3] = c3 + step * fourth;
}

/// The part of [0, rest] that one certificate looks at.
template <class Scalar>
Scalar horizon_of(const PairState<Scalar>& pair, Scalar rest) {
  const Scalar turn = pair.turn_A.turn + pair.turn_B.turn;
  const bool turns_far = turn * rest > kHorizonTurn<Scalar>;
  return turns_far ? kHorizonTurn<Scalar> / turn : rest;
}

/// How much of [0, horizon] is proven free by these clearances, which it uses
/// up. Bound: kMaxRounds expansions.
template <class Scalar>
Scalar proven_free(Clearances<Scalar>& f, Scalar horizon) {
  Scalar step = positive_stretch(f, horizon);
  Scalar proven = step;
  for (int round = 1; round < kMaxRounds; ++round) {  // Bound: kMaxRounds
    if (!(step > kLeastGain<Scalar> * proven) || !(proven < horizon)) break;
    for (std::size_t i = 0; i < 2; ++i) {  // Bound: two ends
      move_origin(f.A[i], Scalar(0), step);
      move_origin(f.B[i], f.fourth, step);
    }
    step = positive_stretch(f, min_of(horizon - proven, kWindowGrowth<Scalar> * step));
    proven += step;
  }
  return min_of(proven, horizon);
}

}  // namespace batuta
