// SPDX-License-Identifier: MIT
// One beat in steps of all lengths, against a truth that knows no steps.

#include <cmath>

#include "beat_truth.hpp"
#include "parts.hpp"

namespace batuta::report {
namespace {

/// How far the plays of one setting were off; merges by adding.
struct Off {
  std::uint64_t beats = 0;
  std::uint64_t others = 0;  ///< not one contact: none, or several
  Histogram time;            ///< of contact, s
  Histogram impulse;         ///< over the true one
  Histogram tip;             ///< m
  double worst_time = 0;
  double worst_impulse = 0;
  double worst_tip = 0;
  std::uint64_t evaluations = 0;
  Histogram in_plain;  ///< host time of a beat
};

void judge(Off& off, const Blow& blow, const BeatTruth& truth) {
  const double time = std::abs(blow.time - truth.time());
  const double impulse = std::abs(blow.impulse / truth.impulse() - 1);
  off.time.add(time);
  off.impulse.add(impulse);
  off.worst_time = std::max(off.worst_time, time);
  off.worst_impulse = std::max(off.worst_impulse, impulse);
}

template <class PlayT>
void play(Off& off, std::int32_t step_us, const BeatPlan& plan, double plain) {
  const BeatTruth truth(plan);
  PlayT duel(step_us);
  double tip = 0;
  play_beat(duel, plan, [&] {
    if (!duel.at_mark()) return;
    const double t = 1e-6 * static_cast<double>(duel.now_us());
    tip = std::max(tip, tip_error(duel.tips(), truth.tips(t)));
  });
  ++off.beats;
  off.evaluations += duel.duel().report().evaluations;
  off.in_plain.add(duel.ns() / plain);
  if (duel.blows().size() != 1) {
    ++off.others;
    return;
  }
  judge(off, duel.blows()[0], truth);
  off.tip.add(tip);
  off.worst_tip = std::max(off.worst_tip, tip);
}

template <class PlayT>
void write_row(Table& table, std::int32_t step_us, const Off& off) {
  table.key("scalar", scalar_name<typename PlayT::Scalar>())
      .key("search", search_name<typename PlayT::Search>())
      .key("step_us", step_us)
      .sum("beats", off.beats)
      .sum("others", off.others)
      .hist("contact_s", off.time)
      .max("worst_contact_s", off.worst_time)
      .hist("impulse_share", off.impulse)
      .max("worst_impulse_share", off.worst_impulse)
      .hist("tip_m", off.tip)
      .max("worst_tip_m", off.worst_tip)
      .sum("evaluations", off.evaluations)
      .hist("time_in_plain", off.in_plain)
      .end_row();
}

}  // namespace

int report_beat(const Options& options) {
  const std::uint64_t count = pick(options, 3, 24, 400);
  const Range range = share_of(options, count);
  Table table(options, "simulation_beat");
  Progress progress("beat: step lengths", step_lengths(options.mode).size());
  for (const std::int32_t step_us : step_lengths(options.mode)) {
    for_each_play([&](auto kind) {
      using PlayT = typename decltype(kind)::Type;
      const double plain = plain_ns();
      Off off;
      for (std::uint64_t i = range.first; i < range.last; ++i) {
        play<PlayT>(off, step_us, beat_plan(i, count), plain);
      }
      write_row<PlayT>(table, step_us, off);
    });
    progress.advance();
  }
  return table.write();
}

}  // namespace batuta::report
