// SPDX-License-Identifier: MIT
// The pool, the device's controls, and what the host is told of both.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "host.hpp"

namespace batuta::pid::test {
namespace {

Values load_of(const Session& session) {
  return session.get(pid_usage(0x89));
}
std::int64_t status_of(const Session& session) {
  return load_of(session).at(pid_usage(0x8B));
}

Status free_block(Session& session, std::int64_t block) {
  return session.send(pid_usage(0x90), {{pid_usage(0x22), block}});
}

/// A constant force that points up, playing.
std::int64_t playing_one(Session& session, double share) {
  const std::int64_t block = session.made(EffectType::kConstant);
  EXPECT_EQ(
      session.send(pid_usage(0x73), {{pid_usage(0x22), block}, {pid_usage(0x70), level(share)}}),
      Status::kOk);
  EXPECT_EQ(session.set_effect(block, {{0x0A0001, degrees(180)}}), Status::kOk);
  EXPECT_EQ(session.start(block), Status::kOk);
  return block;
}

TEST(PidControl, SumBeyondTheRange_IsClippedAndCounted) {
  Session session;
  (void)playing_one(session, 0.75);
  (void)session.force(Stick());
  EXPECT_EQ(session.device.counters().clipped, 0U);
  (void)playing_one(session, 0.75);
  EXPECT_EQ(session.force(Stick()), Vec2<float>(0.0F, 1.0F));
  EXPECT_EQ(session.device.counters().clipped, 1U);
}

TEST(PidPool, Blocks_AreGivenLowestFirstUntilNoneIsFree) {
  Session session;
  EXPECT_EQ(status_of(session), 3) << "nothing was asked for";
  const std::int64_t whole = session.get(pid_usage(0x7F)).at(pid_usage(0x80));
  for (int i = 1; i <= Session::kBlocks; ++i) {
    ASSERT_EQ(session.create(EffectType::kSine), Status::kOk);
    const Values load = load_of(session);
    EXPECT_EQ(load.at(pid_usage(0x8B)), 1);
    EXPECT_EQ(load.at(pid_usage(0x22)), i);
    EXPECT_EQ(load.at(pid_usage(0xAC)), whole - i * whole / Session::kBlocks);
  }
  EXPECT_EQ(session.create(EffectType::kSine), Status::kPoolFull);
  EXPECT_EQ(status_of(session), 2);
  EXPECT_EQ(load_of(session).at(pid_usage(0x22)), 0);
  EXPECT_EQ(load_of(session).at(pid_usage(0xAC)), 0);
  EXPECT_EQ(session.device.counters().count(Verdict::kFull), 1U);

  EXPECT_EQ(free_block(session, 2), Status::kOk);
  EXPECT_EQ(free_block(session, 2), Status::kStaleHandle);
  ASSERT_EQ(session.create(EffectType::kSpring), Status::kOk);
  EXPECT_EQ(load_of(session).at(pid_usage(0x22)), 2);
}

// A host that does not look would take the block before for the new one.
TEST(PidPool, RefusedCreation_IsAnsweredAsAnError) {
  Session session;
  session.made(EffectType::kSine);
  const Bytes wrong = {12, 0, 0};
  EXPECT_EQ(session.device.receive(ReportType::kFeature, 0x21, wrong.data(), 3),
            Status::kInvalidArgument);
  EXPECT_EQ(status_of(session), 3);
  EXPECT_EQ(load_of(session).at(pid_usage(0x22)), 0);
  session.made(EffectType::kSine);
  EXPECT_EQ(session.device.receive(ReportType::kFeature, 0x21, wrong.data(), 2),
            Status::kInvalidArgument);
  EXPECT_EQ(status_of(session), 3);
  EXPECT_EQ(session.get(pid_usage(0x7F)).at(pid_usage(0x83)), Session::kBlocks);
}

TEST(PidPool, FreedBlock_IsSilentAndForgotten) {
  Session session;
  const std::int64_t block = playing_one(session, 0.5);
  EXPECT_EQ(session.force().y(), 0.5F);
  EXPECT_EQ(free_block(session, block), Status::kOk);
  EXPECT_EQ(session.force().y(), 0.0F);
  EXPECT_EQ(session.made(EffectType::kConstant), block);
  EXPECT_EQ(session.start(block), Status::kOk);
  EXPECT_EQ(session.force(), Vec2<float>(0.0F, 0.0F)) << "of the old one";
}

TEST(PidPool, HostThatHasGone_LeavesNothing) {
  Session session;
  playing_one(session, 0.5);
  EXPECT_EQ(session.send(pid_usage(0x7D), {{pid_usage(0x7E), 51}}), Status::kOk);
  EXPECT_NEAR(session.force().y(), 0.1F, 1e-6F);
  session.device.reset();
  playing_one(session, 0.5);
  EXPECT_NEAR(session.force().y(), 0.1F, 1e-6F) << "hid-pidff sets the gain, and resets then";
  session.device.forget_host();
  EXPECT_EQ(session.device.playing(), 0);
  EXPECT_EQ(session.force().y(), 0.0F);
  playing_one(session, 0.5);
  EXPECT_EQ(session.force().y(), 0.5F);
}

// A driver is not told that its device slept: what it made before is still there after.
TEST(PidPool, SilencedDevice_KeepsItsBlocks) {
  Session session;
  const std::int64_t first = playing_one(session, 0.5);
  const std::int64_t second = playing_one(session, 0.25);
  EXPECT_EQ(session.force().y(), 0.75F);
  session.device.silence();
  EXPECT_EQ(session.force().y(), 0.0F);
  EXPECT_EQ(session.device.playing(), 0);
  const std::int64_t third = playing_one(session, 0.125);
  EXPECT_NE(third, first);
  EXPECT_NE(third, second);
  EXPECT_EQ(session.start(first), Status::kOk);
  EXPECT_EQ(session.stop(third), Status::kOk);
  EXPECT_EQ(session.force().y(), 0.5F) << "stopping one leaves the other";
}

TEST(PidPool, EffectThatWasNotSet_IsSilent) {
  Session session;
  ASSERT_EQ(session.create(EffectType::kConstant), Status::kOk);
  ASSERT_EQ(session.send(pid_usage(0x73), {{pid_usage(0x22), 1}, {pid_usage(0x70), 5000}}),
            Status::kOk);
  ASSERT_EQ(session.start(1, 255), Status::kOk);
  EXPECT_EQ(session.force(), Vec2<float>(0.0F, 0.0F));
  EXPECT_EQ(session.set_effect(1, {{0x0A0001, 18001}}), Status::kInvalidArgument);
  EXPECT_EQ(session.force(), Vec2<float>(0.0F, 0.0F)) << "a refused one says nothing";
  EXPECT_EQ(session.set_effect(1, {{0x0A0001, degrees(180)}}), Status::kOk);
  EXPECT_EQ(session.force().y(), 0.5F);
}

TEST(PidReports, ZerosBehindAReport_AreLeftOutAndCounted) {
  Session session;
  playing_one(session, 0.5);
  Bytes half_as_much(18, 0);
  half_as_much[0] = 1;
  half_as_much[1] = 2500 % 256;
  half_as_much[2] = 2500 / 256;
  for (int size = SetConstant::kSize; size <= 18; ++size) {
    EXPECT_EQ(session.device.receive(ReportType::kOutput, 0x15, half_as_much.data(), size),
              Status::kOk);
  }
  EXPECT_EQ(session.device.counters().padded, 15U);
  EXPECT_EQ(session.force().y(), 0.25F);
  half_as_much[17] = 1;
  EXPECT_EQ(session.device.receive(ReportType::kOutput, 0x15, half_as_much.data(), 18),
            Status::kInvalidArgument);
  EXPECT_EQ(session.device.counters().count(Verdict::kLength), 1U);
}

TEST(PidReports, TimesBeyondTheLongest_CountAsThat) {
  Session session;
  const std::int64_t block = playing_one(session, 0.5);
  EXPECT_EQ(session.set_effect(block, {{0x0A0001, degrees(180)}, {pid_usage(0x50), 40000}}),
            Status::kOk);
  EXPECT_EQ(session.start(block), Status::kOk);
  EXPECT_EQ(session.force().y(), 0.5F);
  EXPECT_EQ(session.force({}, 32766999).y(), 0.5F);
  EXPECT_EQ(session.force({}, 1).y(), 0.0F) << "after 32767 ms";
}

TEST(PidPool, ParametersOfAnotherType_AreRefused) {
  Session session;
  const std::int64_t spring = session.made(EffectType::kSpring);
  const std::int64_t sine = session.made(EffectType::kSine);
  const std::int64_t ramp = session.made(EffectType::kRamp);
  const auto sent = [&](unsigned report, std::int64_t block) {
    return session.send(pid_usage(report), {{pid_usage(0x22), block}});
  };
  EXPECT_EQ(sent(0x73, spring), Status::kInvalidArgument);
  EXPECT_EQ(sent(0x73, ramp), Status::kInvalidArgument);
  EXPECT_EQ(sent(0x74, sine), Status::kInvalidArgument);
  EXPECT_EQ(sent(0x6E, spring), Status::kInvalidArgument);
  EXPECT_EQ(sent(0x6E, ramp), Status::kInvalidArgument);
  EXPECT_EQ(sent(0x5F, sine), Status::kInvalidArgument);
  EXPECT_EQ(sent(0x5A, spring), Status::kInvalidArgument);
  EXPECT_EQ(session.device.counters().count(Verdict::kOtherEffect), 7U);
  EXPECT_EQ(sent(0x5F, spring), Status::kOk);
  EXPECT_EQ(sent(0x6E, sine), Status::kOk);
  EXPECT_EQ(sent(0x74, ramp), Status::kOk);
  EXPECT_EQ(sent(0x5A, ramp), Status::kOk);
}

TEST(PidControl, StartSolo_StopsTheOthers) {
  Session session;
  playing_one(session, 0.5);
  const std::int64_t second = playing_one(session, 0.25);
  EXPECT_EQ(session.force().y(), 0.75F);
  EXPECT_EQ(session.send(pid_usage(0x77),
                         {{pid_usage(0x22), second}, {pid_usage(0x78), 2}, {pid_usage(0x7C), 1}}),
            Status::kOk);
  EXPECT_EQ(session.force().y(), 0.25F);
  EXPECT_EQ(session.device.playing(), 1);
}

TEST(PidControl, StopAll_KeepsTheEffects) {
  Session session;
  const std::int64_t block = playing_one(session, 0.5);
  EXPECT_EQ(session.control(3), Status::kOk);
  EXPECT_EQ(session.force().y(), 0.0F);
  EXPECT_EQ(session.start(block), Status::kOk);
  EXPECT_EQ(session.force().y(), 0.5F);
}

TEST(PidControl, Disabled_IsSilentWhileTimeGoesOn) {
  Session session;
  const std::int64_t block = playing_one(session, 0.5);
  EXPECT_EQ(session.set_effect(block, {{0x0A0001, degrees(180)}, {pid_usage(0x50), 20}}),
            Status::kOk);
  EXPECT_EQ(session.force().y(), 0.5F);
  EXPECT_EQ(session.control(2), Status::kOk);
  EXPECT_EQ(session.force({}, 5000).y(), 0.0F);
  EXPECT_EQ(session.control(1), Status::kOk);
  EXPECT_EQ(session.force({}, 14999).y(), 0.5F);
  EXPECT_EQ(session.force({}, 1).y(), 0.0F) << "20 ms in all";
}

TEST(PidControl, Paused_IsSilentAndTimeStandsStill) {
  Session session;
  const std::int64_t block = playing_one(session, 0.5);
  EXPECT_EQ(session.set_effect(block, {{0x0A0001, degrees(180)}, {pid_usage(0x50), 20}}),
            Status::kOk);
  EXPECT_EQ(session.force().y(), 0.5F);
  EXPECT_EQ(session.control(5), Status::kOk);
  EXPECT_EQ(session.force({}, 5000000).y(), 0.0F);
  EXPECT_EQ(session.control(6), Status::kOk);
  EXPECT_EQ(session.force({}, 19999).y(), 0.5F);
  EXPECT_EQ(session.force({}, 1).y(), 0.0F);
}

TEST(PidControl, Reset_FreesAllAndKeepsTheGain) {
  Session session;
  playing_one(session, 1.0);
  EXPECT_EQ(session.send(pid_usage(0x7D), {{pid_usage(0x7E), 51}}), Status::kOk);
  EXPECT_EQ(session.control(2), Status::kOk);
  EXPECT_EQ(session.control(5), Status::kOk);
  EXPECT_EQ(session.control(4), Status::kOk);
  EXPECT_EQ(session.force().y(), 0.0F);
  EXPECT_EQ(status_of(session), 3);
  EXPECT_EQ(session.start(1), Status::kStaleHandle);
  EXPECT_EQ(playing_one(session, 1.0), 1);
  EXPECT_FLOAT_EQ(session.force().y(), 0.2F);
}

struct Told {
  int block;
  bool playing;
  bool paused;
  bool enabled;
  friend bool operator==(const Told& a, const Told& b) {
    return a.block == b.block && a.playing == b.playing && a.paused == b.paused &&
           a.enabled == b.enabled;
  }
};

std::vector<Told> told_by(Session& session) {
  std::vector<Told> all;
  PidState state;
  while (session.device.next_state(state)) {
    all.push_back({state.block, state.playing, state.paused, state.actuators_enabled});
    if (all.size() > 2 * Session::kBlocks) ADD_FAILURE() << "no end";
    if (all.size() > 2 * Session::kBlocks) break;
  }
  return all;
}

TEST(PidState, Changes_AreToldOnce) {
  using All = std::vector<Told>;
  Session session;
  told_by(session);
  EXPECT_EQ(told_by(session), All{});
  playing_one(session, 0.5);
  const std::int64_t second = playing_one(session, 0.5);
  EXPECT_EQ(told_by(session), (All{{1, true, false, true}, {2, true, false, true}}));
  EXPECT_EQ(told_by(session), All{});
  EXPECT_EQ(session.stop(second), Status::kOk);
  EXPECT_EQ(told_by(session), (All{{2, false, false, true}}));
  EXPECT_EQ(session.control(5), Status::kOk);
  EXPECT_EQ(told_by(session), (All{{1, true, true, true}}));
  EXPECT_EQ(session.control(2), Status::kOk);
  EXPECT_EQ(told_by(session), (All{{1, true, true, false}}));
  session.device.reset();
  EXPECT_EQ(told_by(session), (All{{1, false, false, true}}));
}

TEST(PidState, EffectThatEnds_IsTold) {
  Session session;
  const std::int64_t block = playing_one(session, 0.5);
  EXPECT_EQ(session.set_effect(block, {{pid_usage(0x50), 20}}), Status::kOk);
  session.force();
  told_by(session);
  session.force({}, 20000);
  EXPECT_EQ(told_by(session), (std::vector<Told>{{1, false, false, true}}));
}

TEST(PidState, Actuator_IsToldAsItIs) {
  Session session;
  PidState state;
  while (session.device.next_state(state)) continue;
  session.device.tell_actuator(true);
  ASSERT_TRUE(session.device.next_state(state));
  EXPECT_TRUE(state.actuator_power);
  session.device.tell_actuator(true);
  EXPECT_FALSE(session.device.next_state(state));
  session.device.tell_actuator(false);
  ASSERT_TRUE(session.device.next_state(state));
  EXPECT_FALSE(state.actuator_power);
}

TEST(PidForce, StickThatIsNoNumber_IsTakenForOneAtRest) {
  constexpr float kBad[] = {std::numeric_limits<float>::quiet_NaN(),
                            std::numeric_limits<float>::infinity(),
                            -std::numeric_limits<float>::infinity()};
  Session session;
  const std::int64_t block = session.made(EffectType::kDamper);
  for (int axis = 0; axis < 2; ++axis) {
    EXPECT_EQ(session.condition(block, axis, {{pid_usage(0x61), 0}, {pid_usage(0x62), 10000}}),
              Status::kOk);
  }
  EXPECT_EQ(session.start(block), Status::kOk);
  std::uint32_t bad = 0;
  for (const float value : kBad) {
    for (int part = 0; part < 6; ++part) {
      Stick stick;
      Vec2<float>* const parts[] = {&stick.position, &stick.velocity, &stick.acceleration};
      (*parts[part / 2])[part % 2] = value;
      EXPECT_EQ(session.force(stick), Vec2<float>(0.0F, 0.0F));
      EXPECT_EQ(session.device.counters().bad_sticks, ++bad);
    }
  }
  Stick fast;
  fast.velocity = {std::numeric_limits<float>::max(), -std::numeric_limits<float>::max()};
  EXPECT_EQ(session.force(fast), Vec2<float>(0.0F, 0.0F)) << "a coefficient of 0";
  fast.velocity = -fast.velocity;
  EXPECT_EQ(session.force(fast), Vec2<float>(1.0F, -1.0F));
}

// Whatever plays, the demand stays in its square, and the order of effects does not matter.
TEST(PidForce, AnyEffects_StayWithinOne) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> share(-1.0F, 1.0F);
  for (int run = 0; run < 300; ++run) {
    Session session;
    for (int i = 0; i < Session::kBlocks; ++i) {
      const auto type = static_cast<EffectType>(random() % kEffectTypes + 1);
      const std::int64_t block = session.made(type);
      const auto any = [&] { return static_cast<std::int64_t>(random() % 20001) - 10000; };
      if (is_condition(type)) {
        const Values c = {{pid_usage(0x61), any()}, {pid_usage(0x62), any()}};
        EXPECT_EQ(session.condition(block, 0, c), Status::kOk);
        EXPECT_EQ(session.condition(block, static_cast<int>(random() % 2), c), Status::kOk);
      } else if (is_periodic(type)) {
        EXPECT_EQ(session.send(pid_usage(0x6E), {{pid_usage(0x22), block},
                                                 {pid_usage(0x70), std::abs(any())},
                                                 {pid_usage(0x6F), any()},
                                                 {pid_usage(0x72), 7}}),
                  Status::kOk);
      }
      EXPECT_EQ(session.set_effect(block, {{0x0A0001, std::int64_t(random() % 18001)}}),
                Status::kOk);
      EXPECT_EQ(session.start(block), Status::kOk);
    }
    for (int step = 0; step < 20; ++step) {
      Stick stick;
      stick.position = {share(random), share(random)};
      stick.velocity = {share(random) * 50.0F, share(random) * 50.0F};
      const Vec2<float> force = session.force(stick, 1000);
      ASSERT_LE(std::abs(force.x()), 1.0F);
      ASSERT_LE(std::abs(force.y()), 1.0F);
    }
  }
}

}  // namespace
}  // namespace batuta::pid::test
