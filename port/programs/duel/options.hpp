// SPDX-License-Identifier: MIT
#pragma once
// The command line of batuta-duel.

#include <limits>
#include <string>

namespace batuta::host {

/// Exit codes of the program; --help tells them.
inline constexpr int kExitOk = 0;       ///< the bout ran
inline constexpr int kExitFailure = 1;  ///< something went wrong on the way
inline constexpr int kExitUsage = 2;    ///< wrong usage, or a source that cannot be read

struct Options {
  std::string left = "default";
  std::string right = "script:parry";
  std::string svg;      ///< empty: no picture
  std::string figure;   ///< of the hardest beat; empty: none
  std::string strip;    ///< of the last touch; empty: none
  std::string record;   ///< file for the whole bout; empty: none
  std::string replay;   ///< recorded bout to go through instead of one of two sources; empty: none
  int touches = 5;      ///< to which the bout goes
  double distance = 0;  ///< of the fencers on guard, m; 0: as it suits who fences
  std::string search = "advancement";  ///< or "stepping"
  double seconds = std::numeric_limits<double>::infinity();
  bool view = false;  ///< in a window, as it happens
  bool json = false;
  bool realtime = false;
  std::string force = "on";  ///< or "off"
  float spring = 0;          ///< of a force feedback device's own, 0 ... 1
  float damper = 0;
  double patience = 2;  ///< s of silence of a device on a serial line that are waited for
};

/// What the command line asks for.
struct CommandLine {
  bool run = false;  ///< false: leave with `exit_code`; everything has been said
  int exit_code = kExitOk;
  Options options;
};

CommandLine read_command_line(int count, char** words);

}  // namespace batuta::host
