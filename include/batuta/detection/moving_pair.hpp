// SPDX-License-Identifier: MIT
#pragma once
// What a search is asked and what it answers: two capsules, each on a body that moves with a
// constant twist. Frame P of a pair: axes of W, origin at origin_W + origin_v_W t, where A's centre
// of mass is at time t. Neither the distance from the world's origin nor a velocity that both
// bodies share costs digits.

#include <array>

#include "batuta/geometry/capsule.hpp"
#include "batuta/mechanics/motion.hpp"

namespace batuta {

/// A capsule carried by a body in motion; the capsule in the body's frame.
template <class Scalar>
struct MovingCapsule {
  Capsule<Scalar> capsule_B;  ///< in the frame of the body
  Motion<Scalar> motion;      ///< of the body over the time in question
};

namespace detail {

/// Path of one end of a moving axis: start + v t + (cos(w t) - 1) arm + sin(w t) side. At t = 0 it
/// is `start` to the last bit, and what a slow turn adds is as small as the turn
/// (src/detection/moving_pair.md).
template <class Scalar>
struct EndPath {
  Vec3<Scalar> start = zero<Scalar>();  ///< the end at t = 0, m
  Vec3<Scalar> arm = zero<Scalar>();    ///< from the axis of rotation to `start`, perpendicular
                                        ///< to that axis, m
  Vec3<Scalar> side = zero<Scalar>();   ///< axis of rotation x arm, m
};

/// Path of a capsule over a constant twist: those of the two ends of its axis, and what bounds
/// them.
template <class Scalar>
struct CapsulePath {
  std::array<EndPath<Scalar>, 2> ends;  ///< of axis.a and axis.b
  Vec3<Scalar> v = zero<Scalar>();      ///< of the centre of mass, m/s
  Scalar turn_rate = 0;                 ///< |w|, rad/s; 0: arms and sides are zero
  Scalar bounding_radius = 0;           ///< of the ends from the centre of mass, m, to within 3 u
  Scalar longest_arm = 0;  ///< of the two ends, m, to within 3 u; at most the bounding radius
  Scalar radius = 0;       ///< m
};

/// The path of a capsule seen from an origin that moves steadily, axes of W.
/// @param origin_W    the origin at t = 0, m
/// @param origin_v_W  its velocity, m/s
/// @pre `moving` valid: finite, radius >= 0, unit quaternion
/// Bound: two ends.
template <class Scalar>
CapsulePath<Scalar> capsule_path(const MovingCapsule<Scalar>& moving, const Vec3<Scalar>& origin_W,
                                 const Vec3<Scalar>& origin_v_W);

/// The capsule at time t in the frame of its path. One sine/cosine, none if it does not turn.
/// @pre t >= 0, turn_rate t <= kMaxAngle
template <class Scalar>
Capsule<Scalar> capsule_at(const CapsulePath<Scalar>& path, Scalar t);

}  // namespace detail

/// Two capsules over [0, duration], ready for evaluation at any instant, in the pair's frame P.
template <class Scalar>
struct MovingPair {
  detail::CapsulePath<Scalar> A;                     ///< v = 0
  detail::CapsulePath<Scalar> B;                     ///< v = v_B - v_A
  Vec3<Scalar> origin_W = detail::zero<Scalar>();    ///< A's centre of mass at t = 0, m
  Vec3<Scalar> origin_v_W = detail::zero<Scalar>();  ///< and its velocity, m/s
  Scalar duration = 0;                               ///< s
  /// S: distance of the centres + relative travel + bounding radii + radii, m (an upper bound)
  Scalar scale = 0;
};

/// Puts two moving capsules into their common frame.
/// @pre unit quaternions
/// @returns kOk | kInvalidArgument: not finite, negative radius or duration, unequal durations,
///   turn beyond kMaxAngle, or S beyond kLargestCoordinate
template <class Scalar>
Result<MovingPair<Scalar>> make_moving_pair(const MovingCapsule<Scalar>& A,
                                            const MovingCapsule<Scalar>& B);

namespace detail {

/// Both capsules at time t.
template <class Scalar>
struct CapsulesAt {
  Capsule<Scalar> A;  ///< in the pair's frame P
  Capsule<Scalar> B;  ///< in the pair's frame P
};

/// Both capsules at time t, in the pair's frame P. @pre 0 <= t <= duration
template <class Scalar>
CapsulesAt<Scalar> capsules_at(const MovingPair<Scalar>& pair, Scalar t);

}  // namespace detail

/// One distance evaluation. The points are relative to origin_W (the place of the frame's origin at
/// t = 0), ready for contact_from(). Error of the gap: src/detection/moving_pair.md.
/// @pre 0 <= t <= duration
template <class Scalar>
CapsuleGap<Scalar> gap_at(const MovingPair<Scalar>& pair, Scalar t);

/// The gap at time t whose closest points are already known in the pair's frame P.
/// @pre `axes` belongs to capsules_at(pair, t), 0 <= t <= duration
template <class Scalar>
CapsuleGap<Scalar> gap_at(const MovingPair<Scalar>& pair, const ClosestPoints<Scalar>& axes,
                          Scalar t);

namespace detail {

/// d gap / dt, m/s: how fast the material points at the closest parameters of `witness` part along
/// its normal.
/// @pre witness == gap_at(pair, t)
template <class Scalar>
Scalar gap_rate_at(const MovingPair<Scalar>& pair, const CapsuleGap<Scalar>& witness, Scalar t);

}  // namespace detail

/// What a search for the first contact in [0, duration] found.
enum class Outcome : std::uint8_t {
  kFree,      ///< no contact in [0, duration], as far as the method can see; t_free = duration
  kContact,   ///< free at t_free, in contact at t_hit
  kTouching,  ///< in contact at t_free = 0; t_hit, where later: the gap is foreseen to vanish
  kBudget,    ///< free up to t_free, unknown after: stop there. Never to be taken for kFree
  kInvalid,   ///< the question makes no sense; nothing else in the answer is meaningful
};

/// Answer of a search for the first contact in [0, duration] of a pair.
template <class Scalar>
struct SearchResult {
  Outcome outcome = Outcome::kInvalid;  ///< which of the members below mean what
  Scalar t_free = 0;                    ///< s, collision-free there
  Scalar t_hit = 0;                     ///< s, >= t_free; duration for kFree and kBudget
  /// At t_free (kContact, kBudget, kFree) or at 0 (kTouching); points relative to the pair's
  /// origin_W, axes of W.
  CapsuleGap<Scalar> witness;
  /// d gap / dt of the witness, m/s; negative: approaching.
  Scalar gap_rate = 0;
  std::uint32_t evaluations = 0;  ///< distance evaluations used
};

}  // namespace batuta
