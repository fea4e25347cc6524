// SPDX-License-Identifier: MIT
#pragma once
// The link's serial line: a ring each way, emptied and filled by the interrupt of USART1.

#include "platforms/cortex_m/byte_ring.hpp"
#include "platforms/stm32f405/registers/usart.hpp"
#include "shared/link/byte_stream.hpp"

namespace batuta::stm32f405 {

/// What went wrong on the line; each costs bytes, never more: the link's CRC sees to the rest.
struct UsartFaults {
  std::uint32_t overruns = 0;  ///< the interrupt came too late for a byte
  std::uint32_t framing = 0;   ///< no stop bit: a wrong rate, or a line that was pulled
  std::uint32_t noise = 0;     ///< the samples of a bit differed; its byte is dropped
  std::uint32_t full = 0;      ///< nobody read in time; the newest byte is dropped
};

class UsartStream final : public link::ByteStream {
 public:
  /// 3 ms of the line at 3 Mbit/s; a tick of 1 ms reads at most 300.
  static constexpr std::uint32_t kReceiveBytes = 1024;
  static constexpr std::uint32_t kTransmitBytes = 2048;

  explicit UsartStream(Usart& usart) : usart_(usart) {}

  /// 8 bits, no parity, one stop bit. @param brr  see brr_of()
  void start(std::uint32_t brr);

  /// From the interrupt. Bound: one byte each way.
  void on_interrupt();

  /// Counts since the start; the interrupt may be about to add to them.
  UsartFaults faults() const;

 private:
  int do_read(std::uint8_t* bytes, int capacity) override;
  int do_write(const std::uint8_t* bytes, int count) override;
  void receive(std::uint32_t status);
  void transmit();

  Usart& usart_;
  cortex_m::ByteRing<kReceiveBytes> received_;
  cortex_m::ByteRing<kTransmitBytes> to_send_;
  // Written by the interrupt alone.
  volatile std::uint32_t overruns_ = 0;
  volatile std::uint32_t framing_ = 0;
  volatile std::uint32_t noise_ = 0;
  volatile std::uint32_t full_ = 0;
};

}  // namespace batuta::stm32f405
