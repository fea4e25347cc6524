// SPDX-License-Identifier: MIT
#pragma once
// What the stick feels of the blows that a blade takes: the impulses of a step as a mean force over
// that step, brought from the blade to the stick by the transposed Jacobian of the hand's key
// poses. Frame W, SI units. It is a blow and nothing more: no spring, no weight, no friction.

#include "batuta/fencing/duel.hpp"

namespace batuta::firmware {

using DuelType = Duel<float>;
using DuelEvents = DuelType::WorldType::EventList;

/// The impulse that `side`'s blade took, and its moment about the point `p_W`: the sum over the
/// contacts. The normal of a contact points out of body B (the right blade) towards body A (the
/// left one), so that the left blade takes +j n and the right one -j n. Bound: the capacity of the
/// list.
Momentum<float> blow_about(const Vec3<float>& p_W, Side side, const DuelEvents& events);

/// The force on the stick's two coordinates that does the same work as `blow` / dt does on the
/// hand: J^T (F, M), N m for each unit of the stick. It points where the blow drives the blade,
/// that is away from the blow; zero along a coordinate that is beyond the rim.
/// @param blow  impulse and its moment about the hand's origin @pre dt > 0, s
Vec2<float> stick_force(const StickJacobian<float>& jacobian, const Momentum<float>& blow,
                        float dt);

/// A force as shares of the actuator's range.
struct ForceShare {
  Vec2<float> share = Vec2<float>::Zero();  ///< each in [-1, 1]
  bool limited = false;                     ///< the force was larger than the range
};

/// `force` / `full_scale`; one that does not fit keeps its direction and gets as long as fits. A
/// force that is not finite gives zero, and counts as limited. @pre full_scale > 0, N m
ForceShare as_share(const Vec2<float>& force, float full_scale);

}  // namespace batuta::firmware
