// SPDX-License-Identifier: MIT

#include "platforms/rp2040/drivers/pico_stick.hpp"

#include "hardware/adc.h"
#include "platforms/rp2040/board.hpp"

namespace batuta::rp2040 {

Status PicoStick::start(const AxisCalibration& axis) {
  const Status status = builder_.configure(axis, axis);
  if (status != Status::kOk) return status;
  adc_init();
  adc_gpio_init(kStickXPin);
  adc_gpio_init(kStickYPin);
  return Status::kOk;
}

/// The two channels in turn, as close together as they can be.
Status PicoStick::do_read(Microseconds now, InputSample& sample) {
  if (has_read_ && now == read_at_) return Status::kUnavailable;
  has_read_ = true;
  read_at_ = now;
  std::uint16_t counts[drivers::kWindowCounts];
  for (int i = 0; i < drivers::kWindowCounts; ++i) {  // Bound: kWindowCounts
    adc_select_input((i % drivers::kAxes == 0 ? kStickXPin : kStickYPin) - kFirstAdcPin);
    counts[i] = adc_read();
  }
  const drivers::StickReading reading = drivers::sum_window(counts);
  connection_.note(reading.plausible);
  if (!is_connected()) return Status::kUnavailable;
  builder_.axis(Axis::kX, reading.x);
  builder_.axis(Axis::kY, reading.y);
  const Result<InputSample> built = builder_.sync(now);
  if (built.ok()) sample = built.value;
  return built.status;
}

}  // namespace batuta::rp2040
