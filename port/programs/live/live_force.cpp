// SPDX-License-Identifier: MIT

#include "programs/live/live_force.hpp"

#include <chrono>
#include <utility>

namespace batuta::host {

LiveForce::LiveForce(std::unique_ptr<ForceBackend> backend, const ForceOptions& options)
    : pump_(std::move(backend), options, clock_) {
  pump_.turn();
  first_kind_ = pump_.kind();
  problem_ = pump_.problem();
  if (first_kind_ == ForceKind::kNone) {
    pump_.close();
    return;
  }
  thread_ = std::thread([this] {
    constexpr std::chrono::microseconds kTurn(ForcePump::kTurn_us);
    auto next = std::chrono::steady_clock::now();
    while (!ending_) {  // Bound: until the force is destroyed
      pump_.turn();
      // What a slow device costs is not made up for by a burst.
      next = std::max(next + kTurn, std::chrono::steady_clock::now());
      std::this_thread::sleep_until(next);
    }
    pump_.drop_force();
  });
}

LiveForce::~LiveForce() {
  ending_ = true;
  if (thread_.joinable()) thread_.join();
}

Status LiveForce::do_write(const ForceCommand& command) {
  if (kind() == ForceKind::kNone) return Status::kUnavailable;
  pump_.put(command.x, command.y, command.own);
  return Status::kOk;
}

const char* name_of(ForceKind kind) {
  switch (kind) {
    case ForceKind::kForce:
      return "force";
    case ForceKind::kRumble:
      return "rumble";
    case ForceKind::kNone:
      break;
  }
  return "none";
}

}  // namespace batuta::host
