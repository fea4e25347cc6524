// SPDX-License-Identifier: MIT
#pragma once
// Whether a body keeps its place: the ends of the axes of its parts, and the skin about them; and
// what keeps it from doing so by itself (src/world/world.md, "Sleep"). Frame W, SI units.

#include "batuta/world/detail/contact_groups.hpp"

namespace batuta::detail {

/// How far the skin of a part has gone about the part's own axis, m: the ends of a ball's axis, and
/// of that of a rod that spins, stay where they are. Of a body of revolution the orientation shows
/// the spin that the whole would have with the moment across its axis (mechanics/motion.md).
template <class Scalar>
Scalar way_of_skin(const Capsule<Scalar>& part_B, const Body<Scalar>& body,
                   const Quat<Scalar>& from_WB) {
  const Vec3<Scalar> turn_B = 2 * (from_WB.conjugate() * body.X_WB.q_WB).vec();
  const Vec3<Scalar> along_B = part_B.axis.b - part_B.axis.a;
  const Scalar length = along_B.norm();
  if (!(length > Scalar(0))) return part_B.radius * turn_B.norm();
  const Vec3<Scalar> axis_B = along_B / length;
  const Scalar shown = part_B.radius * std::abs(turn_B.dot(axis_B));
  if (body.spin_shows) return shown;
  const Scalar about_axis = body.inverse_moments.dot(axis_B.cwiseAbs2());
  return shown * (2 * about_axis / (body.inverse_moments.sum() - about_axis));
}

/// Whether a body has gone further from a pose than `limit`, m. Bound: kCapsulesPerBody.
template <class SceneT>
bool has_gone(const Actor<SceneT>& actor, const Pose<typename SceneT::Scalar>& from_WB,
              typename SceneT::Scalar limit) {
  using Scalar = typename SceneT::Scalar;
  const auto is_far = [&](const Vec3<Scalar>& x_B) {
    const Vec3<Scalar> way = to_world(actor.body.X_WB, x_B) - to_world(from_WB, x_B);
    return way.squaredNorm() > limit * limit;
  };
  bool gone = false;
  for (int i = 0; i < parts_of(actor); ++i) {  // Bound: kCapsulesPerBody
    const Capsule<Scalar>& part = part_of(actor, i);
    gone = gone || is_far(part.axis.a) || is_far(part.axis.b);
    if constexpr (SceneT::kRotation) {
      gone = gone || way_of_skin(part, actor.body, from_WB.q_WB) > limit;
    }
  }
  return gone;
}

/// Whether a point of a body is faster than `limit`, m/s, or may be. Bound: kCapsulesPerBody.
template <class SceneT>
bool is_faster(const Actor<SceneT>& actor, typename SceneT::Scalar limit) {
  using Scalar = typename SceneT::Scalar;
  const Twist<Scalar> twist = twist_of(actor.body);
  bool is_fast = false;
  for (int i = 0; i < parts_of(actor); ++i) {  // Bound: kCapsulesPerBody
    const Capsule<Scalar>& part = part_of(actor, i);
    const Scalar skin = part.radius * length(twist.w_W);
    for (const auto& x_B : {part.axis.a, part.axis.b}) {  // Bound: 2
      const Vec3<Scalar> v_W = twist.v_W + twist.w_W.cross(actor.body.X_WB.q_WB * x_B);
      is_fast = is_fast || length(v_W) + skin > limit;
    }
  }
  return is_fast;
}

/// How fast a point of a body is that leaves its place, m/s: what rests is faster than rest now and
/// then, by no more than half of what gravity makes in a step. @param rest  what is rest, m/s
template <class SceneT>
Scalar_of<SceneT> leaving_speed(const Bodies<SceneT>& bodies, Scalar_of<SceneT> rest) {
  using Scalar = Scalar_of<SceneT>;
  constexpr Scalar kLeast = 2;  // times rest
  constexpr Scalar kMost = 8;
  Scalar swing = 0;
  if constexpr (SceneT::kGravity) swing = bodies.dt * length(bodies.settings.gravity_W) / 2;
  return clamp(swing, kLeast * rest, kMost * rest);
}

/// Whether the two of a contact are in each other. Its gaps are those of when it was looked at, and
/// of the ends of a line that its nearest point stands for: they may be less than any that there
/// is.
template <class SceneT>
bool is_in_another(const Bodies<SceneT>& bodies, const LastingContactOf<SceneT>& contact) {
  using Scalar = Scalar_of<SceneT>;
  if (!(least_gap(contact) < Scalar(0))) return false;
  const auto now =
      capsule_gap(bodies.shape_W(contact.pair.first), bodies.shape_W(contact.pair.second));
  return now.gap < Scalar(0);
}

/// Whether something is led elsewhere that a body touches.
template <class SceneT>
bool is_carried(const Bodies<SceneT>& bodies, std::size_t led, std::size_t slot) {
  return bodies.is_led(led) && !bodies.is_asleep(led) && !bodies.is_led(slot) &&
         !KinematicsOf<SceneT>::is_still(bodies.states[led].plan.motion);
}

}  // namespace batuta::detail
