// SPDX-License-Identifier: MIT
// What the sticks bring to a step: a sample, or none, of each side.

#include <gtest/gtest.h>

#include "batuta/record/duel.hpp"

namespace batuta::fencing {
namespace {

TEST(DuelInput, EachSide_HasWhatWasSet) {
  DuelInput input;
  EXPECT_EQ(input.at(Side::kLeft), nullptr);
  InputSample sample;
  sample.x = 0.5F;
  sample.sequence = 7;
  input.set(Side::kRight, &sample);
  EXPECT_EQ(input.at(Side::kLeft), nullptr);
  ASSERT_NE(input.at(Side::kRight), nullptr);
  EXPECT_EQ(input.at(Side::kRight)->x, 0.5F);
  EXPECT_EQ(input.at(Side::kRight)->sequence, 7U);
  input.set(Side::kRight, nullptr);
  EXPECT_EQ(input.at(Side::kRight), nullptr) << "none came";
}

}  // namespace
}  // namespace batuta::fencing
