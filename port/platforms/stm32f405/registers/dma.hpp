// SPDX-License-Identifier: MIT
#pragma once
// DMA controller 2: RM0090 section 10.5. This port uses stream 0, channel 0: ADC1.

#include <cstddef>
#include <cstdint>

namespace batuta::stm32f405 {

struct DmaStream {
  volatile std::uint32_t cr;
  volatile std::uint32_t ndtr;
  volatile std::uint32_t par;
  volatile std::uint32_t m0ar;
  volatile std::uint32_t m1ar;
  volatile std::uint32_t fcr;

  static constexpr std::uint32_t kCrEn = 1U << 0;
  static constexpr std::uint32_t kCrDmeie = 1U << 1;
  static constexpr std::uint32_t kCrTeie = 1U << 2;
  static constexpr std::uint32_t kCrHtie = 1U << 3;
  static constexpr std::uint32_t kCrTcie = 1U << 4;
  static constexpr std::uint32_t kCrCirc = 1U << 8;
  static constexpr std::uint32_t kCrMinc = 1U << 10;
  static constexpr std::uint32_t kCrPsize16 = 1U << 11;
  static constexpr std::uint32_t kCrMsize16 = 1U << 13;
  static constexpr std::uint32_t kCrPlHigh = 2U << 16;
};

struct Dma {
  volatile std::uint32_t lisr;
  volatile std::uint32_t hisr;
  volatile std::uint32_t lifcr;
  volatile std::uint32_t hifcr;
  DmaStream stream[8];

  // Stream 0's flags in LISR; the same bits in LIFCR clear them.
  static constexpr std::uint32_t kStream0Dmeif = 1U << 2;
  static constexpr std::uint32_t kStream0Teif = 1U << 3;
  static constexpr std::uint32_t kStream0Htif = 1U << 4;
  static constexpr std::uint32_t kStream0Tcif = 1U << 5;
  static constexpr std::uint32_t kStream0All = 0x3DU;
};
static_assert(sizeof(DmaStream) == 0x18 && offsetof(Dma, stream) == 0x10, "RM0090 10.5");

/// An address as the DMA controller wants it. The CCM at 0x10000000 is out of its reach.
inline std::uint32_t bus_address(const volatile void* object) {
  return static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(object));
}

}  // namespace batuta::stm32f405
