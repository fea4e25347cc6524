// SPDX-License-Identifier: MIT
// batuta-opponents BOUTS SEED [FIRST SECOND]: how the opponents that see fence each other, and
// against loops that see nothing; a line for each pairing. Exit code 1: a blade was inside a guard
// or hand, or touched out of control.

#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "bouts.hpp"
#include "programs/files/standard_output.hpp"

namespace {
using namespace bouts;
using batuta::fencing::Intent;

void print(const std::string& first, const std::string& second, const Tally& tally) {
  std::printf(
      "| %s over %s | %.1f | %.1f | %.1f | %.1f | %.2f | %.0f | %.0f | %.0f | %.0f | %.3f | %.1f | "
      "%.1f | %.3f |\n",
      first.c_str(), second.c_str(), tally.share(tally.won), tally.share(tally.drawn),
      tally.share(tally.ended), tally.seconds / tally.bouts,
      static_cast<double>(tally.corps_a_corps) / tally.bouts, tally.kind(Intent::kAttack),
      tally.kind(Intent::kRiposte), tally.kind(Intent::kCounter), tally.kind(Intent::kBeat),
      1e3 * tally.deepest, 1e3 * tally.in_trunk, 1e3 * tally.in_limb,
      100.0 * tally.steps_in_body / tally.steps);
  std::fflush(stdout);
}

int usage(std::FILE* out) {
  std::fprintf(out, "usage: batuta-opponents BOUTS SEED [FIRST SECOND]\n");
  return out == stderr ? 2 : 0;
}

int run_program(int count, char** words) {
  if (count == 2 && std::strcmp(words[1], "--help") == 0) return usage(stdout);
  const int bouts = count > 2 ? std::atoi(words[1]) : 0;
  if (bouts <= 0 || (count != 3 && count != 5)) return usage(stderr);
  const auto seed = static_cast<std::uint32_t>(std::strtoul(words[2], nullptr, 10));
  std::vector<std::array<std::string, 2>> pairings;
  if (count == 5) {
    pairings = {{words[3], words[4]}};
  } else {
    pairings = {{"club", "novice"},   {"master", "club"},   {"club", "club"},
                {"master", "novice"}, {"novice", "novice"}, {"master", "master"}};
    for (const std::string& loop : names_of_loops()) {
      for (const char* opponent : {"novice", "club", "master"})
        pairings.push_back({loop, opponent});
    }
  }
  std::printf(
      "| pairing | won %% | drawn %% | ended %% | s a bout | corps a corps a bout | attack %% | "
      "riposte %% | counter %% | beat %% | in a weapon mm | in a trunk mm | in a limb mm | "
      "steps in a body %% |\n| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | "
      "---: | ---: | ---: | ---: | ---: |\n");
  Tally all;
  for (const auto& [first, second] : pairings) {
    if (batuta::host::is_output_lost()) break;
    const Tally tally = play_pairing(first, second, bouts, seed);
    print(first, second, tally);
    all.add(tally);
  }
  std::printf("\n%d bouts: %d with a blade in a guard or hand, %d touches out of control\n",
              all.bouts, all.in_weapon, all.out_of_control);
  return all.in_weapon + all.out_of_control > 0 ? 1 : 0;
}

}  // namespace

int main(int count, char** words) {
  batuta::host::begin_output();
  return batuta::host::finish_output("batuta-opponents", run_program(count, words));
}
