// SPDX-License-Identifier: MIT
#pragma once
// A stick of two potentiometers or Hall sensors on ADC1. TIM3 paces the conversions, DMA2 moves
// them into two halves of a buffer in turn; while one fills, the interrupt sums the other. No
// conversion costs an instruction of the program.

#include "batuta/port/sample_builder.hpp"
#include "platforms/stm32f405/drivers/latest.hpp"
#include "platforms/stm32f405/registers/adc.hpp"
#include "platforms/stm32f405/registers/dma.hpp"
#include "platforms/stm32f405/registers/tim.hpp"
#include "shared/drivers/stick_window.hpp"

namespace batuta::stm32f405 {
using namespace drivers;  // what boards share

struct StickRegisters {
  Adc& adc;
  AdcCommon& common;
  Dma& dma;
  Tim& pace;
};

/// A reading takes this long: kOversampling turns of the pace.
inline constexpr std::int32_t kWindowUs = 1000;
inline constexpr std::uint32_t kPaceHz = 1000U * kOversampling;

class AdcStick final : public InputDevice {
 public:
  /// The stick's ends and dead zone, in sums of kOversampling conversions.
  explicit AdcStick(const StickRegisters& at) : at_(at) {}

  /// @returns kOk | kInvalidArgument: a calibration is not valid; nothing changed
  Status calibrate(const AxisCalibration& x, const AxisCalibration& y) {
    return builder_.configure(x, y);
  }

  /// Starts the conversions of two channels, 0 ... 15.
  /// @param timer_hz  clock of the pacing timer
  void start(unsigned x_channel, unsigned y_channel, std::uint32_t timer_hz);

  /// From the interrupt of the DMA stream.
  /// Bound: kWindowCounts.
  void on_dma(Microseconds now);
  /// From the interrupt of the ADC: a conversion was lost, DMA has stopped (RM0090 13.8.1).
  void on_overrun();

  /// False: no stick is wired, its wires are off, or nothing has been converted yet. As the last
  /// reading said: where conversions stop later it stays, and read() has nothing new.
  bool is_connected() const { return connected_.load(std::memory_order_relaxed); }
  /// Readings that were lost or thrown away: late interrupts, errors of ADC and DMA.
  std::uint32_t faults() const { return faults_.load(std::memory_order_relaxed); }

  /// Where DMA writes; a test writes here in its stead.
  volatile std::uint16_t* buffer() { return buffer_; }

 private:
  struct Stamped {
    StickReading reading;
    Microseconds time = 0;
  };

  Status do_read(Microseconds now, InputSample& sample) override;
  void start_dma();
  void take(const volatile std::uint16_t* counts, Microseconds now);
  void count_fault() {
    faults_.store(faults_.load(std::memory_order_relaxed) + 1U, std::memory_order_relaxed);
  }

  StickRegisters at_;
  SampleBuilder builder_;
  Latest<Stamped> latest_;
  std::uint32_t read_ = 0;  ///< count of the last reading handed out
  Connection connection_;   ///< the interrupt's own
  std::atomic<bool> connected_{false};
  std::atomic<std::uint32_t> faults_{0};
  volatile std::uint16_t buffer_[2 * kWindowCounts] = {};
};

}  // namespace batuta::stm32f405
