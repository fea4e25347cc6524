// SPDX-License-Identifier: MIT
#pragma once
// What makes a touch: the point, from outside, along the blade, by a hand that has its weapon in
// its power (src/fencing/touch.md). Frame W, SI units.

#include "batuta/fencing/duel_scene.hpp"

namespace batuta::fencing::detail {

/// A part that the point has entered without a touch is closed until the point is so far from it,
/// m.
template <class Scalar>
inline constexpr Scalar kPointIsOut = Scalar(0.004F);

/// Of a capsule's axis, m.
template <class Scalar>
Scalar length_of(const Capsule<Scalar>& capsule) {
  return (capsule.axis.b - capsule.axis.a).norm();
}

/// How much of a blade is its point of this length: all of one that is no longer. @pre length > 0
template <class Scalar>
Scalar share_of_point(const Capsule<Scalar>& blade_B, Scalar length) {
  const Scalar whole = length_of(blade_B);
  return whole > length ? length / whole : Scalar(1);
}

/// The end of a blade that touches. @pre length > 0
template <class Scalar>
Capsule<Scalar> point_of(const Capsule<Scalar>& blade_B, Scalar length) {
  const Vec3<Scalar> way_B = blade_B.axis.b - blade_B.axis.a;
  const Scalar share = share_of_point(blade_B, length);
  return {{blade_B.axis.b - share * way_B, blade_B.axis.b}, blade_B.radius};
}

/// Along the blade, from hand to tip, how fast its point goes into a part of the other's body where
/// they meet, m/s.
template <class Scalar>
Scalar entry_speed(const MovingCapsule<Scalar>& point, const MovingCapsule<Scalar>& part,
                   const TouchSearch<Scalar>& found, Scalar from) {
  const auto velocity = [&found](const Motion<Scalar>& motion, Scalar t) -> Vec3<Scalar> {
    const Vec3<Scalar> arm_W = found.contact.point_W - pose_at(motion, t).p_W;
    return motion.twist.v_W + motion.twist.w_W.cross(arm_W);
  };
  const Scalar t = min_of(found.t_free - from, point.motion.duration);
  const Vec3<Scalar> along_B = (point.capsule_B.axis.b - point.capsule_B.axis.a).normalized();
  const Vec3<Scalar> along_W = pose_at(point.motion, t).q_WB * along_B;
  const Scalar part_t = min_of(found.t_free, part.motion.duration);
  return along_W.dot(velocity(point.motion, t) - velocity(part.motion, part_t));
}

/// What a hand has of its weapon in a step.
template <class Scalar>
struct Command {
  Scalar control = 1;     ///< at the start of the step
  Scalar first_blow = 0;  ///< when a blow took it, s
  Scalar slip = 0;        ///< from the grip to where the hand wants it, at the end, m
};

/// Whether the point's entry at this time and speed is a touch.
template <class SceneT>
bool counts(const TouchSettings<SceneT>& rule, const Command<typename SceneT::Scalar>& hand,
            typename SceneT::Scalar time, typename SceneT::Scalar speed) {
  using Scalar = typename SceneT::Scalar;
  const Scalar control = time <= hand.first_blow ? hand.control : Scalar(0);
  return speed >= rule.least_speed && control >= rule.least_control &&
         hand.slip <= rule.largest_slip;
}

}  // namespace batuta::fencing::detail
