// SPDX-License-Identifier: MIT
#pragma once
// A stick that is somewhere else: its samples are told, one step after the other, by whoever knows
// them.

#include <limits>
#include <optional>
#include <utility>

#include "host/devices/source.hpp"

namespace batuta::host {

class ReportedStick final : public Source {
 public:
  explicit ReportedStick(std::string description,
                         double duration = std::numeric_limits<double>::infinity())
      : description_(std::move(description)), duration_(duration) {}

  /// What the next read() gives; none: nothing new.
  void tell(const std::optional<InputSample>& sample) { sample_ = sample; }

  std::string description() const override { return description_; }
  double duration() const override { return duration_; }

 private:
  Status do_read(Microseconds /*now*/, InputSample& sample) override {
    if (!sample_) return Status::kUnavailable;
    sample = *sample_;
    sample_.reset();
    return Status::kOk;
  }

  std::string description_;
  double duration_;
  std::optional<InputSample> sample_;
};

}  // namespace batuta::host
