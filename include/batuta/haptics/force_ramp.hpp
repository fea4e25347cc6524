// SPDX-License-Identifier: MIT
#pragma once
// Silence takes the force away, slowly, and life brings it back, slowly: a stick whose samples stop
// must not be held by the last force, and must not be struck by the next one.

#include <cstdint>

#include "batuta/core/status.hpp"

namespace batuta::haptics {

/// How long a force lasts without life, and how fast it goes.
struct RampSettings {
  std::int32_t silent_after = 100;  ///< steps without life that are still no silence, >= 0
  std::int32_t length = 50;         ///< steps from full force to none, and back, > 0
};

/// @returns kOk | kInvalidArgument: out of range, or above a million steps
Status validate(const RampSettings& settings);

/// A share of the force, 0 ... 1, told once a step. Starts silent, at 0. Allocates: never.
class ForceRamp {
 public:
  /// Starts anew. @returns kOk | kInvalidArgument (nothing changed)
  Status configure(const RampSettings& settings);

  /// A step. Without life the share is 0 after at most silent_after + length of them.
  /// @param alive  something came in it. Bound: no loop.
  void advance(bool alive);

  /// Nothing is left at once. It comes back as slowly as ever, with the next step where there is no
  /// silence, and else with the next life. What was counted stays.
  void drop() { level_ = 0; }

  /// What is left of the force: 0 ... 1, exact at both ends.
  float share() const;
  /// Nothing has come for more than `silent_after` steps, or ever.
  bool is_silent() const { return silent_; }
  /// Silences that began since the start; that before the first sign of life is none.
  std::uint32_t silences() const { return silences_; }

 private:
  RampSettings settings_;
  std::int32_t quiet_ = 0;  ///< steps since something came; grows to silent_after + 1
  std::int32_t level_ = 0;  ///< 0 ... length
  std::uint32_t silences_ = 0;
  bool silent_ = true;
};

}  // namespace batuta::haptics
