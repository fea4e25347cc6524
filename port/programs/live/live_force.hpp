// SPDX-License-Identifier: MIT
#pragma once
// Force on a live device. write() leaves the command in a box with room for one; a thread of its
// own speaks with the device. Silence, the end of the program and the loss of the device take the
// force away.

#include <atomic>
#include <memory>
#include <string>
#include <thread>

#include "batuta/port/force.hpp"
#include "platforms/host/clock.hpp"
#include "programs/live/force_pump.hpp"

namespace batuta::host {

class LiveForce final : public ForceDevice {
 public:
  /// Looks once whether the device has a force, and takes its time for it. One that has none is
  /// left alone from then on.
  LiveForce(std::unique_ptr<ForceBackend> backend, const ForceOptions& options);
  LiveForce(const LiveForce&) = delete;
  LiveForce& operator=(const LiveForce&) = delete;
  /// Takes the force away before it returns.
  ~LiveForce();

  /// What the device can do; kNone while it is away.
  ForceKind kind() const { return pump_.kind(); }
  /// What it could do when it was opened.
  ForceKind first_kind() const { return first_kind_; }
  /// Why it could do nothing then, in a few words; empty: it could, or is no device that has a
  /// force.
  const std::string& problem() const { return problem_; }
  const ForceReport& report() { return pump_.report(); }

 private:
  /// @returns kOk | kUnavailable: the device has no force, or is away; nothing is remembered
  Status do_write(const ForceCommand& command) override;

  HostClock clock_;
  ForcePump pump_;
  ForceKind first_kind_ = ForceKind::kNone;
  std::string problem_;
  std::atomic<bool> ending_{false};
  std::thread thread_;  // the last member: it ends before what it uses
};

/// "force", "rumble" or "none".
const char* name_of(ForceKind kind);

}  // namespace batuta::host
