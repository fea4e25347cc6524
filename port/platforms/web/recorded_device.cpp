// SPDX-License-Identifier: MIT
// Between the library and the page: a device's recording, whose lines the page reads
// (page/evemu.js), as the samples that the host would make of it. In static memory, from the page's
// worker.

#include <array>

#include "batuta/port/sample_builder.hpp"

namespace batuta::web {
namespace {

SampleBuilder builder;
std::array<AxisCalibration, 4> axes;  // of the builder, by Axis
std::array<float, 6> synced;          // x, y, feet_x, feet_y, buttons, sequence

}  // namespace

extern "C" {

/// One axis of a device of an evemu recording, by Axis; those of the stick begin a device that has
/// no feet. @returns a Status
int web_axis(unsigned which, int is_relative, int min, int max, int flat) {
  if (which >= axes.size()) return static_cast<int>(Status::kInvalidArgument);
  const AxisKind kind = is_relative != 0 ? AxisKind::kRelative : AxisKind::kAbsolute;
  // Up is a smaller count in the whole input stack.
  axes[which] = {kind, which % 2 != 0, min, max, flat};
  const bool is_feet = which >= static_cast<unsigned>(Axis::kFeetX);
  return static_cast<int>(is_feet ? builder.configure_feet(axes[2], axes[3])
                                  : builder.configure(axes[0], axes[1]));
}

/// What it tells of an axis, by Axis, in counts.
void web_move(unsigned which, int counts) {
  if (which < axes.size()) builder.axis(static_cast<Axis>(which), counts);
}

/// What else it tells: 0 that events were lost, 1 a button that is pressed, 2 one that is let go.
void web_event(int what, int value) {
  if (what == 0) builder.lost();
  // Not a button: nothing that a sword knows.
  if (what == 1 || what == 2) (void)builder.button(value, what == 1);
}

/// Its sync mark. @returns a Status; where kOk, the sample is in web_synced()
int web_sync(std::uint32_t time_us) {
  const Result<InputSample> sample = builder.sync(time_us);
  if (sample.ok()) {
    const InputSample& told = sample.value;
    synced = {told.x,
              told.y,
              told.feet_x,
              told.feet_y,
              static_cast<float>(told.buttons),
              static_cast<float>(told.sequence)};
  }
  return static_cast<int>(sample.status);
}

/// The sample of the last sync mark that gave one: x, y, feet_x, feet_y, buttons, sequence.
const float* web_synced() {
  return synced.data();
}

}  // extern "C"

}  // namespace batuta::web
