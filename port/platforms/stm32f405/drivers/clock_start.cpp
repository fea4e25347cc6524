// SPDX-License-Identifier: MIT

#include "platforms/stm32f405/drivers/clock_start.hpp"

#include "platforms/stm32f405/registers/gpio.hpp"

namespace batuta::stm32f405 {
namespace {

bool comes_up(const volatile std::uint32_t& reg, std::uint32_t mask, std::uint32_t value,
              int turns) {
  for (int i = 0; i < turns; ++i) {  // Bound: turns
    if ((reg & mask) == value) return true;
  }
  return false;
}

/// The part starts on the internal oscillator, so that its ready bit is set, or that of whatever a
/// boot loader has switched to. A register without any of them is none.
bool has_clock_control(const Rcc& rcc) {
  return (rcc.cr & (Rcc::kCrHsirdy | Rcc::kCrHserdy | Rcc::kCrPllrdy)) != 0;
}

/// Before the clock gets faster, not after it: at 168 MHz a flash without wait states reads
/// nonsense.
bool prepare_flash(FlashInterface& flash, std::uint32_t wait_states) {
  flash.acr = wait_states | FlashInterface::kAcrPrften | FlashInterface::kAcrIcen |
              FlashInterface::kAcrDcen;
  return (flash.acr & FlashInterface::kAcrLatencyMask) == wait_states;
}

}  // namespace

ClockStart start_clocks(const ClockRegisters& at, const ClockTree& tree, int turns) {
  Rcc& rcc = at.rcc;
  if (!has_clock_control(rcc)) return ClockStart::kAbsent;

  rcc.apb1enr |= Rcc::kApb1enrPwr;
  at.pwr.cr |= Pwr::kCrVos;
  rcc.cr |= Rcc::kCrHseon;
  if (!comes_up(rcc.cr, Rcc::kCrHserdy, Rcc::kCrHserdy, turns)) return ClockStart::kNoCrystal;
  if (!prepare_flash(at.flash, flash_wait_states(tree.hclk_hz()))) return ClockStart::kNoFlash;

  write_field(rcc.cfgr, kCfgrDividersMask, cfgr_dividers_of(tree));
  rcc.pllcfgr = pllcfgr_of(tree);
  rcc.cr |= Rcc::kCrPllon;
  if (!comes_up(rcc.cr, Rcc::kCrPllrdy, Rcc::kCrPllrdy, turns)) return ClockStart::kNoPll;

  write_field(rcc.cfgr, Rcc::kCfgrSwMask, Rcc::kCfgrSwPll);
  if (!comes_up(rcc.cfgr, Rcc::kCfgrSwsMask, Rcc::kCfgrSwsPll, turns)) return ClockStart::kNoSwitch;
  // A crystal that stops later: hardware breaks TIM8 (no force) and raises an NMI.
  rcc.cr |= Rcc::kCrCsson;
  return ClockStart::kRunning;
}

}  // namespace batuta::stm32f405
