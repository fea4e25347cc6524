// SPDX-License-Identifier: MIT
#pragma once
// Some engines' loops have no counter. A call that does not come back ends the program with a note
// that says which engine and which query, instead of hanging a night's run.

#include <cstdint>

namespace batuta::peers {

inline constexpr unsigned kPatience_s = 30;  ///< for one call
inline constexpr int kStuckExitCode = 3;

/// Watches from its construction to its end. One at a time. The words must outlive it.
class Watchdog {
 public:
  Watchdog(const char* peer, const char* family, std::uint64_t index);
  Watchdog(const Watchdog&) = delete;
  Watchdog(Watchdog&&) = delete;
  Watchdog& operator=(const Watchdog&) = delete;
  Watchdog& operator=(Watchdog&&) = delete;
  ~Watchdog();
};

}  // namespace batuta::peers
