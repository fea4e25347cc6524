// SPDX-License-Identifier: MIT
#pragma once
// Time as a port tells it: microseconds in 32 bits, wrapping after about 71.6 minutes. The core
// reads no clock; the application in port/ reads one and hands times in.

#include <cstdint>

#include "batuta/core/assert.hpp"

namespace batuta {

/// A time stamp, us, modulo 2^32. Only differences have a meaning.
using Microseconds = std::uint32_t;

/// Length of a microsecond, s.
template <class Scalar>
inline constexpr Scalar kSecondsPerUs = Scalar(1e-6);

/// Signed time from `from` to `to`, us, correct across the wrap if they are less than 2^31 us (35.8
/// min) apart.
constexpr std::int32_t elapsed_us(Microseconds from, Microseconds to) {
  return static_cast<std::int32_t>(to - from);
}

/// Whether a is later than b, if the two are less than 2^31 us apart.
constexpr bool is_later(Microseconds a, Microseconds b) {
  return elapsed_us(b, a) > 0;
}

/// A monotonic clock. A port derives from it and implements do_now().
class Clock {
 public:
  /// The time now. Never blocks; may be called from an interrupt handler if the port says so.
  Microseconds now() { return do_now(); }

 protected:
  Clock() = default;
  ~Clock() = default;
  /// Copied only with what derives from it.
  Clock(const Clock&) = default;
  /// Copied only with what derives from it.
  Clock& operator=(const Clock&) = default;

 private:
  virtual Microseconds do_now() = 0;
};

}  // namespace batuta
