// SPDX-License-Identifier: MIT
#pragma once
// The members of an input, for record/archive.hpp.

#include "batuta/port/input.hpp"
#include "batuta/record/archive.hpp"

namespace batuta {

inline void archive(Archive& ar, InputSample& sample) {
  auto& [time, x, y, feet_x, feet_y, buttons, sequence] = sample;
  ar(time, x, y, feet_x, feet_y, buttons, sequence);
}

}  // namespace batuta
