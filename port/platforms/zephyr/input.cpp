// SPDX-License-Identifier: MIT
#include "platforms/zephyr/input.hpp"

namespace batuta::zephyr {

namespace {

/// Codes of the axes by Axis, the same for positions and for movements (INPUT_ABS_X = INPUT_REL_X).
constexpr std::array<std::uint16_t, EventInput::kAxes> kAxisCodes = {INPUT_ABS_X, INPUT_ABS_Y,
                                                                     INPUT_ABS_RX, INPUT_ABS_RY};
static_assert(INPUT_REL_X == INPUT_ABS_X && INPUT_REL_Y == INPUT_ABS_Y &&
              INPUT_REL_RX == INPUT_ABS_RX && INPUT_REL_RY == INPUT_ABS_RY);

constexpr int kNumbered = INPUT_BTN_9 - INPUT_BTN_0 + 1;

/// Place among the buttons of a sample, or -1: none of them.
int button_of(std::uint16_t code) {
  if (code >= INPUT_BTN_0 && code <= INPUT_BTN_9) return code - INPUT_BTN_0;
  if (code >= INPUT_BTN_SOUTH && code <= INPUT_BTN_THUMBR)
    return kNumbered + code - INPUT_BTN_SOUTH;
  return -1;
}
static_assert(kNumbered + INPUT_BTN_THUMBR - INPUT_BTN_SOUTH < SampleBuilder::kMaxButtons);

/// Holds a lock for as long as it lives.
class Locked {
 public:
  explicit Locked(k_spinlock& lock) : lock_(lock), key_(k_spin_lock(&lock)) {}
  ~Locked() { k_spin_unlock(&lock_, key_); }
  Locked(const Locked&) = delete;
  Locked& operator=(const Locked&) = delete;

 private:
  k_spinlock& lock_;
  k_spinlock_key_t key_;
};

}  // namespace

Status EventInput::configure(const AxisCalibration& x, const AxisCalibration& y) {
  const Status status = builder_.configure(x, y);
  if (status != Status::kOk) return status;
  kinds_ = {x.kind, y.kind, AxisKind::kAbsolute, AxisKind::kAbsolute};
  const Locked locked(lock_);
  is_new_ = false;
  return status;
}

Status EventInput::configure_feet(const AxisCalibration& x, const AxisCalibration& y) {
  const Status status = builder_.configure_feet(x, y);
  if (status != Status::kOk) return status;
  kinds_[2] = x.kind;
  kinds_[3] = y.kind;
  return status;
}

void EventInput::on_event(input_event* event, void* self) {
  static_cast<EventInput*>(self)->handle(*event);
}

void EventInput::handle(const input_event& event) {
  if (event.type == INPUT_EV_KEY) {
    const int button = button_of(event.code);
    if (button >= 0) (void)builder_.button(button, event.value != 0);
  }
  if (event.type == INPUT_EV_ABS) move_axis(AxisKind::kAbsolute, event);
  if (event.type == INPUT_EV_REL) move_axis(AxisKind::kRelative, event);
  if (event.sync == 0) return;
  const Result<InputSample> sample = builder_.sync(clock_.now());
  if (sample.status != Status::kOk) return;
  const Locked locked(lock_);
  latest_ = sample.value;
  is_new_ = true;
}

void EventInput::move_axis(AxisKind kind, const input_event& event) {
  for (std::size_t i = 0; i < kAxisCodes.size(); ++i) {  // Bound: kAxes
    if (kAxisCodes[i] == event.code && kinds_[i] == kind)
      builder_.axis(static_cast<Axis>(i), event.value);
  }
}

Status EventInput::do_read(Microseconds now, InputSample& sample) {
  const Locked locked(lock_);
  if (!is_new_ || is_later(latest_.time, now)) return Status::kUnavailable;
  sample = latest_;
  is_new_ = false;
  return Status::kOk;
}

}  // namespace batuta::zephyr
