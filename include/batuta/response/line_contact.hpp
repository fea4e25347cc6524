// SPDX-License-Identifier: MIT
#pragma once
// Capsules that touch along a line: the two contact points at the ends of it are as good as one
// between them, where the pressure is centred (src/response/line_contact.md). Frame W, SI units.

#include "batuta/response/impulse.hpp"

namespace batuta {

/// The point at which one impulse does what two simultaneous ones would do at the ends of the line
/// along which A and B touch; normal and gap as in `nearest`. The impulse, its friction and the
/// event are then those of any other contact. The same for each of the closest points of parallel
/// capsules, and continuous in the pose: with the tilt the line shrinks to `nearest`. Where the
/// axes do not run along each other, where they are only points, or where no place on the line
/// approaches: `nearest`, to the last bit; also for capsules or velocities that are not finite.
/// @pre finite inverse masses and slack
/// @param A_W, B_W  the capsules at the instant of the contact
/// @param nearest   the contact at their closest points; normal unit
/// @param slack     m: a place whose gap exceeds that of `nearest` by half of it or less belongs to
///                  the line, from all of it on it does not
/// Bound: no loop, no root. Squares of lengths must neither overflow nor vanish.
template <class Scalar>
Contact<Scalar> pressure_contact(const Collider<Scalar>& A, const Collider<Scalar>& B,
                                 const Capsule<Scalar>& A_W, const Capsule<Scalar>& B_W,
                                 const Contact<Scalar>& nearest, Scalar slack);

}  // namespace batuta
