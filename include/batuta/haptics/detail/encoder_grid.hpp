// SPDX-License-Identifier: MIT
#pragma once
// The step of an encoder, from the positions that it shows: the greatest common divisor of their
// differences, to the rounding of float, block by block; what most blocks say counts, so that a
// sample that is off the grid spoils one of them. Mathematics: src/haptics/device_measurement.md.

#include "batuta/core/types.hpp"

namespace batuta::detail {

/// What divides some ways.
struct GridStep {
  float step = 0;   ///< u; 0: none yet, or one that rounding does not let tell
  float error = 0;  ///< by how much it may be off; of a step of 0: what it is at most
};

/// Of one axis. Allocates: never.
class EncoderGrid {
 public:
  /// The next position shown. @pre finite. Bound: kDivisions.
  void take(float shown);
  /// A block is over: of ways that differ, as from turn to turn. Bound: no loop.
  void end_block();

  /// Whether enough blocks were seen that told a step.
  bool is_known() const { return blocks_ >= kLeastBlocks; }
  /// Whether three quarters of them say what step() says. A step too small, of a sample that was
  /// off the grid, would be on the unsafe side.
  bool is_sure() const { return is_known() && 2 * lead_ >= blocks_; }
  /// 0: none was seen, or one that rounding does not let tell.
  float step() const { return most_.step; }
  /// By how much the step may be off; where it is finer than can be told, what it is at most.
  float error() const { return most_.error; }

 private:
  /// A step less than so many roundings of a difference is no grid, for rounding makes one.
  static constexpr float kLeastSteps = 32;
  static constexpr int kDivisions = 24;
  static constexpr int kEnough = 16;  ///< differences that were multiples of it, in a block
  static constexpr int kLeastBlocks = 8;

  bool divide(float way);
  bool is_same(const GridStep& one, const GridStep& other) const;

  GridStep most_;   ///< what most blocks say
  GridStep block_;  ///< of the block
  float last_ = 0;
  float largest_ = 0;   ///< position so far
  float rounding_ = 0;  ///< of a difference
  int count_ = 0;       ///< of the block's differences, multiples of its step
  int blocks_ = 0;      ///< that told one
  int lead_ = 0;        ///< blocks that say most_, less those that say something else
  bool has_last_ = false;
  bool is_fine_ = false;  ///< the block
};

}  // namespace batuta::detail
