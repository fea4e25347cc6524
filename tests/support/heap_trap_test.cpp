// SPDX-License-Identifier: MIT
// The trap must catch what it is meant to catch, or the tests that rely on it show nothing.

#include "heap_trap.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <memory>
#include <vector>

namespace batuta::test {
namespace {

/// Keeps the compiler from taking an allocation away.
void use(const void* block) {
  static const volatile void* volatile last = nullptr;
  last = block;
  (void)last;
}

struct alignas(128) Wide {
  char bytes[128];
};

TEST(HeapTrap, Nothing_CountsNothing) {
  const HeapTrap trap;
  EXPECT_EQ(trap.allocations(), 0);
  EXPECT_EQ(trap.releases(), 0);
}

TEST(HeapTrap, New_IsCounted) {
  const HeapTrap trap;
  use(std::make_unique<int>(3).get());
  EXPECT_EQ(trap.allocations(), 1);
  EXPECT_EQ(trap.releases(), 1);
}

TEST(HeapTrap, AlignedNew_IsCounted) {
  const HeapTrap trap;
  use(std::make_unique<Wide>().get());
  EXPECT_EQ(trap.allocations(), 1);
}

TEST(HeapTrap, Vector_IsCounted) {
  const HeapTrap trap;
  std::vector<int> numbers(10);
  use(numbers.data());
  EXPECT_EQ(trap.allocations(), 1);
}

TEST(HeapTrap, CFunctions_AreCounted) {
  const HeapTrap trap;
  void* block = std::malloc(8);
  use(block);
  void* larger = std::realloc(block, 4096);
  use(larger);
  void* zeroed = std::calloc(2, 8);
  use(zeroed);
  void* aligned = std::aligned_alloc(64, 64);
  use(aligned);
  EXPECT_EQ(trap.allocations(), 4);
  std::free(larger);
  std::free(zeroed);
  std::free(aligned);
  EXPECT_GE(trap.releases(), 3);
}

TEST(HeapTrap, AfterItsEnd_StartsAnew) {
  {
    const HeapTrap trap;
    use(std::make_unique<int>(3).get());
  }
  use(std::make_unique<int>(3).get());
  const HeapTrap trap;
  EXPECT_EQ(trap.allocations(), 0);
}

}  // namespace
}  // namespace batuta::test
