// SPDX-License-Identifier: MIT
// A phrase in steps of all lengths: the recording that comes with the program against a script that
// parries, as batuta-duel plays them.

#include <algorithm>
#include <cmath>

#include "parts.hpp"
#include "play.hpp"
#include "programs/devices/default_recording.hpp"
#include "programs/devices/replay_device.hpp"
#include "programs/devices/script_device.hpp"

namespace batuta::report {
namespace {

constexpr std::size_t kShownBlows = 80;  ///< kept of each play; all are counted

/// What is kept of one play: the tips at each mark, the blows, the cost.
struct Trace {
  std::vector<Tips> tips;
  std::vector<Blow> blows;
  std::uint64_t evaluations = 0;
  double ns = 0;
};

/// The two sources, from their beginning.
struct Sticks {
  host::ReplayDevice left{host::parse_recording(host::kDefaultRecording, "default", {}).recording,
                          "default"};
  host::ScriptDevice right{*host::script_named("parry")};
};

template <class PlayT>
Trace play(std::int32_t step_us, std::int64_t length_us) {
  Sticks sticks;
  PlayT duel(step_us);
  Trace trace;
  for (std::int64_t now = 0; now < length_us; now += step_us) {
    const auto time = static_cast<Microseconds>(now);
    InputSample left;
    InputSample right;
    const bool from_left = sticks.left.read(time, left) == Status::kOk;
    const bool from_right = sticks.right.read(time, right) == Status::kOk;
    duel.step(from_left ? &left : nullptr, from_right ? &right : nullptr);
    if (duel.at_mark()) trace.tips.push_back(duel.tips());
  }
  trace.blows = duel.blows();
  trace.evaluations = duel.duel().report().evaluations;
  trace.ns = duel.ns();
  return trace;
}

/// Places for ever shorter steps, from the two shortest, by Richardson's rule for a first order.
std::vector<Tips> extrapolated(const Trace& shortest, const Trace& next, double ratio) {
  std::vector<Tips> out = shortest.tips;
  for (std::size_t i = 0; i < out.size(); ++i) {
    for (std::size_t side = 0; side < 2; ++side) {
      out[i][side] += (shortest.tips[i][side] - next.tips[i][side]) / (ratio - 1);
    }
  }
  return out;
}

struct Tables {
  Table phrase;
  Table runs;
  Table blows;

  explicit Tables(const Options& options)
      : phrase(options, "simulation_phrase"),
        runs(options, "simulation_runs"),
        blows(options, "simulation_blows") {}

  int write() const {
    const std::array<int, 3> codes = {phrase.write(), runs.write(), blows.write()};
    return *std::max_element(codes.begin(), codes.end());
  }
};

template <class PlayT>
void name_play(Table& table, std::int32_t step_us) {
  table.key("scalar", scalar_name<typename PlayT::Scalar>())
      .key("search", search_name<typename PlayT::Search>())
      .key("step_us", step_us);
}

/// Rows of one play. A shard that did not play it writes them empty, so that all shards have the
/// same rows.
template <class PlayT>
void write_rows(Tables& tables, std::int32_t step_us, const Trace* trace,
                const std::vector<Tips>& truth) {
  const double none = std::nan("");
  for (std::size_t i = 0; i < truth.size(); ++i) {
    name_play<PlayT>(tables.phrase, step_us);
    tables.phrase.key("at_ms", 1e-3 * static_cast<double>(i + 1) * kLongestStepUs)
        .max("tip_m", trace == nullptr ? none : tip_error(trace->tips[i], truth[i]))
        .end_row();
  }
  name_play<PlayT>(tables.runs, step_us);
  tables.runs.sum("plays", trace == nullptr ? 0 : 1)
      .sum("blows", trace == nullptr ? 0 : trace->blows.size())
      .sum("evaluations", trace == nullptr ? 0 : trace->evaluations)
      .min("time_in_plain", trace == nullptr ? none : trace->ns / plain_ns())
      .end_row();
  for (std::size_t i = 0; i < kShownBlows; ++i) {
    const bool there = trace != nullptr && i < trace->blows.size();
    name_play<PlayT>(tables.blows, step_us);
    tables.blows.key("number", static_cast<double>(i + 1))
        .max("at_s", there ? trace->blows[i].time : none)
        .max("impulse", there ? trace->blows[i].impulse : none)
        .end_row();
  }
}

}  // namespace

int report_phrase(const Options& options) {
  using Finest = Play<double, Advancement<double>>;
  const std::vector<std::int32_t> steps = step_lengths(options.mode);
  const auto length_us = static_cast<std::int64_t>(pick(options, 500000, 4500000, 4500000));
  const Trace shortest = play<Finest>(steps[0], length_us);
  const Trace next = play<Finest>(steps[1], length_us);
  const double ratio = static_cast<double>(steps[1]) / steps[0];
  const std::vector<Tips> truth = extrapolated(shortest, next, ratio);
  Tables tables(options);
  Progress progress("phrase: plays", 4 * steps.size());
  std::uint64_t number = 0;
  for (const std::int32_t step_us : steps) {
    for_each_play([&](auto kind) {
      using PlayT = typename decltype(kind)::Type;
      const bool mine = number++ % options.shards == options.shard - 1;
      Trace trace;
      if (mine) trace = play<PlayT>(step_us, length_us);
      write_rows<PlayT>(tables, step_us, mine ? &trace : nullptr, truth);
      progress.advance();
    });
  }
  return tables.write();
}

}  // namespace batuta::report
