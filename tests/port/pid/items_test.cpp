// SPDX-License-Identifier: MIT
// The builder's bytes against items written out by hand from HID 1.11, section 6.2.2.

#include "shared/hid_pid/items.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

namespace batuta::pid {
namespace {

std::vector<int> bytes_of(const Items& items) {
  std::vector<int> bytes;
  for (std::size_t i = 0; i < items.size(); ++i) bytes.push_back(items[i]);
  return bytes;
}

TEST(PidItems, Values_AreDescribedOnce) {
  Items d;
  d.report(7);
  d.values(Way::kOutput, {-10000, 10000, 0, 36000, 16, 0x1003, -3}, {Usage::kX, Usage::kY});
  EXPECT_THAT(bytes_of(d),
              testing::ElementsAre(0x85, 0x07,                                // report
                                   0x16, 0xF0, 0xD8, 0x26, 0x10, 0x27,        // logical
                                   0x35, 0x00, 0x47, 0xA0, 0x8C, 0x00, 0x00,  // physical
                                   0x66, 0x03, 0x10, 0x55, 0xFD, 0x75, 0x10, 0x95, 0x02, 0x05, 0x01,
                                   0x09, 0x30, 0x09, 0x31, 0x91, 0x02));
  const std::size_t before = d.size();
  d.values(Way::kInput, {-10000, 10000, 0, 36000, 16, 0x1003, -3}, {Usage::kX, Usage::kY});
  EXPECT_EQ(d.size() - before, 6U) << "two usages and the main item";
}

// The largest numbers of one byte, and the first of two, with a sign: 128 in one byte were -128.
TEST(PidItems, Numbers_KeepTheirSign) {
  Items d;
  d.values(Way::kFeature, {-128, 127, -129, 128, 8}, {Usage::kGain});
  EXPECT_THAT(bytes_of(d), testing::ElementsAre(0x15, 0x80, 0x25, 0x7F, 0x36, 0x7F, 0xFF, 0x46,
                                                0x80, 0x00, 0x65, 0x00, 0x55, 0x00, 0x75, 0x08,
                                                0x95, 0x01, 0x05, 0x0F, 0x09, 0x52, 0xB1, 0x02));
}

// A usage has no sign: 0xAB is one byte.
TEST(PidItems, CollectionChoiceAndPadding_AreTheirItems) {
  Items d;
  d.begin(Collection::kLogical, Usage::kCreateNewEffectReport);
  d.choice(Way::kFeature, {Usage::kSpring, Usage::kDamper});
  d.padding(Way::kFeature, 5);
  d.end();
  EXPECT_THAT(bytes_of(d), testing::ElementsAre(0x05, 0x0F, 0x09, 0xAB, 0xA1, 0x02,  //
                                                0x15, 0x01, 0x25, 0x02, 0x35, 0x01, 0x45, 0x02,
                                                0x65, 0x00, 0x55, 0x00, 0x75, 0x08, 0x95, 0x01,  //
                                                0x09, 0x40, 0x09, 0x41, 0xB1, 0x00,              //
                                                0x75, 0x05, 0xB1, 0x03, 0xC0));
}

TEST(PidItems, Buttons_AreARange) {
  Items d;
  d.values_from(Way::kInput, {0, 1, 0, 1, 1}, Usage::kFirstButton, 16);
  EXPECT_THAT(bytes_of(d), testing::ElementsAre(0x15, 0x00, 0x25, 0x01, 0x35, 0x00, 0x45, 0x01,
                                                0x65, 0x00, 0x55, 0x00, 0x75, 0x01, 0x95, 0x10,  //
                                                0x05, 0x09, 0x19, 0x01, 0x29, 0x10, 0x81, 0x02));
}

}  // namespace
}  // namespace batuta::pid
