// SPDX-License-Identifier: MIT
#pragma once
// Contacts that last, one at a time: where two capsules touch, and the impulses that keep them from
// approaching. What is done with all of them together: contact_groups.hpp. Derivation:
// src/world/world.md, "Contacts that last". Frame W, SI units.

#include <array>

#include "batuta/geometry/capsule.hpp"
#include "batuta/world/detail/proxy_pair.hpp"

namespace batuta::detail {

/// A body while contacts are solved: how its matter moves, and what an impulse does to it.
template <class Scalar>
struct SolvedBody {
  Vec3<Scalar> v_W = Vec3<Scalar>::Zero();  ///< of the centre of mass, m/s
  Vec3<Scalar> w_W = Vec3<Scalar>::Zero();  ///< rad/s
  Mat3<Scalar> inverse_inertia_W = Mat3<Scalar>::Zero();
  Scalar inverse_mass = 0;  ///< 0: nothing pushes it
};

/// One point of a contact, ready to be solved.
template <class Scalar>
struct ContactPoint {
  Vec3<Scalar> point_W = Vec3<Scalar>::Zero();
  Vec3<Scalar> normal_W = Vec3<Scalar>::UnitX();   ///< out of B, towards A
  Vec3<Scalar> tangent_W = Vec3<Scalar>::UnitY();  ///< the other one: normal x tangent
  Scalar gap = 0;                                  ///< m
  Vec3<Scalar> arm_A_W = Vec3<Scalar>::Zero();     ///< from A's centre of mass, m
  Vec3<Scalar> arm_B_W = Vec3<Scalar>::Zero();
  std::array<Vec3<Scalar>, 3> turn_A_W = {
      Vec3<Scalar>::Zero(), Vec3<Scalar>::Zero(),
      Vec3<Scalar>::Zero()};  ///< I_A^-1 (arm x d), d: normal and both tangents
  std::array<Vec3<Scalar>, 3> turn_B_W = {Vec3<Scalar>::Zero(), Vec3<Scalar>::Zero(),
                                          Vec3<Scalar>::Zero()};
  Scalar stiffness = 0;          ///< 1 / (n . K n), kg
  std::array<Scalar, 3> grip{};  ///< inverse of K's tangential part: 11, 12, 22
  Scalar softest = 0;            ///< an upper bound of that part, 1/kg
  Scalar room = 0;               ///< how fast it may still approach in this step, m/s
  Scalar place = 0;              ///< along the shorter axis, m
  Scalar normal = 0;             ///< impulse being solved, N s, >= 0
  Scalar along = 0;              ///< the same, along the tangent
  Scalar across = 0;             ///< and along the other one
  /// Of this step, before what is being solved: cannot be taken back
  Scalar spent_normal = 0;
  Vec3<Scalar> spent_tangent_W = Vec3<Scalar>::Zero();
  Scalar opening = 0;                             ///< the same of the velocity that opens the gap
  Vec3<Scalar> rolling_W = Vec3<Scalar>::Zero();  ///< impulsive torque of rolling resistance
};

/// Two capsules that touch: at one point or, side by side, at two.
template <class Scalar>
struct LastingContact {
  ProxyPair pair;
  std::uint8_t count = 0;  ///< points, 1 or 2
  bool is_solved = false;  ///< belongs to the contacts that are solved in this step
  bool is_new = true;      ///< was not solved in the last step
  bool is_kept = false;    ///< was found near in this step
  bool is_told = false;    ///< its begin was told
  std::uint8_t below = 0;  ///< which one counts as held while gaps are opened: 1: A, 2: B
  bool is_held = false;    ///< something holds its group: only then openings turn bodies
  Scalar since = 0;        ///< in the step, s: its points are those of this time
  Scalar rest_gap = 0;     ///< D of the pair, m
  Scalar friction = 0;
  Scalar rolling = 0;  ///< m
  std::array<ContactPoint<Scalar>, 2> points;
};

/// Sets the points of a contact from its capsules, and carries the impulses of the old points over.
/// @param axes  the closest points of the two axes
/// @param line  whether there may be two points
/// Bound: four ends.
template <class Scalar>
void find_points(LastingContact<Scalar>& contact, const Capsule<Scalar>& A_W,
                 const Capsule<Scalar>& B_W, const ClosestPoints<Scalar>& axes, bool line);

/// Makes the points ready to be solved over the next `time` seconds.
/// @pre the points are where they are now; time > 0
template <class Scalar>
void prepare(LastingContact<Scalar>& contact, const SolvedBody<Scalar>& A,
             const SolvedBody<Scalar>& B, const Vec3<Scalar>& p_A_W, const Vec3<Scalar>& p_B_W,
             Scalar time);

/// Velocity of A's point less that of B's, m/s.
template <class Scalar>
Vec3<Scalar> velocity_across(const ContactPoint<Scalar>& point, const SolvedBody<Scalar>& A,
                             const SolvedBody<Scalar>& B);

/// The fastest approach along a normal of its points, m/s: negative where one approaches.
template <class Scalar>
Scalar fastest_approach(const LastingContact<Scalar>& contact, const SolvedBody<Scalar>& A,
                        const SolvedBody<Scalar>& B);

/// Gives both bodies `share` of the impulses being solved.
template <class Scalar>
void push_share(const LastingContact<Scalar>& contact, SolvedBody<Scalar>& A, SolvedBody<Scalar>& B,
                Scalar share);

/// The impulses being solved become `share` of them, without rolling resistance.
template <class Scalar>
void scale_impulses(LastingContact<Scalar>& contact, Scalar share);

/// One visit: each point's impulses are made those that fit the present velocities. A visit that
/// would add more energy than all before it have taken is left out (world.md, "Contacts that
/// last").
/// @param[in,out] energy  what all visits so far have added to the energy at most, J, <= 0
/// @returns the largest change of a velocity along a normal, m/s. Bound: two points.
template <class Scalar>
Scalar relax(LastingContact<Scalar>& contact, SolvedBody<Scalar>& A, SolvedBody<Scalar>& B,
             Scalar& energy);

/// One visit for the velocities that open gaps.
/// @param A, B   these velocities
/// @param share  of what is missing, to be made up over `time`; 0: nothing is opened, nor closed
/// @returns the largest change of a velocity along a normal, m/s. Bound: two points.
template <class Scalar>
Scalar relax_opening(LastingContact<Scalar>& contact, SolvedBody<Scalar>& A, SolvedBody<Scalar>& B,
                     Scalar time, Scalar share);

/// The impulse on A of what is being solved at a point, N s.
template <class Scalar>
Vec3<Scalar> impulse_of(const ContactPoint<Scalar>& point);

/// What a point gives: on A, and the opposite on B.
template <class Scalar>
struct PointImpulse {
  Vec3<Scalar> J_W = Vec3<Scalar>::Zero();        ///< N s
  Vec3<Scalar> rolling_W = Vec3<Scalar>::Zero();  ///< impulsive torque, N m s
};
template <class Scalar>
PointImpulse<Scalar> impulse_at(const ContactPoint<Scalar>& point) {
  return {impulse_of(point), point.rolling_W};
}

/// Of the impulses solved, the share that belongs to the time that has passed is spent.
template <class Scalar>
void spend(LastingContact<Scalar>& contact, Scalar share);

/// At the end of a step: what was spent and what was left are what the next one starts from.
template <class Scalar>
void take_together(LastingContact<Scalar>& contact);

}  // namespace batuta::detail
