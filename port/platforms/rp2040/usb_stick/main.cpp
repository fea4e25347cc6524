// SPDX-License-Identifier: MIT
// A USB force-feedback stick on an RP2040: brings the devices up by the Pico SDK, runs TinyUSB and
// the stick at 1 kHz, feeds the watchdog.

#include "hardware/watchdog.h"
#include "pico/time.h"
#include "pico/unique_id.h"
#include "platforms/rp2040/board.hpp"
#include "platforms/rp2040/drivers/pico_force.hpp"
#include "platforms/rp2040/drivers/pico_stick.hpp"
#include "platforms/rp2040/rhythm.hpp"
#include "shared/usb_stick/tinyusb_device.hpp"
#include "tusb.h"

namespace batuta::rp2040 {
namespace {

constexpr std::uint32_t kTickUs = 1000;

char serial[2 * PICO_UNIQUE_BOARD_ID_SIZE_BYTES + 1];

usb::UsbStickSettings settings() {
  usb::UsbStickSettings settings;
  settings.identity.serial = serial;
  return settings;
}

PicoStick stick;
PicoForce force;
usb::UsbStick device(force, settings());
repeating_timer_t guard;

bool on_guard(repeating_timer_t* /*timer*/) {
  force.guard_tick();
  return true;  // and again
}

/// @returns false: something has failed, and no force was armed
bool start_devices() {
  pico_get_unique_board_id_string(serial, sizeof serial);
  force.configure();
  if (stick.start(kStickAxis) != Status::kOk || device.start() != Status::kOk) return false;
  // A negative period is from start to start.
  if (!add_repeating_timer_us(-std::int64_t{kTickUs}, on_guard, nullptr, &guard)) return false;
  usb::connect(&device);
  if (!tusb_init()) return false;
  // With an open emergency stop no command is taken, and the host is told that there is no power.
  // Once it is closed it takes a reset.
  (void)force.arm();
  return true;
}

/// Fed where the guard's interrupt has run since the last time.
class Watchdog {
 public:
  /// It runs on under a debugger: a halted processor leaves the bridges as they were.
  void start() { watchdog_enable(kWatchdogMs, false); }
  void on_tick() {
    const std::uint32_t ticks = force.guard_ticks();
    if (ticks != last_) watchdog_update();
    last_ = ticks;
  }

 private:
  std::uint32_t last_ = 0;
};

void tick() {
  const Microseconds now = time_us_32();
  InputSample sample;
  const bool fresh = stick.read(now, sample) == Status::kOk;
  usb::run(device, fresh ? &sample : nullptr, now);
}

}  // namespace
}  // namespace batuta::rp2040

int main() {
  using namespace batuta::rp2040;
  Watchdog watchdog;
  const bool started = start_devices();
  watchdog.start();
  std::uint32_t next = time_us_32();
  while (started) {  // for ever: the watchdog sees to it that it goes on
    next = next_tick_us(next, time_us_32(), kTickUs);
    while (batuta::is_later(next, time_us_32())) {  // Bound: kTickUs
    }
    tick();
    watchdog.on_tick();
  }
  for (;;) {  // the watchdog starts it again
  }
}
