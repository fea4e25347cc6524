// SPDX-License-Identifier: MIT
#pragma once
// A recording that plays: at any time, the latest sample up to then.

#include "programs/devices/recording.hpp"
#include "programs/devices/source.hpp"

namespace batuta::host {

/// Plays from now = 0. Allocates nothing after construction.
class ReplayDevice final : public Source {
 public:
  /// @param label  for description()
  ReplayDevice(Recording recording, std::string label);

  std::string description() const override;
  double duration() const override { return recording_.duration; }
  std::uint32_t losses() const override { return recording_.losses; }
  void rewind() override { next_ = 0; }

 private:
  /// Bound: the samples between two calls.
  Status do_read(Microseconds now, InputSample& sample) override;

  Recording recording_;
  std::string label_;
  std::size_t next_ = 0;
};

}  // namespace batuta::host
