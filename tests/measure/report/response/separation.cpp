// SPDX-License-Identifier: MIT
// What the separation distance D costs and buys [Kavan §4.2]: overlap, jitter of the gap, time for
// which bodies are held, and work, for D from a millionth to a hundredth of a capsule's length.

#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>

#include "parts.hpp"
#include "table_top.hpp"

namespace batuta::report {
namespace {

/// D over the length of a capsule; as the capsules are 1 m long, also in m.
constexpr std::array<double, 9> kDistances = {1e-6, 3e-6, 1e-5, 3e-5, 1e-4, 3e-4, 1e-3, 3e-3, 1e-2};

/// eps_r, m/s: what a body falls in five steps, so that most contacts of one that lies are resting.
constexpr double kRestSpeed = 0.05;

/// Steps of a run: until the bodies have settled, and then while they are looked at.
constexpr int kSettling = 500;
constexpr int kObserved = 500;

std::uint64_t nano(double x) {
  return static_cast<std::uint64_t>(std::llround(max_of(x, 0.0) * 1e9));
}

/// What is known of one row; every member merges by adding or by the larger.
struct Account {
  std::uint64_t runs = 0;
  std::uint64_t steps = 0;
  std::uint64_t samples = 0;   ///< gaps looked at: pairs times steps
  std::uint64_t overlaps = 0;  ///< of these below 0
  Histogram gap;               ///< m
  Histogram change;            ///< of the gap from step to step, m
  double penetration = 0;      ///< deepest seen at the end of a step or at a contact, m
  std::uint64_t separations = 0;
  std::uint64_t most_separations = 0;  ///< in one step
  std::uint64_t collisions = 0;
  std::uint64_t begins = 0;  ///< contacts that began anew although nobody took the bodies apart
  std::uint64_t evaluations = 0;
  std::uint64_t most_evaluations = 0;  ///< in one step
  std::uint64_t held_ns = 0;           ///< of simulated time
  std::uint64_t travel_nm = 0;
  std::uint64_t free_travel_nm = 0;
  std::uint64_t incomplete = 0;  ///< steps whose report says that something did not fit
  /// Host time of a step, ns: mean of a run, least of all runs, because others use the host too.
  double step_ns = std::numeric_limits<double>::infinity();
};

/// D and the play; the search's options stay as they come.
struct Setup {
  Play play;
  double distance;
};

template <class SceneT>
void begin(TableTop<SceneT>& table_top, const Setup& setup, std::uint64_t number) {
  using S = typename SceneT::Scalar;
  WorldSettings<SceneT> settings;
  settings.separation = static_cast<S>(setup.distance);
  settings.rest_speed = static_cast<S>(kRestSpeed);
  if (!table_top.set_up(setup.play, number, settings)) {
    std::fprintf(stderr, "separation: '%s' with D = %g m is refused\n", name(setup.play),
                 setup.distance);
    std::exit(1);
  }
}

template <class SceneT>
void look(const TableTop<SceneT>& table_top, std::array<double, 2>& last, Account& account) {
  for (int k = 0; k < table_top.pairs(); ++k) {
    const double gap = table_top.gap(k);
    double& before = last[static_cast<std::size_t>(k)];
    ++account.samples;
    if (gap < 0) ++account.overlaps;
    account.gap.add(gap);
    account.change.add(std::abs(gap - before));
    account.penetration = max_of(account.penetration, -gap);
    before = gap;
  }
}

/// What the world itself tells of the step.
template <class SceneT>
void count(const World<SceneT>& world, Account& account) {
  const auto& report = world.report();
  ++account.steps;
  account.separations += report.separations;
  account.most_separations = max_of<std::uint64_t>(account.most_separations, report.separations);
  account.collisions += report.collisions;
  account.evaluations += report.evaluations;
  account.most_evaluations = max_of<std::uint64_t>(account.most_evaluations, report.evaluations);
  account.held_ns += nano(static_cast<double>(report.time_held));
  account.incomplete += report.complete() ? 0 : 1;
  for (const auto& event : world.events()) {
    if (event.kind == EventKind::kBegin) ++account.begins;
    if (event.kind == EventKind::kEnd) continue;
    account.penetration = max_of(account.penetration, -static_cast<double>(event.contact.gap));
  }
}

/// One step; its time in seconds: reading the clock takes some 30 ns, a step a thousand.
template <class SceneT>
double timed_step(TableTop<SceneT>& table_top) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  (void)table_top.step();
  return std::chrono::duration<double>(Clock::now() - start).count();
}

template <class SceneT>
void observe(const Setup& setup, std::uint64_t number, Account& account) {
  TableTop<SceneT> table_top;
  begin(table_top, setup, number);
  for (int k = 0; k < kSettling; ++k) (void)table_top.step();
  std::array<double, 2> last{};
  for (int k = 0; k < table_top.pairs(); ++k) last[static_cast<std::size_t>(k)] = table_top.gap(k);
  double seconds = 0;
  for (int k = 0; k < kObserved; ++k) {
    seconds += timed_step(table_top);
    count(table_top.world(), account);
    look(table_top, last, account);
  }
  ++account.runs;
  account.step_ns = min_of(account.step_ns, 1e9 * seconds / kObserved);
  account.travel_nm += nano(setup.play == Play::kRest ? 0 : table_top.travel());
  account.free_travel_nm += nano(table_top.free_travel());
}

void write_row(Table& table, const Account& account) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  const double step_ns = account.runs > 0 ? account.step_ns : none;
  table.sum("runs", account.runs)
      .sum("steps", account.steps)
      .sum("samples", account.samples)
      .sum("overlaps", account.overlaps)
      .max("penetration_m", account.penetration)
      .hist("gap_m", account.gap)
      .hist("change_m", account.change)
      .sum("separations", account.separations)
      .max("most_separations", static_cast<double>(account.most_separations))
      .sum("collisions", account.collisions)
      .sum("begins", account.begins)
      .sum("evaluations", account.evaluations)
      .max("most_evaluations", static_cast<double>(account.most_evaluations))
      .sum("held_ns", account.held_ns)
      .sum("travel_nm", account.travel_nm)
      .sum("free_travel_nm", account.free_travel_nm)
      .sum("incomplete", account.incomplete)
      .min("time_step_ns", step_ns)
      .min("time_step_in_plain", step_ns / plain_ns());
  table.end_row();
}

template <class SearchT>
void add_row(Table& table, const char* search, const Setup& setup, Range runs) {
  using SceneT = TableScene<SearchT>;
  Account account;
  for (std::uint64_t number = runs.first; number < runs.last; ++number) {
    observe<SceneT>(setup, number, account);
  }
  using S = typename SearchT::Scalar;
  table.key("play", name(setup.play))
      .key("search", search)
      .key("scalar", std::is_same_v<S, float> ? "float" : "double")
      .key("distance", setup.distance);
  write_row(table, account);
}

}  // namespace

int report_separation(const Options& options) {
  const Range runs = share_of(options, pick(options, 1, 2, 100));
  Table table(options, "separation");
  Progress progress("separation", kPlays.size() * kDistances.size());
  for (const Play play : kPlays) {
    for (const double distance : kDistances) {
      add_row<Stepping<float>>(table, "stepping", {play, distance}, runs);
      add_row<Stepping<double>>(table, "stepping", {play, distance}, runs);
      add_row<Advancement<float>>(table, "advancement", {play, distance}, runs);
      add_row<Advancement<double>>(table, "advancement", {play, distance}, runs);
      progress.advance();
    }
  }
  return table.write();
}

}  // namespace batuta::report
