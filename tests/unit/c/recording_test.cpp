// SPDX-License-Identifier: MIT
// Recorder and player for C against the library's own recorder, and against the bout itself.

#include <gtest/gtest.h>

#include <cstring>
#include <memory>
#include <vector>

#include "batuta/c/duel.h"
#include "batuta/fencing/duel.hpp"
#include "batuta/record/duel.hpp"
#include "batuta/record/memory_stream.hpp"
#include "batuta/record/recorder.hpp"
#include "heap_trap.hpp"

namespace batuta {
using namespace fencing;
namespace {

constexpr std::int32_t kStepUs = 1000;
constexpr int kSteps = 600;
constexpr std::uint32_t kHashEvery = 10;

/// The left fencer lunges and goes back, twice; a sample each 5 steps.
batuta_stick left_at(int k) {
  const float out = static_cast<float>(k % 300) / 150.0F;
  const float share = out < 1 ? out : 2 - out;
  return {-share, share, 0, 0.5F * share};
}

std::uint64_t hash_of_c(const batuta_duel& duel) {
  std::uint64_t told = 0;
  EXPECT_EQ(batuta_duel_hash(&duel, &told), BATUTA_OK);
  return told;
}

class RecordingForC : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(batuta_duel_init(duel.get(), sizeof *duel, kStepUs, 5), BATUTA_OK);
    ASSERT_EQ(batuta_recorder_init(recorder.get(), sizeof *recorder, duel.get(), kHashEvery),
              BATUTA_OK);
  }
  std::int32_t step(int k) {
    const batuta_stick left = left_at(k);
    EXPECT_EQ(batuta_duel_step(duel.get(), k % 5 == 0 ? &left : nullptr, nullptr), BATUTA_OK);
    return batuta_recorder_step(recorder.get(), duel.get());
  }
  void take() {
    std::array<std::uint8_t, 999> some;
    for (std::size_t count = some.size(); count == some.size();) {
      count = batuta_recorder_take(recorder.get(), some.data(), some.size());
      bytes.insert(bytes.end(), some.begin(), some.begin() + static_cast<std::ptrdiff_t>(count));
    }
  }
  void record() {
    take();
    for (int k = 0; k < kSteps; ++k) {
      ASSERT_EQ(step(k), BATUTA_OK);
      take();
    }
    ASSERT_EQ(batuta_recorder_end(recorder.get(), duel.get()), BATUTA_OK);
    take();
  }
  /// In pieces of so many bytes. @returns how it ended; `last` is then the state
  std::int32_t play(std::size_t piece) {
    EXPECT_EQ(batuta_duel_init(played.get(), sizeof *played, kStepUs, 1), BATUTA_OK);
    EXPECT_EQ(batuta_player_init(player.get(), sizeof *player), BATUTA_OK);
    std::size_t at = 0;
    steps = 0;
    std::int32_t answer = BATUTA_PLAYBACK_WAITING;
    bool has_begun = false;
    for (std::size_t i = 0; i < 2 * bytes.size() + kSteps; ++i) {
      const auto call = has_begun ? batuta_player_next : batuta_player_begin;
      EXPECT_EQ(call(player.get(), played.get(), &answer), BATUTA_OK);
      has_begun = has_begun || answer == BATUTA_PLAYBACK_READY;
      if (answer == BATUTA_PLAYBACK_STEP) ++steps;
      if (answer > BATUTA_PLAYBACK_WAITING || answer == BATUTA_PLAYBACK_END) return answer;
      if (answer != BATUTA_PLAYBACK_WAITING) continue;
      const std::size_t count = std::min(piece, bytes.size() - at);
      EXPECT_EQ(
          batuta_player_give(player.get(), bytes.data() + at, count, at + count == bytes.size()),
          BATUTA_OK);
      at += count;
    }
    return answer;
  }

  std::unique_ptr<batuta_duel> duel = std::make_unique<batuta_duel>();
  std::unique_ptr<batuta_duel> played = std::make_unique<batuta_duel>();
  std::unique_ptr<batuta_recorder> recorder = std::make_unique<batuta_recorder>();
  std::unique_ptr<batuta_player> player = std::make_unique<batuta_player>();
  std::vector<std::uint8_t> bytes;
  int steps = 0;
};

