// SPDX-License-Identifier: MIT
#include "host/duel/device/device_setup.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace batuta::host {
namespace {

TEST(DeviceSetup, TheRateOfTheWords_ReachesTheLine) {
  for (const char* words : {"serial:/dev/none@12345", "serial:/dev/none@12345,script:attack"}) {
    DeviceSetup setup;
    EXPECT_EQ(setup.open(open_source("script:guard"), open_source(words)),
              "/dev/none: unknown rate of 12345 baud");
  }
}

TEST(DeviceSetup, WithoutARate_TheLineIsOpenedWithAKnownOne) {
  DeviceSetup setup;
  EXPECT_THAT(setup.open(open_source("serial:/dev/none"), open_source("script:guard")),
              testing::HasSubstr("no such file"));
}

}  // namespace
}  // namespace batuta::host
