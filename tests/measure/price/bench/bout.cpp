// SPDX-License-Identifier: MIT
#include "batuta/fencing/duel.hpp"
#include "measure.hpp"
#include "ticks.hpp"

namespace batuta::price {
using namespace fencing;
namespace {

Duel<> duel;

/// Samples in the order of their steps, one record ahead.
class Sticks {
 public:
  explicit Sticks(digest::Input& input) : input_(input) { advance(); }

  /// Those of a step. Bound: the records of the chunk.
  void take(std::uint32_t step, const InputSample* (&taken)[2]) {
    taken[0] = taken[1] = nullptr;
    while (any_ && step_ <= step) {
      samples_[side_] = ahead_;
      taken[side_] = &samples_[side_];
      advance();
    }
  }

 private:
  void advance() {
    digest::Record record;
    any_ = input_.next(record);
    if (!any_) return;
    step_ = record.word();
    side_ = record.word() & 1U;
    ahead_.time = record.word();
    ahead_.x = record.number();
    ahead_.y = record.number();
    ahead_.buttons = record.word();
    ahead_.sequence = record.word();
  }

  digest::Input& input_;
  InputSample samples_[2];
  InputSample ahead_;
  std::uint32_t step_ = 0;
  std::uint32_t side_ = 0;
  bool any_ = false;
};

void begin(std::uint32_t step, SampleFile& out) {
  const auto settings = duel_settings();
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
