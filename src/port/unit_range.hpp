// SPDX-License-Identifier: MIT
#pragma once
// What a stick's deflection and a force's share have in common.

namespace batuta {

/// In [-1, 1]. False for NaN: every comparison with it is.
constexpr bool is_in_unit_range(float x) {
  return x >= -1.0F && x <= 1.0F;
}

}  // namespace batuta
