// SPDX-License-Identifier: MIT
// Section "growth" of the report: what a step costs against the number of bodies, in crowds that
// are sparse, dense, and worse than their room. A row for each crowd and number; the scene has room
// for just so many bodies. The timed part is World::step() alone.

#include <array>
#include <chrono>
#include <ctime>
#include <memory>

#include "crowd.hpp"
#include "section.hpp"

namespace batuta::report {
namespace {

using test::Crowd;
using test::CrowdRun;

/// From here on the processor's time is told well enough by its own clock, which leaves out what
/// else runs on the host.
constexpr double kLong_ns = 1e5;

struct Row {
  std::uint64_t steps = 0;
  std::uint64_t pairs = 0;
  std::uint64_t evaluations = 0;
  std::uint64_t contacts = 0;
  std::uint64_t pairs_dropped = 0;
  std::uint64_t incomplete = 0;
  double held = 0;             ///< s, longest
  double deepest_overlap = 0;  ///< m
  Histogram time_ns;

  void add(const StepReport<float>& step, double ns) {
    ++steps;
    pairs += step.pairs;
    evaluations += step.evaluations;
    contacts += step.collisions + step.separations;
    pairs_dropped += step.pairs_dropped;
    incomplete += step.complete() ? 0 : 1;
    held = std::max(held, double{step.time_held});
    deepest_overlap = std::max(deepest_overlap, double{step.deepest_overlap});
    time_ns.add(ns);
  }
};

/// Steps of a run: fewer where a step takes long.
std::uint64_t steps_of(const Options& options, Crowd crowd) {
  const std::uint64_t steps = pick(options, 4, 200, 1000);
  return crowd == Crowd::kWorst ? 1 + steps / 10 : steps;
}

template <int N>
void measure(const Options& options, Crowd crowd, std::uint64_t number, Row& row) {
  using Clock = std::chrono::steady_clock;
  auto run = std::make_unique<CrowdRun<float, N>>();
  run->begin(crowd, number);
  (void)run->step();  // everything is new in the first
  for (std::uint64_t i = 0; i < steps_of(options, crowd); ++i) {
    run->turn_back();
    const std::clock_t spent = std::clock();
    const auto start = Clock::now();
    const Status status = run->step();
    const double ns = std::chrono::duration<double, std::nano>(Clock::now() - start).count();
    keep(status);
    const double spent_ns = 1e9 * static_cast<double>(std::clock() - spent) / CLOCKS_PER_SEC;
    row.add(run->world().report(), ns > kLong_ns ? std::min(ns, spent_ns) : ns);
  }
}

template <int N>
void write_row(Table& table, Crowd crowd, const Row& row) {
  table.key("crowd", test::name(crowd)).key("bodies", N);
  table.key("room_pairs", CrowdRun<float, N>::SceneT::kMaxPairs);
  table.key("bytes", static_cast<double>(sizeof(World<typename CrowdRun<float, N>::SceneT>)));
  table.sum("steps", row.steps).sum("pairs", row.pairs).sum("evaluations", row.evaluations);
  table.sum("contacts", row.contacts).sum("pairs_dropped", row.pairs_dropped);
  table.sum("incomplete", row.incomplete).max("held_s", row.held);
  table.max("deepest_overlap_m", row.deepest_overlap).hist("time_ns", row.time_ns);
  table.end_row();
}

/// All numbers in turn, and that again: what slows the host down slows down all of them.
template <int... kNumbers>
void write_rows(const Options& options, Table& table, Range runs, Progress& progress) {
  for (const Crowd crowd : test::kCrowds) {
    std::array<Row, sizeof...(kNumbers)> rows;
    for (std::uint64_t number = runs.first; number < runs.last; ++number) {
      std::size_t i = 0;
      (measure<kNumbers>(options, crowd, number, rows[i++]), ...);
    }
    std::size_t i = 0;
    (write_row<kNumbers>(table, crowd, rows[i++]), ...);
    progress.advance();
  }
}

int report_growth(const Options& options) {
  Table table(options, "growth");
  const Range runs = share_of(options, pick(options, 3, 8, 24));
  Progress progress("growth", std::size(test::kCrowds));
  write_rows<2, 4, 8, 16, 32, 64, 128, 256, 512>(options, table, runs, progress);
  return table.write();
}

}  // namespace
}  // namespace batuta::report

int main(int argc, char** argv) {
  using namespace batuta::report;
  return report_growth(
      parse(argc, argv,
            {"growth", "What a step of a world costs against the number of bodies.", "2 minutes"}));
}
