// SPDX-License-Identifier: MIT
#pragma once
// A pair in motion, expanded about one instant theta in [0, 1]: the unit of time is the duration,
// so that velocities are travels and angular velocities turns, and no power of a rate overflows.
// Derivation: advancement.md, "Motion".

#include <array>

#include "batuta/detection/advancement.hpp"
#include "round_up.hpp"

namespace batuta {

/// An end: where it is, and what turns. Its derivatives in theta are
///   travel + turn side, -turn^2 arm, -turn^3 side.
template <class Scalar>
struct EndState {
  Vec3<Scalar> p;
  Vec3<Scalar> arm;   ///< from the axis of rotation to the end
  Vec3<Scalar> side;  ///< axis of rotation x arm
};

/// One axis at one instant.
template <class Scalar>
struct AxisState {
  std::array<EndState<Scalar>, 2> ends;
  Vec3<Scalar> travel;
  Scalar turn = 0;

  /// From end 0 to end 1, and the first two derivatives of that vector.
  Vec3<Scalar> direction() const { return ends[1].p - ends[0].p; }
  Vec3<Scalar> direction_rate() const { return turn * (ends[1].side - ends[0].side); }
  Vec3<Scalar> direction_bend() const { return -(turn * turn) * (ends[1].arm - ends[0].arm); }
  /// Velocity of the point with parameter s.
  Vec3<Scalar> rate(Scalar s) const {
    return travel + turn * (ends[0].side + s * (ends[1].side - ends[0].side));
  }
  /// Acceleration of the point with parameter s.
  Vec3<Scalar> bend(Scalar s) const {
    return -(turn * turn) * (ends[0].arm + s * (ends[1].arm - ends[0].arm));
  }
};

/// What holds for the difference of any two points of the axes, at every time.
template <class Scalar>
struct DerivativeBounds {
  Scalar length = 0;        ///< the difference itself
  Scalar speed = 0;         ///< its first derivative
  Scalar acceleration = 0;  ///< its second
  Scalar jerk = 0;          ///< its third
  Scalar snap = 0;          ///< its fourth
};

/// L, m: all lengths of the query, and how far turning could take each reach.
template <class Scalar>
Scalar query_length(const MovingPair<Scalar>& pair) {
  const Scalar arc_A = pair.A.turn_rate * pair.duration * pair.A.reach;
  const Scalar arc_B = pair.B.turn_rate * pair.duration * pair.B.reach;
  return kRoundUp<Scalar> * (pair.scale + (arc_A + arc_B));
}

/// Whether a search with these options makes sense; see search_advancement() for what does not.
template <class Scalar>
bool can_be_searched(const MovingPair<Scalar>& pair, const AdvancementOptions<Scalar>& options);

template <class Scalar>
CapsulePath<Scalar> in_units(CapsulePath<Scalar> path, Scalar duration, Scalar scale) {
  for (EndPath<Scalar>& end : path.ends) {  // Bound: two ends
    end.start *= scale;
    end.arm *= scale;
    end.side *= scale;
  }
  path.v = (path.v * duration) * scale;
  path.turn_rate *= duration;
  path.reach *= scale;
  path.longest_arm *= scale;
  path.radius *= scale;
  return path;
}

/// The same query in units of its duration and of 1 / scale metres.
template <class Scalar>
MovingPair<Scalar> in_units(const MovingPair<Scalar>& pair, Scalar scale) {
  MovingPair<Scalar> unit;
  unit.A = in_units(pair.A, pair.duration, scale);
  unit.B = in_units(pair.B, pair.duration, scale);
  unit.duration = 1;
  unit.scale = pair.scale * scale;
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

/// How long until a gap that falls at `rate` and bends up by `bend` is zero, or least where it is
/// not going to be; 0 for a gap that does not fall.
template <class Scalar>
Scalar time_to_contact(Scalar gap, Scalar rate, Scalar bend) {
  if (!(rate < Scalar(0)) || !(gap > Scalar(0))) return Scalar(0);
  const Scalar square = rate * rate - 2 * (bend * gap);
  return square > Scalar(0) ? 2 * gap / (std::sqrt(square) - rate) : -rate / bend;
}

/// Bounds for axes whose ends swing on these radii. @param pair  in units of its duration
/// @param travel  length of B's
template <class Scalar>
DerivativeBounds<Scalar> derivative_bounds(const MovingPair<Scalar>& pair, Scalar travel,
                                           Scalar radius_A, Scalar radius_B) {
  const Scalar turn_A = pair.A.turn_rate;
  const Scalar turn_B = pair.B.turn_rate;
  const Scalar up = kRoundUp<Scalar>;
  DerivativeBounds<Scalar> bounds;
  Scalar A = up * (turn_A * radius_A);
  Scalar B = up * (turn_B * radius_B);
  bounds.length = up * (pair.scale + (A + B));
  bounds.speed = up * (travel + (A + B));
  A *= turn_A;
  B *= turn_B;
  bounds.acceleration = up * (A + B);
  A *= turn_A;
  B *= turn_B;
  bounds.jerk = up * (A + B);
  bounds.snap = up * (A * turn_A + B * turn_B);
  return bounds;
}

/// @param path  in units of its duration
template <class Scalar>
AxisState<Scalar> state_at(const CapsulePath<Scalar>& path, Scalar theta) {
  const Scalar turn = path.turn_rate;
  const Scalar angle = turn * theta;
  const SinCos<Scalar> at = angle > Scalar(0) ? sin_cos(angle) : SinCos<Scalar>{};
  AxisState<Scalar> axis;
  axis.travel = path.v;
  axis.turn = turn;
  for (std::size_t i = 0; i < 2; ++i) {  // Bound: two ends
    const EndPath<Scalar>& end = path.ends[i];
    axis.ends[i].p = end.start + (path.v * theta + (at.sin * end.side - (1 - at.cos) * end.arm));
    axis.ends[i].arm = at.cos * end.arm + at.sin * end.side;
    axis.ends[i].side = at.cos * end.side - at.sin * end.arm;
  }
  return axis;
}

}  // namespace batuta
