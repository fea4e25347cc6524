// SPDX-License-Identifier: MIT
#include "batuta/core/assert.hpp"

#include <gtest/gtest.h>

namespace batuta {
namespace {

// Published values of the FNV-1a hash with 32 bits.
static_assert(file_id("") == 0x811C9DC5U);
static_assert(file_id("a") == 0xE40C292CU);
static_assert(file_id("foobar") == 0xBF9CF968U);

TEST(FileId, Folders_AreLeftOut) {
  EXPECT_EQ(file_id("/some/where/foobar"), file_id("foobar"));
  EXPECT_EQ(file_id("C:\\some\\foobar"), file_id("foobar"));
  EXPECT_NE(file_id("foobar/"), file_id("foobar"));
}

TEST(Assert, ConditionHolds_Nothing) {
  BATUTA_ASSERT(1 + 1 == 2);
  BATUTA_INVARIANT(1 + 1 == 2);
  BATUTA_SLOW_CHECK(1 + 1 == 2);
}

TEST(AssertDeathTest, ConditionFails_PortIsTold) {
  volatile bool wrong = false;
  EXPECT_DEATH(BATUTA_ASSERT(wrong), "assert");
  EXPECT_DEATH(BATUTA_INVARIANT(wrong), "assert");
}

TEST(Assert, LevelOfTheBuild_DecidesWhatIsEvaluated) {
  int evaluated = 0;
  const auto check = [&evaluated] { return ++evaluated > 0; };
  BATUTA_CHECK_AT(BATUTA_ASSERT_LEVEL, check());
  EXPECT_EQ(evaluated, 1);
  BATUTA_CHECK_AT(BATUTA_ASSERT_LEVEL + 1, check());
  EXPECT_EQ(evaluated, 1);
}

}  // namespace
}  // namespace batuta
