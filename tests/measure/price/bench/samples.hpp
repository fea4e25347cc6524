// SPDX-License-Identifier: MIT
#pragma once
// What the bench tells: a file of little-endian words, six for each thing measured.

#include <cstdint>

#include "digest/io.hpp"

namespace batuta::price {

enum class Kind : std::uint32_t {
  kCalibration = 1,  ///< instructions; ticks
  kReading = 2,      ///< ticks of an empty measurement
  kMakePair = 3,     ///< index in the file; ticks
  kSearch = 4,       ///< index; ticks, outcome, evaluations, 0 or ticks of one evaluation more
  kSegment = 5,      ///< index; ticks
  kImpulse = 6,      ///< index; ticks, whether something was pushed
  kStep = 7,         ///< step; ticks, evaluations, contacts
  kConfigure = 8,    ///< step; ticks
  kStack = 9,        ///< chunk; deepest stack below the function of that chunk, B
  kSceneStep = 10,   ///< step; ticks, contacts, status
  kSceneState = 11,  ///< hash of the bodies at the end of a run
};

struct Sample {
  Kind kind = Kind::kReading;
  std::uint32_t index = 0;
  std::uint32_t ticks = 0;
  std::uint32_t more[3] = {0, 0, 0};
};

/// Collects samples and writes them in blocks.
class SampleFile {
 public:
  bool open(const char* path);
  void add(const Sample& sample);
  /// @returns whether all was written
  bool close();

 private:
  static constexpr std::uint32_t kBlock = 512;
  void flush();

  Sample block_[kBlock];
  std::uint32_t filled_ = 0;
  digest::File file_ = -1;
  bool ok_ = true;
};

}  // namespace batuta::price
