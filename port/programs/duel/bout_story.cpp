// SPDX-License-Identifier: MIT

#include "programs/duel/bout_story.hpp"

#include "programs/duel/bout_words.hpp"

namespace batuta::host {
using namespace fencing;

void BoutStory::add_step(const DuelRunner::DuelType& duel) {
  const auto now = static_cast<float>(time_of(duel));
  for (const Side side : {Side::kLeft, Side::kRight}) {
    add_tip(side, {now, duel.blade_W(side).axis.b});
  }
  for (const auto& event : duel.events()) {  // Bound: DuelScene::kMaxEvents
    if (is_beat(event)) add_beat(beat_of(duel, event));
  }
}

void BoutStory::add_beat(const Beat& beat) {
  if (beats_.push(beat)) return;
  ++beats_left_out_;
  int weakest = 0;
  for (int i = 1; i < kMaxBeats; ++i) {  // Bound: kMaxBeats
    if (beats_[i].impulse < beats_[weakest].impulse) weakest = i;
  }
  if (beats_[weakest].impulse < beat.impulse) beats_[weakest] = beat;
}

}  // namespace batuta::host
