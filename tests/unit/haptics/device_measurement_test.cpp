// SPDX-License-Identifier: MIT
// Devices of known damping, friction, mass, delay and encoder, measured. The truth is the simulated
// axis', which is exact between its samples and knows nothing of the fit.
#include "batuta/haptics/device_measurement.hpp"

#include "hostile_numbers.hpp"
#include "measured_device.hpp"

namespace batuta {
using namespace haptics;
using test::MeasuredDevice;
using test::Measuring;
namespace {

using State = MeasurementState;

double off(const Estimate& estimate, double truth) {
  return std::abs(static_cast<double>(estimate.value) - truth);
}

double sigma(const Estimate& estimate) {
  return static_cast<double>(estimate.sigma);
}

TEST(DeviceMeasurement, PlainDevice_IsToldToFivePercent) {
  const MeasuredDevice device;
  Measuring measuring(device);
  ASSERT_EQ(measuring.run(), State::kMeasured);
  const DeviceEstimates& told = measuring.measurement.estimates();
  EXPECT_LT(off(told.damping, device.damping), 0.05 * device.damping);
  EXPECT_LT(off(told.friction, device.friction), 0.05 * device.friction);
  EXPECT_LT(off(told.mass, device.mass), 0.05 * device.mass);
  EXPECT_LT(off(told.delay, device.delay), 0.05);
  EXPECT_LT(off(told.encoder_step, device.encoder_step), 1e-6 * device.encoder_step);
  EXPECT_LT(off(told.stiffness, 0), 3 * sigma(told.stiffness));
  EXPECT_LT(off(told.offset, 0), 3 * sigma(told.offset));
}

/// What several hundred devices came to.
struct Tally {
  int measured = 0;
  int covered = 0;    ///< all five within three sigma
  int sharp = 0;      ///< numbers whose three sigma are within 5 %
  int within = 0;     ///< of these, those that are
  int too_short = 0;  ///< a profile that says less delay than there is

