// SPDX-License-Identifier: MIT
#include "shared/link/frame_decoder.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "wire.hpp"

namespace batuta::link::test {
namespace {

const Bytes kStepPayload = expected_payload(Step{});
constexpr auto kStepType = static_cast<std::uint8_t>(MessageType::kStep);

Bytes step_frame(std::uint16_t sequence) {
  return wire_of(kStepType, sequence, kStepPayload);
}

Bytes hello_frame(std::uint32_t session, std::uint16_t sequence) {
  Hello hello;
  hello.session = session;
  return wire_of(hello, sequence);
}

/// Nothing is accepted, and one frame is rejected for this reason.
void expect_rejection(const Bytes& wire, Rejection why) {
  DeviceDecoder decoder;
  EXPECT_TRUE(receive(decoder, wire).empty());
  EXPECT_EQ(decoder.counters().count(why), 1U);
  EXPECT_EQ(decoder.counters().rejected(), 1U);
  EXPECT_EQ(decoder.last_rejection(), why);
  // And in step again.
  EXPECT_EQ(receive(decoder, step_frame(0)).size(), 1U);
}

Bytes raw_step() {
  return raw_frame(kProtocolVersion, kStepType, 0, kStepPayload);
}

TEST(FrameDecoder, LibrarysOwnFrames_AreTheBytesOfTheDocument) {
  for (const AnyMessage& any : one_of_each(4)) {
    std::array<std::uint8_t, kMaxWireFrame> wire{};
    FrameEncoder encoder;
    const int count = std::visit(
        [&](const auto& m) { return encoder.encode(m, wire.data(), kMaxWireFrame); }, any);
    EXPECT_EQ(Bytes(wire.begin(), wire.begin() + count), wire_of(any, 0));
  }
}

RC_GTEST_PROP(FrameDecoder, AnyMessage_IsAcceptedByTheOtherEnd, (std::uint64_t seed)) {
  for (const AnyMessage& any : one_of_each(seed)) {
    const auto sequence = static_cast<std::uint16_t>(seed);
    with_decoder_for(any, [&](auto& decoder) {
      const std::vector<Received> all = receive(decoder, wire_of(any, sequence));
      RC_ASSERT(all == std::vector<Received>{received(any, sequence)});
      RC_ASSERT(decoder.counters().rejected() == 0U);
    });
  }
}

TEST(FrameDecoder, OwnEcho_IsRejectedAsType) {
  for (const AnyMessage& any : one_of_each(5)) {
    HostDecoder host;
    DeviceDecoder device;
    const Bytes wire = wire_of(any, 0);
    EXPECT_EQ(receive(host, wire).size() + receive(device, wire).size(), 1U);
    EXPECT_EQ(host.counters().count(Rejection::kType) + device.counters().count(Rejection::kType),
              1U);
  }
}

TEST(FrameDecoder, Delimiters_AloneAreNothing) {
  DeviceDecoder decoder;
  EXPECT_TRUE(receive(decoder, Bytes(100, 0)).empty());
  EXPECT_EQ(decoder.counters().rejected(), 0U);
}

TEST(FrameDecoder, OneDelimiterBetweenFrames_IsEnough) {
  const Bytes first = step_frame(0);
  const Bytes second = step_frame(1);
  DeviceDecoder decoder;
  EXPECT_EQ(receive(decoder, joined({first, Bytes(second.begin() + 1, second.end())})).size(), 2U);
}

TEST(FrameDecoder, FirstFrameAfterPowerUp_NeedsNoDelimiterBefore) {
  const Bytes wire = step_frame(7);
  DeviceDecoder decoder;
  EXPECT_EQ(receive(decoder, Bytes(wire.begin() + 1, wire.end())).size(), 1U);
}

TEST(Rejections, BlockThatRunsIntoTheDelimiter_IsBadCobs) {
  expect_rejection({0, 5, 1, 2, 0}, Rejection::kBadCobs);
  expect_rejection({0, 255, 0}, Rejection::kBadCobs);
}

TEST(Rejections, OneByteTooMany_IsTooLong) {
  const Bytes longest = stuffed(Bytes(kMaxRawFrame, 1));
  expect_rejection(delimited(longest), Rejection::kCrc);
  expect_rejection(delimited(stuffed(Bytes(kMaxRawFrame + 1, 1))), Rejection::kTooLong);
  expect_rejection(delimited(stuffed(Bytes(kMaxRawFrame + 1, 0))), Rejection::kTooLong);
  expect_rejection(delimited(Bytes(100000, 0xFF)), Rejection::kTooLong);
}

TEST(Rejections, LessThanHeaderAndCheckSum_IsTooShort) {
  for (std::size_t size = 0; size < kMinRawFrame; ++size) {
    expect_rejection(delimited(stuffed(Bytes(size, 9))), Rejection::kTooShort);
  }
  expect_rejection(delimited(stuffed(Bytes(kMinRawFrame, 9))), Rejection::kCrc);
}

TEST(Rejections, WrongCheckSum_IsCrc) {
  Bytes raw = raw_step();
  raw.back() ^= 1U;
  expect_rejection(delimited(stuffed(raw)), Rejection::kCrc);
}

TEST(Rejections, OtherVersions_AreVersion) {
  for (int version = 0; version < 256; ++version) {
    if (version == kProtocolVersion) continue;
    const Bytes raw = raw_frame(static_cast<std::uint8_t>(version), kStepType, 0, kStepPayload);
    expect_rejection(delimited(stuffed(raw)), Rejection::kVersion);
  }
}

TEST(Rejections, OfAnotherVersion_TheDecoderSaysWhich) {
  DeviceDecoder decoder;
  EXPECT_EQ(decoder.other_version(), 0);
  for (const int version : {kProtocolVersion + 1, 255, kProtocolVersion - 1}) {
    const Bytes raw = raw_frame(static_cast<std::uint8_t>(version), kStepType, 0, kStepPayload);
    for (const std::uint8_t byte : delimited(stuffed(raw))) (void)decoder.push(byte);
    EXPECT_EQ(decoder.other_version(), version);
  }
}

TEST(Rejections, TypesThatTheHostDoesNotSend_AreType) {
  for (int type = 0; type < 256; ++type) {
    if (type >= 0x01 && type <= 0x03) continue;
    expect_rejection(wire_of(static_cast<std::uint8_t>(type), 0, kStepPayload), Rejection::kType);
  }
}

TEST(Rejections, PayloadOfAnotherLengthOrValue_IsPayload) {
  expect_rejection(wire_of(kStepType, 0, {}), Rejection::kPayload);
  expect_rejection(wire_of(kStepType, 0, Bytes(6, 0)), Rejection::kPayload);
  expect_rejection(wire_of(kStepType, 0, Bytes(kMaxPayload, 0)), Rejection::kPayload);
  Bytes flags = kStepPayload;
  flags[4] = 4;
  expect_rejection(wire_of(kStepType, 0, flags), Rejection::kPayload);
  Step step;
  step.has_left = true;
  step.left.x = std::numeric_limits<float>::quiet_NaN();
  expect_rejection(wire_of(step, 0), Rejection::kPayload);
}

// A rejected frame leaves no trace in the sequence: its number is missing like any other.
TEST(Sequence, RejectedFrames_AreMissedLater) {
  DeviceDecoder decoder;
  const auto accepted = receive(decoder, joined({step_frame(10), wire_of(kStepType, 11, {}),
                                                 wire_of(0x77, 12, {}), step_frame(13)}));
  EXPECT_EQ(accepted.size(), 2U);
  EXPECT_EQ(decoder.counters().gaps, 1U);
  EXPECT_EQ(decoder.counters().lost, 2U);
}

TEST(Sequence, EveryDistance_IsRepeatedOldOrAhead) {
  for (int distance = 0; distance < 0x10000; ++distance) {
    DeviceDecoder decoder;
    constexpr int kStart = 0xFFF0;
    receive(decoder, step_frame(kStart));
    receive(decoder, step_frame(static_cast<std::uint16_t>(kStart + distance)));
    const LinkCounters& counters = decoder.counters();
    const bool ahead = distance >= 1 && distance <= 0x7FFF;
    ASSERT_EQ(counters.accepted, ahead ? 2U : 1U) << distance;
    ASSERT_EQ(counters.count(Rejection::kRepeated), distance == 0 ? 1U : 0U) << distance;
    ASSERT_EQ(counters.count(Rejection::kOld), distance >= 0x8000 ? 1U : 0U) << distance;
    ASSERT_EQ(counters.lost, ahead ? static_cast<unsigned>(distance) - 1U : 0U) << distance;
    ASSERT_EQ(counters.gaps, ahead && distance > 1 ? 1U : 0U) << distance;
  }
}

TEST(Sequence, FirstFrame_MayHaveAnyNumber) {
  for (const unsigned any : {0U, 1U, 0x7FFFU, 0x8000U, 0xFFFFU}) {
    const auto sequence = static_cast<std::uint16_t>(any);
    DeviceDecoder decoder;
    EXPECT_EQ(receive(decoder, step_frame(sequence)).size(), 1U);
    EXPECT_EQ(decoder.counters().lost, 0U);
  }
}

TEST(Sequence, Wrap_IsOneMoreLikeAnyOther) {
  DeviceDecoder decoder;
  for (int i = 0; i < 70000; ++i) {
    ASSERT_EQ(receive(decoder, step_frame(static_cast<std::uint16_t>(i))).size(), 1U);
  }
  EXPECT_EQ(decoder.counters().gaps, 0U);
}

/// What becomes of a receiver that accepts frame 0, misses so many, and hears the rest.
struct AfterSilence {
  std::uint32_t repeated = 0;
  std::uint32_t old = 0;
  std::uint32_t lost = 0;

