// SPDX-License-Identifier: MIT
// Measures one axis of a stick (haptics/device_measurement.hpp), to what the gain advisor is given.
// Nothing else: no stick, no output stage.

#include "batuta/haptics/device_measurement.hpp"

namespace {

using namespace batuta::haptics;

// Volatile ends: what comes is not known to the compiler.
float volatile force_limit;
float volatile position;
float volatile asked;
float volatile stiffest;

MeasurementSettings settings;
DeviceMeasurement measurement;

void measure() {
  batuta::Microseconds now = 0;
  while (measurement.state() == MeasurementState::kRunning) {  // Bound: kMostSteps
    asked = measurement.step({now, position, asked, true});
    now += 1000;
  }
}

}  // namespace

int main() {
  settings.force_limit = force_limit;
  if (measurement.configure(settings) != batuta::Status::kOk) return 1;
  measure();
  const auto profile = measured_profile(settings, measurement.estimates(), 3);
  if (measurement.state() != MeasurementState::kMeasured || !profile.ok()) return 2;
  stiffest = largest_stiffness(profile.value, 0.0F).value.largest;
  return 0;
}
