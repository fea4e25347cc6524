// SPDX-License-Identifier: MIT
#include "programs/feel/measure.hpp"

#include <cstdio>

#include "batuta/haptics/device_measurement.hpp"
#include "batuta/haptics/output_stage.hpp"
#include "shared/simulated/stick.hpp"

namespace batuta {
using namespace haptics;
namespace {

constexpr float kForceLimit = 10;  // N m for each unit of the stick
constexpr float kMargin = 3;       // standard errors

/// Nobody holds it.
port_simulated::StickSettings free_stick() {
  port_simulated::StickSettings settings;
  settings.x.mass = 0.02;
  settings.x.damping = 0.15;
  settings.x.friction = 0.25;
  settings.y = settings.x;
  settings.force_limit = static_cast<double>(kForceLimit);
  settings.encoder_step = 1.0 / 2048;
  settings.delay = 1;
  return settings;
}

const char* name_of(MeasurementState state) {
  switch (state) {
    case MeasurementState::kMeasured:
      return "measured";
    case MeasurementState::kNotStill:
      return "the stick is not still, or not in the middle";
    case MeasurementState::kNoMotion:
      return "the force does not move the stick, or no more";
    case MeasurementState::kLeftWindow:
      return "the stick went too far";
    case MeasurementState::kNoSamples:
    case MeasurementState::kWrongPeriod:
    case MeasurementState::kNotANumber:
      return "the samples are missing, or not as they should be";
    case MeasurementState::kHeldBack:
      return "the force is held back";
    case MeasurementState::kHeld:
      return "a hand holds the stick, or a spring";
    case MeasurementState::kDoesNotFit:
      return "it does not move as a mass with damping and friction does";
    default:
      return "what was seen does not tell";
  }
}

void tell(const char* name, const Estimate& estimate, const char* unit) {
  std::printf("  %-13s %10.5g +- %-8.2g %s\n", name, static_cast<double>(estimate.value),
              static_cast<double>(kMargin * estimate.sigma), unit);
}

/// To its end, or until it is given up. @returns false: the parts could not be configured
bool run(DeviceMeasurement& measurement, const MeasurementSettings& settings) {
  port_simulated::SimulatedStick stick;
  OutputStage stage(stick.force());
  StageSettings limits;
  limits.gain = {1 / kForceLimit, 1 / kForceLimit};
  const bool ready = stick.configure(free_stick()) == Status::kOk &&
                     stage.configure(limits) == Status::kOk && stage.enable() == Status::kOk &&
                     measurement.configure(settings) == Status::kOk;
  InputSample sample;
  InputSample before;
  while (ready && measurement.state() == MeasurementState::kRunning) {  // Bound: kMostSteps
    stick.advance({0, 0});
    StageInput input;
    input.fresh_sample = stick.input().read(stick.now(), sample) == Status::kOk;
    const float told = stage.last_command().x;
    const float share = measurement.step({sample.time, sample.x, told, input.fresh_sample});
    input.time = stick.now();
    input.demanded.x() = share * kForceLimit;
    input.position = {sample.x, sample.y};
    input.velocity.x() = (sample.x - before.x) / settings.period;
    input.fresh_command = true;
    (void)stage.step(input);
    before = sample;
  }
  return ready;
}

void advise(const DeviceProfile<float>& profile) {
  const auto stiffness = largest_stiffness(profile, 0.0F);
  const auto damping = largest_damping(profile, 0.0F);
  std::printf("to be safe, the advisor is given\n");
  std::printf("  damping %.4g N m s, friction %.4g N m, encoder step %.4g, delay %d of %g ms\n",
              static_cast<double>(profile.damping), static_cast<double>(profile.friction),
              static_cast<double>(profile.encoder_step), profile.delay,
              1e3 * static_cast<double>(profile.period));
  std::printf("it bears %.4g N m for each unit of the stick, or a damping of %.3g N m s\n",
              static_cast<double>(stiffness.value.largest),
              static_cast<double>(damping.value.largest));
}

}  // namespace

int measure() {
  MeasurementSettings settings;
  settings.force_limit = kForceLimit;
  DeviceMeasurement measurement;
  if (!run(measurement, settings)) return 1;
  const DeviceEstimates& told = measurement.estimates();
  std::printf("%s, in %d periods\n", name_of(measurement.state()), measurement.steps());
  const auto profile = measured_profile(settings, told, kMargin);
  if (measurement.state() != MeasurementState::kMeasured || !profile.ok()) return 1;
  tell("damping", told.damping, "N m s for each unit of the stick");
  tell("friction", told.friction, "N m for each unit");
  tell("mass", told.mass, "N m s^2 for each unit");
  tell("stiffness", told.stiffness, "N m for each unit squared");
  tell("offset", told.offset, "N m for each unit");
  tell("delay", told.delay, "periods");
  tell("encoder step", told.encoder_step, "units");
  advise(profile.value);
  return 0;
}

}  // namespace batuta
