// SPDX-License-Identifier: MIT
#pragma once
// The sticks of a recorded bout, as the file of queries has them.

#include "batuta/port/input.hpp"
#include "digest/input.hpp"

namespace batuta::price {

/// Samples in the order of their steps, one record ahead.
class Sticks {
 public:
  explicit Sticks(digest::Input& input) : input_(input) { advance(); }

  /// Those of a step, null where there is none. Bound: the records of the chunk.
  void take(std::uint32_t step, const InputSample* (&taken)[2]);

 private:
  void advance();

  digest::Input& input_;
  InputSample samples_[2];
  InputSample ahead_;
  std::uint32_t step_ = 0;
  std::uint32_t side_ = 0;
  bool any_ = false;
};

}  // namespace batuta::price
