// SPDX-License-Identifier: MIT
#pragma once
// Holds a device's step against the host's own, bit for bit.

#include <string>

#include "batuta/haptics/stepped_bout.hpp"
#include "programs/duel/device/step_answer.hpp"

namespace batuta::host {

/// @param there  complete
/// @returns empty: the same poses, events, touches, forces and results of the bout, told in as many
///   frames as here, and new samples used on the same sides | else the first difference: "step 17:
///   left pose: position x differs: 0x3f800000 here, 0x3f800001 there"
std::string first_difference(const haptics::SteppedBout& here, const StepAnswer& there);

}  // namespace batuta::host
