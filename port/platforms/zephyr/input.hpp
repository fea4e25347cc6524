// SPDX-License-Identifier: MIT
#pragma once
// A stick whose driver speaks Zephyr's input subsystem (adc analog-axis, gpio-qdec, a gamepad by
// USB or Bluetooth). The application registers it with the device of its devicetree:
//   INPUT_CALLBACK_DEFINE(DEVICE_DT_GET(DT_NODELABEL(stick)), batuta::zephyr::EventInput::on_event,
//                         &stick);
// The callback runs in the subsystem's thread, or in the driver's (CONFIG_INPUT_MODE_SYNCHRONOUS);
// read() in that of whoever steps the world. A sample goes from one to the other under a spin lock
// that is held for a copy.

#include <zephyr/input/input.h>
#include <zephyr/kernel.h>

#include <array>

#include "batuta/port/sample_builder.hpp"

namespace batuta::zephyr {

class EventInput final : public InputDevice {
 public:
  static constexpr int kAxes = 4;  ///< of two pairs

  /// @param clock  stamps each sample at its sync mark; as `now` of read() does. It outlives this
  explicit EventInput(Clock& clock) : clock_(clock) {}

  /// Calibrates the axes X and Y, INPUT_ABS_X and _Y or INPUT_REL_X and _Y by their kind, and
  /// starts anew. Most drivers count Y downwards: state it as `reversed`. Call it before the driver
  /// reports; not from the callback.
  /// @returns kOk | kInvalidArgument: as SampleBuilder::configure(); nothing changed
  Status configure(const AxisCalibration& x, const AxisCalibration& y);

  /// The second pair: INPUT_ABS_RX and _RY, or INPUT_REL_RX and _RY. @returns as configure()
  Status configure_feet(const AxisCalibration& x, const AxisCalibration& y);

  /// What INPUT_CALLBACK_DEFINE wants. @param self  an EventInput
  static void on_event(input_event* event, void* self);

  /// One event: an axis, or one of 25 buttons, in this order: INPUT_BTN_0 ... INPUT_BTN_9, then
  /// INPUT_BTN_SOUTH ... INPUT_BTN_THUMBR; others are left out. An axis of another kind than was
  /// stated is left out as well. With its `sync` a sample is complete.
  void handle(const input_event& event);

 private:
  Status do_read(Microseconds now, InputSample& sample) override;
  void move_axis(AxisKind kind, const input_event& event);

  Clock& clock_;
  SampleBuilder builder_;                ///< of the callback's thread
  std::array<AxisKind, kAxes> kinds_{};  ///< by Axis, as configured
  k_spinlock lock_{};                    ///< of what follows
  InputSample latest_;
  bool is_new_ = false;
};

}  // namespace batuta::zephyr
