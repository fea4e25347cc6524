// SPDX-License-Identifier: MIT
// How little room a recording can be played in, and records where others belong.
#include <gtest/gtest.h>

#include <vector>

#include "batuta/record/memory_stream.hpp"
#include "batuta/record/player.hpp"
#include "batuta/record/recorder.hpp"
#include "batuta/record/snapshot.hpp"

namespace batuta {
namespace {

/// A state of 40 bytes, so that it needs more room than the record that follows.
struct State {
  std::array<std::uint64_t, 5> words{1, 2, 3, 4, 5};

  void archive(Archive& ar) { ar(words); }
};
constexpr int kStateBytes = detail::kSnapshotHead + 40 + detail::kCheckSum;

struct Input {
  std::uint8_t byte = 0;

  void archive(Archive& ar) { ar(byte); }
};

std::vector<std::uint8_t> recorded(const State& state) {
  std::vector<std::uint8_t> bytes(1024);
  std::vector<std::uint8_t> buffer(512);
  MemorySink sink(bytes.data(), static_cast<int>(bytes.size()));
  Recorder recorder(sink, buffer.data(), static_cast<int>(buffer.size()));
  EXPECT_EQ(recorder.begin<Input>(state, 0), Status::kOk);
  EXPECT_EQ(recorder.end(state), Status::kOk);
  EXPECT_TRUE(recorder.flush());
  return bytes;
}

Playback begun(const std::vector<std::uint8_t>& bytes, int capacity, State& state) {
  std::vector<std::uint8_t> buffer(static_cast<std::size_t>(capacity));
  MemorySource source(bytes.data(), static_cast<int>(bytes.size()));
  Player player(source, buffer.data(), capacity);
  return player.begin<Input>(state);
}

TEST(Player, RoomForTheStateOrNot_IsAByteApart) {
  const std::vector<std::uint8_t> bytes = recorded(State{});
  for (int capacity = 0; capacity < kStateBytes; ++capacity) {
    State state{{9, 9, 9, 9, 9}};
    ASSERT_EQ(begun(bytes, capacity, state), Playback::kTooLarge) << capacity;
    ASSERT_EQ(state.words[0], 9U) << "refused, and nothing read";
  }
  State state{{9, 9, 9, 9, 9}};
  EXPECT_EQ(begun(bytes, kStateBytes, state), Playback::kReady);
  EXPECT_EQ(state.words, State{}.words);
}

/// Its bytes and its check sum are right, and only its kind is not.
TEST(Player, RunUnderAnotherKind_IsDamage) {
  std::vector<std::uint8_t> bytes = recorded(State{});
  std::uint8_t* const record = bytes.data() + kStateBytes;
  const int size = detail::kRecordHead + (record[1] | record[2] << 8);
  for (const detail::RecordKind kind :
       {detail::RecordKind::kStep, detail::RecordKind::kHash, detail::RecordKind::kEnd}) {
    record[0] = static_cast<std::uint8_t>(kind);
    detail::seal(record, size);
    State state;
    EXPECT_EQ(begun(bytes, 256, state), Playback::kDamaged);
  }
  record[0] = static_cast<std::uint8_t>(detail::RecordKind::kRun);
  detail::seal(record, size);
  State state;
  EXPECT_EQ(begun(bytes, 256, state), Playback::kReady);
}

}  // namespace
}  // namespace batuta
