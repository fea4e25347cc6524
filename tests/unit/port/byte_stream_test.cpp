// SPDX-License-Identifier: MIT
// What a port claims to have written or read is believed within what it was asked for.

#include "batuta/port/byte_stream.hpp"

#include <gtest/gtest.h>

#include <array>

namespace batuta {
namespace {

/// Claims what it is told to, and counts how often it was asked.
class ClaimingSink final : public ByteSink {
 public:
  int claim = 0;
  int asked = 0;

 private:
  int do_write(const std::uint8_t* /*bytes*/, int /*count*/) override {
    ++asked;
    return claim;
  }
};

class ClaimingSource final : public ByteSource {
 public:
  int claim = 0;
  int asked = 0;

 private:
  int do_read(std::uint8_t* /*bytes*/, int /*capacity*/) override {
    ++asked;
    return claim;
  }
};

TEST(ByteSink, WhatItTook_IsToldWhereItCanBe) {
  const std::array<std::uint8_t, 4> bytes{};
  ClaimingSink sink;
  for (const int claim : {0, 1, 4}) {
    sink.claim = claim;
    EXPECT_EQ(sink.write(bytes.data(), 4), claim);
  }
  EXPECT_EQ(sink.asked, 3);
  for (const int claim : {-1, 5}) {
    sink.claim = claim;
    EXPECT_EQ(sink.write(bytes.data(), 4), 0) << claim;
  }
}

TEST(ByteSink, ForNothing_IsNotAsked) {
  const std::array<std::uint8_t, 4> bytes{};
  ClaimingSink sink;
  sink.claim = 1;
  EXPECT_EQ(sink.write(nullptr, 4), 0);
  EXPECT_EQ(sink.write(bytes.data(), 0), 0);
  EXPECT_EQ(sink.write(bytes.data(), -1), 0);
  EXPECT_EQ(sink.asked, 0);
}

TEST(ByteSource, WhatItGave_IsToldWhereItCanBe) {
  std::array<std::uint8_t, 4> room{};
  ClaimingSource source;
  for (const int claim : {0, 1, 4, -1}) {  // -1: no more will come
    source.claim = claim;
    EXPECT_EQ(source.read(room.data(), 4), claim);
  }
  source.claim = 5;
  EXPECT_EQ(source.read(room.data(), 4), -1);
}

TEST(ByteSource, ForNoRoom_IsNotAsked) {
  std::array<std::uint8_t, 4> room{};
  ClaimingSource source;
  source.claim = 1;
  EXPECT_EQ(source.read(nullptr, 4), 0);
  EXPECT_EQ(source.read(room.data(), 0), 0);
  EXPECT_EQ(source.asked, 0);
}

}  // namespace
}  // namespace batuta
