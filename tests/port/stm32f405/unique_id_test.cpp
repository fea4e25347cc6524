// SPDX-License-Identifier: MIT

#include "platforms/stm32f405/registers/unique_id.hpp"

#include <gtest/gtest.h>

#include <string>

namespace batuta::stm32f405 {
namespace {

TEST(UniqueId, AsASerialNumber_HasAllDigits) {
  const UniqueId id{{0x01234567U, 0x89ABCDEFU, 0x0000000FU}};
  EXPECT_EQ(std::string(serial_of(id).data()), "0123456789ABCDEF0000000F");
}

}  // namespace
}  // namespace batuta::stm32f405
