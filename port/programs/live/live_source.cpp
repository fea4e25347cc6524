// SPDX-License-Identifier: MIT

#include "programs/live/live_source.hpp"

#include <limits>
#include <utility>

namespace batuta::host {

LiveSource::LiveSource(std::string label, std::unique_ptr<Feed> feed, MakeForce make_force)
    : description_(std::move(label) + " (" + feed->name() + ")"),
      pump_(std::move(feed)),
      make_force_(std::move(make_force)) {
  thread_ = std::thread([this] {
    HostClock clock;
    while (!ending_) {  // Bound: until the source is destroyed
      pump_.turn(clock.now());
      pump_.wait();
    }
    pump_.end_thread();
  });
}

LiveSource::~LiveSource() {
  force_.reset();  // lets go of the stick before the device is closed
  ending_ = true;
  thread_.join();
}

double LiveSource::duration() const {
  return std::numeric_limits<double>::infinity();
}

LiveForce* LiveSource::force(const ForceOptions& options) {
  if (!force_ && make_force_) force_ = std::make_unique<LiveForce>(make_force_(), options);
  return force_.get();
}

Status LiveSource::do_read(Microseconds now, InputSample& sample) {
  const bool begins = !started_ || is_later(latest_now_, now);  // another bout: from 0 again
  if (begins) offset_ = now - clock_.now();
  started_ = true;
  latest_now_ = now;
  if (!pump_.take(sample)) return Status::kUnavailable;
  sample.time += offset_;  // modulo 2^32: right however long ago the bout began
  if (is_later(sample.time, now)) sample.time = now;
  return Status::kOk;
}

}  // namespace batuta::host
