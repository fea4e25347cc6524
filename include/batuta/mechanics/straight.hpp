// SPDX-License-Identifier: MIT
#pragma once
// Bodies that do not turn: a place and a momentum, nothing else. For scenes without rotation, which
// so have no quaternion, no moments of inertia and no angular momentum to store or to compute.

#include "batuta/core/status.hpp"
#include "batuta/core/types.hpp"

namespace batuta {

/// Of inverse mass 0: nothing can move it, whatever its momentum.
template <class Scalar>
struct StraightBody {
  Vec3<Scalar> p_W = detail::zero<Scalar>();         ///< its point, m
  Vec3<Scalar> momentum_W = detail::zero<Scalar>();  ///< N s
  Scalar inverse_mass = 0;                           ///< 1/kg
};

namespace detail {

/// Place at t in [0, duration]: p_W + v_W t.
template <class Scalar>
struct StraightMotion {
  Vec3<Scalar> p_W = zero<Scalar>();  ///< at t = 0, m
  Vec3<Scalar> v_W = zero<Scalar>();  ///< m/s
  Scalar duration = 0;                ///< s, >= 0
};

}  // namespace detail

/// A body at rest.
/// @param mass  kg; infinity: the body is fixed
/// @returns kOk | kInvalidArgument: a place that is not finite, a mass that is not above zero or so
///   small that its inverse is not finite
template <class Scalar>
Result<StraightBody<Scalar>> make_straight_body(const Vec3<Scalar>& p_W, Scalar mass);

/// p / m, m/s; zero for a fixed body.
template <class Scalar>
Vec3<Scalar> velocity_of(const StraightBody<Scalar>& body);

/// J; zero for a fixed body.
template <class Scalar>
Scalar kinetic_energy(const StraightBody<Scalar>& body);

namespace detail {

/// Exactly p_W at t = 0. @pre 0 <= t <= duration
template <class Scalar>
Vec3<Scalar> position_at(const StraightMotion<Scalar>& motion, Scalar t);

}  // namespace detail

/// Finite at both ends, 0 <= duration.
template <class Scalar>
bool is_valid(const detail::StraightMotion<Scalar>& motion);

}  // namespace batuta
