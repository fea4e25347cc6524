// SPDX-License-Identifier: MIT

#include "programs/devices/replay_device.hpp"

#include <utility>

namespace batuta::host {

ReplayDevice::ReplayDevice(Recording recording, std::string label)
    : recording_(std::move(recording)), label_(std::move(label)) {}

std::string ReplayDevice::description() const {
  if (recording_.device.empty()) return label_;
  return label_ + " (" + recording_.device + ")";
}

Status ReplayDevice::do_read(Microseconds now, InputSample& sample) {
  const std::vector<InputSample>& samples = recording_.samples;
  const std::size_t first = next_;
  while (next_ < samples.size() && !is_later(samples[next_].time, now)) ++next_;
  if (next_ == first) return Status::kUnavailable;
  sample = samples[next_ - 1];
  return Status::kOk;
}

}  // namespace batuta::host
