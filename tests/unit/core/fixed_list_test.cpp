// SPDX-License-Identifier: MIT
#include "batuta/core/fixed_list.hpp"

#include <gmock/gmock.h>

namespace batuta {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(FixedList, Push_KeepsTheOrder) {
  FixedList<int, 3> list;
  EXPECT_THAT(list, IsEmpty());
  EXPECT_TRUE(list.push(5));
  EXPECT_TRUE(list.push(4));
  EXPECT_THAT(list, ElementsAre(5, 4));
}

TEST(FixedList, Full_RefusesAndKeepsWhatItHas) {
  FixedList<int, 2> list;
  EXPECT_TRUE(list.push(1));
  EXPECT_TRUE(list.push(2));
  EXPECT_FALSE(list.push(3));
  EXPECT_THAT(list, ElementsAre(1, 2));
}

TEST(FixedList, RemoveSwapping_TakesTheLastInItsPlace) {
  FixedList<int, 4> list;
  for (int i = 0; i < 4; ++i) ASSERT_TRUE(list.push(i));
  list.remove_swapping(1);
  EXPECT_THAT(list, ElementsAre(0, 3, 2));
  list.remove_swapping(2);
  EXPECT_THAT(list, ElementsAre(0, 3));
}

TEST(FixedList, Clear_MakesRoom) {
  FixedList<int, 1> list;
  ASSERT_TRUE(list.push(1));
  list.clear();
  EXPECT_EQ(list.size(), 0);
  EXPECT_TRUE(list.push(2));
  EXPECT_THAT(list, ElementsAre(2));
}

TEST(FixedListDeathTest, RemoveOutOfRange_Traps) {
  FixedList<int, 2> list;
  ASSERT_TRUE(list.push(1));
  EXPECT_DEATH(list.remove_swapping(1), "assert");
  EXPECT_DEATH(list.remove_swapping(-1), "assert");
  EXPECT_DEATH(list[1] = 0, "assert");
  EXPECT_DEATH(list[-1] = 0, "assert");
}

}  // namespace
}  // namespace batuta