  friend bool operator==(const AfterSilence& a, const AfterSilence& b) {
    return a.repeated == b.repeated && a.old == b.old && a.lost == b.lost;
  }
};

AfterSilence after_silence_of(std::uint32_t missed) {
  DeviceDecoder decoder;
  receive(decoder, step_frame(0));
  std::uint32_t number = missed;
  while (receive(decoder, step_frame(static_cast<std::uint16_t>(++number))).empty()) {
  }
  const LinkCounters& counters = decoder.counters();
  return {counters.count(Rejection::kRepeated), counters.count(Rejection::kOld), counters.lost};
}

// The distance is 16 bits wide, and the upper half of it means old.
TEST(Sequence, AfterALongSilence_TheNumbersComeRound) {
  for (const std::uint32_t rounds : {0U, 1U, 2U}) {
    for (const std::uint32_t missed : {0U, 1U, 2U, 32765U, 32766U}) {
      const AfterSilence all_counted{0, 0, missed};
      EXPECT_TRUE(after_silence_of(65536 * rounds + missed) == all_counted) << missed;
    }
    for (const std::uint32_t missed : {32767U, 32768U, 40000U, 65534U, 65535U}) {
      const AfterSilence none_counted{1, 65535 - missed, 0};
      EXPECT_TRUE(after_silence_of(65536 * rounds + missed) == none_counted) << missed;
    }
  }
}

TEST(Sequence, WhoMissesSomeWhileTheNumbersComeRound_CountsTheDistance) {
  DeviceDecoder decoder;
  receive(decoder, step_frame(0));
  EXPECT_TRUE(receive(decoder, joined({step_frame(40001), step_frame(65535)})).empty());
  EXPECT_EQ(receive(decoder, step_frame(100)).size(), 1U);  // the 65636th
  EXPECT_EQ(decoder.counters().lost, 99U);
  EXPECT_EQ(decoder.counters().gaps, 1U);
}

/// The rule once more, in plain integers, over any order of numbers.
RC_GTEST_PROP(Sequence, AnyOrder_AgreesWithTheRule, ()) {
  const auto steps = *rc::gen::container<std::vector<int>>(rc::gen::weightedOneOf<int>(
      {{6, rc::gen::inRange(-3, 5)}, {1, rc::gen::inRange(-40000, 40000)}}));
  DeviceDecoder decoder;
  int last = -1;
  int number = 0;
  std::uint32_t accepted = 0;
  std::uint32_t lost = 0;
  for (const int step : steps) {
    number = ((number + step) % 65536 + 65536) % 65536;
    const int ahead = (number - last + 65536) % 65536;
    const bool take = last < 0 || (ahead > 0 && ahead < 32768);
    const auto all = receive(decoder, step_frame(static_cast<std::uint16_t>(number)));
    RC_ASSERT(all.size() == (take ? 1U : 0U));
    if (take && last >= 0) lost += static_cast<std::uint32_t>(ahead - 1);
    if (take) {
      last = number;
      ++accepted;
    }
  }
  RC_ASSERT(decoder.counters().accepted == accepted);
  RC_ASSERT(decoder.counters().lost == lost);
  RC_ASSERT(decoder.counters().rejected() == steps.size() - accepted);
}

TEST(Sessions, AnotherHello_RestartsTheSequence) {
  DeviceDecoder decoder;
  receive(decoder, joined({hello_frame(5, 1000), step_frame(1001)}));
  EXPECT_EQ(decoder.session(), 5U);
  EXPECT_EQ(receive(decoder, joined({hello_frame(6, 0), step_frame(1)})).size(), 2U);
  EXPECT_EQ(decoder.session(), 6U);
  EXPECT_EQ(decoder.counters().sessions, 2U);
  EXPECT_EQ(decoder.counters().lost, 0U);
  EXPECT_EQ(decoder.counters().rejected(), 0U);
}

TEST(Sessions, SameHello_IsAFrameLikeAnyOther) {
  DeviceDecoder decoder;
  receive(decoder, joined({hello_frame(5, 0), step_frame(1), step_frame(2)}));
  EXPECT_TRUE(receive(decoder, hello_frame(5, 0)).empty()) << "late copy of the first";
  EXPECT_TRUE(receive(decoder, hello_frame(5, 2)).empty()) << "number used before";
  EXPECT_EQ(receive(decoder, hello_frame(5, 3)).size(), 1U) << "sent once more";
  EXPECT_EQ(decoder.counters().sessions, 1U);
  EXPECT_EQ(decoder.counters().count(Rejection::kOld), 1U);
  EXPECT_EQ(decoder.counters().count(Rejection::kRepeated), 1U);
}

TEST(Sessions, InvalidHello_RestartsNothing) {
  DeviceDecoder decoder;
  receive(decoder, joined({hello_frame(5, 10), hello_frame(0, 0)}));
  EXPECT_EQ(decoder.session(), 5U);
  EXPECT_TRUE(receive(decoder, step_frame(1)).empty());
  EXPECT_EQ(decoder.counters().count(Rejection::kOld), 1U);
}

TEST(Sessions, Welcome_RestartsTheHostsSide) {
  Welcome welcome;
  welcome.session = 9;
  HostDecoder decoder;
  receive(decoder, joined({wire_of(Force{}, 500), wire_of(welcome, 3), wire_of(Force{}, 4)}));
  EXPECT_EQ(decoder.counters().accepted, 3U);
  EXPECT_EQ(decoder.counters().lost, 0U);
  EXPECT_EQ(decoder.session(), 9U);
}

TEST(Frame, MessageOfAnotherType_IsNotRead) {
  DeviceDecoder decoder;
  receive(decoder, hello_frame(5, 0));
  Step step;
  Hello hello;
  EXPECT_FALSE(read_message(decoder.frame(), step));
  EXPECT_TRUE(read_message(decoder.frame(), hello));
  EXPECT_EQ(hello.session, 5U);
}

TEST(Frame, NoRoomOrTooLong_WritesNothing) {
  Bytes wire(kMaxWireFrame, 0xAA);
  const Bytes untouched = wire;
  const Bytes payload(kMaxPayload + 1, 0);
  const Frame longest{MessageType::kStep, 0, payload.data(), kMaxPayload};
  EXPECT_EQ(encode_frame(longest, wire.data(), kMaxWireFrame - 1), 0);
  EXPECT_EQ(encode_frame({MessageType::kStep, 0, payload.data(), kMaxPayload + 1}, wire.data(),
                         kMaxWireFrame),
            0);
  EXPECT_EQ(encode_frame({MessageType::kStep, 0, payload.data(), -1}, wire.data(), kMaxWireFrame),
            0);
  EXPECT_EQ(wire, untouched);
  EXPECT_EQ(encode_frame(longest, wire.data(), kMaxWireFrame), kMaxWireFrame);
}

TEST(Frame, RefusedMessage_UsesUpNoNumber) {
  FrameEncoder encoder;
  Bytes wire(kMaxWireFrame);
  EXPECT_EQ(encoder.encode(Hello{}, wire.data(), kMaxWireFrame), 0);
  EXPECT_EQ(encoder.encode(Step{}, wire.data(), 3), 0);
  EXPECT_EQ(encoder.sequence(), 0);
  EXPECT_GT(encoder.encode(Step{}, wire.data(), kMaxWireFrame), 0);
  EXPECT_EQ(encoder.sequence(), 1);
}

}  // namespace
}  // namespace batuta::link::test
