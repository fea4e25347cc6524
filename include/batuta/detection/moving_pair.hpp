// SPDX-License-Identifier: MIT
#pragma once
// What a search is asked and what it answers: two capsules, each on a body that moves with a constant twist.
// The pair is seen from the centre of mass of A at t = 0, so that the distance from the world's origin costs no digits.

#include <array>

#include "batuta/geometry/capsule.hpp"
#include "batuta/mechanics/motion.hpp"

namespace batuta {

/// A capsule carried by a body in motion; the capsule in the body's frame.
template <class Scalar>
struct MovingCapsule {
  Capsule<Scalar> capsule_B;
  Motion<Scalar> motion;
};

/// Path of one end of a moving axis: center + v t + cos(w t) arm + sin(w t) side, about the common local origin
/// (src/detection/moving_pair.md).
template <class Scalar>
struct EndPath {
  Vec3<Scalar> center = Vec3<Scalar>::Zero();  ///< on the axis of rotation at t = 0, m
  Vec3<Scalar> arm = Vec3<Scalar>::Zero();     ///< from there to the end at t = 0, perpendicular to the axis
  Vec3<Scalar> side = Vec3<Scalar>::Zero();    ///< axis x arm
};

template <class Scalar>
struct CapsulePath {
  std::array<EndPath<Scalar>, 2> ends;
  Vec3<Scalar> v = Vec3<Scalar>::Zero();
  Scalar turn_rate = 0;  ///< |w|, rad/s
  Scalar radius = 0;
};

/// Two capsules over [0, duration], ready for evaluation at any instant.
template <class Scalar>
struct MovingPair {
  CapsulePath<Scalar> A;
  CapsulePath<Scalar> B;
  Vec3<Scalar> origin_W = Vec3<Scalar>::Zero();  ///< what was subtracted from all positions
  Scalar duration = 0;
  Scalar scale = 0;  ///< S: distance of the centres + relative travel + reaches + radii, m (an upper bound)
};

/// @returns kOk | kInvalidArgument: not finite, negative radius or duration, unequal durations, turn beyond kMaxAngle
template <class Scalar>
Result<MovingPair<Scalar>> make_moving_pair(const MovingCapsule<Scalar>& A, const MovingCapsule<Scalar>& B);

/// Both capsules at time t, relative to origin_W.
template <class Scalar>
struct CapsulesAt {
  Capsule<Scalar> A;
  Capsule<Scalar> B;
};
template <class Scalar>
CapsulesAt<Scalar> capsules_at(const MovingPair<Scalar>& pair, Scalar t);

/// One distance evaluation. @pre 0 <= t <= duration
template <class Scalar>
CapsuleGap<Scalar> gap_at(const MovingPair<Scalar>& pair, Scalar t);

enum class Outcome : std::uint8_t {
  kFree,      ///< no contact in [0, duration], as far as the method can see; t_free = duration
  kContact,   ///< free at t_free, in contact at t_hit
  kTouching,  ///< in contact at t = 0; t_free = t_hit = 0
  kBudget,    ///< free up to t_free, unknown after: stop there. Never to be taken for kFree
  kInvalid,   ///< the question makes no sense; nothing else in the answer is meaningful
};

template <class Scalar>
struct SearchResult {
  Outcome outcome = Outcome::kInvalid;
  Scalar t_free = 0;  ///< s, collision-free there
  Scalar t_hit = 0;   ///< s, >= t_free; duration for kFree and kBudget
  /// At t_free (kContact, kBudget, kFree) or at 0 (kTouching); points relative to the pair's origin_W.
  CapsuleGap<Scalar> witness;
  /// d gap / dt of the witness, m/s; negative: approaching.
  Scalar gap_rate = 0;
  std::uint32_t evaluations = 0;  ///< distance evaluations used
};

}  // namespace batuta
