// SPDX-License-Identifier: MIT
#pragma once
// What the user asked for.

#include <string>
#include <variant>

#include "query_kind.hpp"

namespace batuta::answer {

enum class Kind { kTimeOfContact, kDistance, kImpulse };

QueryKind kind_of(Kind kind);

struct Command {
  Kind kind = Kind::kTimeOfContact;
  std::string in;   ///< "-": standard input
  std::string out;  ///< "-": standard output
  bool in_float = false;
  SearchSettings search;
};

/// Exit status of a program that has nothing more to do.
struct Exit {
  int status = 0;
};

/// Wrong usage is an answer too.
inline constexpr int kExitIncomplete = 1;  ///< a line was invalid, or the answers are not written
inline constexpr int kExitUsage = 2;

/// The command, or the exit status after help (0) or one line about what is wrong (kExitUsage) was
/// printed.
std::variant<Command, Exit> read_command_line(int argc, char** argv);

}  // namespace batuta::answer
