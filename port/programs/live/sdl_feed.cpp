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

}  // namespace

SdlFeed::SdlFeed(std::shared_ptr<SdlStick> stick) : stick_(std::move(stick)) {
  if (builder_.configure(calibration(false), calibration(true)) != Status::kOk) {
    BATUTA_INVARIANT(false);
  }
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
  return sample_now(handle.get(), sample) ? News::kSample : News::kNone;
}

bool SdlFeed::sample_now(SDL_Joystick* handle, InputSample& sample) {
  SDL_GameController* const pad = stick_->pad();
  const Sint16 x = pad != nullptr ? SDL_GameControllerGetAxis(pad, SDL_CONTROLLER_AXIS_LEFTX)
                                  : SDL_JoystickGetAxis(handle, 0);
  const Sint16 y = pad != nullptr ? SDL_GameControllerGetAxis(pad, SDL_CONTROLLER_AXIS_LEFTY)
                                  : SDL_JoystickGetAxis(handle, 1);
  builder_.axis(Axis::kX, x);
  builder_.axis(Axis::kY, y);
  const Result<InputSample> state = builder_.sync(clock_.now());
  if (!state.ok()) return false;
  InputSample now = state.value;
  now.buttons = buttons_of(handle);
  const bool moved =
      !has_spoken_ || now.x != last_.x || now.y != last_.y || now.buttons != last_.buttons;
  if (!moved) return false;
  has_spoken_ = true;
  last_ = now;
  sample = now;
  return true;
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