/// The library's own duel with the same sticks, recorded by its own recorder.
std::vector<std::uint8_t> recorded_in_cpp() {
  auto settings = duel_settings<>();
  settings.step_us = kStepUs;
  settings.touches = 5;
  const auto duel = std::make_unique<Duel<>>();
  EXPECT_EQ(duel->configure(settings, first_fencer<float>(), second_fencer<float>()), Status::kOk);
  std::vector<std::uint8_t> bytes(1 << 18);
  MemorySink sink(bytes.data(), static_cast<int>(bytes.size()));
  std::vector<std::uint8_t> buffer(static_cast<std::size_t>(Recorder::kRoom<Duel<>>));
  Recorder recorder(sink, buffer.data(), static_cast<int>(buffer.size()));
  EXPECT_EQ(recorder.begin<DuelInput>(*duel, kHashEvery), Status::kOk);
  for (int k = 0; k < kSteps; ++k) {
    const batuta_stick stick = left_at(k);
    InputSample left;
    left.time = static_cast<Microseconds>(k * kStepUs);
    left.x = stick.x;
    left.y = stick.y;
    left.feet_x = stick.feet_x;
    left.feet_y = stick.feet_y;
    left.sequence = static_cast<std::uint32_t>(k / 5);
    DuelInput input;
    input.set(Side::kLeft, k % 5 == 0 ? &left : nullptr);
    EXPECT_EQ(duel->step(input.at(Side::kLeft), nullptr), Status::kOk);
    recorder.step(input, *duel);
    EXPECT_TRUE(recorder.flush());
  }
  EXPECT_EQ(recorder.end(*duel), Status::kOk);
  EXPECT_TRUE(recorder.flush());
  bytes.resize(static_cast<std::size_t>(sink.size()));
  return bytes;
}

TEST_F(RecordingForC, HasTheBytesOfTheLibrarysRecorder) {
  ASSERT_NO_FATAL_FAILURE(record());
  EXPECT_EQ(bytes, recorded_in_cpp());
}

TEST_F(RecordingForC, Played_InPiecesOfAnySize_EndsAsTheBoutDid) {
  ASSERT_NO_FATAL_FAILURE(record());
  for (const std::size_t piece :
       {std::size_t{1}, std::size_t{7}, std::size_t{4096}, bytes.size()}) {
    ASSERT_EQ(play(piece), BATUTA_PLAYBACK_END) << piece;
    EXPECT_EQ(steps, kSteps);
    EXPECT_EQ(batuta_player_agreed(player.get()), kSteps / kHashEvery + 1) << "the end mark's, too";
    EXPECT_EQ(batuta_player_unread(player.get()), 0U);
    EXPECT_EQ(hash_of_c(*played), hash_of_c(*duel));
  }
}

TEST_F(RecordingForC, Played_TellsTheForcesOfTheBout) {
  ASSERT_NO_FATAL_FAILURE(record());
  ASSERT_EQ(play(4096), BATUTA_PLAYBACK_END);
  batuta_duel_state live;
  batuta_duel_state past;
  ASSERT_EQ(batuta_duel_get_state(duel.get(), &live), BATUTA_OK);
  ASSERT_EQ(batuta_duel_get_state(played.get(), &past), BATUTA_OK);
  for (std::size_t axis = 0; axis < 2; ++axis) EXPECT_EQ(live.force[0][axis], past.force[0][axis]);
  EXPECT_NE(live.force[0][1], 0) << "nothing was felt";
}

