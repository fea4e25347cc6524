// SPDX-License-Identifier: MIT
#include "batuta/control/stick.hpp"

#include <initializer_list>

namespace batuta {
namespace {

/// Longest way along one axis of the square.
template <class Scalar>
constexpr Scalar kFullMovement = Scalar(2);

template <class Scalar>
constexpr Scalar seconds(std::int32_t time_us) {
  return static_cast<Scalar>(time_us) * kSecondsPerUs<Scalar>;
}

}  // namespace

Status validate(const StickSettings& settings) {
  const bool ordered = settings.min_interval_us > 0 &&
                       settings.max_interval_us >= settings.min_interval_us &&
                       settings.stale_after_us >= settings.max_interval_us &&
                       settings.stale_after_us <= kLongestSilenceUs;
  const bool fast_enough =
      is_finite(settings.max_speed) &&
      settings.max_speed * seconds<float>(settings.stale_after_us) >= kFullMovement<float>;
  return ordered && fast_enough ? Status::kOk : Status::kInvalidArgument;
}

template <class Scalar>
Status StickTracker<Scalar>::configure(const StickSettings& settings) {
  const Status status = validate(settings);
  if (status != Status::kOk) return status;
  *this = StickTracker();
  settings_ = settings;
  return Status::kOk;
}

/// Whether what was read is a state to go on from.
template <class Scalar>
bool StickTracker<Scalar>::is_sound() const {
  bool good = validate(settings_) == Status::kOk;
  const Vec2<Scalar> feet(static_cast<Scalar>(last_.feet_x), static_cast<Scalar>(last_.feet_y));
  for (const Vec2<Scalar>& place : {position_, goal_, feet}) {  // Bound: 3
    good = good && std::abs(place.x()) <= Scalar(1) && std::abs(place.y()) <= Scalar(1);
  }
  return good && is_finite(remaining_) && is_finite(silence_);
}

template <class Scalar>
SampleUse StickTracker<Scalar>::judge(const InputSample& sample) const {
  for (const float at : {sample.x, sample.y, sample.feet_x, sample.feet_y}) {  // Bound: 4
    if (!is_finite(at)) return SampleUse::kInvalid;
  }
  if (!started_) return SampleUse::kRestart;
  if (sample.time == last_.time) return SampleUse::kRepeated;
  if (stale_) return SampleUse::kRestart;  // a device whose clock was set back is believed again
  return is_later(sample.time, last_.time) ? SampleUse::kUsed : SampleUse::kBackward;
}

template <class Scalar>
SampleUse StickTracker<Scalar>::accept(const InputSample& sample) {
  const SampleUse use = judge(sample);
  switch (use) {
    case SampleUse::kInvalid:
      ++report_.invalid;
      follow(sample);
      return use;
    case SampleUse::kBackward:
      ++report_.backward;
      follow(sample);
      return use;
    case SampleUse::kRepeated:
      ++report_.repeated;
      follow(sample);
      if (stale_) return use;
      keep(sample);
      aim(sample, max_of(remaining_, seconds<Scalar>(settings_.min_interval_us)));
      return use;
    case SampleUse::kRestart:
      ++report_.restarts;
      aim(sample, seconds<Scalar>(settings_.max_interval_us));
      break;
    case SampleUse::kUsed:
      aim(sample, seconds<Scalar>(clamp(elapsed_us(last_.time, sample.time),
                                        settings_.min_interval_us, settings_.max_interval_us)));
      follow(sample);
      break;
  }
  ++report_.used;
  last_.time = sample.time;
  last_.sequence = sample.sequence;
  last_.x = static_cast<float>(goal_.x());  // what it said may be beyond what restore() takes
  last_.y = static_cast<float>(goal_.y());
  keep(sample);
  silence_ = 0;
  stale_ = false;
  started_ = true;
  return use;
}

/// What holds from now on, without a way to it.
template <class Scalar>
void StickTracker<Scalar>::keep(const InputSample& sample) {
  last_.buttons = sample.buttons;
  last_.feet_x = clamp(sample.feet_x, -1.0F, 1.0F);
  last_.feet_y = clamp(sample.feet_y, -1.0F, 1.0F);
}

/// Counts the samples between the last one and this one that never came; none where the numbering
/// went back or began anew.
template <class Scalar>
void StickTracker<Scalar>::follow(const InputSample& sample) {
  const std::uint32_t advance = sample.sequence - last_.sequence;
  const bool forward = advance != 0 && static_cast<std::int32_t>(advance) > 0;
  if (!started_ || !forward) return;
  report_.lost += advance - 1;
  last_.sequence = sample.sequence;
}

template <class Scalar>
void StickTracker<Scalar>::aim(const InputSample& sample, Scalar duration) {
  const Vec2<Scalar> asked(static_cast<Scalar>(sample.x), static_cast<Scalar>(sample.y));
  goal_ = {clamp(asked.x(), Scalar(-1), Scalar(1)), clamp(asked.y(), Scalar(-1), Scalar(1))};
  if (goal_ != asked) ++report_.clamped;

  const Scalar shortest = shortest_way();
  if (shortest > duration) ++report_.slowed;
  remaining_ = max_of(duration, shortest);
}

/// Time to the goal at max_speed.
template <class Scalar>
Scalar StickTracker<Scalar>::shortest_way() const {
  const Vec2<Scalar> way = (goal_ - position_).cwiseAbs();
  return max_of(way.x(), way.y()) / static_cast<Scalar>(settings_.max_speed);
}

template <class Scalar>
void StickTracker<Scalar>::start_from_centre() {
  position_ = Vec2<Scalar>::Zero();
  velocity_ = Vec2<Scalar>::Zero();
  remaining_ = shortest_way();
}

template <class Scalar>
void StickTracker<Scalar>::advance(Scalar dt, StickFollow follow) {
  BATUTA_ASSERT(is_finite(dt) && dt > Scalar(0));
  const Scalar limit = seconds<Scalar>(settings_.stale_after_us);
  silence_ = min_of(silence_ + dt, limit);
  stale_ = !started_ || silence_ >= limit;
  if (stale_) {
    ++report_.stale_steps;
    goal_ = position_;
  }

  const Vec2<Scalar> before = position_;
  if (remaining_ > dt) {
    position_ += (dt / remaining_) * (goal_ - position_);
    remaining_ -= dt;
  } else {
    position_ = goal_;
    remaining_ = 0;
  }
  if (follow == StickFollow::kBack) {
    const Scalar furthest = before.y() - dt * static_cast<Scalar>(settings_.max_speed);
    position_ = {before.x(), min_of(before.y(), max_of(goal_.y(), furthest))};
    remaining_ = max_of(remaining_, shortest_way());
  }
  velocity_ = (position_ - before) / dt;
}

#define BATUTA_INSTANTIATE(S) template class StickTracker<S>;
BATUTA_FOR_EACH_SCALAR(BATUTA_INSTANTIATE)
#undef BATUTA_INSTANTIATE

}  // namespace batuta
