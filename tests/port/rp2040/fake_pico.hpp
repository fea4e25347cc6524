// SPDX-License-Identifier: MIT
#pragma once
// What a test sees and sets behind the functions of the Pico SDK that the port uses.

#include <array>
#include <cstdint>

namespace batuta::rp2040::test {

struct FakePico {
  std::array<std::uint16_t, 30> levels{};  ///< of the pulses, by pin
  std::array<std::uint16_t, 4> counts{};   ///< what the converter says, by input
  std::array<bool, 30> is_pulsed{};        ///< pins that the PWM has
  bool loop_closed = true;                 ///< of the emergency stop
  std::uint16_t wrap = 0;
  unsigned input = 0;
  int conversions = 0;
};

/// There is one, as there is one chip.
FakePico& fake_pico();

}  // namespace batuta::rp2040::test
