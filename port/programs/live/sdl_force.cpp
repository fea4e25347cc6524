// SPDX-License-Identifier: MIT

#include "programs/live/sdl_force.hpp"

#include <algorithm>

#include "programs/live/force_pump.hpp"

namespace batuta::host {

ForceKind SdlForce::open() {
  shut();
  handle_ = stick_->handle();
  if (handle_ == nullptr) return kind();
  Abilities abilities = open_haptic();
  if (SDL_JoystickHasRumble(handle_.get()) == SDL_TRUE) {
    abilities.effects.add(Effect::kRumble);
    abilities.room = std::max(abilities.room, 1);  // not one of SDL_Haptic's
  }
  if (begin(abilities) == ForceKind::kNone) shut();
  return kind();
}

MappedForce::Abilities SdlForce::open_haptic() {
  Abilities abilities;
  if (!session_.has_haptics() || SDL_JoystickIsHaptic(handle_.get()) != SDL_TRUE) return abilities;
  haptic_ = SDL_HapticOpenFromJoystick(handle_.get());
  if (haptic_ == nullptr) return abilities;
  const unsigned features = SDL_HapticQuery(haptic_);
  const int room = SDL_HapticNumEffects(haptic_);
  if ((features & SDL_HAPTIC_CONSTANT) == 0 || room < 1) {
    SDL_HapticClose(haptic_);
    haptic_ = nullptr;
    return abilities;
  }
  constexpr int kFullGain = 100;
  if ((features & SDL_HAPTIC_GAIN) != 0) (void)SDL_HapticSetGain(haptic_, kFullGain);
  if ((features & SDL_HAPTIC_AUTOCENTER) != 0) (void)SDL_HapticSetAutocenter(haptic_, 0);
  abilities.effects.add(Effect::kConstant);
  if ((features & SDL_HAPTIC_SPRING) != 0) abilities.effects.add(Effect::kSpring);
  if ((features & SDL_HAPTIC_DAMPER) != 0) abilities.effects.add(Effect::kDamper);
  abilities.room = room;
  abilities.axes = SDL_HapticNumAxes(haptic_);
  return abilities;
}

void SdlForce::shut() {
  if (haptic_ != nullptr) {
    for (const Place place : {kX, kY, kSpring, kDamper}) remove(place);  // Bound: kPlaces
    SDL_HapticClose(haptic_);
  }
  if (shaken_) (void)SDL_JoystickRumble(handle_.get(), 0, 0, 0);
  haptic_ = nullptr;
  handle_.reset();
  failures_ = {};
  shaken_ = false;
  end({});
}

void SdlForce::remove(Place place) {
  int& id = effects_[place];
  if (id != kNone) SDL_HapticDestroyEffect(haptic_, id);
  id = kNone;
}

/// Another handle is the same device, plugged in anew.
bool SdlForce::has_hold() const {
  return handle_ != nullptr && stick_->handle() == handle_;
}

bool SdlForce::is_there() {
  const bool there = has_hold();
  if (!there) shut();
  return there;
}

MappedForce::Taken SdlForce::push_axis(Place axis, std::int16_t level) {
  return update(axis, sdl_constant(axis == kX ? Push::kRight : Push::kUp, level));
}

MappedForce::Taken SdlForce::push_both(float x, float y) {
  return update(kX, sdl_constant(x, y));
}

MappedForce::Taken SdlForce::resist(Place place, const ConditionPair& condition) {
  const unsigned type = place == kSpring ? SDL_HAPTIC_SPRING : SDL_HAPTIC_DAMPER;
  return update(place, sdl_condition(static_cast<std::uint16_t>(type), condition));
}

MappedForce::Taken SdlForce::shake(const Rumble& rumble) {
  if (!has_hold()) return Taken::kGone;
  constexpr Uint32 kLength_ms = ForcePump::kSilence_us / 1000;
  shaken_ = true;
  const int answer = SDL_JoystickRumble(handle_.get(), rumble.strong, rumble.weak, kLength_ms);
  return judge(kX, answer == 0);
}

bool SdlForce::run(int id) {
  constexpr Uint32 kOnce = 1;
  return SDL_HapticRunEffect(haptic_, id, kOnce) == 0;
}

/// Has an effect play, or changes the one that plays. One that cannot be changed, or not be run
/// again, is made anew.
MappedForce::Taken SdlForce::update(Place place, SDL_HapticEffect effect) {
  if (!has_hold()) return Taken::kGone;
  int& id = effects_[place];
  const bool changed = id != kNone && SDL_HapticUpdateEffect(haptic_, id, &effect) == 0;
  if (changed && (!renews() || run(id))) return judge(place, true);
  remove(place);
  id = std::max(SDL_HapticNewEffect(haptic_, &effect), kNone);
  const bool plays = id != kNone && run(id);
  if (!plays) remove(place);
  return judge(place, plays);
}

MappedForce::Taken SdlForce::judge(Place place, bool done) {
  int& failures = failures_[place];
  failures = done ? 0 : failures + 1;
  if (done) return Taken::kDone;
  if (SDL_JoystickGetAttached(handle_.get()) == SDL_FALSE) return Taken::kGone;
  if (failures < kMostFailures) return Taken::kLater;
  failures = 0;  // the next mapping has as many
  return Taken::kRefused;
}

}  // namespace batuta::host
