// SPDX-License-Identifier: MIT
#pragma once
// The rival that the build of an image states (images.cmake), for a board's main.

#include "shared/firmware/application.hpp"

#ifdef BATUTA_RIVAL_SKILL
#include "shared/firmware/seeing_rival.hpp"
#endif

namespace batuta::firmware {

#ifdef BATUTA_RIVAL_SKILL
using StatedRival = SeeingRival;
inline constexpr SeeingRival::Settings kStatedRival{fencing::Skill::BATUTA_RIVAL_SKILL,
                                                    BATUTA_RIVAL_SEED};
#else
using StatedRival = NoRival;
inline constexpr NoRival::Settings kStatedRival{};
#endif

using StatedApplication = ApplicationOf<StatedRival>;

}  // namespace batuta::firmware
