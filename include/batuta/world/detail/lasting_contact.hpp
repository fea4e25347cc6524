// SPDX-License-Identifier: MIT
#pragma once
// Contacts that last, one at a time: where two capsules touch, and the impulses that keep them from
// approaching. What is done with all of them together: contact_groups.hpp. Derivation:
// src/world/world.md, "Contacts that last". Frame W, SI units.

#include <array>

#include "batuta/geometry/capsule.hpp"
#include "batuta/world/actor.hpp"
#include "batuta/world/detail/proxy_pair.hpp"

namespace batuta::detail {

/// A body while contacts are solved: how its matter moves, and what an impulse does to it.
template <class Scalar>
struct SolvedBody {
  Vec3<Scalar> v_W = Vec3<Scalar>::Zero();  ///< of the centre of mass, m/s
  Vec3<Scalar> w_W = Vec3<Scalar>::Zero();  ///< rad/s
  Mat3<Scalar> inverse_inertia_W = Mat3<Scalar>::Zero();
  Scalar inverse_mass = 0;                      ///< 0: nothing pushes it
  Vec3<Scalar> place_W = Vec3<Scalar>::Zero();  ///< of the centre of mass, m
};

/// What a scene asks of its contacts: they hold nothing else.
template <class ScalarT, bool kWithFriction, bool kWithRolling, bool kWithLine>
struct ContactTraits {
  using Scalar = ScalarT;
  static constexpr bool kFriction = kWithFriction;
  static constexpr bool kRolling = kWithRolling;  ///< rolling resistance; with friction alone
  static constexpr bool kLine = kWithLine;        ///< there may be two points
};

/// Of a point with friction. Across the normal, along the two tangents_of() it.
template <class Scalar>
struct PointFriction {
  std::array<Scalar, 3> softness_across{};  ///< K's tangential part: 11, 12, 22, 1/kg
  Scalar along = 0;                         ///< impulse being solved, along the first, N s
  Scalar across = 0;                        ///< and along the second
  Scalar spent_along = 0;                   ///< see spent_normal
  Scalar spent_across = 0;
};
/// Of a point with rolling resistance.
template <class Scalar>
struct PointRolling {
  Vec3<Scalar> rolling_W = Vec3<Scalar>::Zero();  ///< impulsive torque being solved, N m s
};
/// Of a point that may be one of two.
template <class Scalar>
struct PointPlace {
  Scalar place = 0;  ///< along the shorter axis, m
};

/// One point of a contact, ready to be solved.
template <class Traits>
struct ContactPoint : FeatureIf<Traits::kFriction, PointFriction<typename Traits::Scalar>, 20>,
                      FeatureIf<Traits::kRolling, PointRolling<typename Traits::Scalar>, 21>,
                      FeatureIf<Traits::kLine, PointPlace<typename Traits::Scalar>, 22> {
  using Scalar = typename Traits::Scalar;
  Vec3<Scalar> normal_W = Vec3<Scalar>::UnitX();  ///< out of B, towards A
  Vec3<Scalar> arm_A_W = Vec3<Scalar>::Zero();    ///< from A's centre of mass, m
  Scalar gap = 0;                                 ///< m
  Scalar softness = 0;                            ///< n . K n, 1/kg
  Scalar room = 0;    ///< how fast it may still approach in this step, m/s
  Scalar normal = 0;  ///< impulse being solved, N s, >= 0
  /// Of this step, before what is being solved: cannot be taken back
  Scalar spent_normal = 0;
  Scalar opening = 0;  ///< what is being solved of the velocity that opens the gap, N s
  Scalar start = 0;    ///< the impulse when the sweep began, N s; before sweeps, its group
  Scalar ahead = 0;    ///< where the sweeps have led it last, N s; before sweeps, how low it is
};

/// Of a contact with friction, and with rolling resistance.
template <class Scalar>
struct ContactFriction {
  Scalar friction = 0;
};
template <class Scalar>
struct ContactRolling {
  Scalar rolling = 0;  ///< m
};

/// Two capsules that touch: at one point or, side by side, at two.
template <class Traits>
struct LastingContact : FeatureIf<Traits::kFriction, ContactFriction<typename Traits::Scalar>, 23>,
                        FeatureIf<Traits::kRolling, ContactRolling<typename Traits::Scalar>, 24> {
  using Scalar = typename Traits::Scalar;
  static constexpr std::size_t kPoints = Traits::kLine ? 2 : 1;
  ProxyPair pair;
  std::uint8_t count = 0;  ///< points, 1 or 2
  bool is_solved = false;  ///< belongs to the contacts that are solved in this step
  bool is_new = true;      ///< was not solved in the last step
  bool is_kept = false;    ///< was found near in this step
  bool is_told = false;    ///< its begin was told
  std::uint8_t below = 0;  ///< which one counts as held while gaps are opened: 1: A, 2: B
  bool is_moved = false;  ///< a body of it was shifted far, or left its hand, since it was prepared
  bool is_held = false;   ///< something holds its group: only then openings turn bodies
  Scalar since = 0;       ///< in the step, s: its points are those of this time
  Scalar rest_gap = 0;    ///< D of the pair, m
  std::array<ContactPoint<Traits>, kPoints> points;
};

/// Two directions across a normal, and square to each other.
template <class Scalar>
struct Tangents {
  Vec3<Scalar> along_W;
  Vec3<Scalar> across_W;
};
/// The same for the same normal, to the last bit.
/// Source: Duff and others, "Building an Orthonormal Basis, Revisited", 2017. @pre |normal| = 1
template <class Scalar>
Tangents<Scalar> tangents_of(const Vec3<Scalar>& normal_W) {
  const Vec3<Scalar>& n = normal_W;
  const Scalar sign = n.z() < Scalar(0) ? Scalar(-1) : Scalar(1);
  const Scalar a = -1 / (sign + n.z());
  const Scalar b = n.x() * n.y() * a;
  return {{1 + sign * n.x() * n.x() * a, sign * b, -sign * n.x()},
          {b, sign + n.y() * n.y() * a, -n.y()}};
}

/// From B's centre of mass, m.
template <class Traits, class Scalar>
Vec3<Scalar> arm_B(const ContactPoint<Traits>& point, const SolvedBody<Scalar>& A,
                   const SolvedBody<Scalar>& B) {
  return point.arm_A_W + (A.place_W - B.place_W);
}

/// Sets the points of a contact from its capsules, and carries the impulses of the old points over.
/// @param axes   the closest points of the two axes
/// @param p_A_W  A's centre of mass
/// @param towards_A  where across the gap the points lie, in gaps from its middle: off_middle()
/// Bound: four ends.
template <class Traits, class Scalar>
void find_points(LastingContact<Traits>& contact, const Capsule<Scalar>& A_W,
                 const Capsule<Scalar>& B_W, const ClosestPoints<Scalar>& axes,
                 const Vec3<Scalar>& p_A_W, Scalar towards_A);

/// Makes the points ready to be solved over the next `time` seconds.
/// @pre the points and both bodies are where they are now; time > 0
template <class Traits, class Scalar>
void prepare(LastingContact<Traits>& contact, const SolvedBody<Scalar>& A,
             const SolvedBody<Scalar>& B, Scalar time);

/// Velocity of A's point less that of B's, m/s.
template <class Traits, class Scalar>
Vec3<Scalar> velocity_across(const ContactPoint<Traits>& point, const SolvedBody<Scalar>& A,
                             const SolvedBody<Scalar>& B) {
  return (A.v_W - B.v_W) + (A.w_W.cross(point.arm_A_W) - B.w_W.cross(arm_B(point, A, B)));
}

/// Whether nothing pushes it: it goes where it is led.
template <class Scalar>
bool is_led(const SolvedBody<Scalar>& body) {
  return body.inverse_mass == Scalar(0) && body.inverse_inertia_W.trace() == Scalar(0);
}

/// Whether it turns, and goes nowhere.
template <class Scalar>
bool is_on_axle(const SolvedBody<Scalar>& body) {
  return body.inverse_mass == Scalar(0) && body.inverse_inertia_W.trace() > Scalar(0);
}

/// The same of the two surfaces, as friction sees it: the point lies on the surface of the one that
/// is pushed, and the surface of one that is led is a gap away from it (world.md, "Where").
template <class Traits, class Scalar>
Vec3<Scalar> slip_across(const ContactPoint<Traits>& point, const SolvedBody<Scalar>& A,
                         const SolvedBody<Scalar>& B) {
  Vec3<Scalar> slip = velocity_across(point, A, B);
  if (is_led(B)) {
    slip += B.w_W.cross(point.gap * point.normal_W);
  } else if (is_led(A)) {
    slip += A.w_W.cross(point.gap * point.normal_W);
  }
  return slip;
}

/// Gives an impulse at a point to A, and the opposite to B.
template <class Traits, class Scalar>
void push_at(const ContactPoint<Traits>& point, SolvedBody<Scalar>& A, SolvedBody<Scalar>& B,
             const Vec3<Scalar>& J_W) {
  A.v_W += A.inverse_mass * J_W;
  B.v_W -= B.inverse_mass * J_W;
  A.w_W += A.inverse_inertia_W * point.arm_A_W.cross(J_W);
  B.w_W -= B.inverse_inertia_W * arm_B(point, A, B).cross(J_W);
}

/// The fastest approach along a normal of its points, m/s: negative where one approaches.
template <class Traits, class Scalar>
Scalar fastest_approach(const LastingContact<Traits>& contact, const SolvedBody<Scalar>& A,
                        const SolvedBody<Scalar>& B);

/// Whether a point would press if nothing else touched the two. @pre prepared. Bound: two points.
template <class Traits, class Scalar>
bool would_press(const LastingContact<Traits>& contact, const SolvedBody<Scalar>& A,
                 const SolvedBody<Scalar>& B) {
  bool presses = false;
  for (int i = 0; i < contact.count; ++i) {  // Bound: 2
    const auto& point = contact.points[static_cast<std::size_t>(i)];
    const Scalar rate = point.normal_W.dot(velocity_across(point, A, B));
    presses = presses || rate + point.room < Scalar(0);
  }
  return presses;
}

/// The least gap of its points, m. Bound: two points.
template <class Traits>
typename Traits::Scalar least_gap(const LastingContact<Traits>& contact) {
  const auto& points = contact.points;
  return contact.count > 1 ? min_of(points.front().gap, points.back().gap) : points.front().gap;
}

/// Gives both bodies `share` of the impulses being solved.
template <class Traits, class Scalar>
void push_share(const LastingContact<Traits>& contact, SolvedBody<Scalar>& A, SolvedBody<Scalar>& B,
                Scalar share);

/// The impulses being solved become `share` of them.
template <class Traits, class Scalar>
void scale_impulses(LastingContact<Traits>& contact, Scalar share);

/// One visit: the impulses are made those that fit the present velocities; the normal ones of both
/// points together. A visit that would add more energy than all before it have taken is left out
/// (world.md, "Contacts that last").
/// @param[in,out] energy  what all visits so far have added to the energy at most, J, <= 0
/// @param carried_W  what counts as energy for each newton second that A gets, m/s: within a step,
///   where one of the two is led, what half of the fall that is left makes of it
/// @returns the largest change of a velocity along a normal, m/s. Bound: two points.
template <class Traits, class Scalar>
Scalar relax(LastingContact<Traits>& contact, SolvedBody<Scalar>& A, SolvedBody<Scalar>& B,
             Scalar& energy, const Vec3<Scalar>& carried_W = Vec3<Scalar>::Zero());

/// The normal impulses go `share` further the way that the sweeps have led them; one that would add
/// more energy than was taken before it stays (world.md, "Sweeps that are ahead"). Then a new sweep
/// begins.
/// @param[in,out] energy  as in relax()
template <class Traits, class Scalar>
void go_ahead(LastingContact<Traits>& contact, SolvedBody<Scalar>& A, SolvedBody<Scalar>& B,
              Scalar share, Scalar& energy);

/// How far a sweep has led a contact, as energy, J.
template <class Traits, class Scalar = typename Traits::Scalar>
Scalar led_by_sweep(const LastingContact<Traits>& contact) {
  Scalar sum = 0;
  for (int i = 0; i < contact.count; ++i) {  // Bound: 2
    const auto& point = contact.points[static_cast<std::size_t>(i)];
    const Scalar change = point.normal - point.start;
    sum += point.softness * change * change;
  }
  return sum;
}

/// One visit for the velocities that open gaps.
/// @param A, B   these velocities
/// @param share  of what is missing, to be made up over `time`; 0: nothing is opened, nor closed
/// @returns the largest change of a velocity along a normal, m/s. Bound: two points.
template <class Traits, class Scalar>
Scalar relax_opening(LastingContact<Traits>& contact, SolvedBody<Scalar>& A, SolvedBody<Scalar>& B,
                     Scalar time, Scalar share);

/// What a point gives: on A, and the opposite on B.
template <class Scalar>
struct PointImpulse {
  Vec3<Scalar> J_W = Vec3<Scalar>::Zero();        ///< N s
  Vec3<Scalar> rolling_W = Vec3<Scalar>::Zero();  ///< impulsive torque, N m s
};
/// Of what is being solved.
template <class Traits>
PointImpulse<typename Traits::Scalar> impulse_at(const ContactPoint<Traits>& point) {
  PointImpulse<typename Traits::Scalar> impulse;
  impulse.J_W = point.normal * point.normal_W;
  if constexpr (Traits::kFriction) {
    const auto tangents = tangents_of(point.normal_W);
    impulse.J_W += point.along * tangents.along_W + point.across * tangents.across_W;
  }
  if constexpr (Traits::kRolling) impulse.rolling_W = point.rolling_W;
  return impulse;
}

/// Of the impulses solved, the share that belongs to the time that has passed is spent.
template <class Traits, class Scalar>
void spend(LastingContact<Traits>& contact, Scalar share);

/// lambda . u + lambda_n room of a point (world.md, "Warm start"), J.
template <class Traits, class Scalar>
Scalar power_of(const ContactPoint<Traits>& point, const SolvedBody<Scalar>& A,
                const SolvedBody<Scalar>& B) {
  const auto impulse = impulse_at(point);
  Scalar sum = impulse.J_W.dot(slip_across(point, A, B)) + point.normal * point.room;
  if constexpr (Traits::kRolling) sum += impulse.rolling_W.dot(A.w_W - B.w_W);
  return sum;
}

/// At the end of a step: what was spent and what was left are what the next one starts from.
template <class Traits>
void take_together(LastingContact<Traits>& contact);

/// The kinds of contacts that scenes may have: instantiate(Scalar, friction, rolling, line).
#define BATUTA_FOR_EACH_CONTACT(instantiate, S)                            \
  instantiate(S, false, false, false) instantiate(S, false, false, true)   \
      instantiate(S, true, false, false) instantiate(S, true, false, true) \
          instantiate(S, true, true, false) instantiate(S, true, true, true)

}  // namespace batuta::detail
