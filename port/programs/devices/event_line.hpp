// SPDX-License-Identifier: MIT
#pragma once
// One line of a recording in the evemu format. libevemu's own evemu_read_event() is not used: it
// takes "12abc" for 12, wraps values beyond 32 bits, reads "1.5" as 1 s 5 us, splits "00030" into
// two fields and prints by itself; a recording with any of these would be replayed wrongly without
// a word. A test holds the two against each other.

#include <cstdint>
#include <string_view>

namespace batuta::host {

/// An event as the Linux input stack tells it: linux/input-event-codes.h names types and codes.
struct DeviceEvent {
  std::int64_t time_us = 0;
  std::uint16_t type = 0;
  std::uint16_t code = 0;
  std::int32_t value = 0;
};

enum class LineKind : std::uint8_t {
  kNothing,      ///< blank, or a comment
  kDescription,  ///< of the device: N: I: P: B: A: L: S:
  kEvent,        ///< E: and well formed
  kMalformed,    ///< anything else
};

/// Reads one line without its line feed; a carriage return at its end is ignored. `event` changes
/// for kEvent only.
LineKind read_line(std::string_view line, DeviceEvent& event);

}  // namespace batuta::host
