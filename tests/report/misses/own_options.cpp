// SPDX-License-Identifier: MIT
#include "own_options.hpp"

#include <cstdio>
#include <cstdlib>
#include <string_view>

namespace batuta::report {

namespace {

/// The whole of `text` as a number; ends the program where it is none.
double number_of(const char* option, const char* text) {
  char* end = nullptr;
  const double value = text == nullptr ? 0 : std::strtod(text, &end);
  if (text != nullptr && end != text && *end == '\0') return value;
  std::fprintf(stderr, "%s takes a number\n", option);
  std::exit(2);
}

}  // namespace

CampaignOptions parse_campaign(int argc, const char* const* argv, const About& about) {
  CampaignOptions options;
  std::vector<const char*> others;
  for (int i = 0; i < argc; ++i) {  // Bound: argc
    const std::string_view option = argv[i];
    const char* const value = i + 1 < argc ? argv[i + 1] : nullptr;
    if (option == "--seed") {
      options.seed = static_cast<std::uint64_t>(number_of(argv[i], value));
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
