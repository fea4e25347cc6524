// SPDX-License-Identifier: MIT
#pragma once
// The first block of docs/forces.md as a function: what a firmware does in each millisecond.

#include "batuta/fencing/duel.hpp"
#include "batuta/haptics/duel_hand.hpp"
#include "batuta/haptics/output_stage.hpp"
#include "batuta/port/clock.hpp"

void tick(batuta::fencing::Duel<>& duel, batuta::haptics::HandForce<float>& felt,
          batuta::haptics::OutputStage& stage, std::uint32_t& exchange,
          batuta::InputDevice& input_device, batuta::Clock& clock);
