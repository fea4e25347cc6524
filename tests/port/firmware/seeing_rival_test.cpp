// SPDX-License-Identifier: MIT
// A board that an opponent fences against, held against the host's program for the same: its
// devices and a duel of its own.
#include "shared/firmware/seeing_rival.hpp"

#include <gtest/gtest.h>

#include <type_traits>
#include <utility>

#include "batuta/record/duel.hpp"
#include "device_rig.hpp"
#include "heap_trap.hpp"
#include "programs/devices/seeing_device.hpp"

namespace batuta::test {
using namespace fencing;
namespace {

using firmware::SeeingRival;
using haptics::SteppedBout;
using host::SeeingDevice;
using Rig = DeviceRigOf<SeeingRival>;

constexpr std::int32_t kStepUs = 1000;

bool same(const InputSample& a, const InputSample& b) {
  return a.time == b.time && a.x == b.x && a.y == b.y && a.feet_x == b.feet_x &&
         a.feet_y == b.feet_y && a.buttons == b.buttons && a.sequence == b.sequence;
}

/// A bout as batuta-duel plays it: two devices, and a duel that they see.
class HostBout {
 public:
  HostBout(const host::SeeingScript& left, const host::SeeingScript& right)
      : devices_{SeeingDevice(left), SeeingDevice(right)} {}

  void start(std::int32_t touches) {
    haptics::BoutSettings settings;
    settings.touches = touches;
    ASSERT_EQ(bout.start(settings), Status::kOk);
  }
  /// What a side's device holds out for the next step.
  InputSample look(Side side) {
    InputSample sample;
    devices_[index_of(side)].see(observation_of(bout.duel(), side), kStepUs);
    EXPECT_EQ(devices_[index_of(side)].read(bout.steps() * kStepUs, sample), Status::kOk);
    return sample;
  }

  SteppedBout bout;

