// SPDX-License-Identifier: MIT
#pragma once
// A step of a bout in the words of the link. The device sends these messages; a host makes them
// from its own bout and compares.

#include "batuta/haptics/stepped_bout.hpp"
#include "shared/link/messages.hpp"

namespace batuta::firmware {

using DuelType = fencing::Duel<>;

constexpr link::LinkSide link_side(fencing::Side side) {
  return side == fencing::Side::kLeft ? link::LinkSide::kLeft : link::LinkSide::kRight;
}

/// Of the last step made. @pre started
link::Pose pose_message(const DuelType& duel, fencing::Side side);
/// @pre 0 <= index < duel.world().events().size()
link::Event event_message(const DuelType& duel, int index);
/// @pre 0 <= index < duel.bout().touches.size()
link::Touch touch_message(const DuelType& duel, int index);
link::Force force_message(const haptics::SteppedBout& bout, fencing::Side side);
/// @pre bout.used(side) is not null
link::StickUsed used_message(const haptics::SteppedBout& bout, fencing::Side side);
/// What the bout itself says of its last step; what the device adds stays at its default.
link::StepReport report_message(const haptics::SteppedBout& bout);

/// Touches that were noted in the last step, the last of the bout's list.
int new_touches(const DuelType& duel);
/// Frames that tell of the last step, the report included. @param samples  with those used
int frames_of(const haptics::SteppedBout& bout, bool samples);

}  // namespace batuta::firmware
