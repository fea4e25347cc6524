// SPDX-License-Identifier: MIT
#pragma once
// Goes through a recorded bout again, and says whether every step came out the same.

#include <string>

#include "batuta/record/duel.hpp"
#include "batuta/record/player.hpp"
#include "programs/duel/seen_duel.hpp"

namespace batuta::host {

struct Replay {
  std::string path;
  SearchKind search = SearchKind::kAdvancement;  ///< with which it was recorded
  std::string error;                             ///< of the file; empty: it could be opened
  Playback answer = Playback::kWaiting;
  bool began = false;        ///< the duel stood as at the start of the recording
  bool goes_on = false;      ///< behind its end mark
  bool broken_off = false;   ///< by who watched it
  std::uint32_t steps = 0;   ///< made
  std::uint32_t hashes = 0;  ///< that agreed
  std::uint64_t hash = 0;    ///< of the duel where it ended; 0: it did not begin
  std::uint32_t lost = 0;    ///< steps that the recording says are missing
  int version = 0;           ///< of the recording's format; 0: it could not be read
  int state_version = 0;     ///< of the format of its first state; 0: it could not be read
};

/// Sees a recorded bout go by.
class ReplayWatcher {
 public:
  ReplayWatcher() = default;
  ReplayWatcher(const ReplayWatcher&) = delete;
  ReplayWatcher& operator=(const ReplayWatcher&) = delete;
  virtual ~ReplayWatcher() = default;

  /// The duel stands as at the start of the recording.
  virtual void on_start(const SeenDuel& duel) = 0;
  /// It has made a step. @returns whether the replay goes on
  virtual bool on_step(const SeenDuel& duel) = 0;
};

/// @param watcher  or null
Replay replay(const std::string& path, ReplayWatcher* watcher = nullptr);

/// What became of it, for a person.
std::string words_for(const Replay& replay);

/// Of the program, as --help tells.
int exit_code_for(const Replay& replay);

}  // namespace batuta::host
