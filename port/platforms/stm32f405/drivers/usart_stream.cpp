// SPDX-License-Identifier: MIT

#include "platforms/stm32f405/drivers/usart_stream.hpp"

namespace batuta::stm32f405 {
namespace {

constexpr std::uint32_t kErrors = Usart::kSrOre | Usart::kSrFe | Usart::kSrNf;

void add_if(volatile std::uint32_t& count, bool condition) {
  if (condition) count = count + 1U;
}

}  // namespace

void UsartStream::start(std::uint32_t brr) {
  usart_.cr1 = 0;
  usart_.cr2 = 0;
  usart_.cr3 = 0;
  usart_.brr = brr;
  usart_.cr1 = Usart::kCr1Ue | Usart::kCr1Te | Usart::kCr1Re | Usart::kCr1Rxneie;
}

void UsartStream::on_interrupt() {
  const std::uint32_t status = usart_.sr;
  if ((status & (Usart::kSrRxne | kErrors)) != 0) receive(status);
  if ((status & Usart::kSrTxe) != 0 && (usart_.cr1 & Usart::kCr1Txeie) != 0) transmit();
}

void UsartStream::receive(std::uint32_t status) {
  // Reading SR, then DR, clears the errors as well (RM0090 30.6.1).
  const auto byte = static_cast<std::uint8_t>(usart_.dr & 0xFFU);
  add_if(overruns_, (status & Usart::kSrOre) != 0);
  add_if(framing_, (status & Usart::kSrFe) != 0);
  add_if(noise_, (status & Usart::kSrNf) != 0);
  const bool good = (status & (Usart::kSrFe | Usart::kSrNf)) == 0;
  if (good && (status & Usart::kSrRxne) != 0) add_if(full_, !received_.push(byte));
}

void UsartStream::transmit() {
  std::uint8_t byte = 0;
  if (to_send_.pop(byte)) {
    usart_.dr = byte;
  } else {
    usart_.cr1 &= ~Usart::kCr1Txeie;
  }
}

UsartFaults UsartStream::faults() const {
  return {overruns_, framing_, noise_, full_};
}

int UsartStream::do_read(std::uint8_t* bytes, int capacity) {
  int count = 0;
  while (count < capacity && received_.pop(bytes[count])) ++count;  // Bound: capacity
  return count;
}

int UsartStream::do_write(const std::uint8_t* bytes, int count) {
  int taken = 0;
  while (taken < count && to_send_.push(bytes[taken])) ++taken;  // Bound: count
  // The line is started here and kept going by the interrupt. The interrupt is off while this reads
  // the ring's other end; it changes nothing in CR1 but the bit that is off already.
  usart_.cr1 &= ~Usart::kCr1Txeie;
  std::uint8_t byte = 0;
  for (int i = 0; i < taken; ++i) {  // Bound: count; on hardware two bytes fill the line
    if ((usart_.sr & Usart::kSrTxe) == 0 || !to_send_.pop(byte)) break;
    usart_.dr = byte;
  }
  if (!to_send_.empty()) usart_.cr1 |= Usart::kCr1Txeie;
  return taken;
}

}  // namespace batuta::stm32f405
