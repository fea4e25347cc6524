// SPDX-License-Identifier: MIT
#pragma once
// The records of a recording, as Recorder writes and Player reads them. Format, byte by byte:
// src/record/recorder.md.

#include "batuta/record/archive.hpp"

namespace batuta {

inline constexpr std::uint16_t kRecordingVersion = 1;

enum class RecordKind : std::uint8_t {
  kRun = 'R',   ///< the first one: how the run is recorded
  kStep = 'S',  ///< what a step was given
  kHash = 'H',  ///< of the state after so many steps
  kEnd = 'E',   ///< the last one: steps, hash of the last state, steps that are missing
};

inline constexpr int kRecordHead = 3;  ///< kind, length of the body with 16 bits
inline constexpr int kLargestBody = 65535;

struct RunRecord {
  std::uint16_t version = kRecordingVersion;
  std::uint32_t hash_every = 0;  ///< steps; 0: only at the end
  std::uint64_t input = 0;       ///< fingerprint of the type of the inputs

  void archive(Archive& ar) { ar(version, hash_every, input); }
};

template <class Input>
struct StepRecord {
  std::uint32_t step = 0;  ///< 0: the first one
  Input& input;

  void archive(Archive& ar) {
    ar(step);
    if constexpr (std::is_const_v<Input>) {
      ar.look_at(input);
    } else {
      ar(input);
    }
  }
};

struct HashRecord {
  std::uint32_t steps = 0;  ///< that were over
  std::uint64_t hash = 0;

  void archive(Archive& ar) { ar(steps, hash); }
};

struct EndRecord {
  HashRecord last;         ///< of the last state; the hash is 0 where steps are missing
  std::uint32_t lost = 0;  ///< steps that did not fit: all from last.steps on

  void archive(Archive& ar) { ar(last, lost); }
};

template <class Input>
std::uint64_t fingerprint_of(const Input& input) {
  ArchiveShape shape;
  shape.look_at(input);
  return shape.fingerprint();
}

}  // namespace batuta
