// SPDX-License-Identifier: MIT
#pragma once
// An open event device of the Linux input stack, with libevdev's view of it.

#include <optional>
#include <string>

#include "programs/devices/motion_axes.hpp"

struct libevdev;

namespace batuta::host {

/// Owns the file and libevdev's object; move-only.
class EvdevNode {
 public:
  EvdevNode() = default;
  EvdevNode(EvdevNode&& other) noexcept;
  EvdevNode& operator=(EvdevNode&& other) noexcept;
  EvdevNode(const EvdevNode&) = delete;
  EvdevNode& operator=(const EvdevNode&) = delete;
  ~EvdevNode() { close(); }

  /// @returns empty | why it cannot be opened, in a few words
  std::string open(const std::string& path);
  void close();

  bool is_open() const { return device_ != nullptr; }
  int file() const { return file_; }
  libevdev* device() const { return device_; }
  /// Whether its events are stamped by the clock that HostClock reads.
  bool has_clock() const { return has_clock_; }
  std::string name() const;
  /// The axes that move a sword; none: it is a keyboard, a switch, a microphone's button.
  std::optional<MotionAxes> axes() const;

 private:
  int file_ = -1;
  libevdev* device_ = nullptr;
  bool has_clock_ = false;
};

/// What could have been opened, for a message: "/dev/input/event3 (Xbox pad), /dev/input/event5 (no
/// permission)".
std::string list_evdev();

/// Of opening a device, in a few words. @param error  errno
std::string open_error_words(int error);

}  // namespace batuta::host
