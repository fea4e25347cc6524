// SPDX-License-Identifier: MIT
#include "timing.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <sstream>
#include <string>
#include <thread>

#include "table.hpp"

namespace batuta::report {
namespace {

void rest() {
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
}

/// Some work that does not depend on anything.
void work() {
  volatile double x = 1;
  for (int i = 0; i < 1000; ++i) x = x + 1 / x;
}

TEST(Baseline, EvenBatches_AreCalm) {
  const Baseline even = baseline_of({100, 104, 101, 103, 102}, 1, 1);
  EXPECT_EQ(even.ns, 102);
  EXPECT_NEAR(even.spread, 0.02, 1e-12);
  EXPECT_EQ(even.waited, 0);
  EXPECT_TRUE(even.is_calm());
  // Two that were interrupted do not move the median.
  EXPECT_TRUE(baseline_of({100, 900, 101, 700, 102}, 1, 0.99).is_calm());
}

TEST(Baseline, InterruptedBatches_AreNoticed) {
  EXPECT_FALSE(baseline_of({100, 150, 101, 170, 160}, 1, 1).is_calm());
  EXPECT_FALSE(baseline_of({100, 102, 112, 300, 300}, 1, 1).is_calm());
  // All alike, and all too long: the thread waited.
  EXPECT_FALSE(baseline_of({200, 201, 202, 203, 204}, 1, 0.5).is_calm());
}

TEST(Baseline, ThreadThatRests_IsNoticed) {
  const Baseline rested = baseline_ns(1, rest);
  EXPECT_GT(rested.waited, 0.5);
  EXPECT_FALSE(rested.is_calm());

  int calls = 0;
  const Baseline interrupted = baseline_ns(1, [&calls] {
    work();
    if (++calls > 2) rest();
  });
  EXPECT_GT(interrupted.spread, 1);
  EXPECT_FALSE(interrupted.is_calm());
}

TEST(Baseline, Calmest_TriesAgainWhileItMay) {
  int asked = 0;
  int tries = 5;
  const auto third_is_calm = [&asked] {
    return Baseline{static_cast<double>(++asked), 0, asked < 3 ? 0.5 : 0};
  };
  EXPECT_EQ(calmest(tries, third_is_calm).ns, 3);
  EXPECT_EQ(asked, 3);
  EXPECT_EQ(tries, 3);

  asked = 0;
  const auto second_is_best = [&asked] {
    return Baseline{static_cast<double>(++asked), 0, asked == 2 ? 0.3 : 0.5};
  };
  const Baseline best = calmest(tries, second_is_best);
  EXPECT_EQ(best.ns, 2);
  EXPECT_FALSE(best.is_calm());
  EXPECT_EQ(asked, 4);
  EXPECT_EQ(tries, 0);
}

std::string written(const Options& options, const std::string& name) {
  std::ifstream file(options.out + "/" + name + ".csv");
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

TEST(Table, RowsWithTimes_TellTheirBaselines) {
  Options options;
  options.out = testing::TempDir();
  Table table(options, "batuta_timed");
  (void)plain_ns();
  (void)plain_ns();
  table.key("name", "a").max("time_ns", 1).end_row();
  table.key("name", "b").max("time_ns", 1).end_row();  // none since: the table asks for one
  ASSERT_EQ(table.write(), 0);
  const std::string text = written(options, "batuta_timed");
  EXPECT_EQ(text.rfind("name,time_ns:max,time_baselines:sum,time_disturbed:sum\na,1,2,", 0), 0U);
  EXPECT_NE(text.find("\nb,1,1,"), std::string::npos);

  Table plain(options, "batuta_untimed");
  plain.key("name", "a").max("error", 1).end_row();
  ASSERT_EQ(plain.write(), 0);
  EXPECT_EQ(written(options, "batuta_untimed"), "name,error:max\na,1\n");
}

}  // namespace
}  // namespace batuta::report
