// SPDX-License-Identifier: MIT
// Measures the fight, looks for better keys and draws the map: tests/measure/fight/README.md.

#include <cstdio>
#include <cstring>
#include <string>

#include "keys.hpp"

namespace {
using namespace fight;

int refuse(const std::string& why) {
  std::fprintf(stderr, "batuta-fight: %s\n", why.c_str());
  return 2;
}

int print_map(const std::string& path) {
  Knobs knobs;
  const std::string wrong = knobs.load(path);
  if (!wrong.empty()) return refuse(wrong);
  print_keys(keys_from(knobs), stdout);
  return 0;
}

}  // namespace

int main(int count, char** words) {
  const std::string command = count > 1 ? words[1] : "";
  if (command == "map") return print_map(count > 2 ? words[2] : BATUTA_FIGHT_KEYS);
  return refuse("usage: batuta-fight map [KEYS]");
}
