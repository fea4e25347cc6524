// SPDX-License-Identifier: MIT
#include "platforms/mps2/uart.hpp"

#include <atomic>

#include "platforms/cortex_m/registers.hpp"
#include "platforms/mps2/board.hpp"

namespace batuta::mps2 {
namespace {

using cortex_m::Register;

constexpr Register kData{kBoard.uart + 0x00};
constexpr Register kState{kBoard.uart + 0x04};
constexpr Register kControl{kBoard.uart + 0x08};
constexpr Register kInterrupt{kBoard.uart + 0x0C};  ///< write 1 to clear
constexpr Register kDivider{kBoard.uart + 0x10};

constexpr std::uint32_t kStateTransmitFull = 1;
constexpr std::uint32_t kStateReceiveFull = 2;
constexpr std::uint32_t kStateReceiveOverrun = 8;  ///< write 1 to clear
constexpr std::uint32_t kInterruptTransmit = 1;
constexpr std::uint32_t kInterruptReceive = 2;
constexpr std::uint32_t kTransmitAndReceiveWithInterrupts = 0xF;

std::atomic<Uart*> running{nullptr};  // the one that the interrupts belong to

}  // namespace

bool Uart::start(std::uint32_t bits_per_second) {
  constexpr std::uint32_t kLeastDivider = 16;
  constexpr std::uint32_t kMostDivider = 0xFFFFF;
  if (bits_per_second == 0) return false;
  const std::uint32_t divider = kBoard.clock_hz / bits_per_second;
  if (divider < kLeastDivider || divider > kMostDivider) return false;
  running.store(this);
  kDivider.write(divider);
  kControl.write(kTransmitAndReceiveWithInterrupts);
  cortex_m::enable_interrupt(kBoard.uart_receive_interrupt);
  cortex_m::enable_interrupt(kBoard.uart_transmit_interrupt);
  return true;
}

void Uart::on_receive() {
  // Bound: one byte is in the register; a second one that came meanwhile has its own interrupt.
  if (kState.is_set(kStateReceiveFull)) {
    if (!received_.push(static_cast<std::uint8_t>(kData.read()))) overruns_ = overruns_ + 1;
  }
  if (kState.is_set(kStateReceiveOverrun)) {
    kState.write(kStateReceiveOverrun);
    overruns_ = overruns_ + 1;
  }
}

void Uart::on_transmit() {
  feed();
}

/// Moves bytes to the transmitter while it takes them. Not to be interrupted by itself.
void Uart::feed() {
  std::uint8_t byte = 0;
  // Bound: the ring; on hardware one byte, since the register is full then.
  for (int i = 0; i < kTransmitCapacity; ++i) {
    if (kState.is_set(kStateTransmitFull) || !to_send_.pop(byte)) return;
    kData.write(byte);
  }
}

int Uart::do_read(std::uint8_t* bytes, int capacity) {
  int count = 0;
  // Bound: capacity.
  while (count < capacity && received_.pop(bytes[count])) ++count;
  return count;
}

int Uart::do_write(const std::uint8_t* bytes, int count) {
  int taken = 0;
  // Bound: count.
  while (taken < count && to_send_.push(bytes[taken])) ++taken;
  const cortex_m::InterruptLock lock;
  feed();  // a transmitter that is idle raises no interrupt
  return taken;
}

}  // namespace batuta::mps2

// Cleared first: a byte that comes in the handler raises the interrupt again. Cleared always: one
// that belongs to nobody must not come for ever.

void batuta_on_uart_receive() {
  using namespace batuta::mps2;
  kInterrupt.write(kInterruptReceive);
  if (Uart* const uart = running.load()) uart->on_receive();
}

void batuta_on_uart_transmit() {
  using namespace batuta::mps2;
  kInterrupt.write(kInterruptTransmit);
  if (Uart* const uart = running.load()) uart->on_transmit();
}
