// SPDX-License-Identifier: MIT
// Bouts that are searched as PRICE_SEARCH says.

#include "batuta/fencing/duel.hpp"
#include "measure.hpp"
#include "sticks.hpp"
#include "ticks.hpp"

namespace batuta::price {
using namespace fencing;
namespace {

using PricedScene = DuelScene<two_fencers, PRICE_SEARCH<float>>;
Duel<PricedScene> duel;

void begin(std::uint32_t step, SampleFile& out) {
  const auto settings = duel_settings<PricedScene>();
  const auto left = first_fencer<float>();
  const auto right = second_fencer<float>();
  Status status = Status::kOk;
  const std::uint32_t ticks = ticks_of([&] { status = duel.configure(settings, left, right); });
  out.add({Kind::kConfigure, step, ticks, {static_cast<std::uint32_t>(status), 0, 0}});
}

void measure_step(std::uint32_t step, Sticks& sticks, SampleFile& out) {
  const InputSample* taken[2];
  sticks.take(step, taken);
  const std::uint64_t before = duel.report().evaluations;
  Status status = Status::kOk;
  const std::uint32_t ticks = ticks_of([&] { status = duel.step(taken[0], taken[1]); });
  const auto& report = duel.world().report();
  const auto evaluations = static_cast<std::uint32_t>(duel.report().evaluations - before);
  out.add(
      {Kind::kStep,
       step,
       ticks,
       {evaluations, report.collisions + report.separations, static_cast<std::uint32_t>(status)}});
}

}  // namespace
}  // namespace batuta::price

/// A bout that is over begins anew: what is wanted are steps with both blades in the air.
void price_bout(const batuta::price::Task& task, std::uint32_t steps) {
  using namespace batuta::price;
  Sticks sticks(task.input);
  begin(0, task.out);
  // Bound: steps.
  for (std::uint32_t step = 0; step < steps && step < task.most_steps; ++step) {
    measure_step(step, sticks, task.out);
    if (duel.bout().is_over()) begin(step, task.out);
  }
}
