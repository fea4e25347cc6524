// SPDX-License-Identifier: MIT
#pragma once
// Whether a body keeps its place: the ends of the axes of its parts, and the skin about them
// (src/world/world.md, "Sleep"). Frame W, SI units.

#include "batuta/world/actor.hpp"

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

}  // namespace batuta::detail
