// SPDX-License-Identifier: MIT
// The report descriptor, as a host that knows nothing else reads it.

#include <gtest/gtest.h>

#include "host.hpp"

namespace batuta::pid::test {
namespace {

template <int kBlocks>
Descriptor parsed() {
  return parse(kReportDescriptor<kBlocks>.data(), kReportDescriptor<kBlocks>.size());
}

const ParsedField& field_of(const Descriptor& d, char way, int report, UsageCode usage) {
  for (const ParsedField& f : d.fields) {
    if (f.way != way || f.report != report) continue;
    for (const UsageCode name : f.usages) {
      if (name == usage) return f;
    }
  }
  throw std::runtime_error("no such field");
}

template <class Report>
void expect_size(const Descriptor& d, char way) {
  const int id = static_cast<int>(Report::kId);
  EXPECT_EQ(d.bits_of(way, id), 8 * Report::kSize) << "report " << id;
  std::uint8_t bytes[64] = {};
  EXPECT_EQ(encode(Report{}, bytes, 64), Report::kSize) << "report " << id;
  EXPECT_EQ(encode(Report{}, bytes, Report::kSize - 1), 0) << "report " << id;
}

TEST(PidDescriptor, EveryReport_HasTheLengthOfItsStructure) {
  const Descriptor d = parsed<16>();
  expect_size<Joystick>(d, 'i');
  expect_size<PidState>(d, 'i');
  expect_size<SetEffect>(d, 'o');
  expect_size<SetEnvelope>(d, 'o');
  expect_size<SetCondition>(d, 'o');
  expect_size<SetPeriodic>(d, 'o');
  expect_size<SetConstant>(d, 'o');
  expect_size<SetRamp>(d, 'o');
  expect_size<EffectOperation>(d, 'o');
  expect_size<BlockFree>(d, 'o');
  expect_size<DeviceControl>(d, 'o');
  expect_size<DeviceGain>(d, 'o');
  expect_size<CreateNewEffect>(d, 'f');
  expect_size<BlockLoad>(d, 'f');
  expect_size<Pool>(d, 'f');
  EXPECT_EQ(d.reports('i').size(), 2U);
  EXPECT_EQ(d.reports('o').size(), 10U);
  EXPECT_EQ(d.reports('f').size(), 3U);
}

TEST(PidDescriptor, Collections_AreOneJoystickWithLogicalOnesInside) {
  const Descriptor d = parsed<16>();
  ASSERT_FALSE(d.collections.empty());
  EXPECT_EQ(d.collections.front().usage, 0x010004U) << "Windows looks for PID in a joystick";
  for (std::size_t i = 1; i < d.collections.size(); ++i) {
    EXPECT_EQ(d.collections[i].type, 2);
    EXPECT_GE(d.collections[i].parent, 0);
  }
}

TEST(PidDescriptor, Stick_HasTwoAxesOfSixteenBitsAndSixteenButtons) {
  const Descriptor d = parsed<16>();
  const int id = static_cast<int>(ReportId::kJoystick);
  const ParsedField& x = field_of(d, 'i', id, 0x010030);
  EXPECT_EQ(x.usages, (std::vector<UsageCode>{0x010030, 0x010031}));
  EXPECT_EQ(x.bits, 16);
  EXPECT_EQ(x.low, -32767);
  EXPECT_EQ(x.high, 32767);
  const ParsedField& buttons = field_of(d, 'i', id, 0x090001);
  EXPECT_EQ(buttons.count, 16);
  EXPECT_EQ(buttons.usages.back(), 0x090010U);
  EXPECT_EQ(d.collections[static_cast<std::size_t>(x.collection)].type, 1);
}

bool has_usage(const Descriptor& d, UsageCode usage) {
  for (const ParsedField& f : d.fields) {
    for (const UsageCode name : f.usages) {
      if (name == usage) return true;
    }
  }
  return false;
}

// hid-pidff and hid-input give usage 0xA4 and the sixteenth button the same key, BTN_DEAD.
TEST(PidDescriptor, SafetySwitch_IsNotThere_SoThatNoButtonIsPressed) {
  const Descriptor d = parsed<16>();
  EXPECT_FALSE(has_usage(d, pid_usage(0xA4)));
  for (const unsigned state : {0x9FU, 0xA0U, 0xA5U, 0xA6U}) {
    EXPECT_TRUE(has_usage(d, pid_usage(state))) << "the state's others are: " << state;
  }
}

// A host that manages the pool says where in it a type's parameters stand, by usage 0x58; here the
// device manages it, and tells an axis by Parameter Block Offset.
TEST(PidDescriptor, TypeSpecificBlockOffset_IsNotThere_ForTheDeviceManagesItsPool) {
  const Descriptor d = parsed<16>();
  EXPECT_FALSE(has_usage(d, pid_usage(0x58)));
  const ParsedField& axis =
      field_of(d, 'o', static_cast<int>(ReportId::kSetCondition), pid_usage(0x23));
  EXPECT_EQ(axis.low, 0);
  EXPECT_EQ(axis.high, 1);
  EXPECT_TRUE(has_usage(d, pid_usage(0xA9))) << "device managed pool";
  EXPECT_TRUE(Pool{}.device_managed);
}

TEST(PidDescriptor, Times_AreMillisecondsAndAnglesHundredthsOfADegree) {
  const Descriptor d = parsed<16>();
  const struct {
    ReportId report;
    std::vector<unsigned> usages;
  } times[] = {{ReportId::kSetEffect, {0x50, 0x51, 0x54, 0xA7}},
               {ReportId::kSetEnvelope, {0x5C, 0x5E}},
               {ReportId::kSetPeriodic, {0x72}}};
  for (const auto& [report, usages] : times) {
    for (const unsigned usage : usages) {
      const ParsedField& f = field_of(d, 'o', static_cast<int>(report), pid_usage(usage));
      EXPECT_EQ(f.exponent, -3) << usage;  // hid-pidff scales by it since Linux 6.15
      EXPECT_EQ(f.unit, 0x1003) << usage;  // seconds
      EXPECT_EQ(f.high, f.physical_high) << usage;
    }
  }
  const int effect = static_cast<int>(ReportId::kSetEffect);
  const ParsedField& direction = field_of(d, 'o', effect, 0x0A0001);
  const ParsedField& phase =
      field_of(d, 'o', static_cast<int>(ReportId::kSetPeriodic), pid_usage(0x71));
  for (const ParsedField* f : {&direction, &phase}) {
    EXPECT_EQ(f->physical_high, 36000);
    EXPECT_EQ(f->exponent, -2);
    EXPECT_EQ(f->unit, 0x14);  // degrees
  }
  EXPECT_EQ(field_of(d, 'o', effect, pid_usage(0x52)).unit, 0) << "a gain has none";
  EXPECT_EQ(field_of(d, 'o', effect, pid_usage(0x52)).exponent, 0);
}

TEST(PidDescriptor, Blocks_AreAsManyAsTheDeviceHas) {
  const Descriptor few = parsed<2>();
  const Descriptor many = parsed<64>();
  for (const auto& [way, id] :
       {std::pair('o', 0x11), std::pair('o', 0x12), std::pair('o', 0x13), std::pair('o', 0x14),
        std::pair('o', 0x15), std::pair('o', 0x16), std::pair('o', 0x1A), std::pair('o', 0x1B),
        std::pair('f', 0x22), std::pair('i', 0x02)}) {
    EXPECT_EQ(field_of(few, way, id, pid_usage(0x22)).high, 2) << id;
    EXPECT_EQ(field_of(few, way, id, pid_usage(0x22)).low, 1) << id;
    EXPECT_EQ(field_of(many, way, id, pid_usage(0x22)).high, 64) << id;
  }
}

TEST(PidDescriptor, Parser_RefusesWhatAHostWould) {
  const auto& good = kReportDescriptor<16>;
  const Bytes bytes(good.begin(), good.end());
  const auto parse_of = [](const Bytes& b) { return parse(b.data(), b.size()); };
  EXPECT_NO_THROW(parse_of(bytes));
  const std::size_t first = 6;  // behind the page, the usage and the collection that they open
  for (std::size_t size = first; size < bytes.size(); ++size) {
    EXPECT_ANY_THROW(parse(bytes.data(), size)) << "torn at " << size;
  }
  Bytes extra = bytes;
  extra.push_back(0xC0);
  EXPECT_ANY_THROW(parse_of(extra));
}

}  // namespace
}  // namespace batuta::pid::test
