// SPDX-License-Identifier: MIT
// The whole stick, from the host's transfers to the motor.

#include <gtest/gtest.h>

#include "rig.hpp"

namespace batuta::usb::test {
namespace {

TEST(UsbStick, HostsForce_ComesToTheMotorWithItsSignAndSize) {
  struct Wind {
    int degrees;
    float x, y;
  };
  for (const Wind& wind : {Wind{0, 0, -1}, Wind{90, -1, 0}, Wind{180, 0, 1}, Wind{270, 1, 0}}) {
    Rig rig;
    ASSERT_TRUE(rig.bus.enumerate());
    rig.start(rig.constant(0.5F, wind.degrees));
    rig.run(kFadedIn);
    EXPECT_NEAR(rig.motor.last.x, 0.5F * wind.x, 1e-6F) << wind.degrees;
    EXPECT_NEAR(rig.motor.last.y, 0.5F * wind.y, 1e-6F) << wind.degrees;
    EXPECT_EQ(rig.stick.effects().counters().refused(), 0U);
  }
}

TEST(UsbStick, ForceAfterTheHostHasCome_FadesIn) {
  Rig rig;
  ASSERT_TRUE(rig.bus.enumerate());
  rig.start(rig.constant(1.0F, 270));
  float before = 0;
  for (int i = 0; i < kFadedIn; ++i) {
    rig.run(1);
    EXPECT_GE(rig.motor.last.x, before);
    // No faster than the slower of the stage's two ramps: that over the samples, 50 steps.
    EXPECT_LE(rig.motor.last.x - before, 1.0F / 50 + 1e-5F);
    before = rig.motor.last.x;
  }
  EXPECT_EQ(before, 1.0F);
}

TEST(UsbStick, WithoutAHost_MotorGetsZero) {
  Rig rig;
  rig.motor.last.x = 1;
  rig.run(1);
  EXPECT_EQ(rig.motor.last.x, 0.0F);
  rig.sample.x = 1;  // not even the end stop pushes
  rig.run(kFadedIn);
  EXPECT_EQ(rig.motor.last.x, 0.0F);
  EXPECT_EQ(rig.motor.last.own, 0.0F);
}

/// A stage so slow that a force would take 10 s to go.
UsbStickSettings slow() {
  UsbStickSettings settings;
  settings.stage.slew_rate = 0.1F;
  settings.stage.fade = 10000;
  return settings;
}

/// A rig whose motor has a force that the stage alone would be slow to take away.
class Pushed {
 public:
  Pushed() : rig(slow()) {
    EXPECT_TRUE(rig.bus.enumerate());
    block = rig.constant(1.0F, 270);
    rig.start(block);
    rig.run(5000);
    EXPECT_GT(rig.motor.last.x, 0.2F);
  }
  void expect_no_force() const {
    EXPECT_EQ(rig.motor.last.x, 0.0F);
    EXPECT_EQ(rig.motor.last.y, 0.0F);
  }
  /// Without a host that is awake there is not even what a device adds by itself.
  void expect_silence() const {
    expect_no_force();
    EXPECT_EQ(rig.motor.last.own, 0.0F);
  }
  Rig rig;
  int block = 0;
};

TEST(UsbStick, Suspend_TakesTheForceAtOnceAndKeepsTheBlocks) {
  Pushed pushed;
  Rig& rig = pushed.rig;
  rig.bus.suspend();
  pushed.expect_silence();  // in the callback
  rig.run(1);
  pushed.expect_silence();
  rig.run(1000);
  pushed.expect_silence();

  rig.bus.resume();
  rig.run(5000);
  pushed.expect_no_force();  // nothing has been asked for
  EXPECT_EQ(rig.stick.effects().playing(), 0);
  rig.start(pushed.block);  // as it was uploaded
  rig.run(5000);
  EXPECT_GT(rig.motor.last.x, 0.2F);
  EXPECT_EQ(rig.create(1), pushed.block + 1) << "the block of before is still taken";
}

TEST(UsbStick, Unplug_TakesTheForceAtOnceAndFreesTheBlocks) {
  Pushed pushed;
  Rig& rig = pushed.rig;
  rig.bus.unplug();
  pushed.expect_silence();
  rig.run(1000);
  pushed.expect_silence();
  EXPECT_EQ(rig.stick.effects().playing(), 0);

  ASSERT_TRUE(rig.bus.enumerate());
  rig.run(1000);
  pushed.expect_no_force();
  const int block = rig.constant(1.0F, 90);
  EXPECT_EQ(block, 1) << "all blocks are free";
  rig.start(block);
  rig.run(5000);
  EXPECT_LT(rig.motor.last.x, -0.2F);
}

TEST(UsbStick, HostThatHasGone_TakesItsGainAlong) {
  Rig rig;
  ASSERT_TRUE(rig.bus.enumerate());
  ASSERT_TRUE(rig.bus.out({0x1D, 51}));
  rig.start(rig.constant(1.0F, 270));
  rig.run(kFadedIn);
  EXPECT_NEAR(rig.motor.last.x, 0.2F, 1e-6F);
  rig.bus.unplug();
  ASSERT_TRUE(rig.bus.enumerate());
  rig.start(rig.constant(1.0F, 270));
  rig.run(kFadedIn);
  EXPECT_EQ(rig.motor.last.x, 1.0F) << "the next host knows nothing of the last one's gain";
}

// TinyUSB calls nothing back at a bus reset, as of a host that starts again: the tick has to look.
TEST(UsbStick, BusReset_TakesTheForceInTheNextTick) {
  Pushed pushed;
  Rig& rig = pushed.rig;
  rig.bus.plug();
  rig.run(1);
  pushed.expect_silence();
  ASSERT_TRUE(rig.bus.enumerate());
  rig.run(5000);
  pushed.expect_no_force();
  rig.start(pushed.block);  // a driver that has reset the port still has its effects
  rig.run(5000);
  EXPECT_GT(rig.motor.last.x, 0.2F);
}

TEST(UsbStick, HostThatUnconfigures_HasGone) {
  Pushed pushed;
  Rig& rig = pushed.rig;
  ASSERT_TRUE(rig.bus.control({0x00, 9, 0, 0, 0}, {}).has_value());
  pushed.expect_silence();
  rig.run(1);
  pushed.expect_silence();
  ASSERT_TRUE(rig.bus.control({0x00, 9, 1, 0, 0}, {}).has_value());
  EXPECT_EQ(rig.create(1), 1);
}

TEST(UsbStick, StickThatFallsSilent_LosesItsForce) {
  Rig rig;
  ASSERT_TRUE(rig.bus.enumerate());
  rig.start(rig.constant(1.0F, 270));
  rig.run(kFadedIn);
  ASSERT_EQ(rig.motor.last.x, 1.0F);
  for (int i = 0; i < 20 + 50 + 1; ++i) {  // silent_after + length of the ramp
    batuta::usb::run(rig.stick, nullptr, rig.now += 1000);
  }
  EXPECT_EQ(rig.motor.last.x, 0.0F);
}

TEST(UsbStick, DamperOfTheHost_PushesAgainstTheMotion) {
  Rig rig;
  ASSERT_TRUE(rig.bus.enumerate());
  const int block = rig.create(9);
  ASSERT_TRUE(
      rig.bus.out({0x11, byte_of(block), 9, 0, 0, 0, 0, 0, 0, 0, 0, 0xFF, 0, 4, 0, 0, 0, 0}));
  for (const int axis : {0, 1}) {
    const UsbBytes full = word(10000);
    ASSERT_TRUE(rig.bus.out({0x13, byte_of(block), byte_of(axis), 0, 0, full[0], full[1], full[0],
                             full[1], full[0], full[1], full[0], full[1], 0, 0}));
  }
  rig.start(block);
  rig.run(kFadedIn);
  EXPECT_EQ(rig.motor.last.x, 0.0F);
  for (int i = 0; i < 100; ++i) {
    rig.sample.x += 0.002F;  // 2 /s, of a full scale of 10 /s
    rig.run(1);
  }
  EXPECT_NEAR(rig.motor.last.x, -0.2F, 1e-3F);
  EXPECT_EQ(rig.motor.last.y, 0.0F);
}

TEST(UsbStick, Reports_TellWhereTheStickIsAndWhatPlays) {
  Rig rig;
  ASSERT_TRUE(rig.bus.enumerate());
  rig.sample.x = 1;
  rig.sample.y = 1;
  rig.sample.buttons = 0x8001;
  rig.run(1);
  auto packet = rig.bus.in();
  for (int i = 0; i < 5 && packet.has_value() && (*packet)[0] != 1; ++i) {  // states go first
    rig.run(1);
    packet = rig.bus.in();
  }
  EXPECT_EQ(packet, (UsbBytes{1, 0x01, 0x80, 0xFF, 0x7F, 0x01, 0x80}));  // y away is negative
  EXPECT_EQ(rig.get_report(1, 1), (UsbBytes{1, 0x01, 0x80, 0xFF, 0x7F, 0x01, 0x80}));
  const int block = rig.constant(0.5F, 0);
  rig.start(block);
  rig.run(1);
  bool told = false;
  for (int i = 0; i < 4; ++i) {
    packet = rig.bus.in();
    ASSERT_TRUE(packet.has_value());
    told = told || ((*packet)[0] == 2 && (*packet)[2] == (block << 1 | 1));
    rig.run(1);
  }
  EXPECT_TRUE(told) << "a state with an effect that plays";
}

TEST(UsbStick, HostThatStartsAndStopsEachMillisecond_StillHearsOfTheStick) {
  Rig rig;
  ASSERT_TRUE(rig.bus.enumerate());
  const int block = rig.constant(0.5F, 0);
  constexpr int kMilliseconds = 100;
  int sticks = 0;
  int states = 0;
  for (int i = 0; i < kMilliseconds; ++i) {
    ASSERT_TRUE(rig.bus.out({0x1A, byte_of(block), byte_of(i % 2 == 0 ? 1 : 3), 1}));
    rig.run(1);
    const auto packet = rig.bus.in();
    ASSERT_TRUE(packet.has_value());
    ++((*packet)[0] == 1 ? sticks : states);
  }
  EXPECT_GE(sticks, kMilliseconds / 2);
  EXPECT_GE(states, kMilliseconds / 4) << "and of its states";
}

TEST(UsbStick, MotorThatIsGone_IsToldToTheHost) {
  Rig rig;
  ASSERT_TRUE(rig.bus.enumerate());
  rig.run(kFadedIn);
  const auto powered = rig.get_report(1, 2);
  rig.motor.gone = true;
  rig.run(1);
  const auto without = rig.get_report(1, 2);
  ASSERT_TRUE(powered.has_value() && without.has_value());
  constexpr int kPower = 0x10;  // paused, enabled, empty, override, power
  EXPECT_NE((*powered)[1] & kPower, 0);
  EXPECT_EQ((*without)[1] & kPower, 0);
}

TEST(UsbStick, StageThatIsNotValid_NeverMoves) {
  Motor motor;
  UsbStickSettings settings;
  settings.stage.dt = -1;
  UsbStick stick(motor, settings);
  EXPECT_EQ(stick.start(), Status::kInvalidArgument);
  const InputSample sample;
  for (Microseconds now = 1000; now < 100000; now += 1000) stick.tick(&sample, Host::kAwake, now);
  EXPECT_EQ(motor.last.x, 0.0F);
}

}  // namespace
}  // namespace batuta::usb::test
