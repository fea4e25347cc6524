// SPDX-License-Identifier: MIT
#pragma once
// The key of a map, as the library has it.

#include <array>

namespace fight {

struct MapKey {
  std::array<float, 3> hand_F;
  std::array<float, 3> turn_F;
  float feet;
};

}  // namespace fight
