// SPDX-License-Identifier: MIT

#include "programs/duel/replay.hpp"

#include <memory>
#include <vector>

#include "batuta/record/duel.hpp"
#include "programs/duel/options.hpp"
#include "programs/recording/file_stream.hpp"

namespace batuta::host {
using namespace fencing;
namespace {

using DuelType = Duel<>;

Playback play_on(Player& player, DuelType& duel) {
  Playback answer = player.begin<DuelInput>(duel);
  while (answer == Playback::kReady || answer == Playback::kStep) {  // Bound: the file
    DuelInput input;
    answer = player.next(input, duel);
    // What the duel says to a step is part of its state, and compared with it.
    if (answer == Playback::kStep) (void)duel.step(input.at(Side::kLeft), input.at(Side::kRight));
  }
  return answer;
}

std::string why_not(Playback answer) {
  switch (answer) {
    case Playback::kForeign:
      return "is not a recording";
    case Playback::kOtherVersion:
      return "is a recording of another version of the format";
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

}  // namespace

Replay replay(const std::string& path) {
  Replay result;
  result.path = path;
  FileSource file;
  result.error = file.open(path);
  if (!result.error.empty()) return result;
  constexpr int kBuffer = Player::kRoom<DuelType>;
  std::vector<std::uint8_t> buffer(static_cast<std::size_t>(kBuffer));
  Player player(file, buffer.data(), kBuffer);
  const auto duel = std::make_unique<DuelType>();
  result.answer = play_on(player, *duel);
  std::uint8_t behind = 0;  // a player asks for nothing that stands behind the end mark
  result.goes_on = result.answer == Playback::kEnd && file.read(&behind, 1) > 0;
  result.steps = player.steps();
  result.hashes = player.agreed();
  result.lost = player.lost();
  return result;
}

std::string words_for(const Replay& replay) {
  if (!replay.error.empty()) return replay.error;
  const std::string file = replay.path + ": ";
  const std::string steps = std::to_string(replay.steps) + " steps, ";
  const std::string hashes = std::to_string(replay.hashes) + " hashes agreed";
  if (replay.goes_on) {
    return file + steps + hashes + "; the recording goes on behind its end mark";
  }
  if (replay.answer == Playback::kEnd) return file + steps + hashes;
  std::string words = file + steps + hashes + "; the recording " + why_not(replay.answer);
  if (replay.lost > 0) words += " (" + std::to_string(replay.lost) + " steps are missing)";
  return words;
}

int exit_code_for(const Replay& replay) {
  if (!replay.error.empty()) return kExitUsage;
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
