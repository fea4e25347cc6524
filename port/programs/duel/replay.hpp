// SPDX-License-Identifier: MIT
#pragma once
// Goes through a recorded bout again, and says whether every step came out the same.

#include <string>

#include "batuta/record/player.hpp"

namespace batuta::host {

struct Replay {
  std::string path;
  std::string error;  ///< of the file; empty: it could be opened
  Playback answer = Playback::kWaiting;
  bool goes_on = false;      ///< behind its end mark
  std::uint32_t steps = 0;   ///< made
  std::uint32_t hashes = 0;  ///< that agreed
  std::uint32_t lost = 0;    ///< steps that the recording says are missing
};

Replay replay(const std::string& path);

/// What became of it, for a person.
std::string words_for(const Replay& replay);

/// Of the program, as --help tells.
int exit_code_for(const Replay& replay);

}  // namespace batuta::host
