// SPDX-License-Identifier: MIT
#pragma once
// The output stage of a fencer's stick.

#include "batuta/haptics/output_stage.hpp"
#include "batuta/haptics/stick_forces.hpp"

namespace batuta::firmware {

/// What `settings` mean to an output stage that makes a step every `dt` s. No end stop: the duel
/// uses the stick's whole square, up to its rim. No slew limit below a step: a pulse begins in one.
haptics::StageSettings stage_settings(const haptics::ForceSettings& settings, float dt);

}  // namespace batuta::firmware
