// SPDX-License-Identifier: MIT

#include "programs/live/mapped_force.hpp"

#include <algorithm>
#include <array>

namespace batuta::host {
namespace {

const Condition& condition_of(const Feel& feel, Effect effect) {
  return effect == Effect::kSpring ? feel.spring : feel.damper;
}

Effect effect_of(bool spring) {
  return spring ? Effect::kSpring : Effect::kDamper;
}

}  // namespace

std::string names_of(EffectSet effects) {
  constexpr std::array<const char*, kEffects> kNames = {"constant", "spring", "damper", "rumble"};
  std::string names;
  for (int i = 0; i < kEffects; ++i) {  // Bound: kEffects
    if (!effects.has(static_cast<Effect>(i))) continue;
    if (!names.empty()) names += ", ";
    names += kNames[static_cast<std::size_t>(i)];
  }
  return names;
}

ForceKind MappedForce::begin(const Abilities& abilities) {
  abilities_ = abilities;
  left_out_ = {};
  refused_ = {};
  overlaid_ = {};
  problem_.clear();
  const auto can = [&](Effect effect) {
    return abilities.room > 0 && abilities.effects.has(effect);
  };
  kind_ = can(Effect::kRumble) ? ForceKind::kRumble : ForceKind::kNone;
  if (can(Effect::kConstant)) kind_ = ForceKind::kForce;
  return kind_;
}

void MappedForce::end(const std::string& problem) {
  kind_ = ForceKind::kNone;
  refused_ = {};
  problem_ = problem;
}

Rendered MappedForce::render(const Feel& feel) {
  Taken taken = refused_.empty() ? Taken::kGone : Taken::kRefused;  // where there is no kind
  bool again = kind_ != ForceKind::kNone;
  while (again) {  // Bound: 3, the mappings there are
    taken = kind_ == ForceKind::kForce ? push(feel) : shake(rumble_of(feel));
    if (taken == Taken::kRefused) step_down();
    again = taken == Taken::kRefused && kind_ != ForceKind::kNone;
  }
  if (taken != Taken::kGone) note_left_out(feel);
  switch (taken) {
    case Taken::kDone:
      renews_ = false;
      return Rendered::kDone;
    case Taken::kLater:
      return Rendered::kLater;
    case Taken::kRefused:
      return Rendered::kRefused;
    case Taken::kGone:
      break;
  }
  close();
  return Rendered::kGone;
}

MappedForce::Taken MappedForce::push(const Feel& feel) {
  if (abilities_.axes < 2) return push_axis(kX, level_of(feel.x));
  if (abilities_.room < 2) return push_both(feel.x, feel.y);
  const Taken x = push_axis(kX, level_of(feel.x));
  if (x >= Taken::kRefused) return x;
  const Taken y = push_axis(kY, level_of(feel.y));
  if (y >= Taken::kRefused) return y;
  return std::max({x, y, overlay(feel)});
}

MappedForce::Taken MappedForce::overlay(const Feel& feel) {
  Taken all = Taken::kDone;
  int left = abilities_.room - 2;
  for (const Place place : {kSpring, kDamper}) {  // Bound: 2
    const Effect effect = effect_of(place == kSpring);
    const Condition& condition = condition_of(feel, effect);
    // One that is on the device is told as well that there is none any more.
    const bool wanted = overlaid_.has(effect) || condition.coefficient > 0;
    const bool can = abilities_.effects.has(effect) && !refused_.has(effect);
    if (!wanted || !can || left <= 0) continue;
    const Taken taken = resist(place, condition_numbers(condition));
    if (taken == Taken::kRefused) {
      refused_.add(effect);
      continue;
    }
    overlaid_.add(effect);
    --left;
    all = std::max(all, taken);
  }
  return all;
}

/// From a mapping that the device does not take to the next one, with nothing of the former left.
void MappedForce::step_down() {
  for (const Place place : {kX, kY, kSpring, kDamper}) remove(place);  // Bound: kPlaces
  overlaid_ = {};
  if (kind_ == ForceKind::kForce && abilities_.axes >= 2 && abilities_.room >= 2) {
    abilities_.room = 1;
    return;
  }
  const bool constant = kind_ == ForceKind::kForce;
  refused_.add(constant ? Effect::kConstant : Effect::kRumble);
  const bool shakes = constant && abilities_.effects.has(Effect::kRumble);
  kind_ = shakes ? ForceKind::kRumble : ForceKind::kNone;
  if (!shakes) problem_ = "it takes none of its effects (" + names_of(refused_) + ")";
}

void MappedForce::note_left_out(const Feel& feel) {
  left_out_.add(refused_);
  for (const Effect effect : {Effect::kSpring, Effect::kDamper}) {  // Bound: 2
    const bool wanted = condition_of(feel, effect).coefficient > 0;
    if (wanted && (!overlaid_.has(effect) || refused_.has(effect))) left_out_.add(effect);
  }
}

}  // namespace batuta::host
