// SPDX-License-Identifier: MIT
#pragma once
// Bodies that go on together, as one rigid body with their summed momenta (src/world/world.md,
// "Together"). Frame W, SI units. Called where an answer was not to be had: compiled for size.

#include <array>

#include "batuta/mechanics/motion.hpp"
#include "batuta/mechanics/straight.hpp"

namespace batuta::detail {

/// Several bodies as one rigid body, at one time.
template <class Scalar>
struct RigidGroup {
  Scalar mass = 0;
  Vec3<Scalar> center_W = zero<Scalar>();  ///< of mass
  Momentum<Scalar> momentum;               ///< summed; angular: about the centre
  /// About the centre: columns.
  std::array<Vec3<Scalar>, 3> inertia_W = {zero<Scalar>(), zero<Scalar>(), zero<Scalar>()};
  /// False: one of them cannot be turned about each axis, so they all cannot; or the angular
  /// momentum is beyond the numbers.
  bool turns = true;
};
/// Several bodies that do not turn.
template <class Scalar>
struct StraightGroup {
  Scalar mass = 0;
  Vec3<Scalar> momentum_W = zero<Scalar>();
};

/// Adds a body. @pre inverse mass > 0
template <class Scalar>
void add_to_group(RigidGroup<Scalar>& group, const Body<Scalar>& body);
template <class Scalar>
void add_to_group(StraightGroup<Scalar>& group, const StraightBody<Scalar>& body);

/// How the group goes on for `duration`, in a frame at its centre with the axes of W: by a constant
/// twist at whose end it has no more energy than before, but for rounding. Of second order in the
/// turn; none where that is half a turn or more, or no such turn is found. @pre mass > 0. Bound: 8
/// passes.
template <class Scalar>
Motion<Scalar> group_motion(const RigidGroup<Scalar>& group, Scalar duration);
template <class Scalar>
StraightMotion<Scalar> group_motion(const StraightGroup<Scalar>& group, Scalar duration);

/// Takes a body of a group from its place to that at the end.
/// @param from_W  the origin of the group's frame at first, when this had the axes of W
/// @param X_WG    its frame at the end
template <class Scalar>
void take_along(Body<Scalar>& body, const Vec3<Scalar>& from_W, const Pose<Scalar>& X_WG);

/// The angular momentum of a body that is taken along stays what it is as seen from the group.
template <class Scalar>
void turn_along(Body<Scalar>& body, const Pose<Scalar>& X_WG);

/// How the group moves about its centre, if its angular momentum is L. @pre mass > 0
template <class Scalar>
Twist<Scalar> group_twist(const RigidGroup<Scalar>& group, const Vec3<Scalar>& L_W);

/// Gives a body at its place in a group the momenta of this place, and takes them off what is left
/// of the group's. @param twist  of the group, at center_W  @pre inverse mass > 0
template <class Scalar>
void give_momentum(Body<Scalar>& body, const Vec3<Scalar>& center_W, const Twist<Scalar>& twist,
                   Momentum<Scalar>& left);

}  // namespace batuta::detail
