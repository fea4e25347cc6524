// SPDX-License-Identifier: MIT
#include "batuta/core/pool.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "../../../src/core/lowest_bit.hpp"
#include "heap_trap.hpp"

namespace batuta {

namespace detail {
/// The seam for what counting would take weeks to reach.
class PoolTestAccess {
 public:
  static void set_generation(PoolBase& pool, std::size_t index, std::uint32_t generation) {
    pool.generations_[index] = generation;
  }
};
}  // namespace detail

namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr std::uint32_t kLastGeneration = std::numeric_limits<std::uint32_t>::max();

struct alignas(64) Wide {
  int value = 0;
};
struct Pair {
  Pair(int first_value, float second_value) : first(first_value), second(second_value) {}
  int first;
  float second;
};

static_assert(!std::is_copy_constructible_v<Pool<int, 4>> &&
              !std::is_copy_assignable_v<Pool<int, 4>>);
static_assert(!std::is_move_constructible_v<Pool<int, 4>> &&
              !std::is_move_assignable_v<Pool<int, 4>>);
static_assert(std::is_trivially_destructible_v<Pool<int, 4>>);

#ifndef _MSC_VER  // its classes do not use what their bases have left
/// A pool of N is its book-keeping, and of each slot the object, a generation, and a bit in a whole
/// word; the end is padded.
constexpr std::size_t kBook = 2 * sizeof(void*) + 2 * sizeof(int) + 2 * sizeof(std::uint16_t);
template <int N>
constexpr bool kTakesWhatItSays =
    sizeof(Pool<int, N>) < kBook + N*(sizeof(int) + sizeof(std::uint32_t)) + (N + 31) / 32 * 4 +
                               alignof(Pool<int, N>);
static_assert(kTakesWhatItSays<1> && kTakesWhatItSays<31> && kTakesWhatItSays<32>);
static_assert(kTakesWhatItSays<33> && kTakesWhatItSays<64> && kTakesWhatItSays<65>);
#endif

template <class PoolType>
auto make_in(PoolType& pool, int value) {
  const auto made = pool.make(value);
  EXPECT_TRUE(made.ok());
  return made.value;
}

TEST(Pool, Empty_HoldsNothing) {
  Pool<int, 3> pool;
  EXPECT_TRUE(pool.empty());
  EXPECT_EQ(pool.size(), 0);
  EXPECT_EQ(pool.capacity(), 3);
  EXPECT_EQ(pool.usable_capacity(), 3);
  EXPECT_EQ(pool.begin(), pool.end());
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(pool.at_index(i), nullptr);
    EXPECT_TRUE(pool.handle_at(i).is_null());
  }
}

TEST(Pool, Make_PassesTheArguments) {
  Pool<Pair, 2> pool;
  const auto made = pool.make(7, 0.5F);
  ASSERT_TRUE(made.ok());
  EXPECT_EQ(pool.get(made.value)->first, 7);
  EXPECT_EQ(pool.get(made.value)->second, 0.5F);
}

TEST(Pool, Handle_NamesItsObjectFromEverySide) {
  Pool<int, 40> pool(9);
  make_in(pool, 1);
  const auto handle = make_in(pool, 2);
  const auto& same = pool;
  EXPECT_EQ(*pool.get(handle), 2);
  EXPECT_EQ(same.get(handle), pool.get(handle));
  EXPECT_EQ(pool.index_of(handle), 1);
  EXPECT_EQ(pool.handle_at(1), handle);
  EXPECT_EQ(pool.at_index(1), pool.get(handle));
  EXPECT_EQ(same.at_index(1), pool.get(handle));
  EXPECT_EQ(handle.pool, 9);
}

TEST(Pool, NullHandle_IsRefused) {
  Pool<int, 2> pool;
  make_in(pool, 1);
  EXPECT_EQ(pool.get({}), nullptr);
  EXPECT_EQ(pool.index_of({}), detail::PoolBase::kNoIndex);
  EXPECT_EQ(pool.remove({}), Status::kStaleHandle);
  EXPECT_EQ(pool.size(), 1);
}

TEST(Pool, StaleHandle_IsRefusedAlsoWhereTheSlotIsUsedAgain) {
  Pool<int, 2> pool;
  const auto old = make_in(pool, 1);
  EXPECT_EQ(pool.remove(old), Status::kOk);
  EXPECT_EQ(pool.get(old), nullptr);
  EXPECT_EQ(pool.remove(old), Status::kStaleHandle);
  const auto young = make_in(pool, 2);
  EXPECT_EQ(young.index1, old.index1);
  EXPECT_EQ(pool.get(old), nullptr);
  EXPECT_EQ(pool.remove(old), Status::kStaleHandle);
  EXPECT_EQ(*pool.get(young), 2);
}

TEST(Pool, ForeignHandle_IsRefused) {
  Pool<int, 2> ours(1);
  Pool<int, 2> theirs(2);
  const auto foreign = make_in(theirs, 5);
  make_in(ours, 6);
  EXPECT_EQ(ours.get(foreign), nullptr);
  EXPECT_EQ(ours.remove(foreign), Status::kStaleHandle);
  EXPECT_EQ(ours.size(), 1);
}

