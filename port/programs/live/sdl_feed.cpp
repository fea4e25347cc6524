// SPDX-License-Identifier: MIT

#include "programs/live/sdl_feed.hpp"

#include <algorithm>
#include <chrono>
#include <thread>
#include <utility>

namespace batuta::host {
namespace {

/// SDL's axes: -32768 ... 32767 with their centre at 0; down is the greater count. The one count
/// more on the one side is the rim as well.
AxisCalibration calibration(bool vertical) {
  AxisCalibration axis;
  axis.min = -SDL_JOYSTICK_AXIS_MAX;
  axis.max = SDL_JOYSTICK_AXIS_MAX;
  axis.reversed = vertical;
  return axis;
}

/// Of a hat along one axis, as if it were an axis: all or nothing.
std::int32_t hat_counts(Uint8 hat, Uint8 low, Uint8 high) {
  if ((hat & high) != 0) return SDL_JOYSTICK_AXIS_MAX;
  return (hat & low) != 0 ? -SDL_JOYSTICK_AXIS_MAX : 0;
}

/// Whether anything but the time and the number is another.
bool differs(const InputSample& a, const InputSample& b) {
  return a.x != b.x || a.y != b.y || a.feet_x != b.feet_x || a.feet_y != b.feet_y ||
         a.buttons != b.buttons;
}

}  // namespace

SdlFeed::SdlFeed(std::shared_ptr<SdlStick> stick) : stick_(std::move(stick)) {
  const bool ready = builder_.configure(calibration(false), calibration(true)) == Status::kOk &&
                     builder_.configure_feet(calibration(false), calibration(true)) == Status::kOk;
  BATUTA_INVARIANT(ready);
}

void SdlFeed::wait() {
  constexpr std::chrono::milliseconds kPeriod(1);
  std::this_thread::sleep_for(kPeriod);
}

News SdlFeed::look(InputSample& sample) {
  SDL_JoystickUpdate();
  const SdlStick::Handle handle = stick_->handle();
  if (handle == nullptr || SDL_JoystickGetAttached(handle.get()) == SDL_FALSE) {
    stick_->close();
    return News::kGone;
  }
  stick_->note_others();
  return sample_now(handle.get(), sample) ? News::kSample : News::kNone;
}

bool SdlFeed::sample_now(SDL_Joystick* handle, InputSample& sample) {
  read_axes(handle);
  const Result<InputSample> state = builder_.sync(clock_.now());
  if (!state.ok()) return false;
  InputSample now = state.value;
  now.buttons = buttons_of(handle);
  if (has_spoken_ && !differs(now, last_)) return false;
  has_spoken_ = true;
  last_ = now;
  sample = now;
  return true;
}

void SdlFeed::read_axes(SDL_Joystick* handle) {
  if (SDL_GameController* const pad = stick_->pad()) {
    builder_.axis(Axis::kX, SDL_GameControllerGetAxis(pad, SDL_CONTROLLER_AXIS_LEFTX));
    builder_.axis(Axis::kY, SDL_GameControllerGetAxis(pad, SDL_CONTROLLER_AXIS_LEFTY));
    builder_.axis(Axis::kFeetX, SDL_GameControllerGetAxis(pad, SDL_CONTROLLER_AXIS_RIGHTX));
    builder_.axis(Axis::kFeetY, SDL_GameControllerGetAxis(pad, SDL_CONTROLLER_AXIS_RIGHTY));
    return;
  }
  builder_.axis(Axis::kX, SDL_JoystickGetAxis(handle, 0));
  builder_.axis(Axis::kY, SDL_JoystickGetAxis(handle, 1));
  const Uint8 hat = SDL_JoystickGetHat(handle, 0);  // centred where there is none
  builder_.axis(Axis::kFeetX, hat_counts(hat, SDL_HAT_LEFT, SDL_HAT_RIGHT));
  builder_.axis(Axis::kFeetY, hat_counts(hat, SDL_HAT_UP, SDL_HAT_DOWN));
}

std::uint32_t SdlFeed::buttons_of(SDL_Joystick* handle) const {
  SDL_GameController* const pad = stick_->pad();
  const int count = pad != nullptr ? SDL_CONTROLLER_BUTTON_MAX : SDL_JoystickNumButtons(handle);
  std::uint32_t buttons = 0;
  for (int i = 0; i < std::min(count, SampleBuilder::kMaxButtons); ++i) {  // Bound: kMaxButtons
    const Uint8 pressed =
        pad != nullptr ? SDL_GameControllerGetButton(pad, static_cast<SDL_GameControllerButton>(i))
                       : SDL_JoystickGetButton(handle, i);
    if (pressed != 0) buttons |= std::uint32_t{1} << static_cast<unsigned>(i);
  }
  return buttons;
}

bool SdlFeed::reopen() {
  SDL_JoystickUpdate();  // SDL looks for what was plugged in
  has_spoken_ = false;
  return stick_->open();
}

}  // namespace batuta::host
