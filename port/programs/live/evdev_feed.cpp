// SPDX-License-Identifier: MIT

#include "programs/live/evdev_feed.hpp"

#include <libevdev/libevdev.h>
#include <poll.h>

#include <cerrno>
#include <utility>

#include "platforms/host/clock.hpp"

namespace batuta::host {
namespace {

/// Of the kernel's stamp, where that is of the clock that HostClock reads.
Microseconds time_of(const input_event& event) {
  const auto seconds = static_cast<std::uint64_t>(event.input_event_sec);
  const auto micros = static_cast<std::uint64_t>(event.input_event_usec);
  return static_cast<Microseconds>(seconds * 1'000'000 + micros);  // modulo 2^32, as agreed
}

}  // namespace

std::string EvdevFeed::open() {
  close();
  std::string problem = node_.open(path_);
  if (!problem.empty()) return problem;
  const std::optional<MotionAxes> axes = node_.axes();
  const std::string name = node_.name();
  if (!axes) {
    close();
    return name + " is no stick, pad or mouse";
  }
  if (!claim_->take(number_of(node_.file()))) {
    close();
    return name + " is the other fencer's already";
  }
  name_ = name;
  decoder_.emplace(*axes);
  syncing_ = false;
  tell_state(*axes);
  return {};
}

void EvdevFeed::close() {
  node_.close();
  claim_->release();
}

/// The device speaks when something changes; where its axes are now, libevdev has asked.
void EvdevFeed::tell_state(const MotionAxes& axes) {
  HostClock clock;
  const Microseconds now = clock.now();
  const auto tell = [&](unsigned type, unsigned code, int value) {
    DeviceEvent event;
    event.type = static_cast<std::uint16_t>(type);
    event.code = static_cast<std::uint16_t>(code);
    event.value = value;
    return decoder_->decode(event, now);
  };
  const auto value_of = [&](unsigned type, unsigned code) {
    return libevdev_get_event_value(node_.device(), type, code);
  };
  if (axes.type == EV_ABS && !axes.fingers) {
    (void)tell(EV_ABS, axes.code_x, value_of(EV_ABS, axes.code_x));
    (void)tell(EV_ABS, axes.code_y, value_of(EV_ABS, axes.code_y));
  }
  if (axes.feet) {
    (void)tell(EV_ABS, axes.feet->code_x, value_of(EV_ABS, axes.feet->code_x));
    (void)tell(EV_ABS, axes.feet->code_y, value_of(EV_ABS, axes.feet->code_y));
  }
  for (unsigned code = BTN_MISC; code <= BTN_GEAR_UP; ++code) {  // Bound: the buttons there are
    if (value_of(EV_KEY, code) != 0) (void)tell(EV_KEY, code, 1);
  }
  const Result<InputSample> state = tell(EV_SYN, SYN_REPORT, 0);
  first_.reset();
  if (state.ok()) first_ = state.value;
}

void EvdevFeed::wait() {
  constexpr int kLongest_ms = 5;
  pollfd file{node_.file(), POLLIN, 0};
  (void)::poll(&file, 1, kLongest_ms);
}

News EvdevFeed::look(InputSample& sample) {
  bool moved = first_.has_value();
  if (moved) sample = *first_;
  first_.reset();
  drained_ = false;
  for (int i = 0; i < kMostEvents && !drained_; ++i) {  // Bound: kMostEvents
    const News news = next_event(sample);
    if (news == News::kGone) return news;
    moved = moved || news == News::kSample;
  }
  return moved ? News::kSample : News::kNone;
}

News EvdevFeed::next_event(InputSample& sample) {
  input_event event{};
  const unsigned flag = syncing_ ? LIBEVDEV_READ_FLAG_SYNC : LIBEVDEV_READ_FLAG_NORMAL;
  const int answer = libevdev_next_event(node_.device(), flag, &event);
  if (answer == -EAGAIN || answer == -EINTR) {  // all read, or all told of what was lost
    drained_ = !syncing_ || answer == -EINTR;
    if (answer == -EAGAIN) syncing_ = false;
    return News::kNone;
  }
  if (answer < 0) {  // ENODEV, or a device that cannot be understood any more
    close();
    return News::kGone;
  }
  if (answer == LIBEVDEV_READ_STATUS_SYNC && !syncing_) {  // SYN_DROPPED
    ++losses_;
    syncing_ = true;
    return News::kNone;
  }
  return decode(event, sample) ? News::kSample : News::kNone;
}

bool EvdevFeed::decode(const input_event& event, InputSample& sample) {
  DeviceEvent told;
  told.type = event.type;
  told.code = event.code;
  told.value = event.value;
  // Modulo 2^32 a stamp of another clock lies as often in the past as in the future.
  const Microseconds time = node_.has_clock() ? time_of(event) : HostClock().now();
  const Result<InputSample> decoded = decoder_->decode(told, time);
  if (decoded.ok()) sample = decoded.value;
  return decoded.ok();
}

}  // namespace batuta::host