 private:
  std::array<SeeingDevice, 2> devices_;
};

struct Case {
  host::SeeingScript own;
  host::SeeingScript rival;
  Side own_side;
};

/// @returns exchanges of the bout, 0 where the board played another one
std::uint32_t expect_same_bout(const Case& who) {
  constexpr std::uint32_t kMostSteps = 60000;
  const bool is_left = who.own_side == Side::kLeft;
  HostBout seen(is_left ? who.own : who.rival, is_left ? who.rival : who.own);
  seen.start(2);
  Rig rig;
  rig.settings.bout.touches = 2;
  rig.settings.own_side = who.own_side;
  rig.rival = {who.rival.skill, who.rival.seed};
  rig.start();
  const SteppedBout& played = rig.device->bout();
  while (!seen.bout.is_over() && seen.bout.steps() < kMostSteps) {
    const std::array<InputSample, 2> samples = {seen.look(Side::kLeft), seen.look(Side::kRight)};
    EXPECT_EQ(seen.bout.step(&samples[0], &samples[1]), Status::kOk);
    rig.stick.samples.push_back(samples[index_of(who.own_side)]);
    if (seen.bout.steps() % 100 == 0) rig.ticks += 3;  // the board was late
    rig.run(1);
    const InputSample* const used = played.used(other(who.own_side));
    EXPECT_NE(used, nullptr);
    const bool alike = used != nullptr && same(*used, samples[index_of(other(who.own_side))]) &&
                       hash_of(played.duel()) == hash_of(seen.bout.duel());
    EXPECT_TRUE(alike) << "step " << seen.bout.steps();
    if (!alike) return 0;
  }
  EXPECT_TRUE(played.is_over());
  return played.duel().bout().exchange;
}

TEST(SeeingRival, PlaysStepForStepWhatTheHostsDevicePlays) {
  const Case cases[] = {
      {{"club", Skill::kClub, 5}, {"master", Skill::kMaster, 7}, Side::kLeft},
      {{"novice", Skill::kNovice, 3}, {"club", Skill::kClub, 0xFFFFFFFFU}, Side::kLeft},
      {{"master", Skill::kMaster, 1}, {"novice", Skill::kNovice, 2}, Side::kRight}};
  for (const Case& who : cases) EXPECT_GE(expect_same_bout(who), 2U) << who.rival.name;
}

/// The samples of a board's own bout against a stick that stays away, until it is over.
std::vector<InputSample> lone_bout(Rig& rig) {
  constexpr int kMost = 60000;
  std::vector<InputSample> samples;
  for (int i = 0; i < kMost && !rig.device->bout().is_over(); ++i) {
    rig.run(1);
    const InputSample* const used = rig.device->bout().used(Side::kRight);
    if (used != nullptr) samples.push_back(*used);
  }
  EXPECT_TRUE(rig.device->bout().is_over());
  return samples;
}

TEST(SeeingRival, Alone_EachBoutIsFencedAnew_AsIfItWereTheFirst) {
  Rig rig;
  rig.settings.pause = 10;
  rig.start();
  const std::vector<InputSample> first = lone_bout(rig);
  rig.run(rig.settings.pause - 1);
  ASSERT_EQ(rig.device->bout().steps(), 0U);
  const std::vector<InputSample> second = lone_bout(rig);
  ASSERT_GT(first.size(), 100U);
  ASSERT_EQ(first.size(), second.size());
  for (std::size_t i = 0; i < first.size(); ++i) ASSERT_TRUE(same(first[i], second[i])) << i;
}

TEST(SeeingRival, InAFreeSession_ItsSideIsItsOwn_AndTold) {
  Rig rig;
  rig.start();
  PlainHost host(rig.cable);
  rig.run(40);
  host.received<link::StickUsed>();
  host.send(link::Hello{3, link::Mode::kFree});
  InputSample sample;
  sample.x = 0.5F;
  host.send(link::StickSample{link::LinkSide::kLeft, sample});
  host.send(link::StickSample{link::LinkSide::kRight, sample});
  rig.run(1);
  ASSERT_EQ(rig.device->bout().steps(), 1U);
  EXPECT_EQ(rig.device->bout().used(Side::kLeft)->x, 0.5F);
  ASSERT_NE(rig.device->bout().used(Side::kRight), nullptr);
  EXPECT_EQ(rig.device->bout().used(Side::kRight)->sequence, 0U) << "of a new bout";
  EXPECT_NE(rig.device->bout().used(Side::kRight)->x, 0.5F);
  EXPECT_EQ(rig.device->report().steps_refused, 1U);
  rig.run(1);
  const auto used = host.received<link::StickUsed>();
  ASSERT_EQ(used.size(), 3U) << "two of the first step, one of the second";
  EXPECT_EQ(used[2].side, link::LinkSide::kRight);
}

TEST(SeeingRival, Paced_TheHostPlaysBothSides) {
  Rig rig;
  rig.start();
  PlainHost host(rig.cable);
  host.send(link::Hello{3, link::Mode::kPaced});
  link::Step step;
  step.step = 1;
  host.send(step);
  rig.run(2);
  ASSERT_EQ(rig.device->bout().steps(), 1U);
  EXPECT_EQ(rig.device->bout().used(Side::kRight), nullptr);
}

TEST(SeeingRival, NoneOfTheSkills_IsRefused) {
  Rig rig;
  rig.rival.skill = static_cast<Skill>(7);
  EXPECT_EQ(rig.device->start(rig.settings, rig.rival), Status::kInvalidArgument);
}

// All that a skill may be: the check says the same as the opponent does.
TEST(SeeingRival, Settings_AreGoodWhereAnOpponentTakesThem) {
  int good = 0;
  for (int skill = 0; skill < 256; ++skill) {
    const SeeingRival::Settings settings{static_cast<Skill>(skill), 1};
    Opponent opponent;
    EXPECT_EQ(SeeingRival::validate(settings), opponent.configure(settings.skill, settings.seed));
    good += SeeingRival::validate(settings) == Status::kOk ? 1 : 0;
  }
  EXPECT_EQ(good, 3);
}

// Of two boards one is told, in the middle of a bout, to start anew with what it cannot: both fence
// the same bout.
TEST(SeeingRival, AStartThatIsRefused_LeavesBoutAndRivalAsTheyWere) {
  constexpr int kInTheMiddle = 700;
  Rig undisturbed;
  Rig rig;
  for (Rig* one : {&undisturbed, &rig}) {
    one->start();
    one->run(kInTheMiddle);
  }
  auto bad = rig.settings;
  bad.bout.touches = 0;
  EXPECT_EQ(rig.device->start(bad, {Skill::kMaster, 9}), Status::kInvalidArgument);
  EXPECT_EQ(rig.device->start(rig.settings, {static_cast<Skill>(7), 9}), Status::kInvalidArgument);
  const std::vector<InputSample> expected = lone_bout(undisturbed);
  const std::vector<InputSample> samples = lone_bout(rig);
  ASSERT_GT(expected.size(), 100U);
  ASSERT_EQ(samples.size(), expected.size());
  for (std::size_t i = 0; i < samples.size(); ++i) ASSERT_TRUE(same(samples[i], expected[i])) << i;
}

TEST(SeeingRival, NeverAllocates) {
  SteppedBout bout;
  SeeingRival rival;
  HeapTrap trap;
  ASSERT_EQ(bout.start({}), Status::kOk);
  ASSERT_EQ(rival.configure({Skill::kMaster, 1}), Status::kOk);
  for (int i = 0; i < 2000 && !bout.is_over(); ++i) {
    const InputSample sample = rival.play(bout.duel(), Side::kRight, kStepUs);
    (void)bout.step(nullptr, &sample);
  }
  EXPECT_EQ(trap.allocations(), 0);
}

TEST(SeeingRival, LeftOut_TakesNoRoom) {
  EXPECT_TRUE(std::is_empty_v<firmware::NoRival>);
  constexpr std::size_t kWith = sizeof(firmware::ApplicationOf<SeeingRival>);
  constexpr std::size_t kWord = alignof(firmware::Application);
  EXPECT_LE(sizeof(firmware::Application), kWith - sizeof(SeeingRival) + kWord);
  EXPECT_GE(sizeof(firmware::Application) + sizeof(SeeingRival) + kWord, kWith);
}

}  // namespace
}  // namespace batuta::test
