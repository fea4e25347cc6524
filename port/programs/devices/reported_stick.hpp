// SPDX-License-Identifier: MIT
#pragma once
// A stick that is somewhere else: its samples are told, one step after the other, by whoever knows
// them.

#include <limits>
#include <optional>
#include <utility>

#include "programs/devices/source.hpp"

namespace batuta::host {

class ReportedStick final : public Source {
 public:
  /// @param behind  the device that it stands for, which knows what was lost; outlives this
  explicit ReportedStick(std::string description,
                         double duration = std::numeric_limits<double>::infinity(),
                         const Source* behind = nullptr)
      : description_(std::move(description)), duration_(duration), behind_(behind) {}

  /// What the next read() gives; none: nothing new.
  void tell(const std::optional<InputSample>& sample) { sample_ = sample; }

  std::string description() const override { return description_; }
  double duration() const override { return duration_; }
  std::uint32_t losses() const override { return behind_ == nullptr ? 0 : behind_->losses(); }
  std::uint32_t unplugs() const override { return behind_ == nullptr ? 0 : behind_->unplugs(); }

 private:
  Status do_read(Microseconds /*now*/, InputSample& sample) override {
    if (!sample_) return Status::kUnavailable;
    sample = *sample_;
    sample_.reset();
    return Status::kOk;
  }

  std::string description_;
  double duration_;
  const Source* behind_;
  std::optional<InputSample> sample_;
};

}  // namespace batuta::host
