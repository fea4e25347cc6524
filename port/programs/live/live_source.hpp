// SPDX-License-Identifier: MIT
#pragma once
// A live stick, pad or mouse as a fencer's source. A thread of its own speaks with the device;
// read() takes what that thread saw last, and never waits.

#include <atomic>
#include <functional>
#include <memory>
#include <string>
#include <thread>

#include "platforms/host/clock.hpp"
#include "programs/devices/source.hpp"
#include "programs/live/feed_pump.hpp"
#include "programs/live/live_force.hpp"

namespace batuta::host {

class LiveSource final : public Source {
 public:
  using MakeForce = std::function<std::unique_ptr<ForceBackend>()>;

  /// @param feed   open
  /// @param make_force  the way back into the hand, called when it is first asked for
  LiveSource(std::string label, std::unique_ptr<Feed> feed, MakeForce make_force);
  LiveSource(const LiveSource&) = delete;
  LiveSource& operator=(const LiveSource&) = delete;
  ~LiveSource() override;

  std::string description() const override { return description_; }
  /// Infinite: somebody may always move it, or plug it in again.
  double duration() const override;
  std::uint32_t losses() const override { return pump_.losses(); }
  std::uint32_t unplugs() const override { return pump_.unplugs(); }
  bool is_live() const override { return true; }
  LiveForce* force(const ForceOptions& options) override;

 private:
  /// Samples carry the time of the bout: that of the device, moved by a difference that is fixed
  /// when a bout begins, and never later than `now`. Bound: no loop.
  Status do_read(Microseconds now, InputSample& sample) override;

  std::string description_;
  HostClock clock_;
  FeedPump pump_;
  MakeForce make_force_;
  std::unique_ptr<LiveForce> force_;
  Microseconds offset_ = 0;  ///< time of the bout minus that of the host
  Microseconds latest_now_ = 0;
  bool started_ = false;
  std::atomic<bool> ending_{false};
  std::thread thread_;  // the last member: it ends before what it uses
};

}  // namespace batuta::host
