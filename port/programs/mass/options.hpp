// SPDX-License-Identifier: MIT
#pragma once
// The command line of batuta-mass.

#include <optional>
#include <string>

namespace batuta::mesh {

/// Exit codes of the program; --help tells them.
inline constexpr int kExitOk = 0;
inline constexpr int kExitRefused = 1;  ///< the mesh cannot be used, or the output not written
inline constexpr int kExitUsage = 2;    ///< wrong usage, or a file that cannot be read

struct Options {
  std::string file;
  double density = 7850;       ///< kg/m^3: steel
  std::optional<double> mass;  ///< kg, in place of the density
  double scale = 1;            ///< m per unit of the file
  bool json = false;
};

/// What the command line asks for.
struct CommandLine {
  bool run = false;  ///< false: leave with `exit_code`; everything has been said
  int exit_code = kExitOk;
  Options options;
};

CommandLine read_command_line(int count, char** words);

}  // namespace batuta::mesh
