// SPDX-License-Identifier: MIT
// What must hold of the recordings of batuta/c/duel.h for any bytes whatever, as a libFuzzer
// target: what was recorded plays back to the same hash, in pieces of any size; what was changed on
// the way is told, and nothing is made of it that was not recorded.

#include <array>
#include <cstddef>
#include <vector>

#include "batuta/c/duel.h"
#include "bytes.hpp"

namespace batuta::fuzz {
namespace {

constexpr std::int32_t kStepUs = 1000;
constexpr int kMostSteps = 40;

std::uint64_t hash_of_duel(const batuta_duel& duel) {
  std::uint64_t hash = 0;
  require(batuta_duel_hash(&duel, &hash) == BATUTA_OK, "a duel has a hash");
  return hash;
}

/// A bout of a few steps, and its recording.
struct Recorded {
  std::vector<std::uint8_t> bytes;
  int steps = 0;
  bool is_whole = true;
  std::uint64_t hash = 0;
};

/// Takes up to as many bytes as are asked for.
void take(batuta_recorder& recorder, std::size_t most, std::vector<std::uint8_t>& bytes) {
  const std::size_t before = bytes.size();
  bytes.resize(before + most + 1);
  const std::size_t count = batuta_recorder_take(&recorder, bytes.data() + before, most);
  require(count <= most, "no more than there is room for");
  bytes.resize(before + count);
}

Recorded record(Bytes& bytes) {
  static batuta_duel duel;
  static batuta_recorder recorder;
  static batuta_opponent rival;
  constexpr std::size_t kAll = std::size_t{1} << 16U;
  Recorded made;
  require(batuta_duel_init(&duel, sizeof duel, kStepUs, 1) == BATUTA_OK, "a duel begins");
  require(batuta_opponent_init(&rival, sizeof rival, bytes.choice(3), bytes.word()) == BATUTA_OK,
          "an opponent is one");
  require(batuta_recorder_init(&recorder, sizeof recorder, &duel,
                               static_cast<std::uint32_t>(bytes.choice(5))) == BATUTA_OK,
          "a recording begins");
  take(recorder, kAll, made.bytes);
  const int steps = bytes.choice(kMostSteps);
  for (int i = 0; i < steps; ++i) {
    batuta_stick seen{};
    require(batuta_opponent_look(&rival, &duel, BATUTA_RIGHT, &seen) == BATUTA_OK, "it sees");
    const batuta_sample left = {{2 * bytes.share() - 1, 2 * bytes.share() - 1, 0, 0},
                                static_cast<std::uint32_t>(i) * 1000U + bytes.byte(),
                                bytes.byte(),
                                bytes.byte()};
    const batuta_sample right = {seen, static_cast<std::uint32_t>(i) * 1000U, 0,
                                 static_cast<std::uint32_t>(i)};
    if (batuta_duel_step_sampled(&duel, bytes.flag() ? &left : nullptr, &right) != BATUTA_OK) break;
    made.is_whole = batuta_recorder_step(&recorder, &duel) == BATUTA_OK && made.is_whole;
    if (made.is_whole) ++made.steps;
    take(recorder, bytes.byte(), made.bytes);
  }
  take(recorder, kAll, made.bytes);
  require(batuta_recorder_end(&recorder, &duel) == BATUTA_OK, "a recording ends");
  take(recorder, kAll, made.bytes);
  made.hash = hash_of_duel(duel);
  return made;
}

/// @returns whether anything is another byte now
bool edit(Bytes& bytes, std::vector<std::uint8_t>& recording) {
  const std::vector<std::uint8_t> before = recording;
  const int edits = bytes.choice(4);
  for (int i = 0; i < edits; ++i) {
    const std::size_t at = bytes.word() % recording.size();
    recording[at] = static_cast<std::uint8_t>(recording[at] ^ bytes.byte());
  }
  return recording != before;
}

/// In pieces of so many bytes. @returns how it ended
std::int32_t play(const std::vector<std::uint8_t>& recording, std::size_t piece, batuta_duel& duel,
                  int& steps) {
  static batuta_player player;
  require(batuta_player_init(&player, sizeof player) == BATUTA_OK, "a player begins");
  const std::uint64_t before = hash_of_duel(duel);
  std::int32_t answer = BATUTA_PLAYBACK_WAITING;
  bool has_begun = false;
  std::size_t at = 0;
  for (std::size_t i = 0; i < 2 * recording.size() + 4 * kMostSteps; ++i) {
    const auto call = has_begun ? batuta_player_next : batuta_player_begin;
    require(call(&player, &duel, &answer) == BATUTA_OK, "a player answers");
    has_begun = has_begun || answer == BATUTA_PLAYBACK_READY;
    if (answer == BATUTA_PLAYBACK_STEP) ++steps;
    if (answer == BATUTA_PLAYBACK_END || answer > BATUTA_PLAYBACK_WAITING) break;
    if (answer != BATUTA_PLAYBACK_WAITING) continue;
    const std::size_t count = std::min(piece, recording.size() - at);
    require(batuta_player_give(&player, recording.data() + at, count,
                               at + count == recording.size()) == BATUTA_OK,
            "it takes bytes");
    at += count;
  }
  if (!has_begun && answer != BATUTA_PLAYBACK_DAMAGED) {
    require(hash_of_duel(duel) == before, "what was not begun leaves the duel as it was");
  }
  return answer;
}

void check(Bytes bytes) {
  static batuta_duel duel;
  Recorded recorded = record(bytes);
  const bool is_edited = edit(bytes, recorded.bytes);
  require(batuta_duel_init(&duel, sizeof duel, kStepUs, 1) == BATUTA_OK, "a duel begins");
  int steps = 0;
  const std::int32_t answer =
      play(recorded.bytes, static_cast<std::size_t>(bytes.byte()) * 8 + 1, duel, steps);
  require(steps <= recorded.steps, "no step that was not recorded");
  if (is_edited) {
    require(answer > BATUTA_PLAYBACK_WAITING, "what was changed is told");
    return;
  }
  require(steps == recorded.steps, "every step");
  require(answer == (recorded.is_whole ? BATUTA_PLAYBACK_END : BATUTA_PLAYBACK_GAP),
          "the end, or what is missing");
  if (recorded.is_whole) require(hash_of_duel(duel) == recorded.hash, "the same bits");
}

}  // namespace
}  // namespace batuta::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  batuta::fuzz::check({data, size});
  return 0;
}
