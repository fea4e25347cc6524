// SPDX-License-Identifier: MIT

#include "programs/live/evdev_force.hpp"

#include <fcntl.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>

namespace batuta::host {
namespace {

bool same(const ff_condition_effect& a, const ff_condition_effect& b) {
  return a.right_coeff == b.right_coeff && a.center == b.center &&
         a.right_saturation == b.right_saturation;
}

/// Of one type: what the functions of linux_effects.hpp set.
bool same(const ff_effect& a, const ff_effect& b) {
  switch (a.type) {
    case FF_CONSTANT:
      return a.direction == b.direction && a.u.constant.level == b.u.constant.level;
    case FF_RUMBLE:
      return a.u.rumble.strong_magnitude == b.u.rumble.strong_magnitude &&
             a.u.rumble.weak_magnitude == b.u.rumble.weak_magnitude;
    default:
      return same(a.u.condition[0], b.u.condition[0]) && same(a.u.condition[1], b.u.condition[1]);
  }
}

bool has(const std::array<unsigned char, FF_CNT / 8>& features, unsigned feature) {
  return (features[feature / 8] >> (feature % 8) & 1U) != 0;
}

}  // namespace

ForceKind EvdevForce::open() {
  shut();
  file_ = ::open(path_.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
  if (file_ < 0) {
    end(why_not_opened(errno));
    return ForceKind::kNone;
  }
  if (claim_ != nullptr && !claim_->holds(number_of(file_))) {  // its name is another one's now
    shut();
    return ForceKind::kNone;
  }
  Features features{};
  if (begin(abilities(file_, features)) == ForceKind::kNone) {
    shut();
    return ForceKind::kNone;
  }
  constexpr std::int32_t kFullGain = 0xFFFF;
  if (has(features, FF_GAIN)) set(FF_GAIN, kFullGain);
  if (has(features, FF_AUTOCENTER)) set(FF_AUTOCENTER, 0);  // a spring that nobody has asked for
  return kind();
}

MappedForce::Abilities EvdevForce::abilities(int file, Features& features) {
  Abilities abilities;
  const bool told = ::ioctl(file, EVIOCGBIT(EV_FF, sizeof features), features.data()) >= 0;
  if (!told || ::ioctl(file, EVIOCGEFFECTS, &abilities.room) < 0) abilities.room = 0;
  if (has(features, FF_CONSTANT)) abilities.effects.add(Effect::kConstant);
  if (has(features, FF_SPRING)) abilities.effects.add(Effect::kSpring);
  if (has(features, FF_DAMPER)) abilities.effects.add(Effect::kDamper);
  if (has(features, FF_RUMBLE)) abilities.effects.add(Effect::kRumble);
  return abilities;
}

/// A device that may be read, and would have a force if it might be written, is worth a word; a
/// mouse is not.
std::string EvdevForce::why_not_opened(int error) const {
  if (error != EACCES && error != EPERM && error != EROFS) return {};
  const int file = ::open(path_.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  if (file < 0) return {};
  Features features{};
  const Abilities would_have = abilities(file, features);
  ::close(file);
  const bool feels =
      would_have.effects.has(Effect::kConstant) || would_have.effects.has(Effect::kRumble);
  return feels && would_have.room > 0
             ? "no permission to write to it (is the user in the group input?)"
             : std::string();
}

void EvdevForce::shut() {
  if (file_ >= 0) {
    for (const Place place : {kX, kY, kSpring, kDamper}) remove(place);  // Bound: kPlaces
    ::close(file_);
  }
  file_ = -1;
  slots_ = {};
  end({});
}

void EvdevForce::remove(Place place) {
  Slot& slot = slots_[place];
  if (slot.uploaded) (void)::ioctl(file_, EVIOCRMFF, static_cast<int>(slot.effect.id));
  slot = {};
}

/// Of the whole device. It works as well, if worse, where the device does not listen.
void EvdevForce::set(unsigned property, std::int32_t value) const {
  input_event event{};
  event.type = EV_FF;
  event.code = static_cast<std::uint16_t>(property);
  event.value = value;
  if (::write(file_, &event, sizeof event) < 0) return;
}

bool EvdevForce::is_there() {
  int version = 0;
  const bool there = file_ >= 0 && ::ioctl(file_, EVIOCGVERSION, &version) >= 0;
  if (!there) shut();
  return there;
}

/// Of a call that failed. What does not pass by itself is a refusal where the device still answers.
MappedForce::Taken EvdevForce::judge(int error) const {
  switch (error) {
    case EAGAIN:
    case EBUSY:
    case EINTR:
    case ENOMEM:
      return Taken::kLater;
    default:
      break;
  }
  int version = 0;
  return ::ioctl(file_, EVIOCGVERSION, &version) >= 0 ? Taken::kRefused : Taken::kGone;
}

MappedForce::Taken EvdevForce::push_axis(Place axis, std::int16_t level) {
  return update(axis, linux_constant(axis == kX ? kPushRight : kPushUp, level));
}

MappedForce::Taken EvdevForce::push_both(float x, float y) {
  const PolarForce polar = polar_force(x, y);
  return update(kX, linux_constant(polar.direction, polar.level));
}

MappedForce::Taken EvdevForce::resist(Place place, const ConditionPair& condition) {
  return update(place, linux_condition(place == kSpring ? FF_SPRING : FF_DAMPER, condition));
}

MappedForce::Taken EvdevForce::shake(const Rumble& rumble) {
  if (rumble.strong + rumble.weak > 0) return update(kX, linux_rumble(rumble));
  // Motors at zero would do, if every driver heard it of an effect that plays.
  const Taken stopped = play(kX, false);
  return std::max(stopped, upload(kX, linux_rumble(rumble)));
}

/// Uploads an effect, or changes it where that is done already, and sees to it that it plays. A
/// driver that cannot change an effect may have it anew. Whether a change has an effect last anew
/// differs between drivers (ff-memless: yes, hid-pidff: no); that it is played does so everywhere.
MappedForce::Taken EvdevForce::update(Place place, const ff_effect& effect) {
  const bool was_there = slots_[place].uploaded;
  Taken taken = upload(place, effect);
  if (taken == Taken::kRefused && was_there) {
    remove(place);
    taken = upload(place, effect);
  }
  return taken == Taken::kDone ? play(place, true) : taken;
}

MappedForce::Taken EvdevForce::upload(Place place, ff_effect effect) {
  Slot& slot = slots_[place];
  if (slot.uploaded && same(slot.effect, effect)) return Taken::kDone;
  effect.id = slot.uploaded ? slot.effect.id : static_cast<std::int16_t>(-1);
  if (::ioctl(file_, EVIOCSFF, &effect) < 0) return judge(errno);
  slot.effect = effect;
  slot.uploaded = true;
  return Taken::kDone;
}

MappedForce::Taken EvdevForce::play(Place place, bool on) {
  Slot& slot = slots_[place];
  if (slot.playing == on && !(on && renews())) return Taken::kDone;
  input_event event{};
  event.type = EV_FF;
  event.code = static_cast<std::uint16_t>(slot.effect.id);
  event.value = on ? 1 : 0;
  if (::write(file_, &event, sizeof event) < 0) return judge(errno);
  slot.playing = on;
  return Taken::kDone;
}

}  // namespace batuta::host
