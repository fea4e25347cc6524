// SPDX-License-Identifier: MIT
#include "programs/devices/description.hpp"

#include <gtest/gtest.h>
#include <linux/input.h>

#include <utility>

namespace batuta::host {
namespace {

const std::string kStick =
    "N: a stick\nI: 0003 0001 0002 0003\nP: 00 00 00 00 00 00 00 00\n"
    "B: 00 0b 00 00 00 00 00 00 00\nB: 03 03 00 00 00 00 00 00 00\n"
    "A: 00 -100 200 4 10\nA: 01 5 5 0 0\n";

TEST(Description, KnowsTheAxes) {
  const std::optional<Description> stick = Description::parse(kStick);
  ASSERT_TRUE(stick);
  EXPECT_EQ(stick->name(), "a stick");
  const std::optional<AxisRange> x = stick->range(ABS_X);
  ASSERT_TRUE(x);
  EXPECT_EQ(x->min, -100);
  EXPECT_EQ(x->max, 200);
  EXPECT_EQ(x->flat, 10);
  EXPECT_FALSE(stick->range(ABS_Y)) << "an empty range says nothing";
  EXPECT_FALSE(stick->range(ABS_RX)) << "there is no such axis";
}

TEST(Description, TheVersionSaysHowManyFieldsThereAre) {
  EXPECT_TRUE(Description::parse("# EVEMU 1.1\n# Supported events:\n" + kStick));
  EXPECT_FALSE(Description::parse("# EVEMU 1.3\n" + kStick)) << "the resolution is missing";
}

TEST(Description, Unreadable_IsNothing) {
  EXPECT_FALSE(Description::parse(""));
  EXPECT_FALSE(Description::parse("I: 0003 0001 0002 0003\n"));
  EXPECT_FALSE(Description::parse("N: a stick\nI: what\n"));
}

TEST(Description, Moves) {
  std::optional<Description> a = Description::parse(kStick);
  Description b = std::move(*a);
  EXPECT_EQ(b.name(), "a stick");
  *a = std::move(b);
  EXPECT_EQ(a->name(), "a stick");
}

}  // namespace
}  // namespace batuta::host
