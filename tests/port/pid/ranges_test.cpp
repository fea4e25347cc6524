// SPDX-License-Identifier: MIT
// What the descriptor announces and what the device takes are the same: each field of each report
// of the host is set to its ends and beyond.

#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "host.hpp"

namespace batuta::pid::test {
namespace {

/// Fields that take anything. Without a meaning here: games put anything into the trigger, and into
/// the angle of an axis that there is none of. With one: longer times count as the longest
/// (times_test.cpp).
const std::set<UsageCode> kIgnored = {
    pid_usage(0x53), pid_usage(0x54), pid_usage(0x51), 0x01003B,        0x0A0002,
    pid_usage(0x50), pid_usage(0xA7), pid_usage(0x5C), pid_usage(0x5E), pid_usage(0x72)};

/// A type of effect that the report is for.
EffectType type_for(ReportId id) {
  switch (id) {
    case ReportId::kSetCondition:
      return EffectType::kSpring;
    case ReportId::kSetPeriodic:
      return EffectType::kSquare;
    case ReportId::kSetRamp:
      return EffectType::kRamp;
    default:
      return EffectType::kConstant;
  }
}

/// A device with an effect in each block but the last.
class Ready : public Session {
 public:
  explicit Ready(EffectType type) {
    for (int i = 1; i < kBlocks; ++i) made(type);
  }
  Status send_to(char way, int report, const Values& values) {
    const Bytes bytes = host.pack(way, report, values);
    const ReportType type = way == 'o' ? ReportType::kOutput : ReportType::kFeature;
    return device.receive(type, static_cast<std::uint8_t>(report), bytes.data(),
                          static_cast<int>(bytes.size()));
  }
};

std::vector<UsageCode> names_of(const Descriptor& d, const ParsedField& field) {
  if (field.variable) return field.usages;
  return {d.collections[static_cast<std::size_t>(field.collection)].usage};
}

Status answer_to(const ParsedField& field, UsageCode name, std::int64_t value) {
  Ready session(type_for(static_cast<ReportId>(field.report)));
  return session.send_to(field.way, field.report, {{name, value}});
}

void check_ends(const ParsedField& field, UsageCode name) {
  const bool is_block = name == pid_usage(0x22);
  const std::int64_t last = is_block ? field.high - 1 : field.high;  // with an effect in it
  SCOPED_TRACE(testing::Message() << std::hex << "report " << field.report << " usage " << name);
  EXPECT_EQ(answer_to(field, name, field.low), Status::kOk);
  EXPECT_EQ(answer_to(field, name, last), Status::kOk);
  if (is_block) {
    EXPECT_EQ(answer_to(field, name, field.high), Status::kStaleHandle) << "empty";
  }
  const std::int64_t whole = std::int64_t{1} << field.bits;
  const std::int64_t most = field.low < 0 ? whole / 2 - 1 : whole - 1;
  const std::int64_t least = field.low < 0 ? -whole / 2 : 0;
  if (kIgnored.count(name) > 0) {
    EXPECT_EQ(answer_to(field, name, most), Status::kOk);
    return;
  }
  const Status refusal = is_block ? Status::kStaleHandle : Status::kInvalidArgument;
  if (field.high < most) {
    EXPECT_EQ(answer_to(field, name, field.high + 1), refusal);
  }
  if (field.low > least) {
    EXPECT_EQ(answer_to(field, name, field.low - 1), Status::kInvalidArgument);
  }
  if (field.high < most) {
    EXPECT_EQ(answer_to(field, name, most), Status::kInvalidArgument);
  }
  if (field.low > least) {
    EXPECT_EQ(answer_to(field, name, least), Status::kInvalidArgument);
  }
}

TEST(PidRanges, EveryField_IsTakenToItsEndsAndNoFurther) {
  const Descriptor d = Session().host.descriptor();
  int checked = 0;
  for (const ParsedField& field : d.fields) {
    const bool sent = field.way == 'o' || (field.way == 'f' && field.report == 0x21);
    if (!sent || field.constant) continue;
    for (const UsageCode name : names_of(d, field)) {
      check_ends(field, name);
      ++checked;
    }
  }
  // 13 of the effect; 5, 8, 5, 2 and 3 of parameters; 3, 1, 1 and 1 of commands; 2 of a creation.
  EXPECT_EQ(checked, 44);
}

TEST(PidRanges, BitsWithoutMeaning_AreZero) {
  Ready session(EffectType::kConstant);
  const int report = static_cast<int>(ReportId::kSetEffect);
  Bytes bytes = session.host.pack('o', report, {});
  for (unsigned bit = 3; bit < 8; ++bit) {
    bytes[12] = static_cast<std::uint8_t>(1U << bit);
    EXPECT_EQ(session.device.receive(ReportType::kOutput, 0x11, bytes.data(), SetEffect::kSize),
              Status::kInvalidArgument);
  }
}

// A block that the device does not have is no block, wherever its number comes.
TEST(PidRanges, BlockBeyondThePool_IsNone) {
  Ready session(EffectType::kConstant);
  EXPECT_EQ(session.start(Session::kBlocks + 1), Status::kStaleHandle);
  EXPECT_EQ(session.start(64), Status::kStaleHandle);
  EXPECT_EQ(session.start(65), Status::kInvalidArgument);
  EXPECT_EQ(session.start(0), Status::kInvalidArgument);
  EXPECT_EQ(session.device.counters().count(Verdict::kNoBlock), 2U);
  EXPECT_EQ(session.device.counters().count(Verdict::kRange), 2U);
}

}  // namespace
}  // namespace batuta::pid::test
