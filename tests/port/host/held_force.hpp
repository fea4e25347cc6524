// SPDX-License-Identifier: MIT
#pragma once
// A force pump without its thread, on a device of a fake whose time goes on with the pump's.

#include <functional>
#include <memory>
#include <utility>

#include "programs/live/force_pump.hpp"

namespace batuta::test {

class HeldForce {
 public:
  /// @param pass  has the device's time go on, us
  HeldForce(std::unique_ptr<host::ForceBackend> backend, const host::ForceOptions& options,
            std::function<void(std::int32_t)> pass)
      : pass_(std::move(pass)), pump_(std::move(backend), options, clock_) {}

  void command(float x, float y) { pump_.put(x, y); }
  /// The program is stopped, or its thread is late.
  void pass(std::int32_t microseconds) {
    clock_.time += static_cast<Microseconds>(microseconds);
    pass_(microseconds);
  }
  void turn() { pump_.turn(); }

 private:
  class SetClock final : public Clock {
   public:
    Microseconds time = 0xFFFFF000U;  // it wraps during the tests

   private:
    Microseconds do_now() override { return time; }
  };

  std::function<void(std::int32_t)> pass_;
  SetClock clock_;
  host::ForcePump pump_;
};

/// How late a thread is now and then: what silence leaves of an effect's length.
inline constexpr std::int32_t kLate_us = 95000;
inline constexpr int kTurnsUntilLate = 100;

/// Holds a force for `turns` turns of the pump, some of which are late.
/// @param plays  whether all of it plays, looked at before each turn
/// @returns the turns at whose beginning something of it did not play, but for the first ones
inline int hold(HeldForce& force, float x, float y, int turns, const std::function<bool()>& plays) {
  constexpr int kFirst = 20;  // a rumble has to wait for its turn
  int interrupted = 0;
  for (int i = 0; i < turns; ++i) {
    force.command(x, y);
    force.pass(i % kTurnsUntilLate == kTurnsUntilLate - 1 ? kLate_us : host::ForcePump::kTurn_us);
    if (i > kFirst && !plays()) ++interrupted;
    force.turn();
  }
  return interrupted;
}

}  // namespace batuta::test