TEST(Pool, HandleBeyondTheCapacity_IsRefused) {
  Pool<int, 33> pool;
  make_in(pool, 1);
  for (const int index1 : {34, 35, 64, 65, 65535}) {
    EXPECT_EQ(pool.get({static_cast<std::uint16_t>(index1), 0, 1}), nullptr) << index1;
  }
}

TEST(Pool, Full_IsAStatusAndChangesNothing) {
  Pool<int, 2> pool;
  const auto first = make_in(pool, 1);
  const auto second = make_in(pool, 2);
  const auto third = pool.make(3);
  EXPECT_EQ(third.status, Status::kPoolFull);
  EXPECT_TRUE(third.value.is_null());
  EXPECT_EQ(*pool.get(first), 1);
  EXPECT_EQ(*pool.get(second), 2);
  EXPECT_THAT(pool, ElementsAre(1, 2));
}

TEST(Pool, FreeSlots_AreTakenFromTheLowest) {
  Pool<int, 70> pool;
  std::array<Handle<int>, 70> handles;
  for (int i = 0; i < 70; ++i) handles[static_cast<std::size_t>(i)] = make_in(pool, i);
  for (const std::size_t i : {69U, 33U, 2U, 64U}) ASSERT_EQ(pool.remove(handles[i]), Status::kOk);
  for (const int expected : {2, 33, 64, 69}) EXPECT_EQ(pool.index_of(make_in(pool, 0)), expected);
}

/// Where the bitmap ends, objects begin: a word too few would change them.
TEST(Pool, SlotBehindAFullWord_LeavesTheObjectsAlone) {
  Pool<int, 33> pool;
  for (int i = 0; i < 33; ++i) make_in(pool, 2 * i);
  int expected = 0;
  for (const int value : pool) {
    EXPECT_EQ(value, expected);
    expected += 2;
  }
  EXPECT_EQ(expected, 66);
  ASSERT_EQ(pool.remove(pool.handle_at(32)), Status::kOk);
  EXPECT_EQ(*pool.at_index(0), 0);
  EXPECT_EQ(pool.size(), 32);
}

TEST(Pool, OneSlot_HoldsAnyValue) {
  Pool<int, 1> pool;
  const auto handle = make_in(pool, 0);
  EXPECT_NE(pool.get(handle), nullptr);
  EXPECT_EQ(pool.remove(handle), Status::kOk);
  EXPECT_EQ(pool.at_index(0), nullptr);
}

TEST(Pool, Iterator_FollowsTheSlotsAndSkipsHoles) {
  Pool<int, 100> pool;
  EXPECT_THAT(pool, IsEmpty());
  for (int i = 0; i < 100; ++i) make_in(pool, i);
  for (std::size_t i = 0; i < 100; ++i) {
    if (i != 0 && i != 31 && i != 32 && i != 99) {
      ASSERT_EQ(pool.remove(pool.handle_at(i)), Status::kOk);
    }
  }
  EXPECT_THAT(pool, ElementsAre(0, 31, 32, 99));
  const auto& same = pool;
  EXPECT_THAT(same, ElementsAre(0, 31, 32, 99));
  EXPECT_EQ(*pool.begin()++, 0);
  EXPECT_EQ(*std::next(pool.begin()), 31);
  EXPECT_EQ(std::next(same.begin(), 2).index(), 32U);
}

TEST(Pool, Iterator_EndsWhereTheLastWordOfTheBitmapIsFull) {
  Pool<int, 64> pool;
  for (int i = 0; i < 64; ++i) make_in(pool, -2);  // bits behind the bitmap
  int walked = 0;
  for (const int value : pool) walked -= value;
  EXPECT_EQ(walked, 128);
}

TEST(Pool, Iterator_ObjectsMayBeChangedAndRemovedOnTheWay) {
  Pool<int, 8> pool;
  for (int i = 0; i < 8; ++i) make_in(pool, i);
  for (auto it = pool.begin(); it != pool.end(); ++it) {
    if (*it % 2 == 1) {
      EXPECT_EQ(pool.remove(pool.handle_at(it.index())), Status::kOk);
    } else {
      *it += 100;
    }
  }
  EXPECT_THAT(pool, ElementsAre(100, 102, 104, 106));
}

TEST(Pool, Clear_MakesEveryHandleStale) {
  Pool<int, 40> pool;
  std::array<Handle<int>, 40> handles;
  for (auto& handle : handles) handle = make_in(pool, 1);
  pool.clear();
  EXPECT_TRUE(pool.empty());
  for (std::size_t i = 0; i < 40; ++i) make_in(pool, 2);
  for (const auto& handle : handles) EXPECT_EQ(pool.get(handle), nullptr);
  EXPECT_EQ(pool.size(), 40);
}

