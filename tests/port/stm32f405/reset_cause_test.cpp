// SPDX-License-Identifier: MIT
// RCC_CSR as the part leaves it after each kind of reset (RM0090 7.3.21).

#include "platforms/stm32f405/drivers/reset_cause.hpp"

#include <gtest/gtest.h>

namespace batuta::stm32f405 {
namespace {

TEST(ResetCause, EachKindOfReset_IsTold) {
  EXPECT_EQ(reset_cause(0x0E000000), ResetCause::kPowerOn);  // POR, BOR and pin: the reset value
  EXPECT_EQ(reset_cause(0x06000000), ResetCause::kPowerOn);  // brown-out and pin
  EXPECT_EQ(reset_cause(0x04000000), ResetCause::kPin);
  EXPECT_EQ(reset_cause(0x14000000), ResetCause::kSoftware);  // pulls the pin as well
  EXPECT_EQ(reset_cause(0x24000000), ResetCause::kWatchdog);
  EXPECT_EQ(reset_cause(0x44000000), ResetCause::kWatchdog);
  EXPECT_EQ(reset_cause(0x84000000), ResetCause::kLowPower);
  EXPECT_EQ(reset_cause(0x00000003), ResetCause::kUnknown);  // only the LSI's bits
}

TEST(ResetCause, WatchdogAndSoftware_AreNotHiddenByOlderFlags) {
  EXPECT_EQ(reset_cause(0x2E000000), ResetCause::kWatchdog);
  EXPECT_EQ(reset_cause(0x1E000000), ResetCause::kSoftware);
}

}  // namespace
}  // namespace batuta::stm32f405
