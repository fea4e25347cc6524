// SPDX-License-Identifier: MIT
#pragma once
// Two motors behind the stick, x and y, each on an H-bridge fed by two channels of TIM8. Four
// things take the force away, each on its own: a command of zero; the guard, when no command came
// for kGuardTicks; the break input, in hardware; batuta_board_force_off(), after a fault.

#include <atomic>

#include "batuta/port/force.hpp"
#include "platforms/stm32f405/registers/tim.hpp"

namespace batuta::stm32f405 {

class BridgeForce final : public ForceDevice {
 public:
  /// Ticks of the guard, 1 ms each, that a force lives without a new command.
  static constexpr std::uint32_t kGuardTicks = 10;

  explicit BridgeForce(Tim& timer) : timer_(timer) {}

  /// Sets up the timer, outputs forced low. Break input: low or an open wire means no force.
  /// @param period  steps of one pulse period
  void configure(std::uint32_t period);

  /// Enables the outputs, at force zero.
  /// @returns kOk | kUnavailable: the break input is active, the outputs stay low
  Status arm();

  /// Outputs low until the next arm().
  void disarm() { timer_.bdtr = kSafe; }

  /// The outputs are enabled: neither a break nor disarm() has come since arm().
  bool is_armed() const { return (timer_.bdtr & Tim::kBdtrMoe) != 0; }

  /// From the guard's interrupt, once a millisecond.
  void guard_tick();

  /// Ticks since the start: the watchdog wants to see them, too.
  std::uint32_t guard_ticks() const { return ticks_.load(std::memory_order_relaxed); }
  /// How often the guard took a force away.
  std::uint32_t expiries() const { return expiries_.load(std::memory_order_relaxed); }

  /// BDTR without MOE: outputs driven low, break enabled. Both, and the outputs' polarities, are
  /// locked until a reset (level 2); MOE is not.
  static constexpr std::uint32_t kSafe =
      Tim::kBdtrLock2 | Tim::kBdtrOssi | Tim::kBdtrOssr | Tim::kBdtrBke;

 private:
  Status do_write(const ForceCommand& command) override;
  void silence();

  Tim& timer_;
  std::uint32_t period_ = 0;
  std::atomic<std::uint32_t> left_{0};  ///< ticks until the guard acts; 0: it has
  std::atomic<std::uint32_t> ticks_{0};
  std::atomic<std::uint32_t> expiries_{0};
};

}  // namespace batuta::stm32f405