// Forces are not kept: they begin anew, whatever was felt in the duel before.
TEST_F(RecordingForC, PlayedIntoADuelThatWasFenced_FeelsNothingOfIt) {
  ASSERT_NO_FATAL_FAILURE(record());
  ASSERT_EQ(batuta_duel_init(played.get(), sizeof *played, kStepUs, 5), BATUTA_OK);
  batuta_duel_state felt;
  for (int k = 0; k < 150; ++k) {
    const batuta_stick stick = left_at(k);
    ASSERT_EQ(batuta_duel_step(played.get(), &stick, nullptr), BATUTA_OK);
  }
  ASSERT_EQ(batuta_duel_get_state(played.get(), &felt), BATUTA_OK);
  ASSERT_NE(felt.force[0][1], 0) << "nothing was felt before";
  ASSERT_EQ(batuta_player_init(player.get(), sizeof *player), BATUTA_OK);
  ASSERT_EQ(batuta_player_give(player.get(), bytes.data(), bytes.size(), 1), BATUTA_OK);
  std::int32_t answer = -1;
  ASSERT_EQ(batuta_player_begin(player.get(), played.get(), &answer), BATUTA_OK);
  ASSERT_EQ(answer, BATUTA_PLAYBACK_READY);
  ASSERT_EQ(batuta_duel_get_state(played.get(), &felt), BATUTA_OK);
  for (const float share : {felt.force[0][0], felt.force[0][1]}) EXPECT_EQ(share, 0);
}

TEST_F(RecordingForC, WithABitFlipped_DoesNotEndWell) {
  ASSERT_NO_FATAL_FAILURE(record());
  const std::vector<std::uint8_t> whole = bytes;
  for (std::size_t at = 3; at < whole.size(); at += whole.size() / 40) {
    bytes = whole;
    bytes[at] = static_cast<std::uint8_t>(bytes[at] ^ 0x10U);
    EXPECT_GT(play(4096), BATUTA_PLAYBACK_WAITING) << "byte " << at;
  }
}

TEST_F(RecordingForC, CutShort_IsToldSo) {
  ASSERT_NO_FATAL_FAILURE(record());
  bytes.resize(bytes.size() - 9);
  EXPECT_EQ(play(4096), BATUTA_PLAYBACK_CUT);
  EXPECT_EQ(steps, kSteps);
}

TEST_F(RecordingForC, CutInItsStart_IsToldSoAtOnce) {
  ASSERT_NO_FATAL_FAILURE(record());
  for (const std::size_t count : {std::size_t{1}, std::size_t{200}, bytes.size() / 4}) {
    ASSERT_EQ(batuta_duel_init(played.get(), sizeof *played, kStepUs, 5), BATUTA_OK);
    ASSERT_EQ(batuta_player_init(player.get(), sizeof *player), BATUTA_OK);
    ASSERT_EQ(batuta_player_give(player.get(), bytes.data(), count, 1), BATUTA_OK);
    std::int32_t answer = -1;
    ASSERT_EQ(batuta_player_begin(player.get(), played.get(), &answer), BATUTA_OK);
    while (answer == BATUTA_PLAYBACK_READY || answer == BATUTA_PLAYBACK_STEP) {
      ASSERT_EQ(batuta_player_next(player.get(), played.get(), &answer), BATUTA_OK);
    }
    EXPECT_EQ(answer, BATUTA_PLAYBACK_CUT) << count << " bytes";
  }
}

TEST_F(RecordingForC, StepIntoAnotherDuel_IsRefused) {
  ASSERT_NO_FATAL_FAILURE(record());
  const auto fresh = std::make_unique<batuta_duel>();
  ASSERT_EQ(batuta_duel_init(fresh.get(), sizeof *fresh, kStepUs, 5), BATUTA_OK);
  ASSERT_EQ(batuta_duel_init(played.get(), sizeof *played, kStepUs, 5), BATUTA_OK);
  ASSERT_EQ(batuta_player_init(player.get(), sizeof *player), BATUTA_OK);
  ASSERT_EQ(batuta_player_give(player.get(), bytes.data(), bytes.size(), 1), BATUTA_OK);
  std::int32_t answer = -1;
  ASSERT_EQ(batuta_player_begin(player.get(), played.get(), &answer), BATUTA_OK);
  for (int k = 0; k < 9; ++k) {
    ASSERT_EQ(batuta_player_next(player.get(), played.get(), &answer), BATUTA_OK);
  }
  const auto before = hash_of_c(*fresh);
  EXPECT_EQ(batuta_player_next(player.get(), fresh.get(), &answer), BATUTA_INVALID_ARGUMENT);
  EXPECT_EQ(hash_of_c(*fresh), before);
  int steps_after = 0;
  do {
    ASSERT_EQ(batuta_player_next(player.get(), played.get(), &answer), BATUTA_OK);
    steps_after += answer == BATUTA_PLAYBACK_STEP ? 1 : 0;
  } while (answer == BATUTA_PLAYBACK_STEP);
  EXPECT_EQ(answer, BATUTA_PLAYBACK_END);
  EXPECT_EQ(steps_after, kSteps - 9);
  // Whoever fences on in it is told the end again.
  ASSERT_EQ(batuta_duel_step(played.get(), nullptr, nullptr), BATUTA_OK);
  ASSERT_EQ(batuta_player_next(player.get(), played.get(), &answer), BATUTA_OK);
  EXPECT_EQ(answer, BATUTA_PLAYBACK_END);
}

