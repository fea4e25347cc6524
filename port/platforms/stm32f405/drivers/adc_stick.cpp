// SPDX-License-Identifier: MIT

#include "platforms/stm32f405/drivers/adc_stick.hpp"

#include "platforms/stm32f405/registers/gpio.hpp"

namespace batuta::stm32f405 {
namespace {

constexpr std::uint32_t kStreamSetup =
    DmaStream::kCrDmeie | DmaStream::kCrTeie | DmaStream::kCrHtie | DmaStream::kCrTcie |
    DmaStream::kCrCirc | DmaStream::kCrMinc | DmaStream::kCrPsize16 | DmaStream::kCrMsize16 |
    DmaStream::kCrPlHigh;  // channel 0, peripheral to memory

/// A stream that is disabled still ends its transfer before it takes a new setup (RM0090 10.3.17):
/// one conversion's worth at most.
constexpr int kDmaTurns = 1000;

void set_sampling(Adc& adc, unsigned channel) {
  volatile std::uint32_t& reg = channel >= 10U ? adc.smpr1 : adc.smpr2;
  const unsigned shift = 3U * (channel % 10U);
  write_field(reg, 7U << shift, Adc::kSampling84Cycles << shift);
}

}  // namespace

void AdcStick::start(unsigned x_channel, unsigned y_channel, std::uint32_t timer_hz) {
  Adc& adc = at_.adc;
  at_.common.ccr = AdcCommon::kCcrAdcpreDiv4;
  set_sampling(adc, x_channel);
  set_sampling(adc, y_channel);
  adc.sqr1 = (kAxes - 1U) << 20;
  adc.sqr3 = x_channel | (y_channel << 5);
  adc.cr1 = Adc::kCr1Scan | Adc::kCr1Ovrie;

  at_.pace.psc = 0;
  at_.pace.arr = timer_hz / kPaceHz - 1U;
  at_.pace.cr2 = Tim::kCr2MmsUpdate;
  at_.pace.egr = Tim::kEgrUg;
  start_dma();  // behind this update, which is a trigger, too
  at_.pace.cr1 = Tim::kCr1Cen;
}

void AdcStick::start_dma() {
  DmaStream& stream = at_.dma.stream[0];
  stream.cr = 0;
  for (int i = 0; i < kDmaTurns && (stream.cr & DmaStream::kCrEn) != 0; ++i) {  // Bound: kDmaTurns
  }
  at_.dma.lifcr = Dma::kStream0All;
  stream.par = bus_address(&at_.adc.dr);
  stream.m0ar = bus_address(buffer_);
  stream.ndtr = 2U * kWindowCounts;
  stream.cr = kStreamSetup | DmaStream::kCrEn;
  at_.pace.cnt = 0;  // the next trigger is a turn away: the ADC is stable 3 us after ADON (tSTAB)
  at_.adc.cr2 =
      Adc::kCr2Adon | Adc::kCr2Dma | Adc::kCr2Dds | Adc::kCr2ExtselTim3Trgo | Adc::kCr2ExtenRising;
}

void AdcStick::on_dma(Microseconds now) {
  const std::uint32_t flags = at_.dma.lisr & Dma::kStream0All;
  at_.dma.lifcr = flags;
  const bool first = (flags & Dma::kStream0Htif) != 0;
  const bool second = (flags & Dma::kStream0Tcif) != 0;
  const bool error = (flags & (Dma::kStream0Teif | Dma::kStream0Dmeif)) != 0;
  if (error) {
    on_overrun();
  } else if (first && second) {
    count_fault();  // a whole turn late: one half is being overwritten, and which is not known
  } else if (first || second) {
    take(buffer_ + (first ? 0 : kWindowCounts), now);
  }
}

void AdcStick::on_overrun() {
  count_fault();
  at_.adc.cr2 = 0;
  at_.adc.sr = ~Adc::kSrOvr;
  start_dma();  // a new turn: the channels cannot have changed places
}

void AdcStick::take(const volatile std::uint16_t* counts, Microseconds now) {
  Stamped fresh;
  fresh.reading = sum_window(counts);
  // The mean of a window is where the stick was in the middle of it.
  fresh.time = now - static_cast<Microseconds>(kWindowUs / 2);
  connection_.note(fresh.reading.plausible);
  connected_.store(connection_.connected(), std::memory_order_relaxed);
  if (connection_.connected()) latest_.put(fresh);
}

Status AdcStick::do_read(Microseconds now, InputSample& sample) {
  if (!is_connected()) return Status::kUnavailable;
  Stamped fresh;
  const std::uint32_t count = latest_.copy(fresh);
  if (count == 0 || count == read_ || is_later(fresh.time, now)) return Status::kUnavailable;
  read_ = count;
  builder_.axis(Axis::kX, fresh.reading.x);
  builder_.axis(Axis::kY, fresh.reading.y);
  const Result<InputSample> built = builder_.sync(fresh.time);
  if (!built.ok()) return built.status;
  sample = built.value;
  sample.sequence = count;  // readings that nobody asked for count as well
  return Status::kOk;
}

}  // namespace batuta::stm32f405
