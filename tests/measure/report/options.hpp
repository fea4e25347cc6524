// SPDX-License-Identifier: MIT
#pragma once
// Command line of a section, and which part of a sweep this run is.

#include <cstdint>
#include <string>

namespace batuta::report {

enum class Mode : std::uint8_t {
  kTiny,   ///< a second at most: shows that the program runs
  kQuick,  ///< some ten seconds: what `cmake --workflow --preset report` and CI run
  kFull,   ///< as long as the figures need
};

struct Options {
  std::string out = ".";  ///< folder of the CSV; made if absent
  Mode mode = Mode::kQuick;
  std::uint64_t shard = 1;  ///< 1 ... shards
  std::uint64_t shards = 1;
};

/// What --help says about a section.
struct About {
  const char* section;           ///< name of the program after batuta_report_, and of its CSV file
  const char* what;              ///< one sentence
  const char* full_time;         ///< how long the full mode takes, such as "2 minutes"
  const char* files = nullptr;   ///< what it writes, where that is not <section>.csv
  const char* own_options = "";  ///< whole lines about options that no other section has
};

/// What --help prints, on standard output.
void print_help(const About& about);

/// Reads --out DIR, --mode tiny|quick|full, --shard I/N, --help. Ends the program with 0 after
/// --help, and with 2 and a sentence on standard error where the command line makes no sense.
/// In full mode it says how long that takes.
Options parse(int argc, const char* const* argv, const About& about);

/// The value for the mode at hand, such as a number of queries.
constexpr std::uint64_t pick(const Options& options, std::uint64_t tiny, std::uint64_t quick,
                             std::uint64_t full) {
  if (options.mode == Mode::kTiny) return tiny;
  return options.mode == Mode::kQuick ? quick : full;
}

/// Indices first <= i < last.
struct Range {
  std::uint64_t first = 0;
  std::uint64_t last = 0;
};

/// This shard's part of 0 ... count - 1. The parts of all shards are disjoint and make up the
/// whole; no two differ by more than one. @pre count < 2^40, shards < 2^20
constexpr Range share_of(const Options& options, std::uint64_t count) {
  return {count * (options.shard - 1) / options.shards, count * options.shard / options.shards};
}

/// Lines on standard error: at the beginning, then at most one a second, and at the end.
class Progress {
 public:
  Progress(std::string what, std::uint64_t total);
  void advance(std::uint64_t by = 1);

 private:
  void say(double now);

  std::string what_;
  std::uint64_t total_;
  std::uint64_t done_ = 0;
  double start_;
  double said_;
};

}  // namespace batuta::report