// A damaged start may leave the duel with what was read of it. Nothing then takes it for a bout.
TEST_F(RecordingForC, OfForeignBytes_LeavesTheDuelAlone) {
  const auto before = hash_of_c(*duel);
  bytes.assign(500, 0x42);
  ASSERT_EQ(batuta_player_init(player.get(), sizeof *player), BATUTA_OK);
  ASSERT_EQ(batuta_player_give(player.get(), bytes.data(), bytes.size(), 1), BATUTA_OK);
  std::int32_t answer = -1;
  ASSERT_EQ(batuta_player_begin(player.get(), duel.get(), &answer), BATUTA_OK);
  EXPECT_EQ(answer, BATUTA_PLAYBACK_FOREIGN);
  EXPECT_EQ(hash_of_c(*duel), before);
}

TEST_F(RecordingForC, NotTakenInTime_EndsAtAGapThatIsTold) {
  take();
  int kept = 0;
  while (step(kept) == BATUTA_OK) ASSERT_LT(++kept, kSteps);
  EXPECT_GT(kept, 50);
  take();
  EXPECT_EQ(step(kept), BATUTA_POOL_FULL) << "what is missing stays missing";
  ASSERT_EQ(batuta_recorder_end(recorder.get(), duel.get()), BATUTA_OK);
  take();
  EXPECT_EQ(play(4096), BATUTA_PLAYBACK_GAP);
  EXPECT_EQ(steps, kept);
}

TEST_F(RecordingForC, StepsThatAreForgottenOrDoubled_AreRefused) {
  take();
  ASSERT_EQ(step(0), BATUTA_OK);
  EXPECT_EQ(batuta_recorder_step(recorder.get(), duel.get()), BATUTA_INVALID_ARGUMENT) << "twice";
  ASSERT_EQ(step(1), BATUTA_OK);
  ASSERT_EQ(batuta_duel_step(duel.get(), nullptr, nullptr), BATUTA_OK);  // and is not recorded
  EXPECT_EQ(step(3), BATUTA_INVALID_ARGUMENT);
}

/// Its end says what the duel is: that of another step, or another duel, would be told as a fault
/// of who plays it.
TEST_F(RecordingForC, EndedWithADuelThatIsElsewhere_IsRefused) {
  for (int k = 0; k < 10; ++k) ASSERT_EQ(step(k), BATUTA_OK);
  EXPECT_EQ(batuta_duel_step(duel.get(), nullptr, nullptr), BATUTA_OK);
  EXPECT_EQ(batuta_recorder_end(recorder.get(), duel.get()), BATUTA_INVALID_ARGUMENT);
  ASSERT_EQ(batuta_recorder_step(recorder.get(), duel.get()), BATUTA_OK);
  ASSERT_EQ(batuta_duel_init(played.get(), sizeof *played, kStepUs, 5), BATUTA_OK);
  EXPECT_EQ(batuta_recorder_end(recorder.get(), played.get()), BATUTA_INVALID_ARGUMENT);
  ASSERT_EQ(batuta_recorder_end(recorder.get(), duel.get()), BATUTA_OK);
  EXPECT_EQ(batuta_recorder_end(recorder.get(), duel.get()), BATUTA_UNAVAILABLE);
  take();
  EXPECT_EQ(play(1000), BATUTA_PLAYBACK_END);
  EXPECT_EQ(steps, 11);
}

