// SPDX-License-Identifier: MIT
// The fencing duel with its two fencers, which searches as PRICE_SEARCH says, driven by two samples
// a step, and nothing around it.

#include "batuta/fencing/duel.hpp"

namespace {

using PricedScene =
    batuta::fencing::DuelScene<batuta::fencing::two_fencers, batuta::PRICE_SEARCH<float>>;
batuta::fencing::Duel<PricedScene> duel;
batuta::InputSample samples[2];
float volatile impulse;

}  // namespace

int main() {
  using namespace batuta;
  using namespace batuta::fencing;
  const auto settings = duel_settings<PricedScene>();
  if (duel.configure(settings, first_fencer<float>, second_fencer<float>) != Status::kOk) {
    return 1;
  }
  if (duel.step(&samples[0], &samples[1]) != Status::kOk) return 2;
  for (const auto& event : duel.world().events()) impulse = event.impulse;  // Bound: kMaxEvents
  return duel.bout().is_over() ? 1 : 0;
}
