// SPDX-License-Identifier: MIT
#include "shared/link/sender.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "pipe.hpp"
#include "wire.hpp"

namespace batuta::link::test {
namespace {

Status send(SenderBase& sender, const AnyMessage& message) {
  return std::visit([&sender](const auto& m) { return sender.send(m); }, message);
}

TEST(Sender, NothingQueued_MovesNothing) {
  Sender<kMaxWireFrame> sender;
  Pipe pipe;
  EXPECT_EQ(sender.pump(pipe), 0);
  EXPECT_TRUE(pipe.bytes.empty());
}

TEST(Sender, Messages_ArriveAsFramesInOrder) {
  Sender<2048> sender;
  Pipe pipe;
  Bytes expected;
  std::uint16_t sequence = 0;
  for (const AnyMessage& any : one_of_each(31)) {
    ASSERT_EQ(send(sender, any), Status::kOk);
    const Bytes wire = wire_of(any, sequence++);
    expected.insert(expected.end(), wire.begin(), wire.end());
  }
  EXPECT_EQ(sender.pending(), static_cast<int>(expected.size()));
  EXPECT_EQ(sender.pump(pipe), static_cast<int>(expected.size()));
  EXPECT_EQ(pipe.bytes, expected);
  EXPECT_EQ(sender.sent(), static_cast<std::uint32_t>(kMessages));
  EXPECT_EQ(sender.pending(), 0);
}

TEST(Sender, FullRing_RefusesWholeFramesAndCounts) {
  constexpr int kStepFrame = kMinRawFrame + 5 + 3;
  Sender<100> sender;
  Pipe pipe;
  int taken = 0;
  while (sender.send(Step{}) == Status::kOk) ++taken;
  EXPECT_EQ(taken, 100 / kStepFrame);
  EXPECT_EQ(sender.send(Step{}), Status::kPoolFull);
  EXPECT_EQ(sender.refused(), 2U);
  EXPECT_EQ(sender.room(), 100 - taken * kStepFrame);
  sender.pump(pipe);
  ASSERT_EQ(sender.send(Step{}), Status::kOk);
  sender.pump(pipe);
  DeviceDecoder decoder;
  EXPECT_EQ(receive(decoder, pipe.bytes).size(), static_cast<std::size_t>(taken) + 1);
  EXPECT_EQ(decoder.counters().lost, 0U) << "a refused frame uses up no number";
  EXPECT_EQ(decoder.counters().rejected(), 0U);
}

TEST(Sender, ExactFit_IsTaken) {
  Sender<5 * (kMinRawFrame + 5 + 3)> sender;
  for (int i = 0; i < 5; ++i) EXPECT_EQ(sender.send(Step{}), Status::kOk);
  EXPECT_EQ(sender.room(), 0);
  EXPECT_EQ(sender.send(Step{}), Status::kPoolFull);
}

TEST(Sender, InvalidMessage_IsCountedApart) {
  Sender<100> sender;
  EXPECT_EQ(sender.send(Hello{}), Status::kInvalidArgument);
  EXPECT_EQ(sender.invalid(), 1U);
  EXPECT_EQ(sender.refused(), 0U);
  EXPECT_EQ(sender.pending(), 0);
}

TEST(Sender, StreamThatIsGone_KeepsWhatIsQueued) {
  Sender<100> sender;
  Pipe pipe;
  pipe.room = 0;
  ASSERT_EQ(sender.send(Step{}), Status::kOk);
  const int pending = sender.pending();
  EXPECT_EQ(sender.pump(pipe), 0);
  EXPECT_EQ(sender.pending(), pending);
}

TEST(Sender, Cleared_SendsOnlyWhatComesAfter) {
  Sender<100> sender;
  Pipe pipe;
  pipe.room = 7;
  ASSERT_EQ(sender.send(Step{}), Status::kOk);
  sender.pump(pipe);
  sender.clear();
  pipe.room = 1000;
  ASSERT_EQ(sender.send(Step{}), Status::kOk);
  sender.pump(pipe);
  DeviceDecoder decoder;
  const std::vector<Received> all = receive(decoder, pipe.bytes);
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all.front().sequence, 1U);
  EXPECT_EQ(decoder.counters().rejected(), 1U) << "the torn one";
}

// Whatever the stream takes and whenever, frames come whole and in order, none twice.
RC_GTEST_PROP(Sender, AnyPaceOfTheStream_KeepsFramesWhole, (std::uint64_t seed)) {
  FieldDraws draws(seed);
  Sender<200> sender;
  Pipe pipe;
  std::vector<Received> taken;
  for (int i = 0; i < 300; ++i) {
    const AnyMessage message = any_message(4 + draws.below(kMessages - 4), draws.u32());
    if (send(sender, message) == Status::kOk) {
      taken.push_back(received(message, static_cast<std::uint16_t>(taken.size())));
    }
    pipe.room = draws.below(90);
    const int before = sender.pending();
    const int moved = sender.pump(pipe);
    RC_ASSERT(sender.pending() == before - moved);
  }
  pipe.room = 1000;
  sender.pump(pipe);
  HostDecoder decoder;
  RC_ASSERT(receive(decoder, pipe.bytes) == taken);
  RC_ASSERT(decoder.counters().rejected() == 0U);
  RC_ASSERT(sender.sent() == taken.size());
  RC_ASSERT(sender.sent() + sender.refused() == 300U);
  RC_ASSERT(sender.refused() > 0U);
}

}  // namespace
}  // namespace batuta::link::test
