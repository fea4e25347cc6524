// SPDX-License-Identifier: MIT
#pragma once
// A pair in motion, expanded about one instant theta in [0, 1]: the unit of
// time is the duration, so that velocities are travels and angular velocities
// turns, and no power of a rate overflows. Derivation: advancement.md,
// "Motion".

#include <array>

#include "batuta/detection/advancement.hpp"
#include "round_up.hpp"

namespace batuta {

/// One axis at one instant. The derivatives of an end in theta are
///   travel + turn side, -turn^2 arm, -turn^3 side.
template <class Scalar>
struct AxisState {
  std::array<Vec3<Scalar>, 2> p;     ///< the ends
  std::array<Vec3<Scalar>, 2> arm;   ///< from the axis of rotation to the end
  std::array<Vec3<Scalar>, 2> side;  ///< axis of rotation x arm

  Segment<Scalar> axis() const { return {p[0], p[1]}; }
  Vec3<Scalar> direction() const { return p[1] - p[0]; }
};

/// The turn over the duration, rad, and its powers as they stand in a Taylor
/// polynomial.
template <class Scalar>
struct TurnPowers {
  Scalar turn;
  Scalar half_square;
  Scalar sixth_cube;

  explicit TurnPowers(Scalar angle)
      : turn(angle), half_square(angle * angle / 2), sixth_cube(half_square * angle / 3) {}
};

/// What holds for the difference of any two points of the axes, at every time:
/// bounds of the terms of its Taylor polynomial.
template <class Scalar>
struct TermBounds {
  Scalar length;       ///< of the difference itself
  Scalar speed;        ///< of its first derivative
  Scalar half_second;  ///< of its second, / 2
  Scalar sixth_third;  ///< of its third, / 6
  Scalar last_fourth;  ///< of its fourth, / 24
};

/// L, m: all lengths of the query, and how far turning could take each bounding radius.
template <class Scalar>
Scalar query_length(const MovingPair<Scalar>& pair) {
  const Scalar arc_A = pair.A.turn_rate * pair.duration * pair.A.bounding_radius;
  const Scalar arc_B = pair.B.turn_rate * pair.duration * pair.B.bounding_radius;
  return kRoundUp<Scalar> * (pair.scale + (arc_A + arc_B));
}

/// Whether a search with these options makes sense; see search_advancement()
/// for what does not.
template <class Scalar>
bool can_be_searched(const MovingPair<Scalar>& pair, const AdvancementOptions<Scalar>& options);

template <class Scalar>
void to_units(detail::CapsulePath<Scalar>& path, Scalar duration, Scalar scale) {
  for (detail::EndPath<Scalar>& end : path.ends) {  // Bound: two ends
    end.start *= scale;
    end.arm *= scale;
    end.side *= scale;
  }
  path.v = (path.v * duration) * scale;
  path.turn_rate *= duration;
  path.bounding_radius *= scale;
  path.longest_arm *= scale;
  path.radius *= scale;
}

/// The same query in units of its duration and of 1 / scale metres.
template <class Scalar>
MovingPair<Scalar> in_units(const MovingPair<Scalar>& pair, Scalar scale) {
  MovingPair<Scalar> unit = pair;
  to_units(unit.A, pair.duration, scale);
  to_units(unit.B, pair.duration, scale);
  unit.duration = 1;
  unit.scale *= scale;
  return unit;
}

/// Closest points of a query in such units, in metres.
template <class Scalar>
ClosestPoints<Scalar> in_metres(ClosestPoints<Scalar> closest, Scalar scale) {
  if (scale == Scalar(1)) return closest;
  closest.p_A /= scale;
  closest.p_B /= scale;
  closest.distance /= scale;
  return closest;
}

/// How long until a gap that falls at `rate` and bends up by `bend` is zero, or
/// least where it is not going to be; 0 for a gap that does not fall, never less:
/// where both products underflow, `bend` may have either sign.
template <class Scalar>
Scalar time_to_contact(Scalar gap, Scalar rate, Scalar bend) {
  if (!(rate < Scalar(0)) || !(gap > Scalar(0))) return Scalar(0);
  const Scalar square = rate * rate - 2 * (bend * gap);
  return square > Scalar(0) ? 2 * gap / (std::sqrt(square) - rate)
                            : max_of(Scalar(0), -rate / bend);
}

/// How far an end swings, and what of that its derivatives see.
template <class Scalar>
struct Swing {
  Scalar turn;    ///< over the duration, rad
  Scalar radius;  ///< at most, m
};

/// Bounds for axes whose ends swing like this. @param scale  of the pair;
/// @param travel  length of B's
template <class Scalar>
TermBounds<Scalar> term_bounds(Scalar scale, Scalar travel, const Swing<Scalar>& of_A,
                               const Swing<Scalar>& of_B) {
  const Scalar up = kRoundUp<Scalar>;
  TermBounds<Scalar> bounds;
  Scalar A = up * (of_A.turn * of_A.radius);
  Scalar B = up * (of_B.turn * of_B.radius);
  bounds.length = up * (scale + (A + B));
  bounds.speed = up * (travel + (A + B));
  A *= of_A.turn;
  B *= of_B.turn;
  bounds.half_second = up / 2 * (A + B);
  A *= of_A.turn;
  B *= of_B.turn;
  bounds.sixth_third = up / 6 * (A + B);
  bounds.last_fourth = up / 24 * (A * of_A.turn + B * of_B.turn);
  return bounds;
}

/// What turns of the axis point with parameter s.
template <class Scalar>
inline Vec3<Scalar> between(const std::array<Vec3<Scalar>, 2>& ends, Scalar s) {
  return ends[0] + s * (ends[1] - ends[0]);
}

/// The axis at theta = 0.
template <class Scalar>
AxisState<Scalar> state_at_start(const detail::CapsulePath<Scalar>& path) {
  const detail::EndPath<Scalar>& a = path.ends[0];
  const detail::EndPath<Scalar>& b = path.ends[1];
  return {{a.start, b.start}, {a.arm, b.arm}, {a.side, b.side}};
}

/// The axis at theta. @param travelled  what B has moved by until then, nothing
/// for A
/// @param angle  that it has turned by
template <class Scalar>
void set_state(AxisState<Scalar>& state, const detail::CapsulePath<Scalar>& path,
               const Vec3<Scalar>& travelled, Scalar angle) {
  const detail::SinCos<Scalar> at =
      angle > Scalar(0) ? detail::sin_cos(angle) : detail::SinCos<Scalar>{};
  const Scalar versine = 1 - at.cos;
  for (std::size_t i = 0; i < 2; ++i) {  // Bound: two ends
    const detail::EndPath<Scalar>& end = path.ends[i];
    const Vec3<Scalar> turned = at.sin * end.side - versine * end.arm;
    const Vec3<Scalar> arm = end.arm + turned;
    const Vec3<Scalar> side = at.cos * end.side - at.sin * end.arm;
    state.p[i] = end.start + (travelled + turned);
    state.arm[i] = arm;
    state.side[i] = side;
  }
}

}  // namespace batuta
