// SPDX-License-Identifier: MIT
#pragma once
// Include it to save, restore, record or hash a Duel, with all that it holds.

#include "batuta/record/detail/duel.hpp"

namespace batuta::fencing {

/// What the sticks bring to one step of a duel, as step() takes it: the input of a recording.
struct DuelInput {
  std::array<InputSample, 2> samples{};  ///< by index_of(side)
  std::array<bool, 2> fresh{};           ///< a sample came

  /// A side's sample of this step. @param sample  null: none came
  void set(Side side, const InputSample* sample) {
    fresh[index_of(side)] = sample != nullptr;
    if (sample != nullptr) samples[index_of(side)] = *sample;
  }
  /// Null where none came.
  const InputSample* at(Side side) const {
    return fresh[index_of(side)] ? &samples[index_of(side)] : nullptr;
  }
};

/// Lists the members of an input, for record/archive.hpp. Samples that did not come take no bytes.
inline void archive(Archive& ar, DuelInput& input) {
  auto& [samples, fresh] = input;
  ar(fresh);
  for (const Side side : {Side::kLeft, Side::kRight}) {  // Bound: 2
    if (ar.shaping() || fresh[index_of(side)]) ar(samples[index_of(side)]);
  }
}

}  // namespace batuta::fencing
