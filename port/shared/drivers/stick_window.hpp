// SPDX-License-Identifier: MIT
#pragma once
// From conversions to one reading of the stick: sums in integers, so that a stick that returns
// returns to the same bits, and a look at whether a stick is there at all.

#include <cstdint>

namespace batuta::drivers {

/// Conversions of each axis in one reading: 16 of 12 bits fill 16 bits and take the noise down
/// by 4.
inline constexpr int kOversampling = 16;
inline constexpr int kAxes = 2;
inline constexpr int kWindowCounts = kOversampling * kAxes;

/// Conversions in this range are a stick. Its potentiometers are wired so that they cannot leave it
/// (see the board's note); a wiper that is off, or a supply that is, reads 0 or full scale.
inline constexpr std::uint32_t kLowestCount = 64;
inline constexpr std::uint32_t kHighestCount = 4031;

/// A reading: sums of kOversampling conversions, 0 ... 65,520.
struct StickReading {
  std::int32_t x = 0;
  std::int32_t y = 0;
  bool plausible = false;  ///< every conversion was in the range of a stick
};

/// Conversions as the scan leaves them: x, y, x, y, ...
/// Bound: kWindowCounts.
inline StickReading sum_window(const volatile std::uint16_t* counts) {
  StickReading sum;
  sum.plausible = true;
  for (int i = 0; i < kWindowCounts; ++i) {  // Bound: kWindowCounts
    const std::uint32_t count = counts[i];
    (i % kAxes == 0 ? sum.x : sum.y) += static_cast<std::int32_t>(count);
    sum.plausible = sum.plausible && count >= kLowestCount && count <= kHighestCount;
  }
  return sum;
}

/// Whether a stick is connected: gone at the first reading that is none, back after kReturnAfter
/// good ones in a row, so that a loose contact does not pass for a hand.
class Connection {
 public:
  static constexpr int kReturnAfter = 100;

  void note(bool plausible) {
    if (!plausible) {
      losses_ += connected() ? 1U : 0U;
      good_ = 0;
    } else if (good_ < kReturnAfter) {
      ++good_;
    }
  }
  bool connected() const { return good_ == kReturnAfter; }
  /// How often it went.
  std::uint32_t losses() const { return losses_; }

 private:
  int good_ = 0;
  std::uint32_t losses_ = 0;
};

}  // namespace batuta::drivers
