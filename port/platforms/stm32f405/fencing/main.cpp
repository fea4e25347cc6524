// SPDX-License-Identifier: MIT
// The fencing firmware on an STM32F405: brings the devices up, ticks at 1 kHz, feeds the watchdog.

#include "batuta/core/arithmetic.hpp"
#include "platforms/cortex_m/fault.hpp"
#include "platforms/cortex_m/registers.hpp"
#include "platforms/cortex_m/systick.hpp"
#include "platforms/stm32f405/board.hpp"
#include "platforms/stm32f405/drivers/adc_stick.hpp"
#include "platforms/stm32f405/drivers/bridge_force.hpp"
#include "platforms/stm32f405/drivers/restart_ledger.hpp"
#include "platforms/stm32f405/drivers/usart_stream.hpp"
#include "platforms/stm32f405/drivers/watchdog.hpp"
#include "platforms/stm32f405/interrupts.hpp"
#include "platforms/stm32f405/memory_map.hpp"
#include "shared/firmware/stated_rival.hpp"

namespace batuta::stm32f405 {
namespace {

// Second detail of a failed start.
constexpr std::uint32_t kCalibration = 1;
constexpr std::uint32_t kApplicationSettings = 2;
constexpr std::uint32_t kArithmetic = 3;

/// Smaller numbers interrupt larger ones; SysTick, which every handler may read, has 0.
enum Priority : std::uint32_t { kGuard = 1, kLine = 2, kStick = 3 };

firmware::LastFault last_fault() {
  const cortex_m::FaultRecord record = cortex_m::take_last_fault();
  return {static_cast<std::uint32_t>(record.code), {record.detail[0], record.detail[1]}};
}

cortex_m::SysTickClock clock;
UsartStream stream(usart1());
AdcStick stick({adc1(), adc_common(), dma2(), tim3()});
BridgeForce force(tim8());
Watchdog watchdog(iwdg());
firmware::StatedApplication application({clock, stream, &stick, &force}, last_fault());

void require(bool condition, std::uint32_t reason) {
  if (condition) return;
  cortex_m::enter_safe_state(cortex_m::FaultCode::kStartUp,
                             static_cast<std::uint32_t>(cortex_m::StartUpFailure::kApplication),
                             reason);
}

void start_devices() {
  cortex_m::start_systick(cortex_m::millisecond(kClocks.hclk_hz()));
  stream.start(brr_of(kClocks.pclk2_hz(), kBaud));
  enable(Interrupt::kUsart1, kLine);
  require(stick.calibrate(kStickAxis, kStickAxis) == Status::kOk, kCalibration);
  force.configure(kPulsePeriod);
  connect_force_pins();
  // Without a clock that is known to be right nothing is measured and nothing moves: an emulator
  // gets its samples over the link.
  if (clock_state() != ClockStart::kRunning) return;
  stick.start(kStickXChannel, kStickYChannel, kClocks.timers1_hz());
  enable(Interrupt::kDma2Stream0, kStick);
  enable(Interrupt::kAdc, kStick);
  start_guard(kGuard);
  // With an open emergency stop no command is taken; every step's report counts them. Once it is
  // closed it takes a reset.
  (void)force.arm();
}

}  // namespace
}  // namespace batuta::stm32f405

void batuta_on_usart1() {
  batuta::stm32f405::stream.on_interrupt();
}

void batuta_on_dma2_stream0() {
  using namespace batuta::stm32f405;
  stick.on_dma(clock.now());
}

void batuta_on_adc() {
  batuta::stm32f405::stick.on_overrun();
}

void batuta_on_tim7() {
  using namespace batuta::stm32f405;
  tim7().sr = ~Tim::kSrUif;
  force.guard_tick();
}

int main() {
  using namespace batuta;
  using namespace batuta::stm32f405;
  require(rounds_each_operation<float>(), kArithmetic);
  start_devices();
  require(application.start({}, firmware::kStatedRival) == Status::kOk, kApplicationSettings);
  watchdog.start();
  std::uint32_t tick = cortex_m::period_count();
  for (;;) {  // for ever: the watchdog sees to it that it goes on
    tick = cortex_m::next_period(tick);
    application.tick(tick);
    watchdog.on_tick(force.guard_ticks());
    if (application.ticks().used == kHealthyTicks) forget_restarts();
  }
}
