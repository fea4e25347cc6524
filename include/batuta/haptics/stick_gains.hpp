// SPDX-License-Identifier: MIT
#pragma once
// What a coupling of the hand is at the stick, where the gain advisor needs it: through the key
// poses springs of the hand become J^T K J, another one in each place of the stick.
// Mathematics: src/haptics/gain_advisor.md, "Through the key poses".

#include "batuta/haptics/coupling.hpp"
#include "batuta/haptics/gain_advisor.hpp"

namespace batuta::haptics {

/// The largest eigenvalues of J^T K J and J^T B J, for check() and the limits of gain_advisor.hpp:
/// with them a device whose axes are alike renders the coupling in every direction, where the stick
/// is. Whoever asks for a whole map takes the largest over its places.
/// @param jacobian  HandTarget::jacobian; zero along a coordinate beyond the rim
/// @returns not finite where a number is not, or a product is beyond Scalar; check() says so
/// @pre settings valid. Bound: no loop.
template <class Scalar>
Gains<Scalar> gains_at_stick(const StickJacobian<Scalar>& jacobian,
                             const CouplingSettings<Scalar>& settings);

}  // namespace batuta::haptics
