// SPDX-License-Identifier: MIT

#include "host/live/sdl_force.hpp"

#include "host/live/force_pump.hpp"

namespace batuta::host {

SdlForce::~SdlForce() {
  if (kind_ == ForceKind::kRumble) (void)SDL_JoystickRumble(handle_.get(), 0, 0, 0);
  close();
}

ForceKind SdlForce::open() {
  close();
  handle_ = stick_->handle();
  if (handle_ == nullptr) return kind_;
  if (open_haptic()) {
    kind_ = ForceKind::kForce;
  } else if (SDL_JoystickHasRumble(handle_.get()) == SDL_TRUE) {
    kind_ = ForceKind::kRumble;
  } else {
    close();
  }
  return kind_;
}

bool SdlForce::open_haptic() {
  if (!session_.has_haptics() || SDL_JoystickIsHaptic(handle_.get()) != SDL_TRUE) return false;
  haptic_ = SDL_HapticOpenFromJoystick(handle_.get());
  if (haptic_ == nullptr) return false;
  features_ = SDL_HapticQuery(haptic_);
  room_ = SDL_HapticNumEffects(haptic_);
  axes_ = SDL_HapticNumAxes(haptic_);
  if ((features_ & SDL_HAPTIC_CONSTANT) == 0 || room_ < 1) {
    SDL_HapticClose(haptic_);
    haptic_ = nullptr;
    return false;
  }
  constexpr int kFullGain = 100;
  if ((features_ & SDL_HAPTIC_GAIN) != 0) (void)SDL_HapticSetGain(haptic_, kFullGain);
  if ((features_ & SDL_HAPTIC_AUTOCENTER) != 0) (void)SDL_HapticSetAutocenter(haptic_, 0);
  return true;
}

void SdlForce::close() {
  if (haptic_ != nullptr) {
    for (int& effect : effects_) {
      if (effect != kNone) SDL_HapticDestroyEffect(haptic_, effect);
      effect = kNone;
    }
    SDL_HapticClose(haptic_);
  }
  haptic_ = nullptr;
  handle_.reset();
  kind_ = ForceKind::kNone;
}

bool SdlForce::is_there() {
  // Another handle is the same device, plugged in anew.
  const bool there = handle_ != nullptr && stick_->handle() == handle_;
  if (!there) close();
  return there;
}

Rendered SdlForce::render(const Feel& feel) {
  bool there = is_there();
  if (there && kind_ == ForceKind::kForce) there = render_constant(feel);
  if (there && kind_ == ForceKind::kRumble) {
    const Rumble rumble = rumble_of(feel);
    constexpr Uint32 kLength_ms = ForcePump::kSilence_us / 1000;
    there = SDL_JoystickRumble(handle_.get(), rumble.strong, rumble.weak, kLength_ms) == 0;
  }
  if (!there) close();
  return there ? Rendered::kDone : Rendered::kGone;
}

bool SdlForce::render_constant(const Feel& feel) {
  if (axes_ < 2) return update(kX, sdl_constant(Push::kRight, level_of(feel.x)));
  if (room_ < 2) return update(kX, sdl_constant(feel.x, feel.y));
  bool there = update(kX, sdl_constant(Push::kRight, level_of(feel.x))) &&
               update(kY, sdl_constant(Push::kUp, level_of(feel.y)));
  int left = room_ - 2;
  const auto overlay = [&](Place place, unsigned type, const Condition& condition) {
    const bool wanted = effects_[place] != kNone || condition.coefficient > 0;
    if (!there || !wanted || left <= 0 || (features_ & type) == 0) return;
    --left;
    const ConditionPair numbers = condition_numbers(condition);
    there = update(place, sdl_condition(static_cast<std::uint16_t>(type), numbers));
  };
  overlay(kSpring, SDL_HAPTIC_SPRING, feel.spring);
  overlay(kDamper, SDL_HAPTIC_DAMPER, feel.damper);
  return there;
}

/// Has an effect play, or changes the one that plays. @returns false: the device does not take it
bool SdlForce::update(Place place, SDL_HapticEffect effect) {
  int& id = effects_[place];
  if (id != kNone) return SDL_HapticUpdateEffect(haptic_, id, &effect) == 0;
  id = SDL_HapticNewEffect(haptic_, &effect);
  constexpr Uint32 kOnce = 1;  // it has no end
  return id >= 0 && SDL_HapticRunEffect(haptic_, id, kOnce) == 0;
}

}  // namespace batuta::host
