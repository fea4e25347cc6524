// SPDX-License-Identifier: MIT
#pragma once
// Where the registers are: RM0090 section 2.3, table 1. The one place that turns numbers into
// registers; drivers are handed references, so that a test can hand them plain memory.

#include <cstdint>

#include "platforms/stm32f405/registers/adc.hpp"
#include "platforms/stm32f405/registers/dma.hpp"
#include "platforms/stm32f405/registers/gpio.hpp"
#include "platforms/stm32f405/registers/iwdg.hpp"
#include "platforms/stm32f405/registers/otg_fs.hpp"
#include "platforms/stm32f405/registers/power_flash.hpp"
#include "platforms/stm32f405/registers/rcc.hpp"
#include "platforms/stm32f405/registers/tim.hpp"
#include "platforms/stm32f405/registers/unique_id.hpp"
#include "platforms/stm32f405/registers/usart.hpp"

namespace batuta::stm32f405 {

template <class Registers>
Registers& registers_at(std::uintptr_t address) {
  // NOLINTNEXTLINE(performance-no-int-to-ptr) deviation: memory-mapped
  return *reinterpret_cast<Registers*>(address);
}

inline const UniqueId& unique_id() {
  return registers_at<UniqueId>(0x1FFF7A10U);
}
inline Tim& tim3() {
  return registers_at<Tim>(0x40000400U);
}
inline Tim& tim7() {
  return registers_at<Tim>(0x40001400U);
}
inline Iwdg& iwdg() {
  return registers_at<Iwdg>(0x40003000U);
}
inline Pwr& pwr() {
  return registers_at<Pwr>(0x40007000U);
}
inline Tim& tim8() {
  return registers_at<Tim>(0x40010400U);
}
inline Usart& usart1() {
  return registers_at<Usart>(0x40011000U);
}
inline Adc& adc1() {
  return registers_at<Adc>(0x40012000U);
}
inline AdcCommon& adc_common() {
  return registers_at<AdcCommon>(0x40012300U);
}
inline Gpio& gpioa() {
  return registers_at<Gpio>(0x40020000U);
}
inline Gpio& gpiob() {
  return registers_at<Gpio>(0x40020400U);
}
inline Gpio& gpioc() {
  return registers_at<Gpio>(0x40020800U);
}
inline Rcc& rcc() {
  return registers_at<Rcc>(0x40023800U);
}
inline FlashInterface& flash_interface() {
  return registers_at<FlashInterface>(0x40023C00U);
}
inline Dma& dma2() {
  return registers_at<Dma>(0x40026400U);
}
inline OtgFs& otg_fs() {
  return registers_at<OtgFs>(0x50000000U);
}

}  // namespace batuta::stm32f405
