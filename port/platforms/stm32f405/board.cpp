// SPDX-License-Identifier: MIT
// The board before main(): why it starts, whether it may, the clocks, the pins.

#include "platforms/stm32f405/board.hpp"

#include "platforms/cortex_m/fault.hpp"
#include "platforms/stm32f405/drivers/restart_ledger.hpp"
#include "platforms/stm32f405/interrupts.hpp"
#include "platforms/stm32f405/memory_map.hpp"
#include "platforms/stm32f405/park.hpp"

namespace batuta::stm32f405 {
namespace {

// No initialiser: the start-up code must leave it alone.
[[gnu::section(".noinit.restarts")]] union Kept {
  RestartLedger ledger;
  Kept() {}
} kept;

ClockStart clock_start_result = ClockStart::kAbsent;

/// Reads the cause once: the flags stay until they are cleared, over further resets.
ResetCause take_reset_cause() {
  const std::uint32_t csr = rcc().csr;
  rcc().csr = csr | Rcc::kCsrRmvf;
  return reset_cause(csr);
}

void set_up_pins() {
  gpioc().bsrr = 1U << kLightPin;
  gpioc().moder = kPortCSafe;
  set_pin_pull(gpioa(), kBreakPin, PinPull::kDown);  // an open wire is a stop
  set_pin_function(gpioa(), kBreakPin, kFunctionTim8);
  set_pin_pull(gpiob(), kReceivePin, PinPull::kUp);  // an open line is idle
  set_pin_function(gpiob(), kTransmitPin, kFunctionUsart1);
  set_pin_function(gpiob(), kReceivePin, kFunctionUsart1);
}

void enable_peripherals() {
  rcc().ahb1enr |= Rcc::kAhb1enrDma2;
  rcc().apb1enr |= Rcc::kApb1enrTim3 | Rcc::kApb1enrTim7;
  rcc().apb2enr |= Rcc::kApb2enrTim8 | Rcc::kApb2enrUsart1 | Rcc::kApb2enrAdc1;
  (void)rcc().apb2enr;  // a peripheral answers two cycles after its clock (errata ES0182)
}

}  // namespace

ClockStart clock_state() {
  return clock_start_result;
}

void forget_restarts() {
  note_healthy(kept.ledger);
}

void connect_force_pins() {
  for (unsigned i = 0; i < kForcePins; ++i) {  // Bound: kForcePins
    set_pin_function(gpioc(), kFirstForcePin + i, kFunctionTim8);
  }
}

void start_guard(std::uint32_t priority) {
  constexpr std::uint32_t kTickHz = 1000000;
  tim7().psc = kClocks.timers1_hz() / kTickHz - 1U;
  tim7().arr = 1000U - 1U;
  tim7().egr = Tim::kEgrUg;
  tim7().sr = ~Tim::kSrUif;
  tim7().dier = Tim::kDierUie;
  enable(Interrupt::kTim7, priority);
  tim7().cr1 = Tim::kCr1Cen;
}

void connect_usb() {
  static_assert(kClocks.usb_hz() == 48000000, "full speed takes no other clock");
  rcc().ahb2enr |= Rcc::kAhb2enrOtgfs;
  (void)rcc().ahb2enr;
  set_pin_mode(gpioa(), kUsbVbusPin, PinMode::kInput);
  set_pin_function(gpioa(), kUsbMinusPin, kFunctionOtgFs);
  set_pin_function(gpioa(), kUsbPlusPin, kFunctionOtgFs);
  // Motors have their own supply: without VBUS the board must not pull D+ up (USB 2.0, 7.1.5), and
  // a cable that is pulled is known as that, not as a host that sleeps.
  write_field(otg_fs().gccfg, OtgFs::kGccfgNovbussens | OtgFs::kGccfgVbusbsen,
              OtgFs::kGccfgVbusbsen);
}

}  // namespace batuta::stm32f405

std::uint32_t batuta_board_init() {
  using namespace batuta;
  using namespace batuta::stm32f405;
  rcc().ahb1enr |= Rcc::kAhb1enrGpioa | Rcc::kAhb1enrGpiob | Rcc::kAhb1enrGpioc;
  (void)rcc().ahb1enr;
  batuta_board_force_off();

  const ResetCause cause = take_reset_cause();
  // RAM may have kept a record over a short loss of power; nobody could tell whose.
  if (cause == ResetCause::kPowerOn) (void)cortex_m::take_last_fault();
  const cortex_m::FaultCode before = cortex_m::last_fault().code;
  if (cause == ResetCause::kWatchdog && before == cortex_m::FaultCode::kNone) {
    cortex_m::record_fault(cortex_m::FaultCode::kWatchdog, 0, 0);
  }
  const auto fault = cortex_m::last_fault().code;
  const bool faulty = fault != cortex_m::FaultCode::kNone;
  if (!may_run(kept.ledger, cause, faulty)) park(static_cast<std::uint32_t>(fault));

  clock_start_result = start_clocks({rcc(), pwr(), flash_interface()}, kClocks);
  const bool fit =
      clock_start_result == ClockStart::kRunning || clock_start_result == ClockStart::kAbsent;
  if (!fit) return static_cast<std::uint32_t>(clock_start_result);
  enable_peripherals();
  set_up_pins();
  return 0;
}
