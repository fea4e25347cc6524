// SPDX-License-Identifier: MIT
#include "shared/firmware/application.hpp"

#include <gmock/gmock.h>

#include <limits>

#include "device_rig.hpp"
#include "shared/firmware/step_messages.hpp"

namespace batuta::test {
using namespace fencing;
namespace {

using haptics::SteppedBout;
using link::MessageType;
using link::Mode;
using link::Refusal;
using ::testing::Contains;
using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::Not;

InputSample sample_at(std::uint32_t step, float x, float y) {
  InputSample sample;
  sample.time = step * 1000;
  sample.sequence = step;
  sample.x = x;
  sample.y = y;
  return sample;
}

class FreeDevice : public ::testing::Test {
 protected:
  DeviceRig rig;
  PlainHost host{rig.cable};

  void SetUp() override { rig.start(); }
};

class PacedDevice : public FreeDevice {
 protected:
  void SetUp() override {
    FreeDevice::SetUp();
    host.send(link::Hello{7, Mode::kPaced});
    rig.run(1);
    ASSERT_EQ(host.received<link::Welcome>().size(), 1U);
    host.types();
  }
  /// A step with a sample for the left stick.
  link::Step order(std::uint32_t step) {
    link::Step message;
    message.step = step;
    message.has_left = true;
    message.left = sample_at(step, 0.1F, 0.2F);
    return message;
  }
  void make_steps(std::uint32_t first, std::uint32_t last) {
    for (std::uint32_t step = first; step <= last; ++step) {
      host.send(order(step));
      rig.run(1);
    }
    ASSERT_EQ(rig.device->bout().steps(), last);
    host.received<link::StepReport>();
    host.types();
  }
};

TEST_F(FreeDevice, Alone_MakesOneStepATick_AndTellsItWithTheSample) {
  rig.stick.samples = {sample_at(0, 0.25F, -0.5F)};
  rig.run(1);
  EXPECT_EQ(rig.device->bout().steps(), 1U);
  const auto used = host.received<link::StickUsed>();
  ASSERT_EQ(used.size(), 1U);
  EXPECT_EQ(used[0].sample.x, 0.25F);
  EXPECT_EQ(used[0].step, 1U);
  EXPECT_THAT(host.types(),
              ElementsAre(MessageType::kStickUsed, MessageType::kPose, MessageType::kForce,
                          MessageType::kPose, MessageType::kForce, MessageType::kStepReport));
  rig.run(1);
  host.received<link::StickUsed>();
  EXPECT_THAT(host.types(), Not(Contains(MessageType::kStickUsed))) << "no new sample";
}

TEST_F(FreeDevice, TheLatestSampleWins_WhereverItComesFrom) {
  host.send(link::Hello{3, Mode::kFree});
  rig.run(1);
  rig.stick.samples = {sample_at(0, 0.25F, 0)};
  host.send(link::StickSample{link::LinkSide::kLeft, sample_at(1, 0.5F, 0)});
  host.send(link::StickSample{link::LinkSide::kLeft, sample_at(2, 0.75F, 0)});
  host.send(link::StickSample{link::LinkSide::kRight, sample_at(2, -0.75F, 0)});
  rig.run(1);
  const auto used = host.received<link::StickUsed>();
  ASSERT_EQ(used.size(), 2U);
  EXPECT_EQ(used[0].sample.x, 0.75F);
  EXPECT_EQ(used[1].side, link::LinkSide::kRight);
  EXPECT_EQ(used[1].sample.x, -0.75F);
}

TEST_F(FreeDevice, Alone_AStickSampleIsRefused) {
  host.send(link::StickSample{link::LinkSide::kLeft, sample_at(1, 0.5F, 0)});
  rig.run(1);
  EXPECT_EQ(host.received<link::Refused>().at(0).why, Refusal::kNoSession);
}

TEST_F(FreeDevice, AReport_IsOfItsSession_AndOfNoneAlone) {
  rig.run(1);
  EXPECT_EQ(host.received<link::StepReport>().at(0).session, 0U);
  host.send(link::Hello{0x12345678, Mode::kFree});
  rig.run(1);
  EXPECT_EQ(host.received<link::StepReport>().at(0).session, 0x5678U);
}

TEST_F(FreeDevice, AStepOrder_IsRefused_WithItsReason) {
  link::Step step;
  step.step = 1;
  host.send(step);
  rig.run(1);
  auto refused = host.received<link::Refused>();
  ASSERT_EQ(refused.size(), 1U);
  EXPECT_EQ(refused[0].why, Refusal::kNoSession);
  host.send(link::Hello{3, Mode::kFree});
  host.send(step);
  rig.run(1);
  refused = host.received<link::Refused>();
  ASSERT_EQ(refused.size(), 1U);
  EXPECT_EQ(refused[0].why, Refusal::kWrongMode);
  EXPECT_EQ(rig.device->report().steps_refused, 2U);
}

TEST_F(FreeDevice, AHello_StartsTheBoutAnew_AndTheSameHelloDoesNot) {
  rig.run(30);
  host.send(link::Hello{3, Mode::kFree});
  rig.run(1);
  auto welcome = host.received<link::Welcome>();
  ASSERT_EQ(welcome.size(), 1U);
  EXPECT_EQ(welcome[0].session, 3U);
  EXPECT_EQ(welcome[0].step, 0U);
  EXPECT_EQ(rig.device->bout().steps(), 1U) << "the tick of the Hello made the first step";
  rig.run(9);
  host.send(link::Hello{3, Mode::kFree});
  rig.run(1);
  welcome = host.received<link::Welcome>();
  ASSERT_EQ(welcome.size(), 1U);
  EXPECT_EQ(welcome[0].step, 10U);
  host.send(link::Hello{3, Mode::kPaced});
  rig.run(5);
  EXPECT_EQ(rig.device->bout().steps(), 0U) << "another mode is another bout";
}

TEST_F(FreeDevice, TheOwnStickBeyondItsSquare_IsCounted_AndNotUsed) {
  rig.stick.samples = {sample_at(0, 2, 0)};
  rig.run(1);
  EXPECT_EQ(rig.device->report().stick_invalid, 1U);
  const auto reports = host.received<link::StepReport>();
  ASSERT_EQ(reports.size(), 1U);
  EXPECT_EQ(reports[0].stick_invalid, 1U);
  EXPECT_FALSE(reports[0].used_left);
}

TEST(Device, TellsTheFaultOfTheLastRun) {
  DeviceRig rig;
  rig.device = std::make_unique<firmware::Application>(firmware::Board{rig.clock, rig.cable.device},
                                                       firmware::LastFault{4, {0xABCDEF01U, 42}});
  rig.start();
  PlainHost host(rig.cable);
  host.send(link::Hello{9, Mode::kPaced});
  rig.run(1);
  const auto welcome = host.received<link::Welcome>();
  ASSERT_EQ(welcome.size(), 1U);
  EXPECT_EQ(welcome[0].fault_code, 4U);
  EXPECT_THAT(welcome[0].fault_detail, ElementsAre(0xABCDEF01U, 42U));
  EXPECT_EQ(welcome[0].step_us, 1000U);
}

TEST(Device, SettingsOutOfRange_AreRefused) {
  DeviceRig rig;
  rig.settings.pause = 0;
  EXPECT_EQ(rig.device->start(rig.settings), Status::kInvalidArgument);
  rig.settings = {};
  rig.settings.bout.step_us = 10;
  EXPECT_EQ(rig.device->start(rig.settings), Status::kInvalidArgument);
  rig.settings = {};
  rig.settings.bout.force.full_scale = -1;
  EXPECT_EQ(rig.device->start(rig.settings), Status::kInvalidArgument);
}

/// Settings with one that is out of range.
std::vector<firmware::ApplicationSettings> bad_settings() {
  std::vector<firmware::ApplicationSettings> all(6);
  all[0].pause = 0;
  all[1].bout.step_us = 10;
  all[2].bout.touches = 0;
  all[3].bout.distance = -1;
  all[4].bout.force.full_scale = -1;
  all[5].bout.force.ramp.length = 0;
  for (auto& one : all) one.own_side = Side::kRight;  // what is good of them is not taken, either
  return all;
}

TEST_F(PacedDevice, AStartThatIsRefused_LeavesTheSessionAsItWas) {
  make_steps(1, 20);
  host.send(order(3));
  rig.run(1);
  ASSERT_EQ(rig.device->report().steps_refused, 1U);
  host.received<link::Refused>();
  const std::uint32_t used = rig.device->ticks().used;
  const ForceCommand force = rig.device->force();
  for (const auto& bad : bad_settings()) {
    ASSERT_EQ(rig.device->start(bad), Status::kInvalidArgument);
    EXPECT_EQ(rig.device->session(), 7U);
    EXPECT_EQ(rig.device->mode(), Mode::kPaced);
    EXPECT_EQ(rig.device->bout().steps(), 20U);
    EXPECT_EQ(rig.device->report().steps_refused, 1U);
    EXPECT_EQ(rig.device->ticks().used, used);
    EXPECT_TRUE(rig.device->stage().is_enabled());
    EXPECT_EQ(rig.device->force().time, force.time) << "the motor was told nothing";
  }
  make_steps(21, 22);
  host.send(link::Hello{7, Mode::kPaced});
  rig.run(1);
  const auto welcome = host.received<link::Welcome>();
  ASSERT_EQ(welcome.size(), 1U);
  EXPECT_EQ(welcome[0].step, 22U) << "of the same bout: as many touches as before";
  EXPECT_EQ(welcome[0].step_us, 1000U);
}

TEST_F(PacedDevice, WithoutAnOrder_MakesNoStep) {
  rig.run(50);
  EXPECT_EQ(rig.device->bout().steps(), 0U);
  EXPECT_EQ(host.received<link::StepReport>().size(), 0U);
}

TEST_F(PacedDevice, TheOwnStickIsNotUsed) {
  rig.stick.samples = {sample_at(0, 0.5F, 0)};
  link::Step bare;
  bare.step = 1;
  host.send(bare);
  rig.run(1);
  const auto report = host.received<link::StepReport>();
  ASSERT_EQ(report.size(), 1U);
  EXPECT_FALSE(report[0].used_left);
}

TEST_F(PacedDevice, AnOrder_IsMadeOnce_AndItsRepetitionAnsweredFromTheSameState) {
  make_steps(1, 20);
  host.send(order(21));
  rig.run(1);
  auto poses = host.received<link::Pose>();
  host.send(order(21));
  rig.run(1);
  EXPECT_EQ(rig.device->bout().steps(), 21U);
  const auto again = host.received<link::Pose>();
  ASSERT_EQ(poses.size(), 2U);
  ASSERT_EQ(again.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(poses[i].position_W, again[i].position_W);
    EXPECT_EQ(poses[i].rotation_WB, again[i].rotation_WB);
  }
}

TEST_F(PacedDevice, TheAnswerToARepetition_SaysSo) {
  make_steps(1, 3);
  host.send(order(4));
  rig.run(1);
  EXPECT_FALSE(host.received<link::StepReport>().at(0).repeated);
  host.send(order(4));
  rig.run(1);
  const auto report = host.received<link::StepReport>();
  ASSERT_EQ(report.size(), 1U);
  EXPECT_TRUE(report[0].repeated);
  EXPECT_EQ(report[0].step, 4U);
}

TEST_F(PacedDevice, AnyOtherNumber_IsRefused_AndChangesNothing) {
  make_steps(1, 5);
  for (const std::uint32_t wrong : {0U, 4U, 7U, 0xFFFFFFFFU}) {
    host.send(order(wrong));
    rig.run(1);
    const auto refused = host.received<link::Refused>();
    ASSERT_EQ(refused.size(), 1U) << wrong;
    EXPECT_EQ(refused[0].why, Refusal::kWrongStep);
    EXPECT_EQ(refused[0].step, wrong);
    EXPECT_EQ(refused[0].steps_over, 5U);
  }
  EXPECT_EQ(rig.device->bout().steps(), 5U);
  EXPECT_EQ(rig.device->report().steps_refused, 4U);
}

TEST_F(PacedDevice, AStepZeroBeforeTheFirst_IsNoRepetition) {
  host.send(order(0));
  rig.run(1);
  EXPECT_EQ(host.received<link::Refused>().size(), 1U);
}

TEST_F(PacedDevice, AStickSample_IsRefused) {
  host.send(link::StickSample{});
  rig.run(1);
  const auto refused = host.received<link::Refused>();
  ASSERT_EQ(refused.size(), 1U);
  EXPECT_EQ(refused[0].what, MessageType::kStickSample);
}

TEST_F(PacedDevice, TwoOrdersAtOnce_AreMadeInTwoTicks) {
  host.send(order(1));
  host.send(order(2));
  rig.run(1);
  EXPECT_EQ(rig.device->bout().steps(), 1U);
  rig.run(1);
  EXPECT_EQ(rig.device->bout().steps(), 2U);
}

TEST_F(PacedDevice, AnotherHelloInTheMiddle_StartsFromTheGuard) {
  make_steps(1, 40);
  host.send(link::Hello{8, Mode::kPaced});
  rig.run(1);
  ASSERT_EQ(host.received<link::Welcome>().size(), 1U);
  EXPECT_EQ(rig.device->bout().steps(), 0U);
  SteppedBout fresh;
  ASSERT_EQ(fresh.start(rig.settings.bout), Status::kOk);
  make_steps(1, 39);
  for (std::uint32_t step = 1; step <= 39; ++step) {
    const InputSample left = order(step).left;
    ASSERT_EQ(fresh.step(&left, nullptr), Status::kOk);
  }
  const auto here = firmware::pose_message(fresh.duel(), Side::kLeft);
  const auto there = firmware::pose_message(rig.device->bout().duel(), Side::kLeft);
  EXPECT_EQ(here.position_W, there.position_W) << "nothing of the first bout is left";
  EXPECT_EQ(here.rotation_WB, there.rotation_WB);
}

/// A lunge in this line passes the blade of who stands still.
constexpr float kLine = -0.4F;

TEST_F(PacedDevice, AfterTheBout_OrdersAreRefused_AndTheForceIsNone) {
  std::uint32_t step = 0;
  while (!rig.device->bout().is_over() && step < 3000) {
    link::Step lunge = order(++step);
    lunge.left = sample_at(step, kLine, std::min(1.0F, 0.01F * static_cast<float>(step)));
    host.send(lunge);
    rig.run(1);
  }
  ASSERT_TRUE(rig.device->bout().is_over());
  host.received<link::StepReport>();
  host.send(order(step));
  rig.run(1);
  EXPECT_EQ(host.received<link::StepReport>().size(), 1U) << "the last step may be asked for again";
  host.send(order(step + 1));
  rig.run(1);
  const auto refused = host.received<link::Refused>();
  ASSERT_EQ(refused.size(), 1U);
  EXPECT_EQ(refused[0].why, Refusal::kBoutOver);
  EXPECT_EQ(rig.motor.last.x, 0.0F);
  EXPECT_EQ(rig.motor.last.y, 0.0F);
  rig.run(5000);
  EXPECT_EQ(rig.device->bout().steps(), step) << "in a session the device waits for the host";
}

TEST_F(FreeDevice, HelloToTwo_ABoutOfTwoExchanges_WithItsScore) {
  host.send(link::Hello{7, Mode::kPaced, 2});
  rig.run(1);
  ASSERT_EQ(host.received<link::Welcome>().size(), 1U);
  host.types();
  std::uint32_t step = 0;
  std::uint32_t guard = 0;  // the step before the exchange
  int touches = 0;
  std::vector<std::uint8_t> states;
  link::StepReport last;
  while (!rig.device->bout().is_over() && step < 4000) {
    link::Step lunge;
    lunge.step = ++step;
    lunge.has_left = true;
    const auto since = static_cast<float>(step - guard);
    lunge.left = sample_at(step, kLine, std::min(1.0F, 0.01F * since));
    host.send(lunge);
    rig.run(1);
    const auto reports = host.received<link::StepReport>();
    ASSERT_EQ(reports.size(), 1U);
    last = reports[0];
    if (states.empty() || states.back() != last.bout_state) states.push_back(last.bout_state);
    if (last.bout_state == static_cast<std::uint8_t>(BoutState::kHalt)) guard = step;
    for (const auto type : host.types()) touches += type == link::MessageType::kTouch ? 1 : 0;
  }
  ASSERT_TRUE(rig.device->bout().is_over());
  EXPECT_EQ(states, (std::vector<std::uint8_t>{0, 1, 4, 0, 1, 2}));
  EXPECT_EQ(touches, 2);
  EXPECT_EQ(last.score, (std::array<std::uint8_t, 2>{2, 0}));
  host.send(link::Hello{7, Mode::kPaced, 3});
  rig.run(1);
  EXPECT_EQ(rig.device->bout().steps(), 0U) << "other touches are another bout";
}

TEST_F(FreeDevice, Alone_TheNextBoutBeginsAfterThePause) {
  for (std::uint32_t i = 0; i < 3000; ++i) {
    rig.stick.samples.push_back(sample_at(i, kLine, std::min(1.0F, 0.01F * static_cast<float>(i))));
  }
  int ticks = 0;
  for (; !rig.device->bout().is_over() && ticks < 3000; ++ticks) rig.run(1);
  ASSERT_TRUE(rig.device->bout().is_over());
  rig.run(rig.settings.pause - 2);
  EXPECT_TRUE(rig.device->bout().is_over());
  rig.run(1);
  EXPECT_EQ(rig.device->bout().steps(), 0U);
  rig.run(1);
  EXPECT_EQ(rig.device->bout().steps(), 1U);
}

TEST_F(FreeDevice, ABrokenMotor_IsCounted) {
  rig.motor.broken = true;
  rig.run(3);
  EXPECT_EQ(rig.device->report().force_failures, 3U);
  EXPECT_EQ(host.received<link::StepReport>().back().force_failures, 2U) << "sent before the third";
}

TEST_F(FreeDevice, LateTicks_AreCountedAndTold_AndNeverMadeUpFor) {
  rig.run(1);
  rig.ticks += 4;
  rig.run(1);
  EXPECT_EQ(rig.device->bout().steps(), 2U);
  rig.clock.per_call = 1500;  // now every look at the clock takes longer than a tick
  rig.run(1);
  rig.clock.per_call = 0;
  rig.run(1);
  const auto reports = host.received<link::StepReport>();
  ASSERT_EQ(reports.size(), 4U);
  EXPECT_EQ(reports[1].skipped, 4U);
  EXPECT_EQ(reports[1].overruns, 0U);
  EXPECT_EQ(reports[3].overruns, 1U);
  EXPECT_EQ(rig.device->bout().steps(), 4U);
}

TEST_F(FreeDevice, TelemetryWithoutRoom_IsCounted_AndWhatComesThroughIsWhole) {
  rig.cable.to_host.limit(300);  // about one step fits; nobody reads
  rig.run(50);
  EXPECT_GT(rig.device->unsent(), 0U);
  rig.cable.to_host.limit(1U << 20U);
  std::uint32_t told = 0;
  for (int i = 0; i < 60; ++i) {
    rig.run(1);
    for (const auto& report : host.received<link::StepReport>()) told = report.unsent;
  }
  EXPECT_EQ(told, rig.device->unsent());
  EXPECT_EQ(host.counters().rejected(), 0U) << "never half a frame";
  EXPECT_GT(host.counters().accepted, 100U);
}

TEST_F(FreeDevice, Noise_IsCountedAndTold_AndDoesNoHarm) {
  std::mt19937 random(5);
  for (int i = 0; i < 200; ++i) {
    std::vector<std::uint8_t> noise(100);
    for (auto& byte : noise) byte = static_cast<std::uint8_t>(random());
    host.send_raw(noise);
    rig.run(1);
  }
  EXPECT_EQ(rig.device->bout().steps(), 200U);
  const auto reports = host.received<link::StepReport>();
  ASSERT_EQ(reports.size(), 200U);
  EXPECT_GT(reports.back().rejected, 50U);
  host.send_raw({0});
  host.send(link::Hello{1, Mode::kPaced});
  rig.run(20);
  EXPECT_EQ(host.received<link::Welcome>().size(), 1U);
}

TEST_F(FreeDevice, AFloodOfFrames_IsObeyedAFewATick) {
  link::Step step;
  step.step = 1;
  for (int i = 0; i < 40; ++i) host.send(step);
  rig.run(1);
  const auto first = host.received<link::Refused>().size();
  EXPECT_LE(first, static_cast<std::size_t>(firmware::Application::kFramesPerTick));
  EXPECT_GT(first, 0U);
  rig.run(40);
  EXPECT_EQ(first + host.received<link::Refused>().size(), 40U) << "none is forgotten";
}

}  // namespace
}  // namespace batuta::test
