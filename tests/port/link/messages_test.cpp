// SPDX-License-Identifier: MIT
#include "shared/link/messages.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "wire.hpp"

namespace batuta::link::test {
namespace {

template <class Message>
Bytes payload_of(const Message& message) {
  Payload payload;
  EXPECT_TRUE(encode(message, payload));
  return {payload.bytes.begin(), payload.bytes.begin() + payload.size};
}

template <class Message>
bool comes_back(const Message& message) {
  const Bytes bytes = payload_of(message);
  Message back;
  return decode(bytes.data(), static_cast<int>(bytes.size()), back) &&
         expected_payload(back) == expected_payload(message);
}

RC_GTEST_PROP(Messages, AnyMessage_HasTheBytesOfItsLayout, (std::uint64_t seed)) {
  for (const AnyMessage& any : one_of_each(seed)) {
    RC_ASSERT(std::visit([](const auto& m) { return payload_of(m) == expected_payload(m); }, any));
  }
}

RC_GTEST_PROP(Messages, AnyMessage_ComesBackBitForBit, (std::uint64_t seed)) {
  for (const AnyMessage& any : one_of_each(seed)) {
    RC_ASSERT(std::visit([](const auto& m) { return comes_back(m); }, any));
  }
}

TEST(Messages, EveryDefault_IsValidExceptTheSessionsNumber) {
  for (int i = 0; i < kMessages; ++i) {
    const AnyMessage any = default_message(i);
    const bool numbered =
        std::holds_alternative<Hello>(any) || std::holds_alternative<Welcome>(any);
    Payload payload;
    EXPECT_EQ(std::visit([&payload](const auto& m) { return encode(m, payload); }, any), !numbered)
        << i;
  }
}

TEST(Messages, LongestPayload_IsTheEvent) {
  std::size_t longest = 0;
  for (const AnyMessage& any : one_of_each(1)) {
    longest = std::max(longest,
                       std::visit([](const auto& m) { return expected_payload(m).size(); }, any));
  }
  EXPECT_EQ(longest, expected_payload(Event{}).size());
  EXPECT_EQ(longest, 59U);
  EXPECT_LE(longest, static_cast<std::size_t>(kMaxPayload));
}

TEST(Messages, EveryOtherLength_IsRefusedAndChangesNothing) {
  for (const AnyMessage& any : one_of_each(2)) {
    std::visit(
        [](const auto& message) {
          Bytes bytes = payload_of(message);
          const auto right = static_cast<int>(bytes.size());
          bytes.resize(kMaxPayload, 0);
          for (int size = 0; size <= kMaxPayload; ++size) {
            auto other = std::decay_t<decltype(message)>{};
            const Bytes before = expected_payload(other);
            EXPECT_EQ(decode(bytes.data(), size, other), size == right) << size;
            if (size != right) {
              EXPECT_EQ(expected_payload(other), before) << size;
            }
          }
        },
        any);
  }
}

// A Step's length follows from its flags; each of the four is told apart.
TEST(Messages, StepFlags_DecideItsLength) {
  for (const bool left : {false, true}) {
    for (const bool right : {false, true}) {
      Step step;
      step.has_left = left;
      step.has_right = right;
      EXPECT_EQ(payload_of(step).size(), 5U + (left ? 28U : 0U) + (right ? 28U : 0U));
    }
  }
}

TEST(Messages, TypesOfBothEnds_AreJudgedByTheOtherEndOnly) {
  for (const AnyMessage& any : one_of_each(3)) {
    const MessageType type = type_of(any);
    const Bytes bytes = std::visit([](const auto& m) { return payload_of(m); }, any);
    const auto size = static_cast<int>(bytes.size());
    const Verdict at_host = judge_from_device(type, bytes.data(), size);
    const Verdict at_device = judge_from_host(type, bytes.data(), size);
    EXPECT_EQ(at_host, is_from_device(type) ? Verdict::kGood : Verdict::kUnknownType);
    EXPECT_EQ(at_device, is_from_device(type) ? Verdict::kUnknownType : Verdict::kGood);
  }
}

}  // namespace
}  // namespace batuta::link::test
