// SPDX-License-Identifier: MIT
#pragma once
// The records of a recording, as Recorder writes and Player reads them. Format, byte by byte:
// src/record/recorder.md.

#include "batuta/record/archive.hpp"

namespace batuta {

namespace detail {

/// Of the format of what follows the state; another one is not read.
inline constexpr std::uint16_t kRecordingVersion = 2;

/// What a record of a recording tells; src/record/recorder.md.
enum class RecordKind : std::uint8_t {
  kRun = 'R',   ///< the first one: how the run is recorded
  kStep = 'S',  ///< what a step was given
  kHash = 'H',  ///< of the state after so many steps
  kEnd = 'E',   ///< the last one: steps, hash of the last state, steps that are missing
};

inline constexpr int kRecordHead = 3;       ///< kind, length of the body with 16 bits
inline constexpr int kLargestBody = 65535;  ///< bytes of the body of a record, at most

/// The first record: how the run is recorded.
struct RunRecord {
  std::uint16_t version = kRecordingVersion;  ///< of the format
  std::uint32_t hash_every = 0;               ///< steps; 0: only at the end
  std::uint64_t input = 0;                    ///< fingerprint of the type of the inputs

  /// Lists what is written.
  void archive(Archive& ar) { ar(version, hash_every, input); }
};

/// What a step was given.
template <class Input>
struct StepRecord {
  std::uint32_t step = 0;  ///< 0: the first one
  Input& input;            ///< of the step; refers to that of the caller

  /// Lists what is written.
  void archive(Archive& ar) {
    ar(step);
    if constexpr (std::is_const_v<Input>) {
      ar.look_at(input);
    } else {
      ar(input);
    }
  }
};

/// What the state was after so many steps.
struct HashRecord {
  std::uint32_t steps = 0;  ///< that were over
  std::uint64_t hash = 0;   ///< hash_of() the state

  /// Lists what is written.
  void archive(Archive& ar) { ar(steps, hash); }
};

/// The last record.
struct EndRecord {
  HashRecord last;         ///< of the last state; the hash is 0 where steps are missing
  std::uint32_t lost = 0;  ///< steps that did not fit: all from last.steps on

  /// Lists what is written.
  void archive(Archive& ar) { ar(last, lost); }
};

}  // namespace detail

/// Tells the type of the inputs from others: its members and capacities.
template <class Input>
std::uint64_t fingerprint_of(const Input& input) {
  ArchiveShape shape;
  shape.look_at(input);
  return shape.fingerprint();
}

}  // namespace batuta
