// SPDX-License-Identifier: MIT
// A slot whose generations are used up, in a pool that is written and read.
#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "batuta/core/pool.hpp"
#include "batuta/record/archive.hpp"

namespace batuta {

namespace detail {
/// The seam for what counting would take weeks to reach; the same as in pool_test.cpp.
class PoolTestAccess {
 public:
  static void set_generation(PoolBase& pool, std::size_t index, std::uint32_t generation) {
    pool.generations_[index] = generation;
  }
};
}  // namespace detail

namespace {

using Numbers = Pool<std::uint32_t, 3>;

TEST(PoolArchive, RetiredSlot_StaysRetiredWhereItIsRead) {
  Numbers pool;
  detail::PoolTestAccess::set_generation(pool, 1, std::numeric_limits<std::uint32_t>::max() - 1);
  for (std::uint32_t i = 0; i < 3; ++i) ASSERT_TRUE(pool.make(i).ok());
  const auto last = pool.handle_at(1);
  ASSERT_EQ(pool.remove(last), Status::kOk);
  std::vector<std::uint8_t> bytes(sizeof pool);
  ArchiveWriter writer(bytes.data(), static_cast<int>(bytes.size()));
  writer.look_at(pool);

  Numbers restored;
  ArchiveReader reader(bytes.data(), writer.position());
  reader(restored);
  ASSERT_TRUE(reader.is_done(writer.position()));
  EXPECT_EQ(restored.usable_capacity(), 2);
  EXPECT_EQ(restored.size(), 2);
  EXPECT_EQ(restored.get(last), nullptr);
  EXPECT_EQ(restored.make(7U).status, Status::kPoolFull);
}

/// The last generation is used up when its object goes, not while it lives.
TEST(PoolArchive, LastGenerationInUse_IsNotRetiredYet) {
  Numbers pool;
  detail::PoolTestAccess::set_generation(pool, 1, std::numeric_limits<std::uint32_t>::max() - 1);
  for (std::uint32_t i = 0; i < 3; ++i) ASSERT_TRUE(pool.make(i).ok());
  std::vector<std::uint8_t> bytes(sizeof pool);
  ArchiveWriter writer(bytes.data(), static_cast<int>(bytes.size()));
  writer.look_at(pool);

  Numbers restored;
  ArchiveReader reader(bytes.data(), writer.position());
  reader(restored);
  EXPECT_EQ(restored.usable_capacity(), 3);
  EXPECT_EQ(restored.remove(pool.handle_at(1)), Status::kOk);
  EXPECT_EQ(restored.usable_capacity(), 2);
}

}  // namespace
}  // namespace batuta
