// SPDX-License-Identifier: MIT
// What an opponent takes of a step: it looks, decides, and moves the right fencer's stick, against
// the left fencer of the recording.

#include "measure.hpp"
#include "shared/firmware/seeing_rival.hpp"
#include "sticks.hpp"
#include "ticks.hpp"

namespace batuta::price {
using namespace fencing;
namespace {

constexpr std::int32_t kStepUs = 1000;
/// The one that does the most.
constexpr firmware::SeeingRival::Settings kWho{Skill::kMaster, 1};

Duel<> duel;
firmware::SeeingRival rival;

void begin(std::uint32_t step, SampleFile& out) {
  const auto settings = duel_settings();
  const auto left = first_fencer<float>();
  const auto right = second_fencer<float>();
  Status status = duel.configure(settings, left, right);
  const std::uint32_t ticks = ticks_of([&] {
    if (status == Status::kOk) status = rival.configure(kWho);
  });
  out.add({Kind::kConfigure, step, ticks, {static_cast<std::uint32_t>(status), 0, 0}});
}

void measure_step(std::uint32_t step, Sticks& sticks, SampleFile& out) {
  const InputSample* taken[2];
  sticks.take(step, taken);
  InputSample sample;
  const std::uint32_t ticks = ticks_of([&] { sample = rival.play(duel, Side::kRight, kStepUs); });
  const Status status = duel.step(taken[0], &sample);
  out.add({Kind::kStep, step, ticks, {0, 0, static_cast<std::uint32_t>(status)}});
}

}  // namespace
}  // namespace batuta::price

/// A bout that is over begins anew.
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
