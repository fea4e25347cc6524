// SPDX-License-Identifier: MIT
// The port to Zephyr, on a fake of the functions that it uses.

#include "contract_suite.hpp"
#include "fake_zephyr.hpp"
#include "platforms/zephyr/clock.hpp"
#include "platforms/zephyr/force.hpp"
#include "platforms/zephyr/input.hpp"

namespace batuta::zephyr::test {
namespace {

constexpr std::uint32_t kPeriod = 50000;  // ns: 20 kHz
const device kPwm = {kChannels};

Bridge bridge(std::uint32_t channel, std::uint32_t period = kPeriod) {
  return {{&kPwm, channel, period, 0}, {&kPwm, channel + 1, period, 0}};
}

/// A stick of +-1000 counts that counts Y downwards, and a way to move it.
class Stick {
 public:
  Stick() {
    fake_zephyr() = {};
    const AxisCalibration x = {AxisKind::kAbsolute, false, -1000, 1000, 0};
    const AxisCalibration y = {AxisKind::kAbsolute, true, -1000, 1000, 0};
    EXPECT_EQ(input.configure(x, y), Status::kOk);
  }
  void event(int type, int code, std::int32_t value, bool sync = false) {
    input_event one = {nullptr, sync ? std::uint8_t{1} : std::uint8_t{0},
                       static_cast<std::uint8_t>(type), static_cast<std::uint16_t>(code), value};
    EventInput::on_event(&one, &input);
  }
  InputSample read(Status wanted = Status::kOk) {
    InputSample sample;
    EXPECT_EQ(input.read(clock.now(), sample), wanted);
    EXPECT_EQ(fake_zephyr().locks, 0);
    return sample;
  }

  TickClock clock;
  EventInput input{clock};
};

struct StickRig {
  static constexpr bool kHasSamples = true;
  InputDevice& device() { return stick_.input; }
  Microseconds next() {
    fake_zephyr().ticks += 10;
    if (++calls_ % 3 != 0) stick_.event(INPUT_EV_ABS, INPUT_ABS_X, calls_ % 1000, true);
    return stick_.clock.now();
  }

 private:
  Stick stick_;
  int calls_ = 0;
};

struct ClockRig {
  Clock& clock() {
    fake_zephyr().ticks += 7;
    return clock_;
  }

 private:
  TickClock clock_;
};

struct MotorRig {
  MotorRig() {
    fake_zephyr() = {};
    EXPECT_EQ(device_.start(), Status::kOk);
  }
  ForceDevice& device() { return device_; }

 private:
  PwmForce device_{bridge(0), bridge(2)};
};

}  // namespace
}  // namespace batuta::zephyr::test

namespace batuta::test {
INSTANTIATE_TYPED_TEST_SUITE_P(Zephyr, InputContract, ::testing::Types<zephyr::test::StickRig>);
INSTANTIATE_TYPED_TEST_SUITE_P(Zephyr, ClockContract, ::testing::Types<zephyr::test::ClockRig>);
INSTANTIATE_TYPED_TEST_SUITE_P(Zephyr, ForceContract, ::testing::Types<zephyr::test::MotorRig>);
}  // namespace batuta::test

