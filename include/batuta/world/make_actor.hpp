// SPDX-License-Identifier: MIT
#pragma once
// An actor from a capsule, its density, where it is and how it moves. Restitution, friction, owner,
// filter and controller are the caller's to set in what it returns.

#include "batuta/mechanics/solid.hpp"
#include "batuta/world/actor.hpp"

namespace batuta {

/// A body of one solid capsule, with mass and moments to rounding (solid_body()). The capsule may
/// lie anywhere in G: the body's own frame B has its origin in the capsule's middle, and
/// solid_body() says how its axes lie. Without rotation the body is turned once, here.
/// @param capsule_G  of length 0 where the search is Spheres
/// @param density  kg/m^3; infinity: the body is fixed
/// @param X_WG  where G is in W
/// @param twist  velocity of the capsule's middle, and angular velocity: zero without rotation
/// @returns kOk | kInvalidArgument: what solid_body() refuses; without rotation, an angular
///   velocity; for Spheres, a capsule that is none
/// Bound: no loop.
template <class SceneT>
Result<Actor<SceneT>> make_actor(const Capsule<typename Actor<SceneT>::Scalar>& capsule_G,
                                 typename Actor<SceneT>::Scalar density,
                                 const Pose<typename Actor<SceneT>::Scalar>& X_WG,
                                 const Twist<typename Actor<SceneT>::Scalar>& twist = {}) {
  using Scalar = typename Actor<SceneT>::Scalar;
  using S = detail::SceneFor<SceneT>;
  const auto solid = solid_body(capsule_G, density, X_WG, twist);
  bool good = solid.ok();
  const Body<Scalar>& body = solid.value.body;
  Capsule<Scalar> shape = solid.value.capsule_B;
  Actor<SceneT> actor;
  if constexpr (S::kRotation) {
    actor.body = body;
  } else {
    good = good && detail::is_zero(twist.w_W);
    actor.body.p_W = body.X_WB.p_W;
    actor.body.momentum_W = body.momentum.linear_W;
    actor.body.inverse_mass = body.inverse_mass;
    shape = to_world({Vec3<Scalar>::Zero(), body.X_WB.q_WB}, shape);
  }
  if constexpr (S::Search::kForSpheres) {
    good = good && capsule_G.axis.a == capsule_G.axis.b;
    actor.radius = shape.radius;
  } else if constexpr (S::kCapsulesPerBody == 1) {
    actor.capsule_B = shape;
  } else {
    good = actor.capsules_B.push(shape) && good;
  }
  return good ? success(actor) : failure<Actor<SceneT>>(Status::kInvalidArgument);
}

}  // namespace batuta
