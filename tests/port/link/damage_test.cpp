// SPDX-License-Identifier: MIT
// Every kind of damage to a frame between two good ones. What is damaged is never accepted, always
// counted, and costs no other frame than the one it struck.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <functional>

#include "wire.hpp"

namespace batuta::link::test {
namespace {

constexpr std::uint16_t kNumber = 0x1234;

/// How the damaged frame may end.
enum class Fate {
  kRejected,  ///< it must be rejected
  kHarmless,  ///< or it may come through, unchanged: a delimiter too few or too many
};

/// good, damaged, good. @returns the frames between the good ones, which must be there
std::vector<Received> pass(const AnyMessage& message, const Bytes& damaged) {
  std::vector<Received> between;
  const Received before = received(message, kNumber - 1);
  const Received after = received(message, kNumber + 1);
  with_decoder_for(message, [&](auto& decoder) {
    const Bytes stream =
        joined({wire_of(message, kNumber - 1), damaged, wire_of(message, kNumber + 1)});
    between = receive(decoder, stream);
    EXPECT_EQ(decoder.counters().accepted, between.size());
    EXPECT_EQ(decoder.counters().accepted + decoder.counters().rejected(), stretches(stream));
    EXPECT_EQ(decoder.counters().lost + between.size(), 3U);
  });
  EXPECT_GE(between.size(), 2U);
  if (between.size() < 2) return {};
  EXPECT_EQ(between.front(), before);
  EXPECT_EQ(between.back(), after);
  return {between.begin() + 1, between.end() - 1};
}

void expect(Fate fate, const AnyMessage& message, const Bytes& damaged) {
  const std::vector<Received> between = pass(message, damaged);
  if (between.empty()) return;
  EXPECT_EQ(fate, Fate::kHarmless);
  EXPECT_EQ(between, std::vector<Received>{received(message, kNumber)});
}

/// Calls damage(message, its frame) for one of each message.
void for_each_frame(const std::function<void(const AnyMessage&, const Bytes&)>& damage) {
  for (const std::uint64_t seed : {11U, 12U, 13U}) {
    for (const AnyMessage& any : one_of_each(seed)) damage(any, wire_of(any, kNumber));
  }
}

bool is_delimiter(const Bytes& wire, std::size_t at) {
  return at == 0 || at + 1 == wire.size();
}

// Single bits and every other change of a single byte: 255 values at each place.
TEST(Damage, AnyByteChanged_IsRejected) {
  for_each_frame([](const AnyMessage& message, const Bytes& wire) {
    for (std::size_t at = 0; at < wire.size(); ++at) {
      for (unsigned change = 1; change < 256; ++change) {
        Bytes damaged = wire;
        damaged[at] = static_cast<std::uint8_t>(damaged[at] ^ change);
        expect(Fate::kRejected, message, damaged);
      }
    }
  });
}

TEST(Damage, AnyTwoBitsChanged_AreRejected) {
  const AnyMessage message = any_message(4, 21);
  const Bytes wire = wire_of(message, kNumber);
  const std::size_t bits = wire.size() * 8;
  for (std::size_t first = 0; first < bits; ++first) {
    for (std::size_t second = first + 1; second < bits; ++second) {
      Bytes damaged = wire;
      damaged[first / 8] = static_cast<std::uint8_t>(damaged[first / 8] ^ (1U << (first % 8)));
      damaged[second / 8] = static_cast<std::uint8_t>(damaged[second / 8] ^ (1U << (second % 8)));
      expect(Fate::kRejected, message, damaged);
    }
  }
}

TEST(Damage, AnyTruncation_IsRejected) {
  for_each_frame([](const AnyMessage& message, const Bytes& wire) {
    for (std::size_t size = 0; size + 1 < wire.size(); ++size) {
      expect(Fate::kRejected, message, Bytes(wire.begin(), wire.begin() + std::ptrdiff_t(size)));
    }
    for (std::size_t start = 2; start < wire.size(); ++start) {
      expect(Fate::kRejected, message, Bytes(wire.begin() + std::ptrdiff_t(start), wire.end()));
    }
  });
}

TEST(Damage, AnyByteDropped_IsRejectedOrWasADelimiter) {
  for_each_frame([](const AnyMessage& message, const Bytes& wire) {
    for (std::size_t at = 0; at < wire.size(); ++at) {
      Bytes damaged = wire;
      damaged.erase(damaged.begin() + std::ptrdiff_t(at));
      expect(is_delimiter(wire, at) ? Fate::kHarmless : Fate::kRejected, message, damaged);
    }
  });
}

TEST(Damage, AnyByteDoubled_IsRejectedOrWasADelimiter) {
  for_each_frame([](const AnyMessage& message, const Bytes& wire) {
    for (std::size_t at = 0; at < wire.size(); ++at) {
      Bytes damaged = wire;
      damaged.insert(damaged.begin() + std::ptrdiff_t(at), wire[at]);
      expect(is_delimiter(wire, at) ? Fate::kHarmless : Fate::kRejected, message, damaged);
    }
  });
}

TEST(Damage, AnyByteInserted_IsRejectedOrOutside) {
  for_each_frame([](const AnyMessage& message, const Bytes& wire) {
    for (std::size_t at = 0; at <= wire.size(); ++at) {
      const bool outside = at == 0 || at == wire.size();
      for (unsigned value = 0; value < 256; value += 5) {
        const bool at_delimiter = value == 0 && (at == 1 || at + 1 == wire.size());
        Bytes damaged = wire;
        damaged.insert(damaged.begin() + std::ptrdiff_t(at), static_cast<std::uint8_t>(value));
        expect(outside || at_delimiter ? Fate::kHarmless : Fate::kRejected, message, damaged);
      }
    }
  });
}

TEST(Damage, FrameTwice_IsAcceptedOnce) {
  for_each_frame([](const AnyMessage& message, const Bytes& wire) {
    const std::vector<Received> between = pass(message, joined({wire, wire}));
    EXPECT_EQ(between, std::vector<Received>{received(message, kNumber)});
  });
}

TEST(Damage, NoiseAroundFrames_CostsNone) {
  const Bytes noise = {0x31, 0x00, 0xFF, 0x01, 0x80};
  for_each_frame([&noise](const AnyMessage& message, const Bytes& wire) {
    EXPECT_EQ(pass(message, joined({noise, wire, noise})).size(), 1U);
  });
}

/// A byte as lines and hostile senders make it: zeros, small counts and anything.
rc::Gen<Bytes> garbage() {
  return rc::gen::container<Bytes>(
      rc::gen::weightedOneOf<std::uint8_t>({{2, rc::gen::just(std::uint8_t{0})},
                                            {2, rc::gen::inRange<std::uint8_t>(1, 20)},
                                            {3, rc::gen::arbitrary<std::uint8_t>()}}));
}

// The noise may hold what it will: every frame after a delimiter of its own is received.
RC_GTEST_PROP(Damage, FramesAmongAnyGarbage_AreAllReceived, (std::uint64_t seed)) {
  const auto noises = *rc::gen::container<std::vector<Bytes>>(garbage());
  HostDecoder decoder;
  Bytes stream;
  std::vector<Received> sent;
  FieldDraws draws(seed);
  for (const Bytes& noise : noises) {
    const AnyMessage message = any_message(4 + draws.below(kMessages - 4), draws.u32());
    const auto sequence = static_cast<std::uint16_t>(sent.size());
    stream.insert(stream.end(), noise.begin(), noise.end());
    const Bytes wire = wire_of(message, sequence);
    stream.insert(stream.end(), wire.begin(), wire.end());
    sent.push_back(received(message, sequence));
  }
  RC_ASSERT(receive(decoder, stream) == sent);
  RC_ASSERT(decoder.counters().accepted + decoder.counters().rejected() == stretches(stream));
  RC_ASSERT(decoder.counters().lost == 0U);
}

RC_GTEST_PROP(Damage, AnyGarbageAlone_IsCountedAndNeverAccepted, ()) {
  const Bytes stream = *garbage();
  HostDecoder host;
  DeviceDecoder device;
  RC_ASSERT(receive(host, stream).empty());
  RC_ASSERT(receive(device, stream).empty());
  RC_ASSERT(host.counters().rejected() == stretches(stream));
  RC_ASSERT(device.counters().rejected() == stretches(stream));
}

/// A line that drops, doubles and changes bytes: what comes through is what was sent, in its order.
RC_GTEST_PROP(Damage, BadLine_DeliversOnlyWhatWasSent, (std::uint64_t seed)) {
  FieldDraws draws(seed);
  Bytes stream;
  std::vector<Received> sent;
  for (int i = 0; i < 60; ++i) {
    const AnyMessage message = any_message(4 + draws.below(kMessages - 4), draws.u32());
    sent.push_back(received(message, static_cast<std::uint16_t>(i)));
    for (const std::uint8_t byte : wire_of(message, static_cast<std::uint16_t>(i))) {
      const int fate = draws.below(300);
      if (fate == 0) continue;
      stream.push_back(fate == 1 ? static_cast<std::uint8_t>(draws.below(256)) : byte);
      if (fate == 2) stream.push_back(byte);
    }
  }
  HostDecoder decoder;
  const std::vector<Received> all = receive(decoder, stream);
  auto next = sent.begin();
  for (const Received& one : all) {
    next = std::find(next, sent.end(), one);
    RC_ASSERT(next != sent.end());
    ++next;
  }
  RC_ASSERT(all.size() > 10U);
}

}  // namespace
}  // namespace batuta::link::test
