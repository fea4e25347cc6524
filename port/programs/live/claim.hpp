// SPDX-License-Identifier: MIT
#pragma once
// Which device of the system a fencer has. Two fencers do not share one, whatever names they call
// it by; and a force goes to the device that is read, not to another that has taken its name.

#include <atomic>
#include <cstdint>
#include <string>

namespace batuta::host {

/// What the system calls a device, whatever its path; kNoDevice: it has no number.
using DeviceNumber = std::uint64_t;
inline constexpr DeviceNumber kNoDevice = 0;

/// Of an open file; kNoDevice if it is no device.
DeviceNumber number_of(int file);
/// Of what a path leads to, by way of links.
DeviceNumber number_at(const std::string& path);

class Claim {
 public:
  Claim() = default;
  Claim(const Claim&) = delete;
  Claim& operator=(const Claim&) = delete;
  ~Claim() { release(); }

  /// In place of the device that this had before. A device without a number is nobody's, and
  /// everybody may have it. @returns whether nobody else has it
  bool take(DeviceNumber device);
  void release();
  /// Of any thread.
  bool holds(DeviceNumber device) const {
    return device_.load(std::memory_order_relaxed) == device;
  }

 private:
  std::atomic<DeviceNumber> device_{kNoDevice};
};

}  // namespace batuta::host
