// SPDX-License-Identifier: MIT
// What goes from an interrupt handler to the program: the ring against a model, and both with a
// thread in the interrupt handler's place.

#include <gtest/gtest.h>

#include <deque>
#include <random>
#include <thread>

#include "platforms/cortex_m/byte_ring.hpp"
#include "platforms/stm32f405/drivers/latest.hpp"

namespace batuta::stm32f405 {
namespace {

using cortex_m::ByteRing;

TEST(ByteRing, AnyPushesAndPops_AreThoseOfAQueue) {
  ByteRing<16> ring;
  std::deque<std::uint8_t> model;
  std::mt19937 random(20061107);
  int refused = 0;
  for (int i = 0; i < 200000; ++i) {
    const auto byte = static_cast<std::uint8_t>(random());
    if (random() % 2 == 0) {
      const bool taken = ring.push(byte);
      ASSERT_EQ(taken, model.size() < 16);
      if (taken) model.push_back(byte);
      refused += taken ? 0 : 1;
    } else {
      std::uint8_t popped = 77;
      const bool any = ring.pop(popped);
      ASSERT_EQ(any, !model.empty());
      ASSERT_EQ(popped, any ? model.front() : 77);
      if (any) model.pop_front();
    }
    ASSERT_EQ(ring.empty(), model.empty());
  }
  EXPECT_GT(refused, 100);
}

TEST(ByteRing, WriterBesideReader_KeepsTheOrder) {
  constexpr std::uint32_t kBytes = 200000;
  ByteRing<64> ring;
  std::thread writer([&ring] {
    for (std::uint32_t i = 0; i < kBytes;) {
      if (ring.push(static_cast<std::uint8_t>(i * 31U >> 3))) {
        ++i;
      } else {
        std::this_thread::yield();
      }
    }
  });
  std::uint32_t wrong = 0;
  for (std::uint32_t i = 0; i < kBytes;) {
    std::uint8_t byte = 0;
    if (ring.pop(byte)) {
      wrong += byte == static_cast<std::uint8_t>(i * 31U >> 3) ? 0U : 1U;
      ++i;
    } else {
      std::this_thread::yield();
    }
  }
  writer.join();
  EXPECT_EQ(wrong, 0U);
}

TEST(Latest, ValueThatWasPut_IsTheOneThatComes) {
  Latest<int> latest;
  int value = -1;
  EXPECT_EQ(latest.copy(value), 0U);
  EXPECT_EQ(value, -1);
  for (int i = 1; i < 100; ++i) {
    latest.put(10 * i);
    if (i % 3 != 0) continue;
    EXPECT_EQ(latest.copy(value), static_cast<std::uint32_t>(i));
    EXPECT_EQ(value, 10 * i);
  }
}

}  // namespace
}  // namespace batuta::stm32f405
