// SPDX-License-Identifier: MIT
#include "options.hpp"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "timing.hpp"

namespace batuta::report {

namespace {

constexpr std::uint64_t kMaxShards = 1U << 20;

double seconds() {
  using Clock = std::chrono::steady_clock;
  return std::chrono::duration<double>(Clock::now().time_since_epoch()).count();
}

[[noreturn]] void refuse(const About& about, const std::string& why) {
  std::fprintf(stderr, "batuta_report_%s: %s; --help tells what it takes\n", about.section,
               why.c_str());
  std::exit(2);
}

/// A whole number of at most seven digits, or 0.
std::uint64_t number(std::string_view text) {
  if (text.empty() || text.size() > 7) return 0;
  std::uint64_t value = 0;
  for (const char digit : text) {
    if (digit < '0' || digit > '9') return 0;
    value = 10 * value + static_cast<std::uint64_t>(digit - '0');
  }
  return value;
}

void read_mode(Options& options, const About& about, std::string_view text) {
  if (text == "tiny") {
    options.mode = Mode::kTiny;
    measure_roughly();
  } else if (text == "quick") {
    options.mode = Mode::kQuick;
  } else if (text == "full") {
    options.mode = Mode::kFull;
  } else {
    refuse(about, "--mode is tiny, quick or full, not '" + std::string(text) + "'");
  }
}

void read_shard(Options& options, const About& about, std::string_view text) {
  const std::size_t slash = text.find('/');
  options.shard = number(text.substr(0, slash));
  options.shards = slash == std::string_view::npos ? 0 : number(text.substr(slash + 1));
  if (options.shard < 1 || options.shard > options.shards || options.shards > kMaxShards) {
    refuse(about, "--shard is I/N with 1 <= I <= N, not '" + std::string(text) + "'");
  }
}

void read(Options& options, const About& about, std::string_view name, const char* value) {
  if (name != "--out" && name != "--mode" && name != "--shard") {
    refuse(about, "'" + std::string(name) + "' is not known");
  }
  if (value == nullptr || *value == '\0') {
    refuse(about, std::string(name) + " lacks its value");
  }
  if (name == "--out") options.out = value;
  if (name == "--mode") read_mode(options, about, value);
  if (name == "--shard") read_shard(options, about, value);
}

}  // namespace

void print_help(const About& about) {
  const std::string files =
      about.files == nullptr ? std::string(about.section) + ".csv" : about.files;
  std::printf(
      "usage: batuta_report_%s [--out DIR] [--mode tiny|quick|full] [--shard I/N] [--help]\n"
      "%s\n"
      "  --out DIR     folder of %s (default: .)\n"
      "  --mode MODE   tiny: does it run; quick: some seconds (default); full: %s\n"
      "  --shard I/N   only the I-th of N parts; NAME.csv is then NAME.I-of-N.csv, and merge.py "
      "puts\n"
      "                the parts together again\n"
      "%s",
      about.section, about.what, files.c_str(), about.full_time, about.own_options);
}

Options parse(int argc, const char* const* argv, const About& about) {
  Options options;
  for (int i = 1; i < argc; i += 2) {
    if (std::string_view(argv[i]) == "--help") {
      print_help(about);
      std::exit(0);
    }
    read(options, about, argv[i], i + 1 < argc ? argv[i + 1] : nullptr);
  }
  if (options.mode == Mode::kFull) {
    std::fprintf(stderr, "%s: the full mode takes %s, divided by the number of shards\n",
                 about.section, about.full_time);
  }
  return options;
}

Progress::Progress(std::string what, std::uint64_t total)
    : what_(std::move(what)), total_(total), start_(seconds()), said_(start_) {
  std::fprintf(stderr, "%s: 0 of %llu\n", what_.c_str(), static_cast<unsigned long long>(total_));
}

void Progress::advance(std::uint64_t by) {
  done_ += by;
  const double now = seconds();
  if (now - said_ >= 1 || done_ >= total_) say(now);
}

void Progress::say(double now) {
  said_ = now;
  const double left = done_ == 0 ? 0
                                 : (now - start_) * static_cast<double>(total_ - done_) /
                                       static_cast<double>(done_);
  std::fprintf(stderr, "%s: %llu of %llu, %.1f s, about %.0f s left\n", what_.c_str(),
               static_cast<unsigned long long>(done_), static_cast<unsigned long long>(total_),
               now - start_, left);
}

}  // namespace batuta::report
