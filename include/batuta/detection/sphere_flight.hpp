// SPDX-License-Identifier: MIT
#pragma once
// Time of contact of two spheres in straight flight: the instant in closed form, and one evaluation
// that certifies it. Derivation and error bounds: src/detection/sphere_flight.md.

#include "batuta/detection/moving_pair.hpp"
#include "batuta/geometry/kdop.hpp"
#include "batuta/mechanics/straight.hpp"

namespace batuta {

/// Two spheres over [0, duration], B seen from A. Each member may be a difference or a sum that was
/// rounded once: what is claimed holds for the spheres themselves too.
template <class Scalar>
struct SphereFlight {
  Vec3<Scalar> between = detail::zero<Scalar>();  ///< centre of B - centre of A at t = 0, m
  Vec3<Scalar> v = detail::zero<Scalar>();        ///< velocity of B - velocity of A, m/s
  Scalar radii = 0;                               ///< sum of the two, m, >= 0
  Scalar duration = 0;                            ///< s, >= 0
};

/// Answer of search_spheres().
template <class Scalar>
struct SphereResult {
  Outcome outcome = Outcome::kInvalid;  ///< what was found
  Scalar t_free = 0;                    ///< s, collision-free up to there
  Scalar t_hit = 0;    ///< s, >= t_free: contact, or the closest point of a graze, as foreseen
  Scalar closing = 0;  ///< m^2: above zero where the two approach at t = 0
  Scalar gap = 0;      ///< m, at t = 0
};

/// First contact in [0, duration]; none is missed. With S = |between| + |v| duration + radii:
/// @param contact_tolerance  m, >= 0; a smaller one than the arithmetic resolves is raised
/// @returns
///   kFree: the true gap is > 0 on [0, duration]; t_free = t_hit = duration;
///   kContact: the true gap is > 0 on [0, t_free], and at t_free at most contact_gap_of();
///   kTouching: the gap at t = 0 is at most contact_gap_of(); t_free = t_hit = 0;
///   kBudget: nothing is known, t_free = 0, where the certificate fails; by sphere_flight.md it
///     does not;
///   kInvalid: not finite (but an infinite contact tolerance: all touch); negative radii, duration
///     or contact tolerance; S^2 not finite.
/// Bound: no loop; one evaluation.
template <class Scalar>
SphereResult<Scalar> search_spheres(const SphereFlight<Scalar>& flight, Scalar contact_tolerance);

namespace detail {

/// The largest gap, m, at which search_spheres() may speak of contact: tau + 16 u S,
/// tau = max(contact_tolerance, 128 u (S + 2^-40 m)).
/// @pre the flight and the contact tolerance are valid
template <class Scalar>
Scalar contact_gap_of(const SphereFlight<Scalar>& flight, Scalar contact_tolerance);

/// The tightest box of a sphere whose centre moves, over the duration, rounded outward so that it
/// holds every point of it at every instant (src/detection/straight_pair.md).
/// @pre is_valid(center), radius >= 0. Bound: three axes.
template <class Scalar>
Aabb<Scalar> sphere_aabb(const StraightMotion<Scalar>& center, Scalar radius);

}  // namespace detail

}  // namespace batuta
