// SPDX-License-Identifier: MIT
#include "batuta/record/snapshot.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "batuta/core/crc32.hpp"

namespace batuta {
namespace {

template <class Scalar, int N = 4>
struct State {
  std::array<Scalar, N> numbers{};
  bool flag = false;

  void archive(Archive& ar) {
    auto& [a, b] = *this;
    ar(a, b);
  }
};

using Bytes = std::vector<std::uint8_t>;

template <class T>
Bytes saved(const T& state) {
  Bytes bytes(kSnapshotRoom<T>);
  const Result<int> size = save(state, bytes.data(), static_cast<int>(bytes.size()));
  EXPECT_TRUE(size.ok());
  bytes.resize(static_cast<std::size_t>(size.value));
  return bytes;
}

template <class T>
Restored restored(T& state, const Bytes& bytes) {
  return restore(state, bytes.data(), static_cast<int>(bytes.size()));
}

State<float> example() {
  State<float> state;
  state.numbers = {1, 2, 3, 4};
  state.flag = true;
  return state;
}

TEST(Snapshot, Restored_IsTheSame) {
  State<float> state;
  EXPECT_EQ(restored(state, saved(example())), Restored::kOk);
  EXPECT_EQ(hash_of(state), hash_of(example()));
}

/// The check sum of anything with its own check sum behind it, lowest byte first, is one number:
/// the residue of the catalogue, 0xDEBB20E3, inverted. That it is the right sum: crc32_test.cpp.
TEST(Snapshot, HeadAndCheckSum_AreThoseOfTheDocument) {
  const Bytes bytes = saved(example());
  ASSERT_EQ(bytes.size(), 20U + 17U + 4U);
  EXPECT_EQ(Bytes(bytes.begin(), bytes.begin() + 8), (Bytes{'B', 'A', 'T', 'S', 1, 0, 4, 0}));
  EXPECT_EQ(Bytes(bytes.begin() + 16, bytes.begin() + 20), (Bytes{17, 0, 0, 0}));
  EXPECT_EQ(bytes[36], 1);
  EXPECT_EQ(crc32(bytes.data(), static_cast<int>(bytes.size())), ~0xDEBB20E3U);
}

TEST(Snapshot, EveryBitDamaged_IsRefusedAndTheStateStays) {
  const Bytes good = saved(example());
  for (std::size_t i = 0; i < 8 * good.size(); ++i) {
    Bytes bytes = good;
    bytes[i / 8] = static_cast<std::uint8_t>(bytes[i / 8] ^ (1U << (i % 8)));
    State<float> state;
    EXPECT_NE(restored(state, bytes), Restored::kOk) << "bit " << i;
    EXPECT_EQ(hash_of(state), hash_of(State<float>{})) << "bit " << i;
  }
}

TEST(Snapshot, EveryOtherLength_IsRefused) {
  const Bytes good = saved(example());
  for (std::size_t size = 0; size < good.size() + 4; ++size) {
    if (size == good.size()) continue;
    Bytes bytes = good;
    bytes.resize(size);
    State<float> state;
    EXPECT_NE(restored(state, bytes), Restored::kOk) << size;
  }
}

TEST(Snapshot, OfAnotherKind_SaysWhich) {
  State<float> state;
  EXPECT_EQ(restored(state, Bytes(100, 0)), Restored::kForeign);
  EXPECT_EQ(restored(state, {}), Restored::kForeign);
  EXPECT_EQ(restored(state, saved(State<double>{})), Restored::kOtherScalar);
  EXPECT_EQ(restored(state, saved(State<float, 5>{})), Restored::kOtherScene);
  Bytes newer = saved(example());
  newer[4] = 2;
  EXPECT_EQ(restored(state, newer), Restored::kOtherVersion);
  Bytes not_zero = saved(example());
  not_zero[7] = 1;
  EXPECT_EQ(restored(state, not_zero), Restored::kDamaged);
}

TEST(Snapshot, OutOfRangeUnderAGoodCheckSum_IsRefused) {
  Bytes bytes = saved(example());
  bytes[36] = 2;  // the flag
  detail::seal(bytes.data(), 37);
  State<float> state;
  EXPECT_EQ(restored(state, bytes), Restored::kOutOfRange);
}

TEST(Snapshot, TooLittleRoom_SaysSo) {
  const auto full = static_cast<int>(saved(example()).size());
  for (int room = 0; room < full; ++room) {
    Bytes bytes(static_cast<std::size_t>(room));
    EXPECT_EQ(save(example(), bytes.data(), room).status, Status::kPoolFull);
  }
}

}  // namespace
}  // namespace batuta
