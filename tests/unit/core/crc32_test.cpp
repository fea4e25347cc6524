// SPDX-License-Identifier: MIT
// Against long division: tests/port/link/crc32_test.cpp.
#include "batuta/core/crc32.hpp"

#include <gtest/gtest.h>

#include <array>

#include "batuta/record/snapshot.hpp"

namespace batuta {
namespace {

TEST(Crc32, CheckValueOfTheCatalogue) {
  const std::array<std::uint8_t, 9> digits{'1', '2', '3', '4', '5', '6', '7', '8', '9'};
  EXPECT_EQ(crc32(digits.data(), 9), 0xCBF43926U);
  EXPECT_EQ(crc32(digits.data(), 0), 0U);
}

TEST(Crc32, Snapshot_EndsWithItLowestByteFirst) {
  std::array<std::uint8_t, kSnapshotRoom<float>> bytes{};
  const auto saved = save(1.5F, bytes.data(), static_cast<int>(bytes.size()));
  ASSERT_TRUE(saved.ok());
  const int before = saved.value - detail::kCheckSum;
  std::uint32_t sum = 0;
  for (int i = 0; i < detail::kCheckSum; ++i) {
    sum |= static_cast<std::uint32_t>(bytes[static_cast<std::size_t>(before + i)]) << (8 * i);
  }
  EXPECT_EQ(sum, crc32(bytes.data(), before));
}

}  // namespace
}  // namespace batuta
