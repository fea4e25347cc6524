// SPDX-License-Identifier: MIT
// Every field's range, from both sides: the last value that is taken, and the first that is not, or
// one like it. What may not be sent may not be received either: the bytes are made by the test.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "batuta/fencing/bout.hpp"
#include "wire.hpp"

namespace batuta::link::test {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kAboveOne = 1.0F + 0x1p-23F;

/// Whether a message is sent and received; both or neither.
template <class Message>
::testing::AssertionResult is_taken(const Message& message) {
  Payload payload;
  const bool sent = encode(message, payload);
  const Bytes bytes = expected_payload(message);
  Message back;
  const bool received = decode(bytes.data(), static_cast<int>(bytes.size()), back);
  if (sent && received) return ::testing::AssertionSuccess();
  if (sent != received) {
    return ::testing::AssertionFailure() << (sent ? "sent" : "received") << " only";
  }
  return ::testing::AssertionFailure() << "refused";
}

/// Refused at both ends.
template <class Message>
::testing::AssertionResult is_refused(const Message& message) {
  Payload payload;
  const bool sent = encode(message, payload);
  const Bytes bytes = expected_payload(message);
  Message back;
  const bool received = decode(bytes.data(), static_cast<int>(bytes.size()), back);
  if (!sent && !received && payload.size == 0) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << (sent ? "sent " : "") << (received ? "received" : "");
}

/// Sets one field of a valid message to each value.
template <class Message, class Value, class Set>
void check(const Message& valid, std::initializer_list<Value> taken,
           std::initializer_list<Value> refused, const Set& set) {
  ASSERT_TRUE(is_taken(valid));
  for (const Value& value : taken) {
    Message message = valid;
    set(message, value);
    EXPECT_TRUE(is_taken(message)) << ::testing::PrintToString(value);
  }
  for (const Value& value : refused) {
    Message message = valid;
    set(message, value);
    EXPECT_TRUE(is_refused(message)) << ::testing::PrintToString(value);
  }
}

/// Any finite value, and no other.
template <class Message, class Set>
void check_finite(const Message& valid, const Set& set) {
  constexpr float kLargest = std::numeric_limits<float>::max();
  check(valid, {0.0F, -0.0F, kLargest, -kLargest, 1e-45F}, {kNan, -kNan, kInfinity, -kInfinity},
        set);
}

/// -1 ... 1.
template <class Message, class Set>
void check_share(const Message& valid, const Set& set) {
  check(valid, {-1.0F, -0.0F, 1.0F}, {-kAboveOne, kAboveOne, kNan, kInfinity, -kInfinity}, set);
}

/// 0 ... 1 to within the slack.
template <class Message, class Set>
void check_place(const Message& valid, const Set& set) {
  check(valid, {-kUnitSlack, 0.0F, 1.0F, 1.0F + kUnitSlack},
        {-1.1F * kUnitSlack, 1.0F + 1.1F * kUnitSlack, kNan, kInfinity}, set);
}

/// 0 ... 20 ms.
template <class Message, class Set>
void check_time(const Message& valid, const Set& set) {
  check(valid, {0.0F, 0.02F}, {-1e-9F, 0.0201F, kNan, kInfinity}, set);
}

template <class Message>
void check_samples(const Message& valid, InputSample Message::*sample) {
  check_share(valid, [sample](Message& m, float value) { (m.*sample).x = value; });
  check_share(valid, [sample](Message& m, float value) { (m.*sample).y = value; });
  check_share(valid, [sample](Message& m, float value) { (m.*sample).feet_x = value; });
  check_share(valid, [sample](Message& m, float value) { (m.*sample).feet_y = value; });
}

template <class Message>
void check_normal(const Message& valid) {
  using Vector = std::array<float, 3>;
  check<Message, Vector>(valid, {{0, 0, 1}, {0, -1, 0}, {0.6F, -0.8F, 0}, {0, 0, 1.0009F}},
                         {{0, 0, 0},
                          {1, 1, 0},
                          {0, 0, 1.01F},
                          {0, 0.99F, 0},
                          {1, 0, kNan},
                          {kInfinity, 0, 0},
                          {3e38F, 3e38F, 0}},
                         [](Message& m, const Vector& value) { m.normal_BA_W = value; });
}

Hello hello() {
  Hello message;
  message.session = 1;
  return message;
}

Welcome welcome() {
  Welcome message;
  message.session = 1;
  return message;
}

// StepReport tells the low half, and 0 there means that the device is alone.
TEST(Ranges, Session_HasALowHalfThatIsNotZero) {
  const auto taken = {1U, 0x8000U, 0xFFFFU, 0x10001U, 0x80008000U, 0xFFFFFFFFU};
  const auto refused = {0U, 0x10000U, 0x80000000U, 0xFFFF0000U};
  check<Hello, std::uint32_t>(hello(), taken, refused,
                              [](Hello& m, std::uint32_t value) { m.session = value; });
  check<Welcome, std::uint32_t>(welcome(), taken, refused,
                                [](Welcome& m, std::uint32_t value) { m.session = value; });
}

TEST(Ranges, StepLength_IsThatOfTheDuel) {
  check<Welcome, std::uint32_t>(welcome(), {100, 1000, 20000}, {0, 99, 20001, 0xFFFFFFFFU},
                                [](Welcome& m, std::uint32_t value) { m.step_us = value; });
}

TEST(Ranges, Samples_AreInTheSquare) {
  Step step;
  step.has_left = true;
  step.has_right = true;
  check_samples(step, &Step::left);
  check_samples(step, &Step::right);
  check_samples(StickSample{}, &StickSample::sample);
  check_samples(StickUsed{}, &StickUsed::sample);
}

TEST(Ranges, Force_IsAShare) {
  check_share(Force{}, [](Force& m, float value) { m.x = value; });
  check_share(Force{}, [](Force& m, float value) { m.y = value; });
}

TEST(Ranges, Pose_IsFiniteAndItsRotationUnit) {
  for (std::size_t i = 0; i < 3; ++i) {
    check_finite(Pose{}, [i](Pose& m, float value) { m.position_W[i] = value; });
  }
  using Rotation = std::array<float, 4>;
  check<Pose, Rotation>(
      Pose{}, {{1, 0, 0, 0}, {0, 0, -1, 0}, {0.5F, 0.5F, -0.5F, 0.5F}, {0.9991F, 0, 0, 0}},
      {{0, 0, 0, 0}, {1, 1, 0, 0}, {0.99F, 0, 0, 0}, {1.01F, 0, 0, 0}, {1, kNan, 0, 0}},
      [](Pose& m, const Rotation& value) { m.rotation_WB = value; });
}

TEST(Ranges, Event_HasKindsOrderAndNumbers) {
  check<Event, int>(Event{}, {0, 2}, {3, 255},
                    [](Event& m, int value) { m.kind = static_cast<std::uint8_t>(value); });
  check<Event, int>(Event{}, {0, 2}, {3, 255},
                    [](Event& m, int value) { m.contact_kind = static_cast<std::uint8_t>(value); });
  check<Event, int>(Event{}, {0, kMaxStepFrames - 1}, {kMaxStepFrames, 255},
                    [](Event& m, int value) { m.index = static_cast<std::uint8_t>(value); });
  check<Event, int>(Event{}, {1, 0xFFFF}, {0},
                    [](Event& m, int value) { m.body_B = static_cast<std::uint16_t>(value); });
  check_time(Event{}, [](Event& m, float value) { m.time = value; });
  for (std::size_t i = 0; i < 3; ++i) {
    check_finite(Event{}, [i](Event& m, float value) { m.point_W[i] = value; });
  }
  check_normal(Event{});
  check_finite(Event{}, [](Event& m, float value) { m.gap = value; });
  check_finite(Event{}, [](Event& m, float value) { m.v_rel = value; });
  check_finite(Event{}, [](Event& m, float value) { m.impulse = value; });
  check_place(Event{}, [](Event& m, float value) { m.place_A = value; });
  check_place(Event{}, [](Event& m, float value) { m.place_B = value; });
}

TEST(Ranges, Touch_HasPartAndNumbers) {
  check<Touch, int>(Touch{}, {0, 1}, {2, 255},
                    [](Touch& m, int value) { m.index = static_cast<std::uint8_t>(value); });
  check<Touch, int>(Touch{}, {0, 11}, {12, 255},
                    [](Touch& m, int value) { m.part = static_cast<std::uint8_t>(value); });
  check_time(Touch{}, [](Touch& m, float value) { m.when_in_step = value; });
  for (std::size_t i = 0; i < 3; ++i) {
    check_finite(Touch{}, [i](Touch& m, float value) { m.point_W[i] = value; });
  }
  check_normal(Touch{});
  check_finite(Touch{}, [](Touch& m, float value) { m.gap = value; });
  check_place(Touch{}, [](Touch& m, float value) { m.place = value; });
}

TEST(Ranges, StepReport_CountsFramesAndTouches) {
  check<StepReport, int>(
      StepReport{}, {1, kMaxStepFrames}, {0, kMaxStepFrames + 1, 255},
      [](StepReport& m, int value) { m.frames = static_cast<std::uint8_t>(value); });
  check<StepReport, int>(StepReport{}, {0, 4}, {5, 255}, [](StepReport& m, int value) {
    m.bout_state = static_cast<std::uint8_t>(value);
  });
  check<StepReport, int>(StepReport{}, {0, 2}, {3, 255}, [](StepReport& m, int value) {
    m.touches = static_cast<std::uint8_t>(value);
  });
  for (std::size_t i = 0; i < 2; ++i) {
    check<StepReport, int>(
        StepReport{}, {0, kMostTouches}, {kMostTouches + 1, 255},
        [i](StepReport& m, int value) { m.score[i] = static_cast<std::uint8_t>(value); });
  }
}

TEST(Ranges, Bout_GoesToTouchesOfTheDuel) {
  static_assert(kMostTouches == fencing::kMostTouches);
  check<Hello, int>(hello(), {1, kMostTouches}, {0, kMostTouches + 1, 255},
                    [](Hello& m, int value) { m.touches = static_cast<std::uint8_t>(value); });
}

TEST(Ranges, Refused_NamesAReasonAndAMessageOfTheHost) {
  check<Refused, int>(Refused{}, {0, kRefusals - 1}, {kRefusals, 255},
                      [](Refused& m, int value) { m.why = static_cast<Refusal>(value); });
  check<Refused, int>(Refused{}, {0x01, 0x02, 0x03}, {0x81, 0xFF},
                      [](Refused& m, int value) { m.what = static_cast<MessageType>(value); });
}

/// Bytes that hold a choice or flags, at their offsets: no value beyond the limit is received.
template <class Message>
void check_byte(const Message& valid, std::size_t at, int limit) {
  for (int value = 0; value < 256; ++value) {
    Bytes bytes = expected_payload(valid);
    bytes[at] = static_cast<std::uint8_t>(value);
    Message back;
    EXPECT_EQ(decode(bytes.data(), static_cast<int>(bytes.size()), back), value < limit)
        << at << ": " << value;
  }
}

TEST(Ranges, ChoicesAndFlags_UseNoOtherBits) {
  check_byte(hello(), 4, 2);
  check_byte(welcome(), 5, 2);
  check_byte(StickSample{}, 0, 2);
  check_byte(StickUsed{}, 4, 2);
  check_byte(Pose{}, 4, 2);
  check_byte(Touch{}, 5, 2);
  check_byte(Touch{}, 7, 2);
  check_byte(Force{}, 4, 2);
  check_byte(Force{}, 13, 8);
  check_byte(StepReport{}, 7, 8);
  check_byte(Step{}, 4, 1);  // 1 ... 3 announce samples that are not there
}

}  // namespace
}  // namespace batuta::link::test
