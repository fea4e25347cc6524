// SPDX-License-Identifier: MIT
#include "shared/link/byte_stream.hpp"

#include <gtest/gtest.h>

#include <array>

namespace batuta::link {
namespace {

/// Claims whatever it is told to claim.
class Liar final : public ByteStream {
 public:
  explicit Liar(int claim) : claim_(claim) {}
  int calls = 0;

 private:
  int do_read(std::uint8_t*, int) override {
    ++calls;
    return claim_;
  }
  int do_write(const std::uint8_t*, int) override {
    ++calls;
    return claim_;
  }
  int claim_;
};

TEST(ByteStream, CountsThatCannotBe_AreGoneAndNothingTaken) {
  std::array<std::uint8_t, 4> bytes{};
  for (const int claim : {-2, 5, 1000000}) {
    Liar liar(claim);
    EXPECT_EQ(liar.read(bytes.data(), 4), -1) << claim;
    EXPECT_EQ(liar.write(bytes.data(), 4), 0) << claim;
  }
}

TEST(ByteStream, CountsThatCanBe_ComeThrough) {
  std::array<std::uint8_t, 4> bytes{};
  for (const int claim : {0, 1, 4}) {
    Liar honest(claim);
    EXPECT_EQ(honest.read(bytes.data(), 4), claim);
    EXPECT_EQ(honest.write(bytes.data(), 4), claim);
  }
  EXPECT_EQ(Liar(-1).read(bytes.data(), 4), -1);
  EXPECT_EQ(Liar(-1).write(bytes.data(), 4), 0);
}

TEST(ByteStream, NoRoomOrNull_DoesNotReachThePort) {
  std::array<std::uint8_t, 4> bytes{};
  Liar liar(1);
  EXPECT_EQ(liar.read(nullptr, 4), 0);
  EXPECT_EQ(liar.read(bytes.data(), 0), 0);
  EXPECT_EQ(liar.read(bytes.data(), -1), 0);
  EXPECT_EQ(liar.write(nullptr, 4), 0);
  EXPECT_EQ(liar.write(bytes.data(), -1), 0);
  EXPECT_EQ(liar.calls, 0);
}

}  // namespace
}  // namespace batuta::link