TEST(Pool, LastGeneration_RetiresTheSlot) {
  Pool<int, 2> pool;
  detail::PoolTestAccess::set_generation(pool, 0, kLastGeneration - 1);
  const auto last = make_in(pool, 1);
  EXPECT_EQ(last.generation, kLastGeneration);
  EXPECT_EQ(*pool.get(last), 1);
  EXPECT_EQ(pool.usable_capacity(), 2);
  ASSERT_EQ(pool.remove(last), Status::kOk);
  EXPECT_EQ(pool.usable_capacity(), 1);
  EXPECT_EQ(pool.index_of(make_in(pool, 2)), 1);
  EXPECT_EQ(pool.make(3).status, Status::kPoolFull);
  EXPECT_EQ(pool.get(last), nullptr);
}

TEST(Pool, LastGeneration_RetiresTheSlotInClearToo) {
  Pool<int, 1> pool;
  detail::PoolTestAccess::set_generation(pool, 0, kLastGeneration - 1);
  make_in(pool, 1);
  pool.clear();
  EXPECT_EQ(pool.usable_capacity(), 0);
  EXPECT_EQ(pool.make(2).status, Status::kPoolFull);
}

TEST(Pool, Storage_IsAligned) {
  Pool<Wide, 3> pool;
  for (int i = 0; i < 3; ++i) {
    const auto made = pool.make(Wide{i});
    const auto address = reinterpret_cast<std::uintptr_t>(pool.get(made.value));
    EXPECT_EQ(address % alignof(Wide), 0U);
    EXPECT_EQ(pool.get(made.value)->value, i);
  }
}

TEST(Pool, LargestPool_UsesItsLastSlot) {
  static Pool<char, 65535> pool;
  for (int i = 0; i < 65534; ++i) ASSERT_TRUE(pool.make('a').ok());
  const auto last = pool.make('z');
  ASSERT_TRUE(last.ok());
  EXPECT_EQ(last.value.index1, 65535);
  EXPECT_EQ(pool.index_of(last.value), 65534);
  EXPECT_EQ(*pool.get(last.value), 'z');
  EXPECT_EQ(pool.make('y').status, Status::kPoolFull);
}

TEST(Pool, Work_AllocatesNothing) {
  Pool<int, 8> pool;
  const test::HeapTrap trap;
  for (int round = 0; round < 3; ++round) {
    for (int i = 0; i < 9; ++i) (void)pool.make(i);
    for (int& value : pool) ++value;
    (void)pool.remove(pool.handle_at(3));
    pool.clear();
  }
  EXPECT_EQ(trap.allocations(), 0);
}

TEST(Pool, Restored_HoldsTheFirstObjectAndTheLast) {
  Pool<Pair, 3> pool;
  for (int i = 1; i <= 3; ++i) ASSERT_TRUE(pool.make(i, 0.5F).ok());
  Pool<Pair, 3> copy;
  ASSERT_TRUE(copy.make(8, 0.25F).ok());
  copy.restore(pool);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(copy.at_index(i)->first, static_cast<int>(i) + 1);
    EXPECT_EQ(copy.at_index(i)->second, 0.5F);
  }
}

TEST(Pool, Restored_HoldsTheSameObjectsUnderTheSameHandles) {
  Pool<Pair, 40> pool(3);
  Pool<Pair, 40> copy(9);
  const auto old = copy.make(1, 1.0F).value;
  std::vector<Handle<Pair>> handles;
  for (int i = 0; i < 40; ++i) handles.push_back(pool.make(i, 0.5F).value);
  for (std::size_t i = 0; i < 40; i += 3) ASSERT_EQ(pool.remove(handles[i]), Status::kOk);
  copy.restore(pool);
  EXPECT_EQ(copy.get(old), nullptr);
  EXPECT_EQ(copy.size(), pool.size());
  for (std::size_t i = 0; i < 40; ++i) {
    const Pair* object = copy.get(handles[i]);
    ASSERT_EQ(object == nullptr, i % 3 == 0);
    if (object == nullptr) continue;
    EXPECT_EQ(object->first, static_cast<int>(i));
  }
  const auto next = pool.make(7, 1.0F).value;
  const auto same = copy.make(7, 1.0F).value;
  EXPECT_EQ(next.index1, same.index1);
  EXPECT_EQ(next.generation, same.generation);
  copy.restore(copy);
  EXPECT_EQ(copy.get(same)->first, 7);
}

TEST(LowestBit, Counted_IsTheCompilersOwn) {
  for (std::uint32_t position = 0; position < 32; ++position) {
    const std::uint32_t bit = 1U << position;
    for (const std::uint32_t above : {0U, ~0U, 0xA5A5A5A5U, 0x80000000U}) {
      const std::uint32_t word = bit | (above & ~(bit - 1U));
      EXPECT_EQ(detail::counted_lowest_bit(word), position);
      EXPECT_EQ(detail::lowest_bit(word), position);
    }
  }
  EXPECT_EQ(detail::counted_lowest_bit(0), 31U);  // against what it asks for: it ends all the same
}

}  // namespace
}  // namespace batuta
