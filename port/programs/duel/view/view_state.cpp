// SPDX-License-Identifier: MIT

#include "programs/duel/view/view_state.hpp"

namespace batuta::host {
using namespace fencing;

void ViewFeed::begin(const DuelRunner::DuelType& duel, const haptics::StickForces& forces) {
  const std::uint32_t bout = state_.bout + 1;
  state_ = ViewState();
  state_.bout = bout;
  touches_ = TouchCursor();
  take(duel, forces);
}

void ViewFeed::add_step(const DuelRunner::DuelType& duel, const haptics::StickForces& forces) {
  ++state_.steps;
  take(duel, forces);
  for (const auto& event : duel.events()) {  // Bound: DuelScene::kMaxEvents
    if (!is_beat(event)) continue;
    state_.beats[state_.beat_count % ViewState::kRecent] = beat_of(duel, event);
    ++state_.beat_count;
  }
}

void ViewFeed::take(const DuelRunner::DuelType& duel, const haptics::StickForces& forces) {
  state_.postures = postures_of(duel);
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const std::size_t i = index_of(side);
    state_.hands[i] = {duel.stick(side).position(), forces.of(side).share};
    state_.tips[i][state_.steps % ViewState::kRecent] = {static_cast<float>(state_.postures.time),
                                                         state_.postures.blade_W[i].axis.b};
  }
  touches_.for_each_new(
      duel, [&](const Touch<float>& touch) { (void)state_.touches.push(mark_of(duel, touch)); });
  state_.score = score_of(duel.bout());
  state_.halt = duel.bout().state == BoutState::kHalt;
  state_.corps_a_corps = duel.bout().is_corps_a_corps();
  state_.annulled = duel.bout().annulled;
}

}  // namespace batuta::host
