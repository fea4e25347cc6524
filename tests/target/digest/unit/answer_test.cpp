// SPDX-License-Identifier: MIT
#include "../answer.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace batuta::digest {
namespace {

std::uint64_t hash_of(float x) {
  Answer answer;
  answer.add("x", x);
  return answer.hash();
}

TEST(DigestAnswer, OneUlp_ChangesTheHash) {
  EXPECT_EQ(hash_of(1.0F), hash_of(1.0F));
  EXPECT_NE(hash_of(1.0F), hash_of(std::nextafter(1.0F, 2.0F)));
}

TEST(DigestAnswer, SignOfZero_ChangesTheHash) {
  EXPECT_NE(hash_of(0.0F), hash_of(-0.0F));
}

TEST(DigestAnswer, SignAndPayloadOfNan_DoNot) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(hash_of(nan), hash_of(-nan));
  EXPECT_EQ(hash_of(nan), hash_of(float_of(0x7fa12345U)));
  EXPECT_NE(hash_of(nan), hash_of(std::numeric_limits<float>::infinity()));
}

TEST(DigestAnswer, OrderOfFields_ChangesTheHash) {
  Answer ab;
  ab.add("a", 1.0F);
  ab.add("b", 2.0F);
  Answer ba;
  ba.add("b", 2.0F);
  ba.add("a", 1.0F);
  EXPECT_NE(ab.hash(), ba.hash());
}

TEST(DigestAnswer, Doctored_DiffersInTheFirstFloatByOneUlp) {
  Answer doctored(nullptr, true);
  doctored.add("count", 5U);
  doctored.add("x", 1.0F);
  doctored.add("y", 1.0F);
  Answer expected;
  expected.add("count", 5U);
  expected.add("x", std::nextafter(1.0F, 2.0F));
  expected.add("y", 1.0F);
  EXPECT_EQ(doctored.hash(), expected.hash());
}

struct Listener final : AnswerListener {
  void on_word(const char* /*field*/, std::uint32_t word) override { words.push_back(word); }
  std::vector<std::uint32_t> words;
};

TEST(DigestAnswer, Listener_HearsEveryWordInOrder) {
  Listener listener;
  Answer answer(&listener);
  answer.add("v", Vec3<float>(1, 2, 4));
  answer.add("yes", true);
  answer.add("q", Quat<float>(0.5F, 0, 0, 8));  // w last, as Eigen keeps it
  const std::vector<std::uint32_t> expected = {0x3f800000, 0x40000000, 0x40800000, 1,
                                               0,          0,          0x41000000, 0x3f000000};
  EXPECT_EQ(listener.words, expected);
}

}  // namespace
}  // namespace batuta::digest
