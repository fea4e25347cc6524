// SPDX-License-Identifier: MIT
#pragma once
// Simple opponents: a fencer whose stick follows a fixed pattern, smoothly, 1000 samples a second,
// always the same.

#include <cstddef>
#include <optional>
#include <string_view>

#include "programs/devices/source.hpp"

namespace batuta::host {

/// To the stick position (x, y) within a time, starting and ending at rest.
struct ScriptMove {
  std::uint32_t duration_ms;  ///< > 0
  float x;
  float y;
};

/// Moves in a circle: after the last one comes the first.
struct Script {
  std::string_view name;
  const ScriptMove* moves;
  std::size_t count;  ///< > 0
};

/// guard: waits in guard, breathing. parry: quarte, a beat and sixte on a rhythm. attack:
/// feints, then lunges.
std::optional<Script> script_named(std::string_view name);

/// Plays a script from now = 0, for ever.
class ScriptDevice final : public Source {
 public:
  static constexpr Microseconds kPeriod_us = 1000;

  explicit ScriptDevice(const Script& script);

  std::string description() const override;
  double duration() const override;
  void rewind() override;

 private:
  /// Bound: the moves of the script.
  Status do_read(Microseconds now, InputSample& sample) override;

  Script script_;
  std::uint32_t length_ms_ = 0;  ///< of the circle
  std::uint32_t phase_ms_ = 0;   ///< of the latest sample, in the circle
  InputSample latest_;
  bool started_ = false;
};

}  // namespace batuta::host