  void take(const MeasuredDevice& device, const Measuring& measuring) {
    ++measured;
    const DeviceEstimates& told = measuring.measurement.estimates();
    const std::array<Estimate, 5> numbers = {told.damping, told.friction, told.mass, told.delay,
                                             told.encoder_step};
    const std::array<double, 5> truths = {device.damping, device.friction, device.mass,
                                          static_cast<double>(device.delay), device.encoder_step};
    bool all = true;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      const bool is_sharp = truths[i] > 0 && 3 * sigma(numbers[i]) <= 0.05 * truths[i];
      all = all && off(numbers[i], truths[i]) <= 3 * sigma(numbers[i]);
      sharp += is_sharp ? 1 : 0;
      within += is_sharp && off(numbers[i], truths[i]) <= 0.05 * truths[i] ? 1 : 0;
    }
    covered += all ? 1 : 0;
    const auto profile = measured_profile(measuring.settings, told, 3);
    EXPECT_EQ(profile.status, Status::kOk);
    too_short += profile.value.delay < device.delay ? 1 : 0;
  }
};

// A device is told, to what is told beside it, or refused; and it stays where it is safe.
TEST(DeviceMeasurement, AnyDevice_IsWithinThreeSigmaOrRefused) {
  constexpr int kDevices = 500;
  Tally tally;
  for (int i = 0; i < kDevices; ++i) {
    const MeasuredDevice device = test::any_device(static_cast<std::uint64_t>(i));
    Measuring measuring(device, static_cast<std::uint64_t>(i));
    if (measuring.run() == State::kMeasured) tally.take(device, measuring);
    EXPECT_LE(measuring.largest_share, measuring.settings.most_share) << i;
    EXPECT_LT(measuring.farthest, 0.85) << i;
    EXPECT_LE(measuring.measurement.steps(), DeviceMeasurement::kMostSteps) << i;
  }
  RecordProperty("measured", tally.measured);
  RecordProperty("covered", tally.covered);
  RecordProperty("sharp", tally.sharp);
  EXPECT_GE(tally.measured, 0.8 * kDevices);
  EXPECT_GE(tally.covered, 0.99 * tally.measured);
  EXPECT_GE(tally.sharp, 3 * tally.measured);  // of five numbers, some of which are 0
  EXPECT_EQ(tally.within, tally.sharp);
  EXPECT_EQ(tally.too_short, 0);
}

// A force that is held from within a period on: the columns of whole delays are joined by a curve.
TEST(DeviceMeasurement, DelayInParts_IsWithinThreeSigma) {
  constexpr int kDevices = 160;
  int measured = 0;
  int covered = 0;
  for (std::uint64_t i = 0; i < kDevices; ++i) {
    MeasuredDevice device = test::any_device(i);
    device.delay += 0.5;
    Measuring measuring(device, i);
    if (measuring.run() != State::kMeasured) continue;
    ++measured;
    const DeviceEstimates& told = measuring.measurement.estimates();
    covered += off(told.delay, device.delay) <= 3 * sigma(told.delay) &&
                       off(told.damping, device.damping) <= 3 * sigma(told.damping)
                   ? 1
                   : 0;
  }
  EXPECT_GE(measured, 0.8 * kDevices);
  EXPECT_GE(covered, 0.99 * measured);
}

// Damping goes with the period, and mass with its square: what is let through is covered.
TEST(DeviceMeasurement, MeanPeriodThatIsWrong_IsRefusedOrCovered) {
  for (const double share : {0.85, 0.9, 0.99, 0.995, 1.005, 1.01, 1.1, 1.15}) {
    MeasuredDevice device;
    device.period = share * 1e-3;
    device.told_period = 1e-3;
    EXPECT_EQ(Measuring(device).run(), State::kWrongPeriod) << share;
  }
  for (const double share : {0.998, 0.9995, 1.0005, 1.002}) {
    MeasuredDevice device;
    device.period = share * 1e-3;
    device.told_period = 1e-3;
    device.encoder_step = 1e-5;  // so fine that only the period counts
    Measuring measuring(device);
    ASSERT_EQ(measuring.run(), State::kMeasured) << share;
    const DeviceEstimates& told = measuring.measurement.estimates();
    EXPECT_LT(off(told.damping, device.damping), 3 * sigma(told.damping)) << share;
    EXPECT_LT(off(told.mass, device.mass), 3 * sigma(told.mass)) << share;
    EXPECT_LT(off(told.mass, device.mass), 0.006 * device.mass) << share;
  }
}

// Microseconds begin anew after 71 minutes.
TEST(DeviceMeasurement, ClockThatBeginsAnew_ChangesNothing) {
  const MeasuredDevice device;
  Measuring plain(device);
  Measuring wrapped(device);
  wrapped.first_time = static_cast<Microseconds>(-5'000'000);
  ASSERT_EQ(plain.run(), State::kMeasured);
  ASSERT_EQ(wrapped.run(), State::kMeasured);
  EXPECT_EQ(plain.measurement.estimates().damping.value,
            wrapped.measurement.estimates().damping.value);
}

// It stands at the place of the first sample, not at 0.
TEST(DeviceMeasurement, FirstSampleThatIsLate_IsWaitedFor) {
  MeasurementSettings settings;
  settings.force_limit = 5;
  DeviceMeasurement measurement;
  ASSERT_EQ(measurement.configure(settings), Status::kOk);
  for (int i = 0; i < 300; ++i) {
    MeasurementInput input;
    input.time = static_cast<Microseconds>(1000 * i);
    input.fresh = i >= 3;
    input.position = 0.1F;
    input.applied = measurement.step(input);
    ASSERT_EQ(measurement.state(), State::kRunning) << i;
  }
}

// A stick that swings by itself, slowly, and whose last sample does not come.
TEST(DeviceMeasurement, MostSteps_EndItWithoutASampleToo) {
  MeasurementSettings settings;
  settings.force_limit = 5;
  DeviceMeasurement measurement;
  ASSERT_EQ(measurement.configure(settings), Status::kOk);
  MeasurementInput input;
  for (int i = 1; measurement.state() == State::kRunning; ++i) {
    const double angle = i < 1000 ? 0 : (i - 1000) * 3.14159 / 1900;
    input.time = static_cast<Microseconds>(1000 * i);
    input.position = static_cast<float>(0.25 * std::sin(angle));
    input.fresh = i < DeviceMeasurement::kMostSteps - 2;
    input.applied = measurement.step(input);
  }
  EXPECT_EQ(measurement.state(), State::kNoMotion);
  EXPECT_EQ(measurement.steps(), DeviceMeasurement::kMostSteps);
}

// An encoder's step that is too small would be on the unsafe side.
TEST(DeviceMeasurement, SamplesOffTheGrid_MakeNoStepTooSmall) {
  for (const double share : {0.0, 0.001, 0.003, 0.01, 0.05, 0.3}) {
    for (std::uint64_t i = 0; i < 10; ++i) {
      MeasuredDevice device;
      device.stray = share;
      device.stray_at = static_cast<int>(100 + 499 * i);
      Measuring measuring(device, i);
      const State state = measuring.run();
      EXPECT_TRUE(share > 0 || state == State::kMeasured) << i;
      if (state != State::kMeasured) continue;
      const Estimate& step = measuring.measurement.estimates().encoder_step;
      EXPECT_GE(static_cast<double>(step.value) + 3 * sigma(step), device.encoder_step) << share;
    }
  }
}

// A spring, or a weight that is not balanced, is told apart from damping and friction.
TEST(DeviceMeasurement, SpringAndWeight_AreToldApart) {
  MeasuredDevice device;
  device.stiffness = 0.4;
  device.known_stiffness = 0.5;
  device.weight = 0.05;
  Measuring measuring(device);
  ASSERT_EQ(measuring.run(), State::kMeasured);
  const DeviceEstimates& told = measuring.measurement.estimates();
  EXPECT_LT(off(told.stiffness, 0.4), 3 * sigma(told.stiffness));
  EXPECT_LT(off(told.offset, -0.05), 3 * sigma(told.offset) + 0.4 * device.encoder_step);
  EXPECT_LT(off(told.damping, device.damping), 0.05 * device.damping);
  EXPECT_LT(off(told.friction, device.friction), 0.05 * device.friction);
}

// Jitter and holes within what is allowed widen what is told, and what is told still holds.
TEST(DeviceMeasurement, JitterAndLostSamples_AreCoveredByWhatIsTold) {
  int measured = 0;
  for (std::uint64_t i = 0; i < 40; ++i) {
    MeasuredDevice device;
    device.jitter = 0.08;
    device.lost = 0.005;
    device.encoder_step = 1e-4;
    Measuring measuring(device, i);
    if (measuring.run() != State::kMeasured) continue;
    ++measured;
    const DeviceEstimates& told = measuring.measurement.estimates();
    EXPECT_LE(off(told.damping, device.damping), 3 * sigma(told.damping)) << i;
    EXPECT_LE(off(told.friction, device.friction), 3 * sigma(told.friction)) << i;
    EXPECT_LE(off(told.delay, device.delay), 3 * sigma(told.delay)) << i;
  }
  EXPECT_GE(measured, 36);
}

// What is not seen is left out, and not taken for a stick that stands: no number gets much worse.
TEST(DeviceMeasurement, LostSamples_AreLeftOut) {
  MeasuredDevice device;
  device.encoder_step = 1e-5;
  Measuring whole(device);
  ASSERT_EQ(whole.run(), State::kMeasured);
  device.lost = 0.005;
  Measuring holed(device);
  ASSERT_EQ(holed.run(), State::kMeasured);
  const DeviceEstimates& fine = whole.measurement.estimates();
  const DeviceEstimates& told = holed.measurement.estimates();
  EXPECT_LT(sigma(told.damping), 2 * sigma(fine.damping));
  EXPECT_LT(sigma(told.friction), 2 * sigma(fine.friction));
  EXPECT_LT(sigma(told.mass), 2 * sigma(fine.mass));
}

/// How far the stick went to either side of where it began, the mean of all its turns, u.
std::array<double, 2> mean_turns(Measuring& measuring) {
  constexpr double kStroke = 0.05;  // u; smaller ones are no strokes
  std::array<double, 2> sums{};
  std::array<int, 2> counts{};
  double last = 0, way = 0;
  while (measuring.measurement.state() == State::kRunning) {
    measuring.step(0);
    const double moved = measuring.position() - last;
    if (way * moved < 0 && std::abs(last) > kStroke) {
      const std::size_t side = last > 0 ? 1 : 0;
      sums[side] += std::abs(last);
      ++counts[side];
    }
    last = measuring.position();
    way = moved;
  }
  return {sums[0] / counts[0], sums[1] / counts[1]};
}

// A force that pulls to one side all the time: where to brake is learnt for each side by itself.
TEST(DeviceMeasurement, StrokesAgainstAWeight_GoAsFarAsThoseWithIt) {
  for (const double weight : {-0.15, 0.15}) {
    MeasuredDevice device;
    device.weight = weight;
    Measuring measuring(device);
    const auto [left, right] = mean_turns(measuring);
    EXPECT_EQ(measuring.measurement.state(), State::kMeasured);
    EXPECT_NEAR(left, right, 0.15 * left) << weight;
  }
}

/// How a device that differs from the plain one ends.
State end_of(void (*change)(MeasuredDevice&)) {
  MeasuredDevice device;
  change(device);
  Measuring measuring(device);
  return measuring.run();
}

TEST(DeviceMeasurement, WhatCannotBeMeasured_IsRefused) {
  EXPECT_EQ(end_of([](MeasuredDevice& d) { d.friction = d.force_limit; }), State::kNoMotion);
  EXPECT_EQ(end_of([](MeasuredDevice& d) { d.stiffness = 1000; }), State::kNoMotion);
  EXPECT_EQ(end_of([](MeasuredDevice& d) { d.weight = 1; }), State::kNotStill);
  EXPECT_EQ(end_of([](MeasuredDevice& d) { d.stiffness = 0.4; }), State::kHeld);
  EXPECT_EQ(end_of([](MeasuredDevice& d) { d.stiffness = 3; }), State::kHeld);
  EXPECT_EQ(end_of([](MeasuredDevice& d) { d.jitter = 0.5; }), State::kWrongPeriod);
  EXPECT_EQ(end_of([](MeasuredDevice& d) { d.lost = 0.9; }), State::kNoSamples);
  EXPECT_EQ(end_of([](MeasuredDevice& d) { d.let_through = 0.3; }), State::kHeldBack);
  EXPECT_EQ(end_of([](MeasuredDevice& d) { d.let_through = 3; }), State::kHeldBack);
  for (const int delay : {20, 40, 63}) {
    MeasuredDevice device;
    device.delay = delay;
    EXPECT_NE(Measuring(device).run(), State::kMeasured) << delay;
  }
  for (const double step : {0.02, 0.05, 0.2}) {
    MeasuredDevice device;
    device.encoder_step = step;
    EXPECT_NE(Measuring(device).run(), State::kMeasured) << step;
  }
}

// Play is no part of the model: it is refused, or what is told of the loop holds all the same.
TEST(DeviceMeasurement, PlayBeforeTheEncoder_IsRefusedOrCovered) {
  int refused = 0;
  for (const double play : {0.0005, 0.002, 0.005, 0.01, 0.03, 0.1}) {
    MeasuredDevice device;
    device.play = play;
    device.encoder_step = 1e-4;
    Measuring measuring(device);
    if (measuring.run() != State::kMeasured) {
      ++refused;
      continue;
    }
    const DeviceEstimates& told = measuring.measurement.estimates();
    EXPECT_LE(off(told.damping, device.damping), 0.05 * device.damping) << play;
    EXPECT_LE(off(told.friction, device.friction), 0.05 * device.friction) << play;
  }
  RecordProperty("refused", refused);
}

// A force that depends on the place widens what is told, and from some size on is refused.
TEST(DeviceMeasurement, Cogging_IsCoveredByWhatIsToldOrDoesNotFit) {
  State state = State::kMeasured;
  for (const double cogging : {0.003, 0.01, 0.03, 0.1, 0.3}) {
    MeasuredDevice device;
    device.cogging = cogging;
    Measuring measuring(device);
    state = measuring.run();
    if (state != State::kMeasured) continue;
    const DeviceEstimates& told = measuring.measurement.estimates();
    EXPECT_LE(off(told.damping, device.damping), 3 * sigma(told.damping)) << cogging;
    EXPECT_LE(off(told.friction, device.friction), 3 * sigma(told.friction)) << cogging;
  }
  EXPECT_EQ(state, State::kDoesNotFit);  // the last: more than friction
}

/// How many of 100 devices are told more damping or friction than they have, by three sigma.
int told_too_much(void (*change)(MeasuredDevice&)) {
  int unsafe = 0;
  for (std::uint64_t i = 0; i < 100; ++i) {
    MeasuredDevice device = test::any_device(i);
    change(device);
    Measuring measuring(device, i);
    if (measuring.run() != State::kMeasured) continue;
    const DeviceEstimates& told = measuring.measurement.estimates();
    const bool is_unsafe =
        static_cast<double>(told.damping.value) > device.damping + 3 * sigma(told.damping) ||
        static_cast<double>(told.friction.value) > device.friction + 3 * sigma(told.friction);
    unsafe += is_unsafe ? 1 : 0;
  }
  return unsafe;
}

/// A hand that holds the stick with a share of the motor's force.
void hold(MeasuredDevice& device, double share) {
  device.held_stiffness = share * device.force_limit / 4;
  device.held_damping = share * device.force_limit / 8;
}

// What is not the same from sweep to sweep does not fit; what is left is stated in the note.
TEST(DeviceMeasurement, HandForAPartOfTheTime_IsMostlyRefused) {
  constexpr int kOneInTen = 10;
  const auto early = [](MeasuredDevice& d) { hold(d, 0.01), d.held_to = 4000; };
  const auto between = [](MeasuredDevice& d) {
    hold(d, 0.01), d.held_from = 4000, d.held_to = 8000;
  };
  const auto late = [](MeasuredDevice& d) { hold(d, 0.03), d.held_from = 8000; };
  EXPECT_LE(told_too_much(early), kOneInTen);
  EXPECT_LE(told_too_much(between), kOneInTen);
  EXPECT_LE(told_too_much(late), kOneInTen);
}

TEST(DeviceMeasurement, DragThatGrowsWithTheSquare_IsMostlyRefused) {
  constexpr int kOneInFive = 20;
  EXPECT_LE(told_too_much([](MeasuredDevice& d) { d.drag = 0.003 * d.force_limit / 4; }),
            kOneInFive);
  EXPECT_LE(told_too_much([](MeasuredDevice& d) { d.drag = 0.03 * d.force_limit / 4; }),
            kOneInFive);
}

TEST(DeviceMeasurement, StickThatAHandMoves_IsRefused) {
  MeasuredDevice device;
  device.stiffness = 200;
  device.friction = 0;
  Measuring measuring(device);
  for (int i = 0; i < 100; ++i) measuring.step(0.002 * i);
  EXPECT_EQ(measuring.measurement.state(), State::kNotStill);
  EXPECT_EQ(measuring.measurement.step({}), 0.0F);
}

TEST(DeviceMeasurement, AxisWiredTheWrongWay_IsRefused) {
  MeasuredDevice device;
  device.let_through = -1;
  EXPECT_NE(Measuring(device).run(), State::kMeasured);
}

TEST(DeviceMeasurement, SettingsOutOfRange_AreRefusedAndChangeNothing) {
  MeasurementSettings good;
  good.force_limit = 5;
  EXPECT_EQ(validate(good), Status::kOk);
  float MeasurementSettings::*const fields[] = {
      &MeasurementSettings::period,    &MeasurementSettings::force_limit,
      &MeasurementSettings::travel,    &MeasurementSettings::most_share,
      &MeasurementSettings::excursion, &MeasurementSettings::safe_window};
  DeviceMeasurement measurement;
  for (const auto field : fields) {
    for (const float bad : {0.0F, -1.0F, NAN, INFINITY}) {
      MeasurementSettings settings = good;
      settings.*field = bad;
      EXPECT_EQ(measurement.configure(settings), Status::kInvalidArgument) << bad;
      EXPECT_EQ(measurement.state(), State::kIdle);
    }
  }
  good.safe_window = 0.2F;  // less than the excursion
  EXPECT_EQ(validate(good), Status::kInvalidArgument);
  EXPECT_EQ(measured_profile(good, {}, 3).status, Status::kInvalidArgument);
}

TEST(DeviceMeasurement, HostileSamples_EndItOrAskForLittle) {
  MeasurementSettings settings;
  settings.force_limit = 5;
  for (const float bad : test::kHostile<float>) {
    for (const int place : {0, 1}) {
      DeviceMeasurement measurement;
      ASSERT_EQ(measurement.configure(settings), Status::kOk);
      for (int i = 0; i < 1000; ++i) {
        MeasurementInput input;
        input.time = static_cast<Microseconds>(1000 * i);
        input.fresh = true;
        if (i % 7 == 6) (place == 0 ? input.position : input.applied) = bad;
        const float share = measurement.step(input);
        ASSERT_TRUE(is_finite(share) && std::abs(share) <= settings.most_share);
      }
      if (is_finite(bad)) continue;
      EXPECT_EQ(measurement.state(), State::kNotANumber);
    }
  }
}

}  // namespace
}  // namespace batuta
