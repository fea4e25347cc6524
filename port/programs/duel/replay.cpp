// SPDX-License-Identifier: MIT

#include "programs/duel/replay.hpp"

#include <array>
#include <cinttypes>
#include <cstdio>
#include <memory>
#include <vector>

#include "batuta/record/duel.hpp"
#include "programs/duel/options.hpp"
#include "programs/recording/file_stream.hpp"

namespace batuta::host {
using namespace fencing;
namespace {

template <class DuelType>
void play_on(Player& player, DuelType& duel, ReplayWatcher* watcher, Replay& result) {
  const SeenDuelOf<DuelType> seen(duel);
  Playback& answer = result.answer;
  answer = player.begin<DuelInput>(duel);
  result.began = answer == Playback::kReady || answer == Playback::kStep;
  if (result.began && watcher != nullptr) watcher->on_start(seen);
  while (answer == Playback::kReady || answer == Playback::kStep) {  // Bound: the file
    DuelInput input;
    answer = player.next(input, duel);
    if (answer != Playback::kStep) continue;
    // What the duel says to a step is part of its state, and compared with it.
    (void)duel.step(input.at(Side::kLeft), input.at(Side::kRight));
    result.broken_off = watcher != nullptr && !watcher->on_step(seen);
    if (result.broken_off) return;
  }
}

/// A recording is a state and what was done to it; each has a format and a version of its own.
std::string other_version(const Replay& replay) {
  const bool is_state = replay.state_version != batuta::detail::kSnapshotVersion;
  const int found = is_state ? replay.state_version : replay.version;
  const int known = is_state ? batuta::detail::kSnapshotVersion : batuta::detail::kRecordingVersion;
  return "is of version " + std::to_string(found) + " of the format" +
         (is_state ? " of states" : "") + "; this program reads version " + std::to_string(known);
}

std::string why_not(const Replay& replay) {
  switch (replay.answer) {
    case Playback::kForeign:
      return "is not a recording";
    case Playback::kOtherVersion:
      return other_version(replay);
    case Playback::kOtherScalar:
    case Playback::kOtherScene:
    case Playback::kTooLarge:
      return "is a recording of another scene than this program's duel";
    case Playback::kGap:
      return "has a gap here: the recorder could not write as fast as the bout went";
    case Playback::kCut:
    case Playback::kWaiting:
      return "ends here without an end mark";
    case Playback::kParted:
      return "parts from this replay in its last step";
    case Playback::kReady:
    case Playback::kStep:
    case Playback::kEnd:
    case Playback::kDamaged:
      break;
  }
  return "is damaged here";
}

std::string why_not_begun(const Replay& replay) {
  const bool cut = replay.answer == Playback::kCut || replay.answer == Playback::kWaiting;
  if (cut) return "ends before its first step";
  return replay.answer == Playback::kDamaged ? "is damaged before its first step" : why_not(replay);
}

std::string hexadecimal(std::uint64_t number) {
  std::array<char, 17> digits{};
  std::snprintf(digits.data(), digits.size(), "%016" PRIx64, number);
  return digits.data();
}

template <class DuelType>
Replay replay_with(SearchKind search, const std::string& path, ReplayWatcher* watcher) {
  Replay result;
  result.search = search;
  result.path = path;
  FileSource file;
  result.error = file.open(path);
  if (!result.error.empty()) return result;
  constexpr int kBuffer = Player::kRoom<DuelType>;
  std::vector<std::uint8_t> buffer(static_cast<std::size_t>(kBuffer));
  Player player(file, buffer.data(), kBuffer);
  const auto duel = std::make_unique<DuelType>();
  play_on(player, *duel, watcher, result);
  std::uint8_t behind = 0;  // a player asks for nothing that stands behind the end mark
  result.goes_on = result.answer == Playback::kEnd && file.read(&behind, 1) > 0;
  result.steps = player.steps();
  result.hashes = player.agreed();
  if (result.began) result.hash = hash_of(*duel);
  result.lost = player.lost();
  result.version = player.version();
  result.state_version = player.state_version();
  return result;
}

}  // namespace

// The state at the start tells by its fingerprint whose it is.
Replay replay(const std::string& path, ReplayWatcher* watcher) {
  Replay certified = replay_with<CertifiedDuel>(SearchKind::kAdvancement, path, watcher);
  if (certified.answer != Playback::kOtherScene) return certified;
  const Replay paper = replay_with<PaperDuel>(SearchKind::kStepping, path, watcher);
  return paper.answer == Playback::kOtherScene ? certified : paper;
}

std::string words_for(const Replay& replay) {
  if (!replay.error.empty()) return replay.error;
  if (!replay.began) return replay.path + ": it " + why_not_begun(replay);
  const std::string file = replay.path + ": ";
  const std::string steps = std::to_string(replay.steps) + " steps, ";
  const std::string hashes = std::to_string(replay.hashes) + " hashes agreed, search " +
                             name_of(replay.search) + ", hash " + hexadecimal(replay.hash);
  if (replay.broken_off) return file + steps + hashes + "; broken off";
  if (replay.goes_on) {
    return file + steps + hashes + "; the recording goes on behind its end mark";
  }
  if (replay.answer == Playback::kEnd) return file + steps + hashes;
  std::string words = file + steps + hashes + "; the recording " + why_not(replay);
  if (replay.lost > 0) words += " (" + std::to_string(replay.lost) + " steps are missing)";
  return words;
}

int exit_code_for(const Replay& replay) {
  if (!replay.error.empty()) return kExitUsage;
  if (replay.broken_off) return kExitOk;
  switch (replay.answer) {
    case Playback::kEnd:
      return replay.goes_on ? kExitFailure : kExitOk;
    case Playback::kForeign:
    case Playback::kOtherVersion:
    case Playback::kOtherScalar:
    case Playback::kOtherScene:
    case Playback::kTooLarge:
      return kExitUsage;
    default:
      return kExitFailure;
  }
}

}  // namespace batuta::host
