// SPDX-License-Identifier: MIT

#include "programs/live/force_pump.hpp"

#include <algorithm>
#include <cstdlib>

namespace batuta::host {
namespace {

/// A motor that shakes takes some 50 ms to be felt: a blow fades over that time, not in one step.
constexpr float kFade = 10000.0F / 50000.0F;  // of the range, for each rumble

/// Also where a stopped program has slept for more than half of what two times may differ by.
std::int64_t passed_us(Microseconds since, Microseconds now) {
  return static_cast<Microseconds>(now - since);
}

bool same(const Rumble& a, const Rumble& b) {
  return a.strong == b.strong && a.weak == b.weak;
}

}  // namespace

void ForcePump::put(float x, float y, float own) {
  const float size = size_of(x, y);
  float seen = hardest_.load(std::memory_order_relaxed);
  // Bound: the other thread takes it at most once in the meantime.
  while (seen < size && !hardest_.compare_exchange_weak(seen, size, std::memory_order_relaxed)) {
  }
  commands_.put({x, y, own, clock_.now()});
}

void ForcePump::turn() {
  const Microseconds now = clock_.now();
  if (!attach(now)) return;
  take_command(now);
  const Feel next = feel();
  if (is_due(next, now)) {
    send(next, now);
  } else {
    look_after(now);
  }
}

void ForcePump::drop_force() {
  if (kind() != ForceKind::kNone) (void)backend_->render({});
  kind_ = ForceKind::kNone;
  backend_->end_thread();
}

bool ForcePump::attach(Microseconds now) {
  if (kind() != ForceKind::kNone) return true;
  if (has_tried_ && elapsed_us(tried_, now) < kRetry_us) return false;
  has_tried_ = true;
  tried_ = now;
  if (given_up_ && is_given_up()) return false;
  kind_ = backend_->open();
  applied_ = false;
  busy_ = false;
  sent_at_ = now - kRumblePeriod_us;  // it need not wait
  renewed_at_ = now - kRefresh_us;
  held_ = 0;
  hardest_ = 0.0F;
  return kind() != ForceKind::kNone;
}

/// A device that takes nothing is not asked again before it has been plugged in anew.
bool ForcePump::is_given_up() {
  given_up_ = backend_->is_there();
  if (!given_up_) lose();
  return given_up_;
}

void ForcePump::take_command(Microseconds now) {
  if (commands_.take(command_)) {
    fresh_ = true;
    silent_ = false;
  }
  if (!silent_ && elapsed_us(command_.time, now) > kSilence_us) {
    silent_ = true;
    if (size_of(command_.x, command_.y) > 0) ++report_.silences;
    command_.x = 0;
    command_.y = 0;
  }
  const float hardest = hardest_.exchange(0.0F, std::memory_order_relaxed);
  held_ = is_off() ? 0.0F : std::max(held_, hardest);
}

Feel ForcePump::feel() const {
  if (silent_) return {};
  Feel feel = {command_.x, command_.y, held_, options_.spring, options_.damper};
  feel.spring.coefficient *= command_.own;
  feel.damper.coefficient *= command_.own;
  return feel;
}

bool ForcePump::has_changed(const Feel& feel) const {
  if (!applied_) return true;
  if (kind() == ForceKind::kRumble) return !same(rumble_of(feel), rumble_of(sent_));
  return level_of(feel.x) != level_of(sent_.x) || level_of(feel.y) != level_of(sent_.y) ||
         level_of(feel.spring.coefficient) != level_of(sent_.spring.coefficient) ||
         level_of(feel.damper.coefficient) != level_of(sent_.damper.coefficient);
}

bool ForcePump::is_felt(const Feel& feel) const {
  if (kind() == ForceKind::kRumble) {
    const Rumble motors = rumble_of(feel);
    return motors.strong + motors.weak > 0;
  }
  return level_of(feel.x) != 0 || level_of(feel.y) != 0 || feel.spring.coefficient > 0 ||
         feel.damper.coefficient > 0;
}

/// What is not felt may end.
bool ForcePump::is_to_renew(const Feel& feel, Microseconds now) const {
  return is_felt(feel) && passed_us(renewed_at_, now) >= kRefresh_us;
}

bool ForcePump::is_due(const Feel& feel, Microseconds now) const {
  if (is_off() && has_changed(feel)) return true;
  if (kind() == ForceKind::kRumble && passed_us(sent_at_, now) < kRumblePeriod_us) return false;
  return has_changed(feel) || is_to_renew(feel, now);
}

/// Switched off, which is more than a force that happens to be zero: nothing fades, nothing waits.
bool ForcePump::is_off() const {
  return silent_ || (command_.own <= 0 && size_of(command_.x, command_.y) <= 0);
}

void ForcePump::send(const Feel& feel, Microseconds now) {
  const bool changed = has_changed(feel);
  const bool renewed = is_to_renew(feel, now);
  if (renewed) backend_->renew();
  const Rendered rendered = backend_->render(feel);
  tried_ = now;
  if (rendered != Rendered::kDone) {
    settle(rendered, now);
    return;
  }
  busy_ = false;
  kind_ = backend_->kind();
  report_.kind = kind();
  report_.left_out.add(backend_->left_out());
  measure(changed, now);
  sent_ = feel;
  sent_at_ = now;
  if (renewed) renewed_at_ = now;
  applied_ = true;
  fresh_ = false;
  held_ = std::max(0.0F, held_ - kFade);
  reports_.put(report_);
}

/// What was not rendered.
void ForcePump::settle(Rendered rendered, Microseconds now) {
  applied_ = false;
  if (rendered == Rendered::kLater) {
    stall(now);
  } else if (rendered == Rendered::kRefused) {
    given_up_ = true;
    kind_ = ForceKind::kNone;
    report_.kind = ForceKind::kNone;
    report_.left_out.add(backend_->left_out());
    reports_.put(report_);
  } else {
    lose();
  }
}

/// A busy device keeps the force that it has; closed, it loses it.
void ForcePump::stall(Microseconds now) {
  if (!busy_) busy_since_ = now;
  busy_ = true;
  kind_ = backend_->kind();
  if (elapsed_us(busy_since_, now) <= kSilence_us) return;
  backend_->close();
  kind_ = ForceKind::kNone;
  ++report_.stalls;
  reports_.put(report_);
}

/// A device that is plugged in anew must not wait for the next blow to be noticed.
void ForcePump::look_after(Microseconds now) {
  // Kept young: after an hour without a word, the difference of two wrapping times is another.
  if (passed_us(sent_at_, now) > kSilence_us) sent_at_ = now - kSilence_us;
  if (passed_us(renewed_at_, now) > kSilence_us) renewed_at_ = now - kSilence_us;
  if (elapsed_us(tried_, now) < kRetry_us) return;
  tried_ = now;
  if (!backend_->is_there()) lose();
}

void ForcePump::lose() {
  kind_ = ForceKind::kNone;
  ++report_.unplugs;
  reports_.put(report_);
}

void ForcePump::measure(bool changed, Microseconds now) {
  ++report_.sent;
  const std::int32_t period_us = elapsed_us(sent_at_, now);
  if (report_.sent > 1 && changed && period_us < kRefresh_us) {  // longer: nothing had to be said
    const std::int32_t meant_us = kind() == ForceKind::kRumble ? kRumblePeriod_us : kTurn_us;
    ++sums_.periods;
    sums_.period_us += period_us;
    sums_.jitter_us += std::abs(period_us - meant_us);
    report_.worst_period_us = std::max(report_.worst_period_us, period_us);
    report_.mean_period_us = sums_.period_us / sums_.periods;
    report_.jitter_us = sums_.jitter_us / sums_.periods;
  }
  if (!fresh_) return;
  const std::int32_t age_us = elapsed_us(command_.time, clock_.now());
  ++sums_.ages;
  sums_.age_us += age_us;
  report_.worst_age_us = std::max(report_.worst_age_us, age_us);
  report_.mean_age_us = sums_.age_us / sums_.ages;
}

const ForceReport& ForcePump::report() {
  (void)reports_.take(read_report_);
  return read_report_;
}

}  // namespace batuta::host
