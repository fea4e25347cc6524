// SPDX-License-Identifier: MIT
// Section "costs" of the report: what a step of many bodies costs beside Bullet's, with nobody
// asleep. Crossed bars that stand, crossed bars that fall over, and sparse crowds. Both engines
// make each step in turn, so that what slows the host down slows down both; the thread's own clock
// counts, and of it the step alone. A row tells the mean step of a run and what it is over
// Bullet's. A run of bars that stand ends where one of the two towers falls: bars that lie about
// would be compared with bars that stand.

#include <cmath>
#include <cstdio>
#include <limits>

#include "batuta/core/arithmetic.hpp"
#include "plans.hpp"
#include "section.hpp"

namespace batuta::worlds {
namespace {

enum class Kind : std::uint8_t { kStanding, kCollapsing, kSparse };

struct Case {
  Kind kind;
  int bodies;
  int hz;
  double seconds;
};
constexpr Case kCases[] = {{Kind::kStanding, 28, 60, 5},    {Kind::kStanding, 32, 60, 5},
                           {Kind::kStanding, 40, 60, 5},    {Kind::kStanding, 64, 1000, 1},
                           {Kind::kStanding, 128, 1000, 1}, {Kind::kCollapsing, 64, 60, 5},
                           {Kind::kCollapsing, 128, 60, 5}, {Kind::kSparse, 32, 60, 4},
                           {Kind::kSparse, 64, 60, 4},      {Kind::kSparse, 128, 60, 4},
                           {Kind::kSparse, 256, 60, 4},     {Kind::kSparse, 512, 60, 2},
                           {Kind::kSparse, 1024, 60, 1},    {Kind::kSparse, 2048, 60, 1},
                           {Kind::kSparse, 4096, 60, 1}};

const char* name(Kind kind) {
  constexpr const char* kNames[] = {"standing", "collapsing", "sparse"};
  return kNames[static_cast<int>(kind)];
}

struct Row {
  std::uint64_t steps = 0;
  std::uint64_t incomplete = 0;
  double bytes = std::numeric_limits<double>::quiet_NaN();  ///< of the world
  report::Histogram time_us;                                ///< of a step, mean of a run
  report::Histogram time_of_bullet_us;
  report::Histogram time_over_bullet;
};

/// Room in a world, for so many: the next power of two.
int room_for(int bodies) {
  int room = 32;
  while (room < bodies) room *= 2;
  return room;
}

/// Turns back who is outside the cube and goes further out.
void turn_back(Engine& engine, int bodies) {
  const double half = half_cube(bodies);
  for (int i = 0; i < bodies; ++i) {
    const BodyState state = engine.state(i);
    for (int axis = 0; axis < 3; ++axis) {
      const auto k = static_cast<std::size_t>(axis);
      if (std::abs(state.place[k]) > half && state.place[k] * state.v[k] > 0) {
        engine.mirror(i, axis);
      }
    }
  }
}

double seconds_of_step(Engine& engine) {
  const double start = report::thread_seconds();
  engine.step();
  return report::thread_seconds() - start;
}

/// Whether the last bar is about as high as where it was put: less the gaps, 5 mm a layer, of four
/// bars on eight logs, and of what Bullet's bars sink into each other at first.
bool stands(const Engine& engine, const Plan& plan) {
  constexpr double kGap = 0.005;
  constexpr double kSunk = 0.15;
  const auto layers = static_cast<double>((plan.bodies.size() - 8) / 4);
  const BodyPlan& top = plan.bodies.back();
  const BodyState state = engine.state(static_cast<int>(plan.bodies.size()) - 1);
  return state.place[2] > top.start.place[2] - layers * kGap - kSunk;
}
bool both_stand(const std::array<EnginePtr, 2>& engines, const Plan& plan) {
  return stands(*engines[0], plan) && (!engines[1] || stands(*engines[1], plan));
}

EnginePtr ours(const Case& asked) {
  const int room = room_for(asked.bodies);
  return asked.kind == Kind::kSparse ? batuta_crowd(room, asked.hz) : batuta_bars(room, asked.hz);
}
EnginePtr bullet(const Case& asked) {
#ifdef BATUTA_WORLDS_BULLET
  return bullet_engine(asked.hz);
#else
  (void)asked;
  return nullptr;
#endif
}

void run(const Case& asked, double seconds, std::uint64_t number, Row& row) {
  const bool is_sparse = asked.kind == Kind::kSparse;
  const Plan plan = is_sparse ? draw_crowd(asked.bodies, number) : draw_bars(asked.bodies, number);
  std::array<EnginePtr, 2> engines = {ours(asked), bullet(asked)};
  std::array<double, 2> sums{};
  for (const EnginePtr& engine : engines) {
    if (engine) engine->load(plan);
  }
  const int most = std::max(2, static_cast<int>(std::lround(seconds * asked.hz)));
  int steps = 0;
  for (; steps < most; ++steps) {
    if (asked.kind == Kind::kStanding && steps > 0 && !both_stand(engines, plan)) break;
    for (std::size_t k = 0; k < 2; ++k) {
      if (!engines[k]) continue;
      if (is_sparse) turn_back(*engines[k], asked.bodies);
      sums[k] += seconds_of_step(*engines[k]);
    }
  }
  row.steps += static_cast<std::uint64_t>(steps);
  row.incomplete += static_cast<std::uint64_t>(engines[0]->incomplete());
  row.bytes = static_cast<double>(engines[0]->bytes());
  row.time_us.add(1e6 * sums[0] / steps);
  if (!engines[1]) return;
  row.time_of_bullet_us.add(1e6 * sums[1] / steps);
  row.time_over_bullet.add(sums[0] / sums[1]);
}

void write(report::Table& table, const Case& asked, const Row& row) {
  table.key("scene", name(asked.kind)).key("bodies", asked.bodies).key("hz", asked.hz);
  table.max("bytes", row.bytes).sum("steps", row.steps).sum("incomplete", row.incomplete);
  table.hist("time_us", row.time_us).hist("time_of_bullet_us", row.time_of_bullet_us);
  table.hist("time_over_bullet", row.time_over_bullet);
  table.end_row();
}

int measure(const report::Options& options) {
#ifndef BATUTA_WORLDS_BULLET
  std::fprintf(stderr, "costs: Bullet was skipped, its package is not installed\n");
#endif
  report::Table table(options, "costs");
  const report::Range runs = report::share_of(options, report::pick(options, 1, 3, 9));
  report::Progress progress("costs", std::size(kCases));
  for (const Case& asked : kCases) {
    const bool is_tiny = options.mode == report::Mode::kTiny;
    Row row;
    for (std::uint64_t number = runs.first; number < runs.last; ++number) {
      run(asked, is_tiny ? 0.01 : asked.seconds, number, row);
    }
    write(table, asked, row);
    progress.advance();
  }
  return table.write();
}

}  // namespace
}  // namespace batuta::worlds

int main(int argc, char** argv) {
  using namespace batuta::report;
  return batuta::worlds::measure(parse(
      argc, argv, {"costs", "What a step of many bodies costs beside Bullet's.", "3 minutes"}));
}
