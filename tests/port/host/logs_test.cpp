// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <regex>
#include <sstream>
#include <string>

#include "batuta/fencing/opponent.hpp"
#include "bouts.hpp"
#include "heap_trap.hpp"
#include "programs/duel/bout_log.hpp"
#include "programs/duel/json_log.hpp"
#include "programs/duel/progress_bar.hpp"

namespace batuta::host {
namespace {

using testing::HasSubstr;
using testing::Not;

/// A stream into memory.
class TextFile {
 public:
  TextFile() : file_(open_memstream(&text_, &size_)) {}
  TextFile(const TextFile&) = delete;
  TextFile& operator=(const TextFile&) = delete;
  ~TextFile() {
    std::fclose(file_);
    std::free(text_);
  }
  std::FILE* file() { return file_; }
  std::string text() {
    std::fflush(file_);
    return {text_, size_};
  }

 private:
  char* text_ = nullptr;
  std::size_t size_ = 0;
  std::FILE* file_;
};

template <class Log>
std::string log_of(BoutRig& bout) {
  TextFile out;
  Log log(out.file());
  bout.run(&log);
  return out.text();
}

TEST(BoutLog, TellsTheBout) {
  BoutRig bout("default", "script:parry");
  const std::string log = log_of<BoutLog>(bout);
  for (const char* words : {"left   default (batuta synthetic stick)", "right  script parry",
                            "en garde", "beat", "N s at", "part    after", "left touches the torso",
                            "left wins", "samples used", "us a step"}) {
    EXPECT_THAT(log, HasSubstr(words));
  }
  EXPECT_LT(std::count(log.begin(), log.end(), '\n'), 100) << "for people";
}

TEST(BoutLog, ABoutToTwo_TouchByTouch) {
  BoutRig bout("script:attack", "script:guard", 60, {2, SearchKind::kStepping});
  const std::string log = log_of<BoutLog>(bout);
  EXPECT_THAT(log, HasSubstr("to 2 touches, search stepping"));
  EXPECT_THAT(log, HasSubstr("s  halt    1 : 0\n"));
  EXPECT_THAT(log, HasSubstr("s  halt    left wins, 2 : 0\n"));
  std::size_t en_garde = 0;
  for (std::size_t at = log.find("en garde"); at != std::string::npos;
       at = log.find("en garde", at + 1)) {
    ++en_garde;
  }
  EXPECT_EQ(en_garde, 2U);
}

/// Blade on blade and blade on guard at once are one meeting, which ends with the last of them.
TEST(BoutLog, WeaponsPartOnce) {
  BoutRules rules;
  rules.touches = 5;
  rules.distance = fencing::Opponent::kOnGuard;
  int parts = 0;
  using Players = std::array<const char*, 2>;
  for (const Players& players :
       {Players{"script:master", "script:parry"}, Players{"script:club", "script:club@2"},
        Players{"script:club", "script:novice@117"}}) {
    BoutRig bout(players[0], players[1], 60, rules);
    std::istringstream log(log_of<BoutLog>(bout));
    const std::regex part("^ *([0-9.]+) s  part    after ([0-9]+) ms");
    double before = 0;
    for (std::string line; std::getline(log, line);) {
      std::smatch told;
      if (!std::regex_search(line, told, part)) continue;
      const double end = std::stod(told[1]);
      constexpr double kRounding = 1.1e-3;  // s: of both numbers
      EXPECT_GT(end - 1e-3 * std::stod(told[2]), before - kRounding) << line;
      before = end;
      ++parts;
    }
  }
  EXPECT_GT(parts, 8) << "else this shows nothing";
}

TEST(JsonLog, ABoutToTwo_TouchByTouch) {
  BoutRig bout("script:attack", "script:guard", 60, {2, SearchKind::kStepping});
  const std::string log = log_of<JsonLog>(bout);
  EXPECT_THAT(log, HasSubstr("\"search\":\"stepping\""));
  EXPECT_THAT(log, HasSubstr("\"touches\":2"));
  EXPECT_THAT(log, HasSubstr("\"exchange\":1,\"score_left\":1,\"score_right\":0,"
                             "\"annulled\":false"));
  const std::string summary = log.substr(log.rfind('\n', log.size() - 2) + 1);
  EXPECT_THAT(summary, HasSubstr("\"score_left\":2,\"score_right\":0,\"exchanges\":2"));
  EXPECT_THAT(summary, HasSubstr("\"touch_by\":\"left\""));
}

/// Feet that press on, behind a parry.
class PressingFeet final : public Source {
 public:
  std::string description() const override { return "feet that press on"; }
  double duration() const override { return std::numeric_limits<double>::infinity(); }

