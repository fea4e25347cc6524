// SPDX-License-Identifier: MIT
#pragma once
// A rigid body [Kavan eq. 4-15]. State: pose and momenta, because they are what is conserved;
// velocities follow. Only inverse mass and inverse inertia are kept: zero means "cannot be moved"
// [Kavan §4.1]. Frames: W world; B body: origin in the centre of mass, axes the principal axes of
// inertia. SI units.

#include <cstdint>

#include "batuta/core/status.hpp"
#include "batuta/geometry/capsule.hpp"
#include "batuta/mechanics/mass.hpp"
#include "batuta/mechanics/rotation.hpp"

namespace batuta {

/// Where B is in W: x_W = p_W + R(q_WB) x_B [Kavan eq. 4].
template <class Scalar>
struct Pose {
  Vec3<Scalar> p_W = detail::zero<Scalar>();     ///< origin of B in W, m
  Quat<Scalar> q_WB = Quat<Scalar>(1, 0, 0, 0);  ///< unit
};

/// How a body moves: velocity of its centre of mass and angular velocity, components in W.
template <class Scalar>
struct Twist {
  Vec3<Scalar> v_W = detail::zero<Scalar>();  ///< m/s
  Vec3<Scalar> w_W = detail::zero<Scalar>();  ///< rad/s
};

/// Linear and angular momentum about the centre of mass, or a change of them (impulse and impulsive
/// torque), in W.
template <class Scalar>
struct Momentum {
  Vec3<Scalar> linear_W = detail::zero<Scalar>();   ///< kg m/s
  Vec3<Scalar> angular_W = detail::zero<Scalar>();  ///< kg m^2/s
};

namespace detail {

/// What a flight of a body with three unlike moments keeps beside its angular momentum, so that
/// rounding does not add up in its energy (src/mechanics/motion.md). move_along() writes it.
template <class Scalar>
struct FlightMemory {
  /// The angular momentum of the flight: with another one the rest counts for nothing.
  Vec3<Scalar> angular_W = zero<Scalar>();
  /// 2 E - |b|^2 / I_axis, E the energy of turning, J.
  Scalar excess = 0;
  std::uint8_t axis = 0;  ///< the axis of B nearest to b when the flight began: 0, 1, 2
  /// The body was left between the ends of a planned motion, where its energy is not the flight's.
  bool is_on_chord = false;
};

}  // namespace detail

/// A rigid body: pose, momenta and what they have to move.
template <class Scalar>
struct Body {
  Pose<Scalar> X_WB;          ///< where its frame B is
  Momentum<Scalar> momentum;  ///< linear and angular, in W
  Scalar inverse_mass = 0;    ///< 1/kg; 0: fixed in place
  /// 1/(kg m^2), along the axes of B; 0: does not turn
  Vec3<Scalar> inverse_moments = detail::zero<Scalar>();
  /// Something seen of it lies off its axis of symmetry, so that its orientation about that axis
  /// matters to free_flight(). A World sets it from the capsule; without meaning for a body that is
  /// not axisymmetric.
  bool spin_shows = false;
  /// Of move_along(). Who turns a body by hand and leaves its momentum as it is sets it to {};
  /// otherwise the next flight may turn it back by up to 1e-3 rad.
  detail::FlightMemory<Scalar> flight = {};
};

/// A body at rest with the inverse of `mass` and `moments`; infinity gives zero, that is fixed.
/// @returns kOk | kInvalidArgument (mass or a moment is not positive, NaN, or too small for its
/// inverse; pose not finite; an orientation of length 0)
template <class Scalar>
Result<Body<Scalar>> make_body(const Pose<Scalar>& X_WB, Scalar mass, const Vec3<Scalar>& moments);

/// Whether nothing can move or turn it: inverse mass and moments are zero.
template <class Scalar>
[[gnu::noinline]] bool is_fixed(const Body<Scalar>& body) {
  return body.inverse_mass == Scalar(0) && detail::is_zero(body.inverse_moments);
}

/// x_W of a point given in B [Kavan eq. 4].
template <class Scalar>
Vec3<Scalar> to_world(const Pose<Scalar>& X_WB, const Vec3<Scalar>& x_B);
/// x_B of a point given in W: the way back [Kavan eq. 4].
template <class Scalar>
Vec3<Scalar> to_body(const Pose<Scalar>& X_WB, const Vec3<Scalar>& x_W);
/// A capsule given in B, in W; the radius stays.
template <class Scalar>
Capsule<Scalar> to_world(const Pose<Scalar>& X_WB, const Capsule<Scalar>& capsule_B);

namespace detail {

/// I^-1 in W: R J^-1 R^T [Kavan eq. 5, 29].
template <class Scalar>
Mat3<Scalar> inverse_inertia_W(const Body<Scalar>& body);

/// v = p / m [Kavan eq. 7]: twist_of(body).v_W, where nobody asks for w.
template <class Scalar>
Vec3<Scalar> velocity_of(const Body<Scalar>& body);

/// Of a body that goes nowhere and turns about one axis: what its bearing has taken is not its own,
/// and moves it nowhere (world.md, "About an axle"). It stays where it is no more than rounding:
/// nothing that merely turns is touched. Who turns about two axes keeps it: there it makes a
/// gyroscope. @pre inverse_mass == 0
template <class Scalar>
void drop_held(Body<Scalar>& body);

}  // namespace detail

/// v = p / m, w = I^-1 b [Kavan eq. 7, 8]. Computed in B, so that strongly unequal moments lose
/// nothing.
template <class Scalar>
Twist<Scalar> twist_of(const Body<Scalar>& body);

/// p = m v, b = I w; zero along what cannot be moved.
template <class Scalar>
Momentum<Scalar> momentum_of(const Body<Scalar>& body, const Twist<Scalar>& twist);

/// Velocity of the body's point at x_W [Kavan eq. 6].
template <class Scalar>
Vec3<Scalar> velocity_at(const Pose<Scalar>& X_WB, const Twist<Scalar>& twist,
                         const Vec3<Scalar>& x_W);

/// Torque about the centre of mass of a force at x_W [Kavan eq. 10]; also the impulsive torque of
/// an impulse of force [Kavan eq. 14].
template <class Scalar>
Vec3<Scalar> torque_of(const Pose<Scalar>& X_WB, const Vec3<Scalar>& force_W,
                       const Vec3<Scalar>& x_W);

/// Force and torque over dt [Kavan eq. 9, 11], or an impulse and impulsive torque with dt = 1
/// [Kavan eq. 12-15]. What cannot be moved stays as it is. @returns kOk | kInvalidArgument (not
/// finite, also in its result; dt < 0); then nothing is changed
template <class Scalar>
Status apply(Body<Scalar>& body, const Vec3<Scalar>& force_W, const Vec3<Scalar>& torque_W,
             Scalar dt);

/// Impulse J_F at the point x_W: p += J_F, b += (x - c) x J_F [Kavan eq. 12-15].
/// @returns kOk | kInvalidArgument (not finite); then nothing is changed
template <class Scalar>
Status apply_impulse(Body<Scalar>& body, const Vec3<Scalar>& impulse_W, const Vec3<Scalar>& x_W);

/// p.v/2 + b.w/2, J; 0 for a fixed body. By the squares of the momenta: where these overflow or
/// vanish (in float above 1e19 and below 1e-19 kg m/s), so does it, before its own value would.
template <class Scalar>
Scalar kinetic_energy(const Body<Scalar>& body);

}  // namespace batuta
