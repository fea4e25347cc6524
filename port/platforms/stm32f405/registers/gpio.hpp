// SPDX-License-Identifier: MIT
#pragma once
// General-purpose pins: RM0090 section 8.4.

#include <cstddef>
#include <cstdint>

namespace batuta::stm32f405 {

struct Gpio {
  volatile std::uint32_t moder;
  volatile std::uint32_t otyper;
  volatile std::uint32_t ospeedr;
  volatile std::uint32_t pupdr;
  volatile std::uint32_t idr;
  volatile std::uint32_t odr;
  volatile std::uint32_t bsrr;
  volatile std::uint32_t lckr;
  volatile std::uint32_t afr[2];
};
static_assert(offsetof(Gpio, bsrr) == 0x18 && offsetof(Gpio, afr) == 0x20, "RM0090 8.4");

enum class PinMode : std::uint32_t { kInput = 0, kOutput = 1, kAlternate = 2, kAnalog = 3 };
enum class PinPull : std::uint32_t { kNone = 0, kUp = 1, kDown = 2 };

/// The two bits of `pin` in MODER, OSPEEDR or PUPDR.
constexpr std::uint32_t pin_pair(unsigned pin, std::uint32_t value) {
  return value << (2U * pin);
}

constexpr std::uint32_t pin_mode(unsigned pin, PinMode mode) {
  return pin_pair(pin, static_cast<std::uint32_t>(mode));
}

/// Writes `value` to the bits of `mask`, leaving the others.
inline void write_field(volatile std::uint32_t& reg, std::uint32_t mask, std::uint32_t value) {
  reg = (reg & ~mask) | (value & mask);
}

inline void set_pin_mode(Gpio& port, unsigned pin, PinMode mode) {
  write_field(port.moder, pin_pair(pin, 3U), pin_mode(pin, mode));
}

inline void set_pin_pull(Gpio& port, unsigned pin, PinPull pull) {
  write_field(port.pupdr, pin_pair(pin, 3U), pin_pair(pin, static_cast<std::uint32_t>(pull)));
}

/// The function first, the mode last: the pin never shows another peripheral's signal.
inline void set_pin_function(Gpio& port, unsigned pin, std::uint32_t function) {
  const unsigned shift = 4U * (pin % 8U);
  write_field(port.afr[pin / 8U], 15U << shift, function << shift);
  set_pin_mode(port, pin, PinMode::kAlternate);
}

}  // namespace batuta::stm32f405
