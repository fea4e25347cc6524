// SPDX-License-Identifier: MIT
#pragma once
// The clocks as arithmetic: what the dividers give, and whether the part allows it. Checked by the
// compiler; clock_start.hpp brings it about. RM0090 sections 7.2 and 3.5.1, data sheet DS8626
// section 5.3.

#include <cstdint>

#include "platforms/stm32f405/registers/rcc.hpp"

namespace batuta::stm32f405 {

/// From the crystal to the buses.
struct ClockTree {
  std::uint32_t hse_hz;  ///< crystal
  std::uint32_t pll_m;   ///< crystal to the PLL's input
  std::uint32_t pll_n;   ///< input to oscillator
  std::uint32_t pll_p;   ///< oscillator to SYSCLK
  std::uint32_t pll_q;   ///< oscillator to the 48 MHz of USB, which must be legal though unused
  std::uint32_t apb1;    ///< AHB to APB1
  std::uint32_t apb2;    ///< AHB to APB2

  constexpr std::uint32_t pll_input_hz() const { return hse_hz / pll_m; }
  constexpr std::uint32_t oscillator_hz() const { return pll_input_hz() * pll_n; }
  constexpr std::uint32_t sysclk_hz() const { return oscillator_hz() / pll_p; }
  constexpr std::uint32_t usb_hz() const { return oscillator_hz() / pll_q; }
  constexpr std::uint32_t hclk_hz() const { return sysclk_hz(); }
  constexpr std::uint32_t pclk1_hz() const { return hclk_hz() / apb1; }
  constexpr std::uint32_t pclk2_hz() const { return hclk_hz() / apb2; }
  /// Timers run at twice their bus where it is divided.
  constexpr std::uint32_t timers1_hz() const { return pclk1_hz() * (apb1 == 1 ? 1U : 2U); }
  constexpr std::uint32_t timers2_hz() const { return pclk2_hz() * (apb2 == 1 ? 1U : 2U); }
};

/// Flash wait states at 2.7 V ... 3.6 V: one for each 30 MHz begun above the first (section 3.5.1).
constexpr std::uint32_t flash_wait_states(std::uint32_t hclk_hz) {
  return (hclk_hz - 1U) / 30000000U;
}

constexpr bool is_apb_divider(std::uint32_t divider) {
  return divider == 1 || divider == 2 || divider == 4 || divider == 8 || divider == 16;
}

/// Fields that fit their registers, every division exact.
constexpr bool is_exact(const ClockTree& tree) {
  return tree.pll_m >= 2 && tree.pll_m <= 63 && tree.hse_hz % tree.pll_m == 0 && tree.pll_n >= 50 &&
         tree.pll_n <= 432 && tree.pll_p >= 2 && tree.pll_p <= 8 && tree.pll_p % 2 == 0 &&
         tree.oscillator_hz() % tree.pll_p == 0 && tree.pll_q >= 2 && tree.pll_q <= 15 &&
         is_apb_divider(tree.apb1) && is_apb_divider(tree.apb2) &&
         tree.hclk_hz() % tree.apb1 == 0 && tree.hclk_hz() % tree.apb2 == 0;
}

/// What the data sheet promises to work, at 2.7 V ... 3.6 V and voltage scale 1.
constexpr bool is_within_limits(const ClockTree& tree) {
  return tree.hse_hz >= 4000000 && tree.hse_hz <= 26000000 && tree.pll_input_hz() >= 1000000 &&
         tree.pll_input_hz() <= 2000000 && tree.oscillator_hz() >= 100000000 &&
         tree.oscillator_hz() <= 432000000 && tree.hclk_hz() <= 168000000 &&
         tree.pclk1_hz() <= 42000000 && tree.pclk2_hz() <= 84000000 && tree.usb_hz() <= 48000000;
}

constexpr bool is_valid(const ClockTree& tree) {
  return is_exact(tree) && is_within_limits(tree);
}

/// RCC_PLLCFGR, fed from the crystal (RM0090 7.3.2).
constexpr std::uint32_t pllcfgr_of(const ClockTree& tree) {
  return tree.pll_m | (tree.pll_n << 6) | ((tree.pll_p / 2U - 1U) << 16) | Rcc::kPllcfgrSrcHse |
         (tree.pll_q << 24);
}

/// PPREx: 0 for 1, 4 ... 7 for 2 ... 16.
constexpr std::uint32_t ppre_of(std::uint32_t divider) {
  return divider == 1 ? 0U : divider == 2 ? 4U : divider == 4 ? 5U : divider == 8 ? 6U : 7U;
}

/// The buses' dividers in RCC_CFGR (RM0090 7.3.3); AHB undivided.
constexpr std::uint32_t cfgr_dividers_of(const ClockTree& tree) {
  return (ppre_of(tree.apb1) << 10) | (ppre_of(tree.apb2) << 13);
}
constexpr std::uint32_t kCfgrDividersMask = (15U << 4) | (7U << 10) | (7U << 13);

/// USART_BRR at 16-fold oversampling: the divider in sixteenths is the clock over the rate, to the
/// nearest (RM0090 30.3.4).
constexpr std::uint32_t brr_of(std::uint32_t clock_hz, std::uint32_t baud) {
  return (clock_hz + baud / 2U) / baud;
}

/// How far the rate is off, in millionths.
constexpr std::int64_t baud_error_ppm(std::uint32_t clock_hz, std::uint32_t baud) {
  const std::int64_t made = std::int64_t{baud} * brr_of(clock_hz, baud);
  return (std::int64_t{clock_hz} - made) * 1000000 / made;
}

}  // namespace batuta::stm32f405
