// SPDX-License-Identifier: MIT
#pragma once
// A force changes by no more than so much in a step. src/haptics/output_stage.md.

#include "batuta/core/status.hpp"

namespace batuta::haptics {

/// Of one axis. Starts at force zero. Allocates: never.
class SlewLimiter {
 public:
  /// Starts anew, at zero. @param most  largest change in one step, > 0, finite
  /// @returns kOk | kInvalidArgument (nothing changed)
  Status configure(float most);

  /// A step towards `share`; there, exactly, if it is near enough. @pre finite. Bound: no loop.
  /// @returns between the last one and `share`
  float towards(float share);

  /// Zero at once.
  void drop() { last_ = 0; }

 private:
  float most_ = 0;
  float last_ = 0;
};

}  // namespace batuta::haptics