namespace batuta::zephyr::test {
namespace {

TEST(TickClock, Microseconds_WrapWhereTheyAreCut) {
  fake_zephyr() = {};
  TickClock clock;
  fake_zephyr().ticks = 42949672;  // 2^32 us = 42,949,672.96 ticks of 100 us
  EXPECT_EQ(clock.now(), 4294967200U);
  fake_zephyr().ticks += 1;
  EXPECT_EQ(clock.now(), 4U);
  fake_zephyr().ticks = (std::uint64_t{1} << 32U) + 10;  // 5 days: more than 32 bits of ticks
  EXPECT_EQ(clock.now(), 1000U);
  fake_zephyr() = {};
  fake_zephyr().ticks_per_second = 32768;
  fake_zephyr().ticks = 3;
  EXPECT_EQ(clock.now(), 91U);  // 91.55 us
}

TEST(EventInput, SampleIsCompleteAtItsMark) {
  Stick stick;
  stick.read(Status::kUnavailable);
  fake_zephyr().ticks = 50;
  stick.event(INPUT_EV_ABS, INPUT_ABS_X, 500);
  stick.read(Status::kUnavailable);
  stick.event(INPUT_EV_ABS, INPUT_ABS_Y, 250, true);
  const InputSample sample = stick.read();
  EXPECT_EQ(sample.time, 5000U);
  EXPECT_EQ(sample.x, 0.5F);
  EXPECT_EQ(sample.y, -0.25F);
  stick.read(Status::kUnavailable);
}

TEST(EventInput, LatestWinsAndTheGapIsCounted) {
  Stick stick;
  stick.event(INPUT_EV_ABS, INPUT_ABS_X, 100, true);
  const std::uint32_t first = stick.read().sequence;
  for (const int x : {200, 300, 400}) stick.event(INPUT_EV_ABS, INPUT_ABS_X, x, true);
  const InputSample sample = stick.read();
  EXPECT_EQ(sample.x, 0.4F);
  EXPECT_EQ(sample.sequence - first, 3U);
}

TEST(EventInput, SampleOfLater_WaitsForItsTime) {
  Stick stick;
  fake_zephyr().ticks = 20;
  stick.event(INPUT_EV_ABS, INPUT_ABS_X, 1000, true);
  InputSample sample;
  EXPECT_EQ(stick.input.read(1999, sample), Status::kUnavailable);
  EXPECT_EQ(stick.input.read(2000, sample), Status::kOk);
}

TEST(EventInput, ButtonsHaveTheirPlaces) {
  Stick stick;
  stick.event(INPUT_EV_KEY, INPUT_BTN_0, 1);
  stick.event(INPUT_EV_KEY, INPUT_BTN_9, 1);
  stick.event(INPUT_EV_KEY, INPUT_BTN_SOUTH, 1);
  stick.event(INPUT_EV_KEY, INPUT_BTN_THUMBR, 1);
  stick.event(INPUT_EV_KEY, INPUT_BTN_LEFT, 1);  // of a mouse
  stick.event(INPUT_EV_KEY, INPUT_BTN_THUMBR + 1, 1, true);
  EXPECT_EQ(stick.read().buttons, 1U << 0U | 1U << 9U | 1U << 10U | 1U << 24U);
  stick.event(INPUT_EV_KEY, INPUT_BTN_9, 0, true);
  EXPECT_EQ(stick.read().buttons, 1U << 0U | 1U << 10U | 1U << 24U);
}

TEST(EventInput, EventsOfAnotherKind_AreLeftOut) {
  Stick stick;
  stick.event(INPUT_EV_ABS, INPUT_ABS_X, 500);
  stick.event(INPUT_EV_REL, INPUT_REL_X, -700);
  stick.event(INPUT_EV_ABS, INPUT_ABS_Z, 900);
  stick.event(INPUT_EV_ABS, INPUT_ABS_RX, 900);  // a second pair that was not stated
  stick.event(INPUT_EV_MSC, INPUT_ABS_X, 900, true);
  const InputSample sample = stick.read();
  EXPECT_EQ(sample.x, 0.5F);
  EXPECT_EQ(sample.feet_x, 0.0F);
}

TEST(EventInput, MovementsAddUp_SecondPairToo) {
  Stick stick;
  const AxisCalibration wheel = {AxisKind::kRelative, false, -100, 100, 0};
  const AxisCalibration lever = {AxisKind::kAbsolute, false, 0, 200, 0};
  ASSERT_EQ(stick.input.configure(wheel, wheel), Status::kOk);
  ASSERT_EQ(stick.input.configure_feet(lever, wheel), Status::kOk);
  for (int i = 0; i < 3; ++i) stick.event(INPUT_EV_REL, INPUT_REL_X, 25);
  stick.event(INPUT_EV_REL, INPUT_REL_RY, -50);
  stick.event(INPUT_EV_ABS, INPUT_ABS_RX, 200);
  stick.event(INPUT_EV_REL, INPUT_REL_RX, 1, true);
  const InputSample sample = stick.read();
  EXPECT_EQ(sample.x, 0.75F);
  EXPECT_EQ(sample.feet_x, 1.0F);
  EXPECT_EQ(sample.feet_y, -0.5F);
}

TEST(EventInput, BadCalibration_ChangesNothing) {
  Stick stick;
  stick.event(INPUT_EV_ABS, INPUT_ABS_X, 500, true);
  const AxisCalibration none = {AxisKind::kRelative, false, 5, 5, 0};
  EXPECT_EQ(stick.input.configure(none, none), Status::kInvalidArgument);
  EXPECT_EQ(stick.input.configure_feet(none, none), Status::kInvalidArgument);
  EXPECT_EQ(stick.read().x, 0.5F);
  stick.event(INPUT_EV_ABS, INPUT_ABS_X, 600, true);
  EXPECT_EQ(stick.read().x, 0.6F);
}

class Motors : public ::testing::Test {
 protected:
  Motors() { fake_zephyr() = {}; }
  static std::array<std::uint32_t, kChannels> pulses() { return fake_zephyr().pulses; }

