// SPDX-License-Identifier: MIT
// Measures the table of the fight, looks for better keys of the map and draws it. Everything is
// played through the stick, by scripts that know only their own clock.

#include <cstdio>
#include <cstdlib>
#include <string>

#include "fencers.hpp"
#include "figure.hpp"
#include "programs/files/output_file.hpp"
#include "programs/files/standard_output.hpp"
#include "search.hpp"
#include "table.hpp"

namespace {
using namespace fight;

constexpr const char* kUsage =
    "usage: batuta-fight map [KEYS]\n"
    "       batuta-fight table TRIES SEED [KEYS [WHO]] KEYS -: the library's own map, as without;\n"
    "                                                  WHO 11, 12, 21, 22: attacker, defender\n"
    "       batuta-fight ripostes TRIES SEED [KEYS]    which lunge follows which parry\n"
    "       batuta-fight search TRIES ROUNDS SEED KEYS\n"
    "       batuta-fight figure FILE                   of the library's own map";

int refuse(const std::string& why) {
  std::fprintf(stderr, "batuta-fight: %s\n", why.c_str());
  return 2;
}

/// What was typed after the command.
class Words {
 public:
  Words(int count, char** words) : count_(count), words_(words) {}

  bool are(int least, int most) const { return count_ - 2 >= least && count_ - 2 <= most; }
  const char* text(int i) const { return words_[2 + i]; }
  const char* text_or(int i, const char* otherwise) const {
    return count_ > 2 + i ? text(i) : otherwise;
  }
  /// 0: not a count.
  int number(int i) const { return static_cast<int>(std::strtol(text(i), nullptr, 10)); }
  std::uint64_t seed(int i) const { return std::strtoull(text(i), nullptr, 10); }

 private:
  int count_;
  char** words_;
};

int print_map(const Words& words) {
  if (!words.are(0, 1)) return refuse(kUsage);
  Knobs knobs;
  const std::string wrong = knobs.load(words.text_or(0, BATUTA_FIGHT_KEYS));
  if (!wrong.empty()) return refuse(wrong);
  print_keys(keys_from(knobs), stdout);
  return 0;
}

/// The keys that were named.
struct Named {
  Keys keys{};
  bool any = false;
  std::string wrong;

  const Keys* get() const { return any ? &keys : nullptr; }
};

Named named(const char* path) {
  Named result;
  if (path == nullptr || std::string(path) == "-") return result;
  Knobs knobs;
  result.wrong = knobs.load(path);
  if (result.wrong.empty()) result.keys = keys_from(knobs);
  result.any = true;
  return result;
}

int print_table(const Words& words) {
  const std::string who = words.text_or(3, "11");
  const bool is_pair = who == "11" || who == "12" || who == "21" || who == "22";
  if (!words.are(2, 4) || words.number(0) <= 0 || !is_pair) return refuse(kUsage);
  const Named map = named(words.text_or(2, nullptr));
  if (!map.wrong.empty()) return refuse(map.wrong);
  const Choices chosen = choices();
  const auto cases = all_cases(chosen);
  const Trials trials{words.number(0), words.seed(1)};
  const auto fencer = [](char name) { return name == '1' ? Who::kFirst : Who::kSecond; };
  const Pair pair = pair_with(map.get(), fencer(who[0]), fencer(who[1]));
  print(table_of(cases, play_all(pair, cases, chosen, trials)), stdout);
  return 0;
}

/// Every riposte after every parry, in percent of the parries that held.
int print_ripostes(const Words& words) {
  if (!words.are(2, 3) || words.number(0) <= 0) return refuse(kUsage);
  const Named map = named(words.text_or(2, nullptr));
  if (!map.wrong.empty()) return refuse(map.wrong);
  std::vector<Case> cases;
  for (int line = 0; line < kLines; ++line) {
    for (int answer = 0; answer < kLines; ++answer) {
      cases.push_back(
          {Situation::kRiposteStays, static_cast<Line>(line), static_cast<Line>(answer)});
    }
  }
  const Trials trials{words.number(0), words.seed(1)};
  const auto tallies = play_all(pair_with(map.get()), cases, choices(), trials);
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const Tally& tally = tallies[i];
    std::printf("%-8s then %-12s %5.1f %% of %d\n", kParryNames[i / kLines], kLineNames[i % kLines],
                tally.ripostes > 0 ? 100.0 * tally.landed / tally.ripostes : 0, tally.ripostes);
  }
  return 0;
}

int climb(const Words& words) {
  if (!words.are(4, 4) || words.number(0) <= 0 || words.number(1) <= 0) return refuse(kUsage);
  const std::string wrong =
      search({words.number(0), words.number(1), words.seed(2), words.text(3)});
  return wrong.empty() ? 0 : refuse(wrong);
}

int draw(const Words& words) {
  if (!words.are(1, 1)) return refuse(kUsage);
  const std::string path = words.text(0);
  batuta::host::OutputFile file;
  std::string wrong = file.open(path);
  if (wrong.empty()) {
    draw_map(batuta::fencing::first_fencer<float>(), file.stream());
    wrong = file.commit();
  }
  return wrong.empty() ? 0 : refuse(path + ": cannot be written: " + wrong);
}

int help() {
  std::printf("%s\n", kUsage);
  return 0;
}

int run_program(int count, char** words) {
  const std::string command = count > 1 ? words[1] : "";
  const Words rest(count, words);
  if (command == "--help") return help();
  if (command == "map") return print_map(rest);
  if (command == "table") return print_table(rest);
  if (command == "ripostes") return print_ripostes(rest);
  if (command == "search") return climb(rest);
  if (command == "figure") return draw(rest);
  return refuse(kUsage);
}

}  // namespace

int main(int count, char** words) {
  batuta::host::begin_output();
  return batuta::host::finish_output("batuta-fight", run_program(count, words));
}
