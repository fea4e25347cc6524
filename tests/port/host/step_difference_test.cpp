// SPDX-License-Identifier: MIT
#include "programs/duel/device/step_difference.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <memory>

#include "shared/firmware/step_messages.hpp"

namespace batuta::host {
using namespace fencing;
namespace {

using haptics::SteppedBout;
using ::testing::HasSubstr;

/// A step in which the blades meet, told frame by frame, each of which a test may change.
class AToldStep : public ::testing::Test {
 protected:
  std::unique_ptr<SteppedBout> bout = std::make_unique<SteppedBout>();
  StepAnswer answer;
  int frames = 0;

  void SetUp() override {
    ASSERT_EQ(bout->start({}), Status::kOk);
    while (bout->duel().world().events().empty() && bout->steps() < 300) {
      InputSample left;
      left.time = bout->steps() * 1000;
      left.y = 0.5F * std::fmin(static_cast<float>(bout->steps()) / 150.0F, 1.0F);
      ASSERT_EQ(bout->step(&left, nullptr), Status::kOk);
    }
    ASSERT_FALSE(bout->duel().world().events().empty());
    tell_all();
    ASSERT_EQ(difference(), "");
  }
  template <class Message>
  StepAnswer::Taken tell(const Message& message) {
    link::Payload payload;
    EXPECT_TRUE(encode(message, payload));
    return answer.take({Message::kType, 0, payload.bytes.data(), payload.size});
  }
  void tell_all() {
    answer.begin(bout->steps());
    for (const Side side : {Side::kLeft, Side::kRight}) {
      tell(firmware::pose_message(bout->duel(), side));
      tell(firmware::force_message(*bout, side));
    }
    for (int i = 0; i < bout->duel().world().events().size(); ++i) {
      tell(firmware::event_message(bout->duel(), i));
    }
    link::StepReport report = firmware::report_message(*bout);
    report.frames = static_cast<std::uint8_t>(firmware::frames_of(*bout, false));
    EXPECT_FALSE(answer.is_complete());
    EXPECT_EQ(tell(report), StepAnswer::Taken::kReport);
    EXPECT_TRUE(answer.is_complete());
  }
  std::string difference() const { return first_difference(*bout, answer); }
};

float next(float x) {
  return std::nextafter(x, 10.0F);
}

TEST_F(AToldStep, OneBitOfAPose_IsNamed) {
  link::Pose pose = firmware::pose_message(bout->duel(), Side::kRight);
  pose.rotation_WB[2] = next(pose.rotation_WB[2]);
  tell(pose);
  EXPECT_THAT(difference(), HasSubstr("right pose: rotation y differs: 0x"));
  EXPECT_THAT(difference(), HasSubstr("step " + std::to_string(bout->steps()) + ": "));
}

TEST_F(AToldStep, OneBitOfAForce_IsNamed) {
  link::Force force = firmware::force_message(*bout, Side::kLeft);
  force.y = std::nextafter(force.y, 0.0F);
  tell(force);
  EXPECT_THAT(difference(), HasSubstr("left force: y differs: 0x"));
}

TEST_F(AToldStep, OneBitOfAnEvent_IsNamed) {
  link::Event event = firmware::event_message(bout->duel(), 0);
  event.impulse = next(event.impulse);
  tell(event);
  EXPECT_THAT(difference(), HasSubstr("event 0: impulse differs: 0x"));
}

TEST_F(AToldStep, TheSignOfZero_IsADifference) {
  link::Force force = firmware::force_message(*bout, Side::kRight);
  ASSERT_EQ(force.x, 0.0F) << "a side without samples has no force";
  force.x = std::signbit(force.x) ? 0.0F : -0.0F;
  tell(force);
  EXPECT_THAT(difference(), HasSubstr("right force: x differs: 0x"));
}

TEST_F(AToldStep, AnEventThatIsNotThere_IsADifference) {
  link::Event event = firmware::event_message(bout->duel(), 0);
  event.index = 9;
  tell(event);
  EXPECT_FALSE(answer.is_complete()) << "one frame too many";
  EXPECT_THAT(difference(), HasSubstr("bout: events differs"));
}

TEST_F(AToldStep, WhatTheBoutSays_IsCompared) {
  link::StepReport report = firmware::report_message(*bout);
  report.evaluations += 1;
  tell(report);
  EXPECT_THAT(difference(), HasSubstr("bout: evaluations differs: "));
}

TEST_F(AToldStep, AnotherNumberOfFrames_IsADifference) {
  link::StepReport report = firmware::report_message(*bout);
  report.frames = static_cast<std::uint8_t>(firmware::frames_of(*bout, false) - 1);
  tell(report);
  EXPECT_THAT(difference(), HasSubstr("bout: frames differs: "));
}

TEST_F(AToldStep, FramesOfOtherSteps_AreNotTaken) {
  link::Pose pose = firmware::pose_message(bout->duel(), Side::kLeft);
  pose.position_W[0] = 9;
  pose.step -= 1;
  EXPECT_EQ(tell(pose), StepAnswer::Taken::kNo);
  pose.step += 2;
  EXPECT_EQ(tell(pose), StepAnswer::Taken::kLater);
  EXPECT_EQ(tell(link::Refused{}), StepAnswer::Taken::kNo);
  EXPECT_EQ(difference(), "");
}

TEST_F(AToldStep, WithoutOneOfItsFrames_IsNotComplete) {
  answer.begin(bout->steps());
  tell(firmware::pose_message(bout->duel(), Side::kLeft));
  link::StepReport report = firmware::report_message(*bout);
  report.frames = static_cast<std::uint8_t>(firmware::frames_of(*bout, false));
  tell(report);
  EXPECT_FALSE(answer.is_complete());
  EXPECT_THAT(difference(), HasSubstr("was not told"));
}

}  // namespace
}  // namespace batuta::host