  PwmForce force{bridge(0), bridge(2)};
  batuta::test::PlainForce stage{force};
};

TEST_F(Motors, BeforeStart_CommandsAreRefused) {
  EXPECT_EQ(stage.write({0, 0.5F, 0.5F, 0}), Status::kUnavailable);
  EXPECT_EQ(force.off(0), Status::kUnavailable);
  EXPECT_EQ(fake_zephyr().written, 0);
}

TEST_F(Motors, Command_PulsesOneInputOfEachBridge) {
  fake_zephyr().pulses = {9, 9, 9, 9};
  ASSERT_EQ(force.start(), Status::kOk);
  EXPECT_EQ(pulses(), (std::array<std::uint32_t, kChannels>{}));
  EXPECT_EQ(stage.write({1, 0.5F, -1.0F, 0}), Status::kOk);
  EXPECT_EQ(pulses(), (std::array<std::uint32_t, kChannels>{25000, 0, 0, 50000}));
  EXPECT_EQ(stage.write({2, -0.25F, 1.0F, 0}), Status::kOk);
  EXPECT_EQ(pulses(), (std::array<std::uint32_t, kChannels>{0, 12500, 50000, 0}));
  EXPECT_EQ(fake_zephyr().both_high, 0);
  EXPECT_EQ(force.off(3), Status::kOk);
  EXPECT_EQ(pulses(), (std::array<std::uint32_t, kChannels>{}));
}

TEST_F(Motors, ChannelThatFails_TakesTheForceAway) {
  ASSERT_EQ(force.start(), Status::kOk);
  for (std::uint32_t channel = 0; channel < kChannels; ++channel) {
    fake_zephyr().refuses = {};
    ASSERT_EQ(stage.write({0, 0.5F, 0.5F, 0}), Status::kOk);
    const std::uint32_t stuck = pulses().at(channel);
    fake_zephyr().refuses.at(channel) = true;
    EXPECT_EQ(stage.write({0, -0.5F, -0.5F, 0}), Status::kUnavailable);
    std::array<std::uint32_t, kChannels> wanted{};
    wanted.at(channel) = stuck;  // what does not answer keeps what it had
    EXPECT_EQ(pulses(), wanted) << channel;
    EXPECT_EQ(fake_zephyr().both_high, 0);
  }
}

TEST_F(Motors, ImpossibleBridges_AreRefused) {
  fake_zephyr().is_ready = false;
  EXPECT_EQ(force.start(), Status::kUnavailable);
  fake_zephyr().is_ready = true;
  for (const std::uint32_t period : {0U, PwmForce::kLongestPeriod + 1}) {
    PwmForce slow(bridge(0, period), bridge(2));
    EXPECT_EQ(slow.start(), Status::kInvalidArgument);
    PwmForce slow_y(bridge(0), bridge(2, period));
    EXPECT_EQ(slow_y.start(), Status::kInvalidArgument);
  }
  Bridge unlike = bridge(0);
  unlike.in2.period = kPeriod / 2;
  PwmForce halves(unlike, bridge(2));
  EXPECT_EQ(halves.start(), Status::kInvalidArgument);
  PwmForce absent(bridge(0), bridge(kChannels));
  EXPECT_EQ(absent.start(), Status::kUnavailable);
  EXPECT_EQ(fake_zephyr().written, 0);
}

}  // namespace
}  // namespace batuta::zephyr::test
