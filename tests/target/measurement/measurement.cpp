// SPDX-License-Identifier: MIT
// A stick that is known, measured on a part: the simulated axis is the device, in double, and the
// measurement is the library's own float. Counts the instructions of its steps, which tells what
// they take of a millisecond.
#include <cmath>

#include "batuta/haptics/device_measurement.hpp"
#include "bench/ticks.hpp"
#include "boot/checks.hpp"
#include "platforms/cortex_m/stack.hpp"
#include "shared/simulated/axis.hpp"
#include "shared/simulated/encoder.hpp"

namespace {

using namespace batuta;
using namespace haptics;

constexpr double kForceLimit = 10;
constexpr double kEncoderStep = 1.0 / 2048;
constexpr int kDelay = 1;                 ///< periods
constexpr std::size_t kMostStack = 1000;  ///< B, of configure(): less than a third of the object

port_simulated::AxisSettings stick() {
  port_simulated::AxisSettings settings;
  settings.mass = 0.02;
  settings.damping = 0.15;
  settings.friction = 0.25;
  settings.travel = 1;
  return settings;
}

port_simulated::SimulatedAxis axis;
DeviceMeasurement measurement;
std::uint32_t most_ticks = 0;
std::uint64_t all_ticks = 0;

/// A period of the measurement, and what it took. @returns the share that it asks for
float timed_step(const MeasurementInput& input) {
  float asked = 0;
  const std::uint32_t ticks = price::ticks_of([&] { asked = measurement.step(input); });
  if (ticks > most_ticks) most_ticks = ticks;
  all_ticks += ticks;
  return asked;
}

/// To its end. Nobody holds the stick.
void run() {
  float told[kDelay + 1] = {};  // the latest first
  MeasurementInput input;
  input.fresh = true;
  while (measurement.state() == MeasurementState::kRunning) {  // Bound: kMostSteps
    input.position = static_cast<float>(port_simulated::encoded(axis.position(), kEncoderStep));
    input.applied = told[0];
    const float asked = timed_step(input);
    for (int i = kDelay; i > 0; --i) told[i] = told[i - 1];  // Bound: kDelay
    told[0] = asked;
    axis.advance(kForceLimit * static_cast<double>(told[kDelay]), 0);
    input.time += 1000;
  }
}

/// To five percent, which is what is promised of a plain device.
bool is_near(const Estimate& told, double truth) {
  return std::abs(static_cast<double>(told.value) - truth) <= 0.05 * truth;
}

void check_estimates(Checks& check, const MeasurementSettings& settings) {
  const DeviceEstimates& told = measurement.estimates();
  check.that(measurement.state() == MeasurementState::kMeasured, "the stick is measured");
  check.that(is_near(told.damping, stick().damping), "damping");
  check.that(is_near(told.friction, stick().friction), "friction");
  check.that(is_near(told.mass, stick().mass), "mass");
  check.that(is_near(told.encoder_step, kEncoderStep), "encoder step");
  check.that(is_near(told.delay, kDelay), "delay");
  const auto profile = measured_profile(settings, told, 3);
  check.that(profile.ok() && profile.value.delay >= kDelay, "no less delay than there is");
  const auto bound = largest_stiffness(profile.value, 0.0F);
  check.that(bound.ok() && bound.value.largest > 0, "the advisor takes what was measured");
}

void tell(const char* name, std::uint64_t ticks) {
  const std::uint64_t loop = price::calibration_ticks();
  semihosting::write(name);
  semihosting::write_unsigned(
      static_cast<std::uint32_t>(ticks * price::kCalibrationInstructions / loop));
  semihosting::write("\n");
}

}  // namespace

int main() {
  Checks check;
  MeasurementSettings settings;
  settings.force_limit = static_cast<float>(kForceLimit);
  price::start_ticks();
  check.that(axis.configure(stick()) == Status::kOk, "there is a stick");
  cortex_m::repaint_stack();
  const std::size_t above = cortex_m::stack_used();
  check.that(measurement.configure(settings) == Status::kOk, "the measurement is configured");
  check.that(cortex_m::stack_used() - above < kMostStack, "no copy of it is made on the stack");
  run();
  check_estimates(check, settings);
  semihosting::write("steps: ");
  semihosting::write_unsigned(static_cast<std::uint32_t>(measurement.steps()));
  semihosting::write("\n");
  tell("instructions of a step, mean: ",
       all_ticks / static_cast<std::uint64_t>(measurement.steps()));
  tell("instructions of a step, most: ", most_ticks);
  check.end();
}
