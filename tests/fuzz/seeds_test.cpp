// SPDX-License-Identifier: MIT
// The seeds are what another implementation of the protocol sends (make_corpus.py). A seed that is
// rejected where it should be accepted would teach the fuzzer nothing, and one of the two is wrong.

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "shared/link/frame_decoder.hpp"

namespace batuta::link {
namespace {

/// Bytes of a seed for the line, without the first one, which is the fuzz target's.
std::vector<std::uint8_t> wire_in(const std::string& name) {
  std::ifstream file(BATUTA_LINK_SEEDS "/" + name, std::ios::binary);
  const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
  EXPECT_GT(bytes.size(), 1U) << name;
  if (bytes.empty()) return {};
  EXPECT_EQ(bytes.front(), 0) << name << " is no stream";
  return {bytes.begin() + 1, bytes.end()};
}

struct Heard {
  LinkCounters device;
  LinkCounters host;
};

Heard hear(const std::string& name) {
  DeviceDecoder device;
  HostDecoder host;
  for (const std::uint8_t byte : wire_in(name)) {
    device.push(byte);
    host.push(byte);
  }
  return {device.counters(), host.counters()};
}

class MessageSeed : public ::testing::TestWithParam<const char*> {};

TEST_P(MessageSeed, IsAcceptedByOneEndAndAnEchoForTheOther) {
  const Heard heard = hear(GetParam());
  EXPECT_EQ(heard.device.accepted + heard.host.accepted, 1U);
  EXPECT_EQ(heard.device.count(Rejection::kType) + heard.host.count(Rejection::kType), 1U);
}

INSTANTIATE_TEST_SUITE_P(Each, MessageSeed,
                         ::testing::Values("hello", "step_none", "step_left", "step_both",
                                           "stick_sample", "welcome", "pose", "event", "force",
                                           "touch", "stick_used", "step_report", "refused"),
                         [](const auto& seed) { return std::string(seed.param); });

TEST(Seeds, Session_HasAllMessagesAndNoDamage) {
  const Heard heard = hear("session");
  EXPECT_EQ(heard.device.accepted, 5U);
  EXPECT_EQ(heard.host.accepted, 8U);
  EXPECT_EQ(heard.device.rejected(), heard.device.count(Rejection::kType));
  EXPECT_EQ(heard.host.rejected(), heard.host.count(Rejection::kType));
}

struct Damaged {
  const char* name;
  Rejection why;
  std::uint32_t times;
};

TEST(Seeds, EachDamage_IsWhatItsNameSays) {
  for (const Damaged& seed : {Damaged{"bad_check_sum", Rejection::kCrc, 1},
                              Damaged{"bad_version", Rejection::kVersion, 1},
                              Damaged{"bad_stuffing", Rejection::kBadCobs, 1},
                              Damaged{"too_long", Rejection::kTooLong, 1},
                              Damaged{"too_short", Rejection::kTooShort, 2}}) {
    const Heard heard = hear(seed.name);
    EXPECT_EQ(heard.device.count(seed.why), seed.times) << seed.name;
    EXPECT_EQ(heard.device.rejected(), seed.times) << seed.name;
    EXPECT_EQ(heard.device.accepted, 1U) << seed.name << ": the frame after it";
  }
}

}  // namespace
}  // namespace batuta::link
