// SPDX-License-Identifier: MIT
#pragma once
// Serial line 1: RM0090 section 30.6.

#include <cstddef>
#include <cstdint>

namespace batuta::stm32f405 {

struct Usart {
  volatile std::uint32_t sr;
  volatile std::uint32_t dr;
  volatile std::uint32_t brr;
  volatile std::uint32_t cr1;
  volatile std::uint32_t cr2;
  volatile std::uint32_t cr3;
  volatile std::uint32_t gtpr;

  static constexpr std::uint32_t kSrFe = 1U << 1;
  static constexpr std::uint32_t kSrNf = 1U << 2;
  static constexpr std::uint32_t kSrOre = 1U << 3;
  static constexpr std::uint32_t kSrRxne = 1U << 5;
  static constexpr std::uint32_t kSrTxe = 1U << 7;
  static constexpr std::uint32_t kCr1Re = 1U << 2;
  static constexpr std::uint32_t kCr1Te = 1U << 3;
  static constexpr std::uint32_t kCr1Rxneie = 1U << 5;
  static constexpr std::uint32_t kCr1Txeie = 1U << 7;
  static constexpr std::uint32_t kCr1Ue = 1U << 13;
};
static_assert(offsetof(Usart, brr) == 0x08 && offsetof(Usart, gtpr) == 0x18, "RM0090 30.6");

}  // namespace batuta::stm32f405
