// SPDX-License-Identifier: MIT

#include "host/live/evdev_force.hpp"

#include <fcntl.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>

namespace batuta::host {
namespace {

/// Of a call that failed. What does not pass by itself, above all ENODEV, is a device that is to be
/// opened anew.
Rendered judge(int error) {
  switch (error) {
    case EAGAIN:
    case EBUSY:
    case EINTR:
    case ENOMEM:
    case ENOSPC:
      return Rendered::kLater;
    default:
      return Rendered::kGone;
  }
}

/// Of two effects.
Rendered worse(Rendered a, Rendered b) {
  return std::max(a, b);
}

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

}  // namespace

EvdevForce::~EvdevForce() {
  close();
}

ForceKind EvdevForce::open() {
  close();
  file_ = ::open(path_.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
  if (file_ < 0) return ForceKind::kNone;
  features_ = {};
  const bool told = ::ioctl(file_, EVIOCGBIT(EV_FF, sizeof features_), features_.data()) >= 0;
  if (!told || ::ioctl(file_, EVIOCGEFFECTS, &room_) < 0) room_ = 0;
  if (room_ > 0 && has(FF_CONSTANT)) kind_ = ForceKind::kForce;
  if (room_ > 0 && !has(FF_CONSTANT) && has(FF_RUMBLE)) kind_ = ForceKind::kRumble;
  if (kind_ == ForceKind::kNone) {
    close();
    return kind_;
  }
  constexpr std::int32_t kFullGain = 0xFFFF;
  if (has(FF_GAIN)) set(FF_GAIN, kFullGain);
  if (has(FF_AUTOCENTER)) set(FF_AUTOCENTER, 0);  // a spring that nobody has asked for
  return kind_;
}

void EvdevForce::close() {
  if (file_ >= 0) {
    for (const Slot& slot : slots_) {
      if (slot.uploaded) (void)::ioctl(file_, EVIOCRMFF, static_cast<int>(slot.effect.id));
    }
    ::close(file_);
  }
  file_ = -1;
  room_ = 0;
  slots_ = {};
  kind_ = ForceKind::kNone;
}

bool EvdevForce::has(unsigned feature) const {
  return (features_[feature / 8] >> (feature % 8) & 1U) != 0;
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
  if (!there) close();
  return there;
}

Rendered EvdevForce::render(const Feel& feel) {
  Rendered rendered = Rendered::kGone;
  if (kind_ == ForceKind::kRumble) rendered = update(slots_[kX], linux_rumble(rumble_of(feel)));
  if (kind_ == ForceKind::kForce) rendered = render_constant(feel);
  if (rendered == Rendered::kGone) close();
  return rendered;
}

Rendered EvdevForce::render_constant(const Feel& feel) {
  if (room_ < 2) {
    const PolarForce polar = polar_force(feel.x, feel.y);
    return update(slots_[kX], linux_constant(polar.direction, polar.level));
  }
  const Rendered x = update(slots_[kX], linux_constant(kPushRight, level_of(feel.x)));
  const Rendered y = update(slots_[kY], linux_constant(kPushUp, level_of(feel.y)));
  Rendered all = worse(x, y);
  int left = room_ - 2;
  const auto overlay = [&](Place place, std::uint16_t type, const Condition& condition) {
    const bool wanted = slots_[place].uploaded || condition.coefficient > 0;
    if (!wanted || left <= 0 || !has(type)) return;
    --left;
    all = worse(all, update(slots_[place], linux_condition(type, condition_numbers(condition))));
  };
  overlay(kSpring, FF_SPRING, feel.spring);
  overlay(kDamper, FF_DAMPER, feel.damper);
  return all;
}

/// Uploads an effect, or changes it where that is done already, and sees to it that it plays.
Rendered EvdevForce::update(Slot& slot, ff_effect effect) const {
  if (!slot.uploaded || !same(slot.effect, effect)) {
    effect.id = slot.uploaded ? slot.effect.id : static_cast<std::int16_t>(-1);
    if (::ioctl(file_, EVIOCSFF, &effect) < 0) return judge(errno);
    slot.effect = effect;
    slot.uploaded = true;
  }
  if (slot.playing) return Rendered::kDone;
  input_event event{};
  event.type = EV_FF;
  event.code = static_cast<std::uint16_t>(slot.effect.id);
  event.value = 1;
  slot.playing = ::write(file_, &event, sizeof event) >= 0;
  return slot.playing ? Rendered::kDone : judge(errno);
}

}  // namespace batuta::host
