// SPDX-License-Identifier: MIT
#pragma once
// Analogue-to-digital converter 1: RM0090 section 13.13.

#include <cstddef>
#include <cstdint>

namespace batuta::stm32f405 {

struct Adc {
  volatile std::uint32_t sr;
  volatile std::uint32_t cr1;
  volatile std::uint32_t cr2;
  volatile std::uint32_t smpr1;
  volatile std::uint32_t smpr2;
  volatile std::uint32_t jofr[4];
  volatile std::uint32_t htr;
  volatile std::uint32_t ltr;
  volatile std::uint32_t sqr1;
  volatile std::uint32_t sqr2;
  volatile std::uint32_t sqr3;
  volatile std::uint32_t jsqr;
  volatile std::uint32_t jdr[4];
  volatile std::uint32_t dr;

  static constexpr std::uint32_t kSrOvr = 1U << 5;
  static constexpr std::uint32_t kCr1Scan = 1U << 8;
  static constexpr std::uint32_t kCr1Ovrie = 1U << 26;
  static constexpr std::uint32_t kCr2Adon = 1U << 0;
  static constexpr std::uint32_t kCr2Dma = 1U << 8;
  static constexpr std::uint32_t kCr2Dds = 1U << 9;  ///< DMA goes on after the last transfer
  static constexpr std::uint32_t kCr2ExtselTim3Trgo = 8U << 24;  ///< section 13.6
  static constexpr std::uint32_t kCr2ExtenRising = 1U << 28;
  static constexpr std::uint32_t kSampling84Cycles = 4U;  ///< code in SMPRx
  static constexpr std::uint32_t kConversionCycles = 84U + 12U;
};
static_assert(offsetof(Adc, smpr1) == 0x0C && offsetof(Adc, sqr1) == 0x2C, "RM0090 13.13");
static_assert(offsetof(Adc, sqr3) == 0x34 && offsetof(Adc, dr) == 0x4C, "RM0090 13.13");

/// Common to ADC1, ADC2 and ADC3, at ADC1 + 0x300.
struct AdcCommon {
  volatile std::uint32_t csr;
  volatile std::uint32_t ccr;

  static constexpr std::uint32_t kCcrAdcpreDiv4 = 1U << 16;
};
static_assert(offsetof(AdcCommon, ccr) == 0x04, "RM0090 13.13.16");

}  // namespace batuta::stm32f405
