// SPDX-License-Identifier: MIT
#include "shared/link/crc32.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <string>
#include <vector>

namespace batuta::link {
namespace {

using Bytes = std::vector<std::uint8_t>;

std::uint32_t crc_of(const Bytes& bytes) {
  return crc32(bytes.data(), static_cast<int>(bytes.size()));
}

std::uint32_t mirrored(std::uint32_t value, int bits) {
  std::uint32_t result = 0;
  for (int i = 0; i < bits; ++i) {
    if ((value >> static_cast<unsigned>(i)) & 1U) {
      result |= 1U << static_cast<unsigned>(bits - 1 - i);
    }
  }
  return result;
}

/// The textbook: the message as a polynomial, most significant bit first, one bit at a time, with
/// the mirroring outside.
std::uint32_t long_division(const Bytes& bytes) {
  std::uint32_t remainder = 0xFFFFFFFFU;
  for (const std::uint8_t byte : bytes) {
    remainder ^= mirrored(byte, 8) << 24U;
    for (int bit = 0; bit < 8; ++bit) {
      const bool carry = (remainder & 0x80000000U) != 0;
      remainder <<= 1U;
      if (carry) remainder ^= 0x04C11DB7U;
    }
  }
  return mirrored(remainder, 32) ^ 0xFFFFFFFFU;
}

TEST(Crc32, PublishedCheckValue_Agrees) {
  const std::string digits = "123456789";
  EXPECT_EQ(crc_of(Bytes(digits.begin(), digits.end())), 0xCBF43926U);
}

TEST(Crc32, NothingAndOneByte_AgreeWithLongDivision) {
  EXPECT_EQ(crc_of({}), 0U);
  for (int byte = 0; byte < 256; ++byte) {
    const Bytes one = {static_cast<std::uint8_t>(byte)};
    EXPECT_EQ(crc_of(one), long_division(one)) << byte;
  }
}

TEST(Crc32, LeadingZeros_AreSeen) {
  EXPECT_NE(crc_of({0}), crc_of({0, 0}));
  EXPECT_NE(crc_of({7}), crc_of({0, 7}));
}

RC_GTEST_PROP(Crc32, AnyBytes_AgreeWithLongDivision, (const Bytes& bytes)) {
  RC_ASSERT(crc_of(bytes) == long_division(bytes));
}

}  // namespace
}  // namespace batuta::link