/// Where nothing was put into the duel, nothing keeps it from being put elsewhere.
TEST_F(RecordingForC, OfNoBytesYet_LeavesTheDistanceFree) {
  ASSERT_EQ(batuta_duel_init(played.get(), sizeof *played, kStepUs, 1), BATUTA_OK);
  ASSERT_EQ(batuta_player_init(player.get(), sizeof *player), BATUTA_OK);
  std::int32_t answer = 0;
  ASSERT_EQ(batuta_player_begin(player.get(), played.get(), &answer), BATUTA_OK);
  ASSERT_EQ(answer, BATUTA_PLAYBACK_WAITING);
  EXPECT_EQ(batuta_duel_set_distance(played.get(), 1000.0F), BATUTA_OK);
  EXPECT_EQ(batuta_duel_set_distance(played.get(), 1000.5F), BATUTA_INVALID_ARGUMENT);
}

TEST_F(RecordingForC, Begun_IsNotBegunAgain_AndItsDistanceStays) {
  ASSERT_NO_FATAL_FAILURE(record());
  ASSERT_EQ(batuta_duel_init(played.get(), sizeof *played, 2 * kStepUs, 1), BATUTA_OK);
  ASSERT_EQ(batuta_player_init(player.get(), sizeof *player), BATUTA_OK);
  ASSERT_EQ(batuta_player_give(player.get(), bytes.data(), bytes.size(), 1), BATUTA_OK);
  std::int32_t answer = -1;
  ASSERT_EQ(batuta_player_begin(player.get(), played.get(), &answer), BATUTA_OK);
  ASSERT_EQ(answer, BATUTA_PLAYBACK_READY);
  const auto before = hash_of_c(*played);
  EXPECT_EQ(batuta_player_begin(player.get(), played.get(), &answer), BATUTA_INVALID_ARGUMENT);
  EXPECT_EQ(batuta_duel_set_distance(played.get(), 4), BATUTA_UNAVAILABLE);
  EXPECT_EQ(hash_of_c(*played), before);
}

// Two duels of one hash go on alike: what the next sample is called is part of the duel.
TEST_F(RecordingForC, Played_GoesOnAsTheBoutDoes) {
  ASSERT_NO_FATAL_FAILURE(record());
  ASSERT_EQ(play(4096), BATUTA_PLAYBACK_END);
  for (int k = 0; k < 100; ++k) {
    const batuta_stick stick = left_at(k);
    for (batuta_duel* const one : {duel.get(), played.get()}) {
      ASSERT_EQ(batuta_duel_step(one, &stick, nullptr), BATUTA_OK);
    }
    ASSERT_EQ(hash_of_c(*played), hash_of_c(*duel)) << k;
  }
}

TEST_F(RecordingForC, OfADuelThatIsNone_IsDamaged) {
  const auto none = std::make_unique<Duel<>>();
  bytes.resize(1 << 14);
  MemorySink sink(bytes.data(), static_cast<int>(bytes.size()));
  std::vector<std::uint8_t> buffer(static_cast<std::size_t>(Recorder::kRoom<Duel<>>));
  Recorder own(sink, buffer.data(), static_cast<int>(buffer.size()));
  ASSERT_EQ(own.begin<DuelInput>(*none, 0), Status::kOk);
  ASSERT_EQ(own.end(*none), Status::kOk);
  ASSERT_TRUE(own.flush());
  bytes.resize(static_cast<std::size_t>(sink.size()));
  EXPECT_EQ(play(4096), BATUTA_PLAYBACK_DAMAGED);
}

TEST_F(RecordingForC, HasNoRoomForItsEnd_UntilSomethingIsTaken) {
  while (step(0) == BATUTA_OK) continue;
  std::int32_t status = batuta_recorder_end(recorder.get(), duel.get());
  if (status == BATUTA_POOL_FULL) {
    take();
    status = batuta_recorder_end(recorder.get(), duel.get());
  }
  EXPECT_EQ(status, BATUTA_OK);
  EXPECT_EQ(batuta_recorder_end(recorder.get(), duel.get()), BATUTA_UNAVAILABLE);
  EXPECT_EQ(batuta_recorder_step(recorder.get(), duel.get()), BATUTA_UNAVAILABLE);
}

