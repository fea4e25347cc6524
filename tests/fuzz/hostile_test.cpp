// SPDX-License-Identifier: MIT
// The fuzzers reach every hostile number, and the seeds that name them by index name all of them.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "bytes.hpp"

namespace batuta::fuzz {
namespace {

std::uint32_t pattern_of(float x) {
  std::uint32_t pattern = 0;
  std::memcpy(&pattern, &x, sizeof pattern);
  return pattern;
}

/// What a fuzzer reads from four bytes.
std::uint32_t read_pattern(std::uint32_t pattern) {
  std::uint8_t bytes[4] = {};
  for (int i = 0; i < 4; ++i) bytes[i] = static_cast<std::uint8_t>(pattern >> (8 * i));
  return pattern_of(Bytes(bytes, sizeof bytes).bits());
}

TEST(HostileNumbers, ArePayloadsOfNotANumber) {
  for (std::uint32_t i = 0; i < test::kHostile<float>.size(); ++i) {
    EXPECT_EQ(read_pattern(0x7FC00000U + i), pattern_of(test::kHostile<float>[i])) << i;
  }
}

TEST(HostileNumbers, OtherPatternsAreThemselves) {
  const auto end = static_cast<std::uint32_t>(0x7FC00000U + test::kHostile<float>.size());
  for (const std::uint32_t pattern :
       {0U, 0x3F800000U, 0x7F800000U, end, 0x7FFFFFFFU, 0x80000000U, 0xFFC00001U, 0xFFFFFFFFU}) {
    EXPECT_EQ(read_pattern(pattern), pattern);
  }
}

TEST(HostileNumbers, EachHasASeed) {
  for (const char* fuzzer : {"distance", "keyframes"}) {
    const std::string folder = std::string(BATUTA_CORPUS "/") + fuzzer;
    std::size_t seeds = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      seeds += entry.path().filename().string().rfind("hostile_", 0) == 0 ? 1 : 0;
    }
    EXPECT_EQ(seeds, test::kHostile<float>.size()) << fuzzer;
  }
}

}  // namespace
}  // namespace batuta::fuzz
