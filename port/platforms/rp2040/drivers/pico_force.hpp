// SPDX-License-Identifier: MIT
#pragma once
// Two motors behind the stick, x and y, each on an H-bridge fed by the two channels of a PWM slice.
// What takes the force away, each on its own: a command of zero; the guard, when no command came
// for kGuardTicks; the loop of the emergency stop, which every tick of the guard reads. The RP2040
// has no break input: the same loop has to cut the bridges' supply or enable, too (rp2040.md).

#include <atomic>

#include "batuta/port/force.hpp"

namespace batuta::rp2040 {

class PicoForce final : public ForceDevice {
 public:
  /// Ticks of the guard, 1 ms each, that a force lives without a new command.
  static constexpr std::uint32_t kGuardTicks = 10;

  /// Pins and slices, the outputs low.
  void configure();
  /// From now on commands are taken. @returns kOk | kUnavailable: the emergency stop is open
  Status arm();
  /// From the guard's interrupt, once a millisecond.
  void guard_tick();

  bool is_armed() const { return armed_.load(std::memory_order_relaxed); }
  /// Ticks since the start: the watchdog wants to see them.
  std::uint32_t guard_ticks() const { return ticks_.load(std::memory_order_relaxed); }

 private:
  Status do_write(const ForceCommand& command) override;

  std::atomic<bool> armed_{false};
  std::atomic<std::uint32_t> left_{0};  ///< ticks until the guard acts; 0: it has
  std::atomic<std::uint32_t> ticks_{0};
};

}  // namespace batuta::rp2040
