// SPDX-License-Identifier: MIT
#include "own_options.hpp"

#include <cstdio>
#include <cstdlib>
#include <string_view>

namespace batuta::report {

namespace {

[[noreturn]] void refuse(const char* option, const char* what) {
  std::fprintf(stderr, "batuta_report_misses: %s takes %s; --help tells what it takes\n", option,
               what);
  std::exit(2);
}

/// The whole of `text` as a number; ends the program where it is none.
double number_of(const char* option, const char* text) {
  char* end = nullptr;
  const double value = text == nullptr ? 0 : std::strtod(text, &end);
  if (text == nullptr || end == text || *end != '\0') refuse(option, "a number");
  return value;
}

/// The same for a seed, which is whole and not negative.
std::uint64_t seed_of(const char* option, const char* text) {
  constexpr double kMost = 9007199254740992.0;  // 2^53: whole numbers up to here
  const double value = number_of(option, text);
  if (!(value >= 0 && value <= kMost)) refuse(option, "a whole number from 0 to 2^53");
  const auto seed = static_cast<std::uint64_t>(value);
  if (static_cast<double>(seed) != value) refuse(option, "a whole number from 0 to 2^53");
  return seed;
}

}  // namespace

CampaignOptions parse_campaign(int argc, const char* const* argv, const About& about) {
  CampaignOptions options;
  std::vector<const char*> others;
  for (int i = 0; i < argc; ++i) {  // Bound: argc
    const std::string_view option = argv[i];
    const char* const value = i + 1 < argc ? argv[i + 1] : nullptr;
    if (option == "--seed") {
      options.seed = seed_of(argv[i], value);
      ++i;
    } else if (option == "--inflation-factor") {
      options.inflation = number_of(argv[i], value);
      options.sweeps = false;
      ++i;
    } else {
      others.push_back(argv[i]);
    }
  }
  options.common = parse(static_cast<int>(others.size()), others.data(), about);
  return options;
}

}  // namespace batuta::report
