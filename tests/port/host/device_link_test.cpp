// SPDX-License-Identifier: MIT
// The host's end of the cable by itself, against a device that says what the test wants.
#include "programs/duel/device/device_link.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <deque>

#include "../firmware/cable.hpp"
#include "../link/wire.hpp"

namespace batuta::host {
namespace {

/// Hears Hello, and answers with so many delimiters and a Welcome once it has been asked often
/// enough.
class SlowToAnswer final : public link::ByteStream {
 public:
  std::vector<std::uint32_t> sessions;  ///< of the Hellos
  std::size_t asked_for = 1;
  int delimiters = 0;

 private:
  int do_read(std::uint8_t* bytes, int capacity) override {
    int count = 0;
    for (; count < capacity && !line_.empty(); ++count) {
      bytes[count] = line_.front();
      line_.pop_front();
    }
    return count;
  }
  int do_write(const std::uint8_t* bytes, int count) override {
    for (int i = 0; i < count; ++i) {
      link::Hello hello;
      if (decoder_.push(bytes[i]) != link::Arrival::kFrame) continue;
      if (link::read_message(decoder_.frame(), hello)) hear(hello);
    }
    return count;
  }
  void hear(const link::Hello& hello) {
    sessions.push_back(hello.session);
    if (sessions.size() < asked_for) return;
    link::Welcome welcome;
    welcome.session = hello.session;
    std::array<std::uint8_t, link::kMaxWireFrame> wire{};
    const int count = encoder_.encode(welcome, wire.data(), link::kMaxWireFrame);
    line_.insert(line_.end(), static_cast<std::size_t>(delimiters), std::uint8_t{0});
    line_.insert(line_.end(), wire.begin(), wire.begin() + count);
  }

  link::DeviceDecoder decoder_;
  link::FrameEncoder encoder_;
  std::deque<std::uint8_t> line_;
};

struct LinkRig {
  SlowToAnswer device;
  test::HandClock clock;
  int waits = 0;
  DeviceLink link{{device, clock,
                   [this](int /*timeout_ms*/) {
                     clock.time += 1000;
                     ++waits;
                   }},
                  {20, 30, 30}};
};

TEST(DeviceLink, AHelloThatIsSentAgain_IsOfTheSameSession) {
  LinkRig rig;
  rig.device.asked_for = 3;
  ASSERT_TRUE(rig.link.open(link::Mode::kPaced));
  ASSERT_EQ(rig.device.sessions.size(), 3U);
  EXPECT_EQ(rig.device.sessions[1], rig.device.sessions[0]);
  EXPECT_EQ(rig.device.sessions[2], rig.device.sessions[0]);
  EXPECT_EQ(rig.link.sums().sessions, 1U);
  EXPECT_EQ(rig.link.sums().resends, 2U);
}

TEST(DeviceLink, Patience_IsOfSoManySeconds_AndNeverLessForADeviceThatWasJustSwitchedOn) {
  EXPECT_EQ(patience_of(2).tries, Patience{}.tries);
  EXPECT_EQ(patience_of(2).greetings, Patience{}.greetings);
  EXPECT_EQ(patience_of(0.12).tries, 3) << "50 ms each, and no less than was asked for";
  EXPECT_EQ(patience_of(1000).tries, 20000);
  EXPECT_EQ(patience_of(1000).greetings, 20000);
}

TEST(DeviceLink, ASilentDevice_IsGivenUp_AsSoonAsThePatienceIsOver) {
  for (const double seconds : {0.1, 2.0, 30.0, 1000.0}) {
    LinkRig rig;
    ASSERT_TRUE(rig.link.open(link::Mode::kPaced));
    const Line line{rig.device, rig.clock, [&](int /*timeout_ms*/) { rig.clock.time += 1000; }};
    DeviceLink link(line, patience_of(seconds));
    link::Step first;
    first.step = 1;
    for (const bool free : {false, true}) {
      const Microseconds before = rig.clock.time;
      StepAnswer answer;
      if (free) {
        EXPECT_EQ(link.listen(1, answer), DeviceLink::Heard::kSilence);
      } else {
        EXPECT_FALSE(link.ask(first, answer));
      }
      const double waited_us = elapsed_us(before, rig.clock.time);
      EXPECT_GE(waited_us, seconds * 1e6);
      EXPECT_LE(waited_us, seconds * 1.1e6)
          << "a millisecond of waiting too long for each question";
      const std::string words = " within " + std::to_string(int(seconds * 1000)) + " ms";
      EXPECT_NE(link.problem().find(words), std::string::npos) << link.problem();
    }
  }
}

/// Says the same over and over.
class Parrot final : public link::ByteStream {
 public:
  std::vector<std::uint8_t> words;

 private:
  int do_read(std::uint8_t* bytes, int capacity) override {
    const int count = std::min(capacity, static_cast<int>(words.size()));
    std::copy_n(words.begin(), count, bytes);
    return count;
  }
  int do_write(const std::uint8_t* /*bytes*/, int count) override { return count; }
};

TEST(DeviceLink, ADeviceOfAnotherVersion_IsToldByBothVersions) {
  LinkRig rig;
  for (const int version : {link::kProtocolVersion + 1, 0, 255}) {
    Parrot device;
    device.words = link::test::delimited(link::test::stuffed(
        link::test::raw_frame(static_cast<std::uint8_t>(version),
                              static_cast<std::uint8_t>(link::MessageType::kWelcome), 0, {})));
    DeviceLink link({device, rig.clock, [&](int /*timeout_ms*/) { rig.clock.time += 1000; }},
                    {20, 1, 1});
    ASSERT_FALSE(link.open(link::Mode::kPaced));
    const std::string words = "speaks version " + std::to_string(version) +
                              " of the protocol; this program speaks version " +
                              std::to_string(int{link::kProtocolVersion});
    EXPECT_NE(link.problem().find(words), std::string::npos) << link.problem();
  }
}

TEST(DeviceLink, EachOpening_IsASessionOfItsOwn_WhoseLowHalfIsNotThatOfADeviceAlone) {
  LinkRig rig;
  std::uint32_t last = 0;
  for (int i = 0; i < 70000; ++i) {  // more than the low half has
    ASSERT_TRUE(rig.link.open(link::Mode::kFree));
    const std::uint32_t session = rig.device.sessions.back();
    ASSERT_NE(session, last);
    ASSERT_NE(session & 0xFFFFU, 0U);
    last = session;
  }
}

TEST(DeviceLink, WhatHasBeenReadAlready_IsNotWaitedFor) {
  for (int delimiters = 100; delimiters < 200; ++delimiters) {
    LinkRig rig;
    rig.device.delimiters = delimiters;
    ASSERT_TRUE(rig.link.open(link::Mode::kPaced));
    // A wait is right only where the bytes of a turn end with what was read: the line then says at
    // once that there is more.
    EXPECT_LE(rig.waits, delimiters % 32 == 0 ? 1 : 0) << delimiters;
  }
}

}  // namespace
}  // namespace batuta::host
