// SPDX-License-Identifier: MIT
// The foreseen instant against parabolas whose roots are chosen: gap + rate t + bend t^2 / 2.
#include <gtest/gtest.h>

#include "../../../src/detection/expansion.hpp"

namespace batuta {
namespace {

TEST(TimeToContact, RootOfTheParabola_IsTheFirst) {
  EXPECT_DOUBLE_EQ(time_to_contact(4.0, -3.0, 1.0), 2.0) << "4 - 3 t + t^2 / 2: 2 and 4";
  EXPECT_DOUBLE_EQ(time_to_contact(3.0, -2.0, -2.0), 1.0) << "3 - 2 t - t^2: 1 and -3";
  EXPECT_DOUBLE_EQ(time_to_contact(3.0, -2.0, 0.0), 1.5);
}

TEST(TimeToContact, NoRoot_IsWhereTheGapIsLeast) {
  EXPECT_DOUBLE_EQ(time_to_contact(10.0, -3.0, 1.0), 3.0);
}

TEST(TimeToContact, NoGapOrNoneThatFalls_IsNow) {
  EXPECT_EQ(time_to_contact(0.0, -3.0, 1.0), 0.0);
  EXPECT_EQ(time_to_contact(-1.0, -3.0, 1.0), 0.0);
  EXPECT_EQ(time_to_contact(4.0, 0.0, 1.0), 0.0);
  EXPECT_EQ(time_to_contact(4.0, 3.0, -1.0), 0.0);
}

}  // namespace
}  // namespace batuta
