// SPDX-License-Identifier: MIT
// Reports byte by byte, written out by hand; and every report of every wrong length.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "heap_trap.hpp"
#include "host.hpp"

namespace batuta::pid::test {
namespace {

template <class Report>
Report decoded(const Bytes& bytes) {
  Report report;
  EXPECT_TRUE(decode(bytes.data(), static_cast<int>(bytes.size()), report));
  std::uint8_t again[64] = {};
  EXPECT_EQ(encode(report, again, 64), static_cast<int>(bytes.size()));
  EXPECT_TRUE(std::equal(bytes.begin(), bytes.end(), again)) << "there and back";
  return report;
}

TEST(PidReports, SetEffect_IsReadFieldByField) {
  const auto r = decoded<SetEffect>({0x03, 0x04, 0xE8, 0x03, 0x02, 0x01, 0x06, 0x05, 0x32, 0x00,
                                     0x80, 0x07, 0x05, 0x94, 0x11, 0x50, 0x46});
  EXPECT_EQ(r.block, 3);
  EXPECT_EQ(r.type, EffectType::kSine);
  EXPECT_EQ(r.duration_ms, 1000);
  EXPECT_EQ(r.trigger_repeat_ms, 0x0102);
  EXPECT_EQ(r.sample_period_ms, 0x0506);
  EXPECT_EQ(r.start_delay_ms, 50);
  EXPECT_EQ(r.gain, 128);
  EXPECT_EQ(r.trigger_button, 7);
  EXPECT_TRUE(r.axis_x);
  EXPECT_FALSE(r.axis_y);
  EXPECT_TRUE(r.has_direction);
  EXPECT_EQ(r.direction, 4500);  // east
  EXPECT_EQ(r.direction_2, 18000);
}

TEST(PidReports, Parameters_AreReadFieldByField) {
  const auto envelope =
      decoded<SetEnvelope>({0x01, 0x10, 0x27, 0xF4, 0x01, 0x64, 0x00, 0xFF, 0x7F});
  EXPECT_EQ(envelope.attack_level, 10000);
  EXPECT_EQ(envelope.fade_level, 500);
  EXPECT_EQ(envelope.attack_ms, 100);
  EXPECT_EQ(envelope.fade_ms, 32767);
  const auto condition = decoded<SetCondition>(
      {0x02, 0x01, 0xF0, 0xD8, 0x10, 0x27, 0xFF, 0xFF, 0x0A, 0x00, 0x14, 0x00, 0x1E, 0x00});
  EXPECT_EQ(condition.block, 2);
  EXPECT_EQ(condition.offset, 1);
  EXPECT_EQ(condition.centre, -10000);
  EXPECT_EQ(condition.positive_coefficient, 10000);
  EXPECT_EQ(condition.negative_coefficient, -1);
  EXPECT_EQ(condition.positive_saturation, 10);
  EXPECT_EQ(condition.negative_saturation, 20);
  EXPECT_EQ(condition.dead_band, 30);
  const auto periodic =
      decoded<SetPeriodic>({0x04, 0x88, 0x13, 0x78, 0xEC, 0x28, 0x23, 0x0A, 0x00});
  EXPECT_EQ(periodic.magnitude, 5000);
  EXPECT_EQ(periodic.offset, -5000);
  EXPECT_EQ(periodic.phase, 9000);
  EXPECT_EQ(periodic.period_ms, 10);
  EXPECT_EQ(decoded<SetConstant>({0x01, 0xF0, 0xD8}).magnitude, -10000);
  const auto ramp = decoded<SetRamp>({0x01, 0x10, 0x27, 0xF0, 0xD8});
  EXPECT_EQ(ramp.start, 10000);
  EXPECT_EQ(ramp.end, -10000);
}

TEST(PidReports, Commands_AreReadFieldByField) {
  const auto operation = decoded<EffectOperation>({0x10, 0x02, 0xFF});
  EXPECT_EQ(operation.block, 16);
  EXPECT_EQ(operation.operation, Operation::kStartSolo);
  EXPECT_EQ(operation.loops, kEndlessLoops);
  EXPECT_EQ(decoded<BlockFree>({0x40}).block, 64);
  EXPECT_EQ(decoded<DeviceControl>({0x06}).control, Control::kContinue);
  EXPECT_EQ(decoded<DeviceGain>({0x80}).gain, 128);
  const auto create = decoded<CreateNewEffect>({0x0B, 0x34, 0x12});
  EXPECT_EQ(create.type, EffectType::kFriction);
  EXPECT_EQ(create.byte_count, 0x1234);
}

TEST(PidReports, Answers_AreWrittenFieldByField) {
  std::uint8_t bytes[4] = {};
  ASSERT_EQ(encode(BlockLoad{5, LoadStatus::kSuccess, 0x0123}, bytes, 4), 4);
  EXPECT_THAT(bytes, testing::ElementsAre(0x05, 0x01, 0x23, 0x01));
  ASSERT_EQ(encode(Pool{0x0400, 16, true, false}, bytes, 4), 4);
  EXPECT_THAT(bytes, testing::ElementsAre(0x00, 0x04, 0x10, 0x01));
  ASSERT_EQ(encode(PidState{true, false, false, true, true, 3}, bytes, 4), 2);
  EXPECT_EQ(bytes[0], 0x11);  // paused, power
  EXPECT_EQ(bytes[1], 0x07);  // block 3, playing
}

/// A report that a host packs by usages alone, as the device reads it.
template <class Report>
Report packed(char way, const Values& values) {
  const Session session;
  const Bytes bytes = session.host.pack(way, static_cast<int>(Report::kId), values);
  Report report;
  EXPECT_TRUE(decode(bytes.data(), static_cast<int>(bytes.size()), report));
  return report;
}

TEST(PidReports, UsagesOfAnEffect_AreTheFieldsOfThatName) {
  const auto r = packed<SetEffect>('o', {{pid_usage(0x22), 2},
                                         {pid_usage(0x25), 9},
                                         {pid_usage(0x50), 11},
                                         {pid_usage(0x54), 12},
                                         {pid_usage(0x51), 13},
                                         {pid_usage(0xA7), 14},
                                         {pid_usage(0x52), 15},
                                         {pid_usage(0x53), 16},
                                         {0x010031, 1},
                                         {0x0A0001, 17},
                                         {0x0A0002, 18}});
  EXPECT_EQ(r.block, 2);
  EXPECT_EQ(r.type, EffectType::kDamper);
  EXPECT_EQ(r.duration_ms, 11);
  EXPECT_EQ(r.trigger_repeat_ms, 12);
  EXPECT_EQ(r.sample_period_ms, 13);
  EXPECT_EQ(r.start_delay_ms, 14);
  EXPECT_EQ(r.gain, 15);
  EXPECT_EQ(r.trigger_button, 16);
  EXPECT_FALSE(r.axis_x);
  EXPECT_TRUE(r.axis_y);
  EXPECT_FALSE(r.has_direction);
  EXPECT_EQ(r.direction, 17);
  EXPECT_EQ(r.direction_2, 18);
}

TEST(PidReports, UsagesOfParameters_AreTheFieldsOfThatName) {
  const auto e = packed<SetEnvelope>(
      'o',
      {{pid_usage(0x5B), 1}, {pid_usage(0x5C), 2}, {pid_usage(0x5D), 3}, {pid_usage(0x5E), 4}});
  EXPECT_EQ(e.attack_level, 1);
  EXPECT_EQ(e.attack_ms, 2);
  EXPECT_EQ(e.fade_level, 3);
  EXPECT_EQ(e.fade_ms, 4);
  const auto c = packed<SetCondition>('o', {{pid_usage(0x23), 1},
                                            {pid_usage(0x60), -1},
                                            {pid_usage(0x61), -2},
                                            {pid_usage(0x62), -3},
                                            {pid_usage(0x63), 4},
                                            {pid_usage(0x64), 5},
                                            {pid_usage(0x65), 6}});
  EXPECT_EQ(c.offset, 1);
  EXPECT_EQ(c.centre, -1);
  EXPECT_EQ(c.positive_coefficient, -2);
  EXPECT_EQ(c.negative_coefficient, -3);
  EXPECT_EQ(c.positive_saturation, 4);
  EXPECT_EQ(c.negative_saturation, 5);
  EXPECT_EQ(c.dead_band, 6);
  const auto p = packed<SetPeriodic>(
      'o',
      {{pid_usage(0x70), 1}, {pid_usage(0x6F), -2}, {pid_usage(0x71), 3}, {pid_usage(0x72), 4}});
  EXPECT_EQ(p.magnitude, 1);
  EXPECT_EQ(p.offset, -2);
  EXPECT_EQ(p.phase, 3);
  EXPECT_EQ(p.period_ms, 4);
  const auto r = packed<SetRamp>('o', {{pid_usage(0x75), -1}, {pid_usage(0x76), 2}});
  EXPECT_EQ(r.start, -1);
  EXPECT_EQ(r.end, 2);
}

TEST(PidReports, UsagesOfAnswers_AreTheFieldsOfThatName) {
  const auto s =
      packed<PidState>('i', {{pid_usage(0xA0), 1}, {pid_usage(0xA6), 1}, {pid_usage(0x22), 3}});
  EXPECT_FALSE(s.paused || s.actuator_override || s.playing);
  EXPECT_TRUE(s.actuators_enabled && s.actuator_power);
  EXPECT_EQ(s.block, 3);
  const auto t =
      packed<PidState>('i', {{pid_usage(0x9F), 1}, {pid_usage(0xA5), 1}, {pid_usage(0x94), 1}});
  EXPECT_TRUE(t.paused && t.actuator_override && t.playing);
  const auto j = packed<Joystick>('i', {{0x010030, -1}, {0x010031, 2}, {0x090003, 1}});
  EXPECT_EQ(j.x, -1);
  EXPECT_EQ(j.y, 2);
  EXPECT_EQ(j.buttons, 4);
}

// What a host may read from a device: a state is of a block, a load may be of none.
TEST(PidReports, Answers_HaveTheirRangesToo) {
  const auto state_of = [](std::uint8_t byte) {
    const std::uint8_t bytes[] = {0x00, byte};
    PidState state;
    return decode(bytes, 2, state);
  };
  EXPECT_FALSE(state_of(0x01)) << "block 0";
  EXPECT_TRUE(state_of(0x02));
  EXPECT_TRUE(state_of(0x81)) << "block 64";
  EXPECT_FALSE(state_of(0x82)) << "block 65";
  const auto load_of = [](std::uint8_t block) {
    const std::uint8_t bytes[] = {block, 0x01, 0x00, 0x00};
    BlockLoad load;
    return decode(bytes, 4, load);
  };
  EXPECT_TRUE(load_of(0));
  EXPECT_TRUE(load_of(64));
  EXPECT_FALSE(load_of(65));
}

// Right and up; HID's Y grows towards the user, so up is negative.
TEST(PidReports, Joystick_TurnsUpIntoAway) {
  InputSample sample;
  sample.x = 1.0F;
  sample.y = 0.5F;
  sample.buttons = 0xABCD1234U;
  std::uint8_t bytes[6] = {};
  ASSERT_EQ(encode(joystick_of(sample), bytes, 6), 6);
  EXPECT_THAT(bytes, testing::ElementsAre(0x34, 0x12, 0xFF, 0x7F, 0x00, 0xC0));
  sample.x = -1.0F;
  sample.y = -1.0F;
  ASSERT_EQ(encode(joystick_of(sample), bytes, 6), 6);
  EXPECT_THAT(bytes, testing::ElementsAre(0x34, 0x12, 0x01, 0x80, 0xFF, 0x7F));
}

int length_of(ReportType type, int id) {
  const Descriptor d = Session().host.descriptor();
  if (type == ReportType::kOutput) return d.bits_of('o', id) / 8;
  return type == ReportType::kFeature && id == 0x21 ? 3 : 0;
}

// Every id of every type with 0 ... 64 bytes: only the very length is read at all.
TEST(PidReports, EveryWrongLength_IsRefusedCountedAndWithoutEffect) {
  for (const ReportType type : {ReportType::kInput, ReportType::kOutput, ReportType::kFeature}) {
    for (int id = 0; id < 256; ++id) {
      Session session;
      const std::int64_t block = session.made(EffectType::kConstant);
      ASSERT_EQ(session.send(pid_usage(0x73), {{pid_usage(0x22), block}, {pid_usage(0x70), 4000}}),
                Status::kOk);
      ASSERT_EQ(session.start(block, 255), Status::kOk);
      const int length = length_of(type, id);
      std::uint32_t refused = 0;
      const Bytes ones(64, 0x01);  // in every range
      for (int size = 0; size <= 64; ++size) {
        if (length > 0 && size == length) continue;
        const Status status =
            session.device.receive(type, static_cast<std::uint8_t>(id), ones.data(), size);
        ASSERT_EQ(status, Status::kInvalidArgument) << "report " << id << ", " << size << " bytes";
        ++refused;
      }
      const Counters& counters = session.device.counters();
      EXPECT_EQ(counters.refused(), refused);
      EXPECT_EQ(counters.count(length > 0 ? Verdict::kLength : Verdict::kUnknown), refused);
      EXPECT_EQ(session.force(), Vec2<float>(0.0F, -0.4F)) << "report " << id;
    }
  }
}

TEST(PidReports, WholeSession_AllocatesNothing) {
  Device<16> device;
  const Bytes create = {0x04, 0x00, 0x00};
  const Bytes effect = {0x01, 0x04, 0, 0, 0, 0, 0, 0, 0, 0, 0xFF, 0, 0x04, 0x94, 0x11, 0, 0};
  const Bytes wave = {0x01, 0x10, 0x27, 0x00, 0x00, 0x00, 0x00, 0x0A, 0x00};
  const Bytes start = {0x01, 0x01, 0x01};
  std::uint8_t answer[8] = {};
  PidState state;
  const batuta::test::HeapTrap trap;
  EXPECT_EQ(device.receive(ReportType::kFeature, 0x21, create.data(), 3), Status::kOk);
  EXPECT_EQ(device.answer(0x22, answer, 8), 4);
  EXPECT_EQ(device.receive(ReportType::kOutput, 0x11, effect.data(), 17), Status::kOk);
  EXPECT_EQ(device.receive(ReportType::kOutput, 0x14, wave.data(), 9), Status::kOk);
  EXPECT_EQ(device.receive(ReportType::kOutput, 0x1A, start.data(), 3), Status::kOk);
  device.force({}, 0);
  EXPECT_NEAR(device.force({}, 2500).x(), -1.0F, 1e-6F);
  EXPECT_TRUE(device.next_state(state));
  EXPECT_EQ(trap.allocations(), 0);
}

}  // namespace
}  // namespace batuta::pid::test
