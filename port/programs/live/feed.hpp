// SPDX-License-Identifier: MIT
#pragma once
// A live device as its own thread sees it: it may wait, and it may ask the system. No step of a
// bout ever does; see LiveSource.

#include <cstdint>
#include <string>

#include "batuta/port/input.hpp"

namespace batuta::host {

/// What looking at a device brought.
enum class News : std::uint8_t {
  kNone,    ///< it is as it was
  kSample,  ///< it has moved, or it has just been opened
  kGone,    ///< unplugged
};

class Feed {
 public:
  Feed() = default;
  Feed(const Feed&) = delete;
  Feed& operator=(const Feed&) = delete;
  virtual ~Feed() = default;

  /// The device's own name.
  virtual std::string name() const = 0;
  /// Returns when there may be news, and after a few milliseconds in any case.
  virtual void wait() = 0;
  /// Does not wait. @param sample  the latest state, for kSample; its time is that of HostClock
  virtual News look(InputSample& sample) = 0;
  /// After kGone: looks once whether the device is back. Does not wait for it.
  /// @returns whether it is
  virtual bool reopen() = 0;
  /// Times that the device, or the system on its way, had lost events.
  virtual std::uint32_t losses() const = 0;
  /// The last call on the thread that made the others: what a library keeps for each thread goes.
  virtual void end_thread() {}
};

}  // namespace batuta::host
