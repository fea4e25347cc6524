// SPDX-License-Identifier: MIT
#pragma once
// What a test sees and sets behind the functions of Zephyr that the port uses.

#include <array>
#include <cstdint>

/// Zephyr leaves the type to its drivers.
struct device {
  std::uint32_t channels = 0;
};

namespace batuta::zephyr::test {

constexpr std::uint32_t kChannels = 4;

struct FakeZephyr {
  std::uint64_t ticks = 0;
  std::uint64_t ticks_per_second = 10000;         ///< Zephyr's own default
  std::array<std::uint32_t, kChannels> pulses{};  ///< ns, by channel
  std::array<bool, kChannels> refuses{};          ///< channels that answer with an error
  bool is_ready = true;
  int both_high = 0;  ///< times that both channels of a pair were pulsed
  int written = 0;
  int locks = 0;  ///< held now
};

/// There is one, as there is one kernel.
FakeZephyr& fake_zephyr();

}  // namespace batuta::zephyr::test
