// SPDX-License-Identifier: MIT
#pragma once
// What an encoder shows of a position.

#include "batuta/core/types.hpp"

namespace batuta::port_simulated {

/// The nearest multiple of `step`, u; the position itself where step is 0.
inline double encoded(double position, double step) {
  return step > 0 ? step * std::floor(position / step + 0.5) : position;
}

}  // namespace batuta::port_simulated
