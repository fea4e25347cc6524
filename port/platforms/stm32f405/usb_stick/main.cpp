// SPDX-License-Identifier: MIT
// A USB force-feedback stick on an STM32F405: brings the devices up, runs TinyUSB and the stick at
// 1 kHz, feeds the watchdog.

#include "platforms/cortex_m/fault.hpp"
#include "platforms/cortex_m/systick.hpp"
#include "platforms/stm32f405/board.hpp"
#include "platforms/stm32f405/drivers/adc_stick.hpp"
#include "platforms/stm32f405/drivers/bridge_force.hpp"
#include "platforms/stm32f405/drivers/restart_ledger.hpp"
#include "platforms/stm32f405/drivers/watchdog.hpp"
#include "platforms/stm32f405/interrupts.hpp"
#include "platforms/stm32f405/memory_map.hpp"
#include "shared/usb_stick/tinyusb_device.hpp"
#include "tusb.h"

namespace batuta::stm32f405 {
namespace {

// Second detail of a failed start.
constexpr std::uint32_t kCalibration = 1;
constexpr std::uint32_t kStageSettings = 2;
constexpr std::uint32_t kUsbStack = 3;

/// Smaller numbers interrupt larger ones; SysTick, which every handler may read, has 0.
enum Priority : std::uint32_t { kGuard = 1, kStick = 3, kBus = 4 };

const std::array<char, 25> serial = serial_of(unique_id());

usb::UsbStickSettings settings() {
  usb::UsbStickSettings settings;
  settings.identity.serial = serial.data();
  return settings;
}

cortex_m::SysTickClock clock;
AdcStick stick({adc1(), adc_common(), dma2(), tim3()});
BridgeForce force(tim8());
Watchdog watchdog(iwdg());
usb::UsbStick device(force, settings());

void require(bool condition, std::uint32_t reason) {
  if (condition) return;
  cortex_m::enter_safe_state(cortex_m::FaultCode::kStartUp,
                             static_cast<std::uint32_t>(cortex_m::StartUpFailure::kApplication),
                             reason);
}

void start_bus() {
  connect_usb();
  usb::connect(&device);
  enable(Interrupt::kOtgFs, kBus);
  require(tusb_init(), kUsbStack);
}

void start_devices() {
  cortex_m::start_systick(cortex_m::millisecond(kClocks.hclk_hz()));
  require(stick.calibrate(kStickAxis, kStickAxis) == Status::kOk, kCalibration);
  require(device.start() == Status::kOk, kStageSettings);
  force.configure(kPulsePeriod);
  connect_force_pins();
  // Without a clock that is known to be right nothing is measured, nothing moves, and no bus runs.
  if (clock_state() != ClockStart::kRunning) return;
  stick.start(kStickXChannel, kStickYChannel, kClocks.timers1_hz());
  enable(Interrupt::kDma2Stream0, kStick);
  enable(Interrupt::kAdc, kStick);
  start_guard(kGuard);
  // With an open emergency stop no command is taken, and the host is told that there is no power.
  // Once it is closed it takes a reset.
  (void)force.arm();
  start_bus();
}

}  // namespace
}  // namespace batuta::stm32f405

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

void batuta_on_otg_fs() {
  tud_int_handler(0);
}

// What TinyUSB takes from a board: the processor's clock, Hz, by the name of CMSIS, and a clock.
extern "C" std::uint32_t SystemCoreClock;
std::uint32_t SystemCoreClock = batuta::stm32f405::kClocks.hclk_hz();

std::uint32_t tusb_time_millis_api() {
  return batuta::cortex_m::period_count();
}

int main() {
  using namespace batuta;
  using namespace batuta::stm32f405;
  (void)cortex_m::take_last_fault();  // there is nobody to tell
  start_devices();
  watchdog.start();
  std::uint32_t tick = cortex_m::period_count();
  std::uint32_t ticks = 0;
  for (;;) {  // for ever: the watchdog sees to it that it goes on
    tick = cortex_m::next_period(tick);
    const Microseconds now = clock.now();
    InputSample sample;
    const bool fresh = stick.read(now, sample) == Status::kOk;
    usb::run(device, fresh ? &sample : nullptr, now);
    watchdog.on_tick(force.guard_ticks());
    if (++ticks == kHealthyTicks) forget_restarts();
  }
}