TEST_F(RecordingForC, Storage_IsFilledAndAllocatesNothing) {
  EXPECT_EQ(alignof(batuta_recorder) % batuta_recorder_align(), 0U);
  EXPECT_EQ(alignof(batuta_player) % batuta_player_align(), 0U);
  EXPECT_LE(batuta_recorder_size(), sizeof(batuta_recorder));
  EXPECT_LE(batuta_player_size(), sizeof(batuta_player));
  const test::HeapTrap trap;
  (void)step(0);
  (void)batuta_player_init(player.get(), batuta_player_size());
  EXPECT_EQ(trap.allocations(), 0);
}

TEST_F(RecordingForC, BadInput_IsRefused) {
  batuta_recorder none_recorder{};
  batuta_player none_player{};
  std::uint8_t byte = 0;
  std::int32_t answer = 77;
  const auto* const no_duel = played.get();  // zeros
  EXPECT_EQ(batuta_recorder_init(nullptr, sizeof *recorder, duel.get(), 1),
            BATUTA_INVALID_ARGUMENT);
  EXPECT_EQ(batuta_recorder_init(&none_recorder, batuta_recorder_size() - 1, duel.get(), 1),
            BATUTA_INVALID_ARGUMENT);
  EXPECT_EQ(batuta_recorder_init(&none_recorder, sizeof none_recorder, no_duel, 1),
            BATUTA_INVALID_ARGUMENT);
  EXPECT_EQ(batuta_recorder_step(&none_recorder, duel.get()), BATUTA_INVALID_ARGUMENT);
  EXPECT_EQ(batuta_recorder_step(recorder.get(), no_duel), BATUTA_INVALID_ARGUMENT);
  EXPECT_EQ(batuta_recorder_end(&none_recorder, duel.get()), BATUTA_INVALID_ARGUMENT);
  EXPECT_EQ(batuta_recorder_end(recorder.get(), nullptr), BATUTA_INVALID_ARGUMENT);
  EXPECT_EQ(batuta_recorder_take(&none_recorder, &byte, 1), 0U);
  EXPECT_EQ(batuta_recorder_take(recorder.get(), nullptr, 1), 0U);
  EXPECT_EQ(batuta_player_init(nullptr, sizeof none_player), BATUTA_INVALID_ARGUMENT);
  EXPECT_EQ(batuta_player_init(&none_player, batuta_player_size() - 1), BATUTA_INVALID_ARGUMENT);
  EXPECT_EQ(batuta_player_give(&none_player, &byte, 1, 1), BATUTA_INVALID_ARGUMENT);
  EXPECT_EQ(batuta_player_begin(&none_player, duel.get(), &answer), BATUTA_INVALID_ARGUMENT);
  EXPECT_EQ(batuta_player_next(&none_player, duel.get(), &answer), BATUTA_INVALID_ARGUMENT);
  EXPECT_EQ(batuta_player_unread(&none_player), 0U);
  EXPECT_EQ(batuta_player_agreed(&none_player), 0U);
  ASSERT_EQ(batuta_player_init(player.get(), sizeof *player), BATUTA_OK);
  EXPECT_EQ(batuta_player_give(player.get(), nullptr, 1, 1), BATUTA_INVALID_ARGUMENT);
  EXPECT_EQ(batuta_player_begin(player.get(), played.get(), &answer), BATUTA_INVALID_ARGUMENT);
  EXPECT_EQ(batuta_player_begin(player.get(), duel.get(), nullptr), BATUTA_INVALID_ARGUMENT);
  EXPECT_EQ(batuta_player_next(player.get(), duel.get(), nullptr), BATUTA_INVALID_ARGUMENT);
  EXPECT_EQ(answer, 77);
  EXPECT_EQ(batuta_player_next(player.get(), duel.get(), &answer), BATUTA_INVALID_ARGUMENT)
      << "nothing was begun";
  EXPECT_EQ(answer, 77);
}

}  // namespace
}  // namespace batuta
