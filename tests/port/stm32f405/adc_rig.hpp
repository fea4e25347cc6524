// SPDX-License-Identifier: MIT
#pragma once
// An ADC stick on plain memory, and a hand that does what DMA and its interrupt do.

#include "platforms/stm32f405/drivers/adc_stick.hpp"

namespace batuta::stm32f405::test {

struct AdcRig {
  static constexpr AxisCalibration kAxis{AxisKind::kAbsolute, false, 1024, 64496, 400};

  AdcRig() { (void)stick.calibrate(kAxis, kAxis); }

  /// A half of the buffer is filled, and the interrupt comes `late_us` after the last conversion.
  void convert(std::uint16_t x, std::uint16_t y, std::int32_t late_us = 0) {
    volatile std::uint16_t* counts = stick.buffer() + (second ? kWindowCounts : 0);
    for (int i = 0; i < kWindowCounts; i += kAxes) {
      counts[i] = x;
      counts[i + 1] = y;
    }
    dma.lisr = second ? Dma::kStream0Tcif : Dma::kStream0Htif;
    second = !second;
    now += static_cast<Microseconds>(kWindowUs + late_us);
    stick.on_dma(now);
    dma.lisr = 0;
  }
  /// Enough good readings for the stick to count as connected.
  void connect() {
    for (int i = 0; i < Connection::kReturnAfter; ++i) convert(2048, 2048);
  }

  Adc adc{};
  AdcCommon common{};
  Dma dma{};
  Tim pace{};
  AdcStick stick{{adc, common, dma, pace}};
  Microseconds now = 0;
  bool second = false;
};

}  // namespace batuta::stm32f405::test
