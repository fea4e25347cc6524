// SPDX-License-Identifier: MIT
#pragma once
// Mass, centre of mass and inertia tensor [Kavan eq. 1-3] of capsules, point masses and their sums:
// a sword is blade + guard + pommel. Frame S: the one in which the shape is modelled. SI units.

#include "batuta/core/status.hpp"
#include "batuta/geometry/capsule.hpp"

namespace batuta {

/// Mass, centre and inertia of a shape, in the frame S in which it is modelled.
template <class Scalar>
struct MassProperties {
  Scalar mass = 0;                                 ///< kg
  Vec3<Scalar> center_S = detail::zero<Scalar>();  ///< m
  Mat3<Scalar> inertia_S = Mat3<Scalar>::Zero();   ///< about the centre, axes of S, kg m^2
};

/// A body's own frame B: origin in the centre of mass, axes the principal axes of inertia.
template <class Scalar>
struct PrincipalFrame {
  Vec3<Scalar> center_S = detail::zero<Scalar>();  ///< origin of B in S, m
  Quat<Scalar> q_SB = Quat<Scalar>(1, 0, 0, 0);    ///< turns components in B into components in S
  Vec3<Scalar> moments = detail::zero<Scalar>();   ///< ascending, kg m^2
};

/// A solid capsule of uniform density: a cylinder and two half balls.
/// The axial moment is known to a few u of the transverse one: of a needle 1e4 times as long as
/// thick (float) nothing is left of it, and make_body() refuses zero; make such bodies in double.
/// @pre capsule valid, density > 0 and finite, kg/m^3
/// @returns kOk | kInvalidArgument (also where mass or moments vanish or overflow: radius 0 has no
/// volume)
template <class Scalar>
Result<MassProperties<Scalar>> solid_capsule(const Capsule<Scalar>& capsule, Scalar density);

namespace detail {

/// The axial moment of the same capsule, kg m^2, to a few u of itself. @pre as solid_capsule()
template <class Scalar>
Scalar axial_moment(const Capsule<Scalar>& capsule, Scalar density);

}  // namespace detail

/// A mass in one point: no inertia about its centre.
/// @returns kOk | kInvalidArgument (mass not positive and finite, or position not finite)
template <class Scalar>
Result<MassProperties<Scalar>> point_mass(Scalar mass, const Vec3<Scalar>& position_S);

/// Two parts in the same frame as one: masses add, inertias about the common centre (parallel
/// axes). A part without mass changes nothing.
template <class Scalar>
MassProperties<Scalar> operator+(const MassProperties<Scalar>& P, const MassProperties<Scalar>& Q);

/// The principal axes: q_SB is a proper rotation, moments ascend, negative rounding residue is
/// cleared to 0. Error of a moment: a few u times the largest one (src/mechanics/mass.md), so make
/// thin bodies in double. The identity and zero moments where the tensor is zero or not finite.
/// Bound: kJacobiSweeps = 6 sweeps of three plane rotations.
template <class Scalar>
PrincipalFrame<Scalar> principal_frame(const MassProperties<Scalar>& mass);

}  // namespace batuta