 private:
  Status do_read(Microseconds now, InputSample& sample) override {
    sample = {};
    sample.time = now;
    sample.sequence = ++count_;
    sample.x = -1;
    sample.feet_y = 1;
    return Status::kOk;
  }
  std::uint32_t count_ = 0;
};

/// What a log says of a bout of two who press on until they stand body to body.
template <class Log>
std::string log_of_pressing() {
  PressingFeet left;
  PressingFeet right;
  DuelRunner runner(left, right, 4, {2});
  EXPECT_EQ(runner.start(), Status::kOk);
  TextFile out;
  Log log(out.file());
  log.on_start(runner);
  while (runner.step()) log.on_step(runner);  // Bound: the limit of the bout
  return out.text();
}

TEST(BoutLog, CorpsACorps_IsTold) {
  EXPECT_THAT(log_of_pressing<BoutLog>(), HasSubstr("s  halt    0 : 0, corps a corps\n"));
  EXPECT_THAT(log_of_pressing<JsonLog>(), HasSubstr("\"annulled\":false,\"corps_a_corps\":true}"));
}

// After a halt nobody is touched: the summary still tells the last touch.
TEST(JsonLog, LastTouch_IsThatOfAnEarlierExchange) {
  BoutRig bout("script:attack", "script:guard", 3.3, {5});
  const std::string log = log_of<JsonLog>(bout);
  EXPECT_EQ(bout.runner->duel().bout().touches.size(), 0);
  const std::string summary = log.substr(log.rfind('\n', log.size() - 2) + 1);
  EXPECT_THAT(summary, HasSubstr("\"touch_by\":\"left\""));
  EXPECT_THAT(summary, HasSubstr("\"result\":\"left\""));
}

TEST(BoutLog, ADraw_AndARecordingThatEnded) {
  BoutRig bout("default", "script:guard", 20);
  const std::string until_touch = log_of<BoutLog>(bout);
  EXPECT_THAT(until_touch, Not(HasSubstr("the stick stayed")));
  BoutRig guards("script:guard", "script:guard", 0.5);
  EXPECT_THAT(log_of<BoutLog>(guards), HasSubstr("0.500 s  halt    draw"));
}

TEST(JsonLog, FirstTheStart_LastTheSummary) {
  BoutRig bout("default", "script:parry");
  const std::string log = log_of<JsonLog>(bout);
  EXPECT_EQ(log.rfind("{\"type\":\"start\"", 0), 0U);
  const std::size_t last = log.rfind('\n', log.size() - 2) + 1;
  EXPECT_EQ(log.compare(last, 18, "{\"type\":\"summary\","), 0) << log.substr(last);
  EXPECT_THAT(log.substr(last), HasSubstr("\"result\":\"left\""));
  EXPECT_THAT(log, HasSubstr("{\"type\":\"touch\""));
  EXPECT_THAT(log, HasSubstr("\"event\":\"begin\",\"kind\":\"colliding\""));
  EXPECT_THAT(log, HasSubstr("\"event\":\"end\""));
}

TEST(ProgressBar, GrowsAndGoesAway) {
  BoutRig bout("script:guard", "script:guard", 1);
  TextFile out;
  ProgressBar bar(out.file());
  bout.run(&bar);
  EXPECT_THAT(out.text(), HasSubstr("]  50 %"));
  EXPECT_THAT(out.text(), HasSubstr("\r\033[K")) << "erased at the end";
}

/// The text allocates nothing while the bout goes on, but for what the stream itself does; a JSON
/// object is made on the heap.
template <class Log>
int allocations_of(const char* path) {
  std::FILE* out = std::fopen(path, "w");
  Log log(out);
  BoutRig bout("default", "script:parry");
  log.on_start(*bout.runner);
  int allocations = 0;
  bool going_on = true;
  while (going_on) {
    const test::HeapTrap trap;
    going_on = bout.runner->step();
    log.on_step(*bout.runner);
    allocations += trap.allocations();
  }
  std::fclose(out);
  return allocations;
}

TEST(BoutLog, AllocatesNothing_WhileTheBoutGoesOn) {
  EXPECT_EQ(allocations_of<BoutLog>("/dev/null"), 0);
}

}  // namespace
}  // namespace batuta::host
