// SPDX-License-Identifier: MIT
#pragma once
// UART 0 of the board, a CMSDK APB UART (Arm DDI 0479), 8N1: the link's byte stream.

#include <cstdint>

#include "platforms/cortex_m/byte_ring.hpp"
#include "shared/link/byte_stream.hpp"

namespace batuta::mps2 {

/// Both directions by interrupt, through a ring each. One object; call from one context, not from
/// an interrupt. Never blocks: what does not fit is not taken (write) or counted (receive).
class Uart final : public link::ByteStream {
 public:
  static constexpr std::uint16_t kReceiveCapacity = 512;
  static constexpr std::uint16_t kTransmitCapacity = 1024;

  Uart() = default;
  Uart(const Uart&) = delete;
  Uart& operator=(const Uart&) = delete;

  /// Starts both directions; the object must live as long as the program.
  /// @returns false where the rate cannot be had from the board's clock (under 16 ticks a bit)
  bool start(std::uint32_t bits_per_second);

  /// Bytes lost on reception since the start, because the ring or the register was full.
  std::uint32_t overruns() const { return overruns_; }

  void on_receive();   ///< the interrupt's, which has been cleared
  void on_transmit();  ///< the interrupt's, which has been cleared

 private:
  int do_read(std::uint8_t* bytes, int capacity) override;
  int do_write(const std::uint8_t* bytes, int count) override;
  void feed();

  cortex_m::ByteRing<kReceiveCapacity> received_;
  cortex_m::ByteRing<kTransmitCapacity> to_send_;
  volatile std::uint32_t overruns_ = 0;
};

}  // namespace batuta::mps2
