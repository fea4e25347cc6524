// SPDX-License-Identifier: MIT
// The effects of a fake event device: what was uploaded, what plays, and until when.
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <limits>

#include "fake_event_device.hpp"

namespace batuta::test {

void FakeEventDevice::forget_effects() {
  const std::lock_guard<std::mutex> lock(mutex_);
  effects_.clear();
  playing_.clear();
}

void FakeEventDevice::refuse_effects(int error, unsigned type) {
  const std::lock_guard<std::mutex> lock(mutex_);
  effect_refusals_[type] = error;
}

void FakeEventDevice::drain_writes(int file) {
  const auto found = files_.find(file);
  if (found == files_.end()) return;
  input_event event{};
  while (::syscall(SYS_read, found->second, &event, sizeof event) == sizeof event) {
    if (event.type != EV_FF) continue;
    if (event.code >= FF_GAIN) {
      properties_[event.code] = event.value;
    } else {
      play(event.code, event.value);
    }
  }
}

/// From its beginning, also where it plays. As on a stick of USB (hid-pidff), whose change of a
/// level has an effect last no longer.
void FakeEventDevice::play(int effect, int times) {
  playing_.erase(effect);
  const auto found = effects_.find(effect);
  if (times == 0 || found == effects_.end()) return;
  ++plays_;
  constexpr std::int64_t kNever = std::numeric_limits<std::int64_t>::max();
  const std::int64_t length_us = std::int64_t{found->second.replay.length} * 1000;
  playing_[effect] = length_us == 0 ? kNever : time_us_ + times * length_us;
}

void FakeEventDevice::pass(std::int32_t microseconds) {
  const std::lock_guard<std::mutex> lock(mutex_);
  for (const auto& [file, end] : files_) drain_writes(file);
  time_us_ += microseconds;
  for (auto effect = playing_.begin(); effect != playing_.end();) {
    effect = effect->second <= time_us_ ? playing_.erase(effect) : std::next(effect);
  }
}

int FakeEventDevice::plays() {
  const std::lock_guard<std::mutex> lock(mutex_);
  for (const auto& [file, end] : files_) drain_writes(file);
  return plays_;
}

std::vector<ff_effect> FakeEventDevice::effects() {
  const std::lock_guard<std::mutex> lock(mutex_);
  std::vector<ff_effect> all;
  for (const auto& [id, effect] : effects_) all.push_back(effect);
  return all;
}

bool FakeEventDevice::is_playing(int effect) {
  const std::lock_guard<std::mutex> lock(mutex_);
  for (const auto& [file, end] : files_) drain_writes(file);
  return playing_.count(effect) == 1;
}

int FakeEventDevice::property(unsigned code) {
  const std::lock_guard<std::mutex> lock(mutex_);
  for (const auto& [file, end] : files_) drain_writes(file);
  const auto found = properties_.find(code);
  return found == properties_.end() ? -1 : found->second;
}

int FakeEventDevice::uploads() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return uploads_;
}

std::vector<ff_effect> FakeEventDevice::removed() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return removed_;
}

int FakeEventDevice::strongest(unsigned type) {
  const std::lock_guard<std::mutex> lock(mutex_);
  return strongest_[type];
}

int strength(const ff_effect& effect) {
  if (effect.type == FF_CONSTANT) return std::abs(int{effect.u.constant.level});
  if (effect.type == FF_RUMBLE) return effect.u.rumble.strong_magnitude;
  return std::abs(int{effect.u.condition[0].right_coeff});
}

}  // namespace batuta::test
