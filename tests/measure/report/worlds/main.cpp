// SPDX-License-Identifier: MIT
// Section "worlds" of the report: batuta's world and Bullet's on the same scenes (plans.hpp), for
// what they take, what becomes of the energy, how deep bodies are in each other, and what passes
// through. The timed part is the step alone; what is judged is worked out in double from the states
// that the engines tell, twenty times a second.

#include <cmath>
#include <cstdio>
#include <ctime>

#include "batuta/mechanics/body.hpp"
#include "plans.hpp"
#include "section.hpp"

namespace batuta::worlds {
namespace {

constexpr int kLooks = 20;  ///< a second

struct Row {
  std::uint64_t runs = 0;
  std::uint64_t movers = 0;
  std::uint64_t missed = 0;  ///< movers that went through what was in their way
  std::uint64_t steps = 0;
  std::uint64_t incomplete = 0;
  double least_energy = 1;  ///< at the end, of that at the start
  double most_energy = 1;
  double deepest = 0;       ///< penetration, m
  double speed_at_end = 0;  ///< root of twice the kinetic energy over the mass, m/s
  report::Histogram time_us;
};

Vec3<double> vec(const Triple& x) {
  return {x[0], x[1], x[2]};
}

Body<double> body_of(const BodyPlan& plan, const BodyState& state) {
  const auto& q = state.turn;
  const Pose<double> X_WB = {vec(state.place), {q[0], q[1], q[2], q[3]}};
  Body<double> body;
  body.X_WB = X_WB;
  if (plan.mass > 0) {
    body = make_body<double>(X_WB, plan.mass,
                             {plan.moment_across, plan.moment_across, plan.moment_along})
               .value;
    body.momentum = momentum_of(body, {vec(state.v), vec(state.w)});
  }
  return body;
}

/// Of all movers, J.
double kinetic(const Plan& plan, const Engine& engine) {
  double sum = 0;
  for (int i = 0; i < kMovers; ++i) {
    sum += kinetic_energy(body_of(plan.bodies[static_cast<std::size_t>(i)], engine.state(i)));
  }
  return sum;
}

double mass_of(const Plan& plan) {
  double sum = 0;
  for (const BodyPlan& body : plan.bodies) sum += body.mass;
  return sum;
}

/// Deepest penetration of a mover at this moment, m.
double depth(const Plan& plan, const Engine& engine) {
  std::vector<Capsule<double>> shapes;
  for (std::size_t i = 0; i < plan.bodies.size(); ++i) {
    const BodyPlan& body = plan.bodies[i];
    const auto pose = body_of(body, engine.state(static_cast<int>(i))).X_WB;
    const Segment<double> axis = {{0, 0, -body.half_length}, {0, 0, body.half_length}};
    const Capsule<double> shape = {axis, body.radius};
    shapes.push_back(to_world(pose, shape));
  }
  double deepest = 0;
  for (std::size_t i = 0; i < kMovers; ++i) {
    for (std::size_t k = i + 1; k < shapes.size(); ++k) {
      deepest = std::max(deepest, -capsule_gap(shapes[i], shapes[k]).gap);
    }
  }
  return deepest;
}

/// Who left the cage, or was shot at and still hangs where it was.
std::uint64_t missed(Play play, const Engine& engine) {
  std::uint64_t count = 0;
  for (int i = 0; i < kMovers; ++i) {
    const BodyState state = engine.state(i);
    if (play == Play::kVolley) {
      count += i % 2 == 1 && vec(state.v).norm() == 0;
    } else {
      const Vec3<double> place = vec(state.place).cwiseAbs();
      const bool is_below = state.place[2] < -kHalfCage;
      const bool is_beside = place.head<2>().maxCoeff() > kHalfCage;
      count += is_below || is_beside || (play == Play::kCage && place.z() > kHalfCage);
    }
  }
  return count;
}

/// Of the processor, us: what else runs on the host does not count.
double spent_us() {
  return 1e6 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

void run(Engine& engine, Play play, double seconds, std::uint64_t number, Row& row) {
  const Plan plan = draw(play, number);
  engine.load(plan);
  const double before = kinetic(plan, engine);
  const int steps = static_cast<int>(std::lround(seconds * engine.steps_per_second()));
  const int between = engine.steps_per_second() / kLooks;
  double time = 0;
  for (int i = 1; i <= steps; ++i) {
    const double start = spent_us();
    engine.step();
    time += spent_us() - start;
    if (i % between == 0) row.deepest = std::max(row.deepest, depth(plan, engine));
  }
  const double after = kinetic(plan, engine);
  ++row.runs;
  row.movers += play == Play::kVolley ? kMovers / 2 : kMovers;
  row.missed += missed(play, engine);
  row.steps += static_cast<std::uint64_t>(steps);
  row.incomplete += static_cast<std::uint64_t>(engine.incomplete());
  row.least_energy = std::min(row.least_energy, after / before);
  row.most_energy = std::max(row.most_energy, after / before);
  row.speed_at_end = std::max(row.speed_at_end, std::sqrt(2 * after / mass_of(plan)));
  row.time_us.add(time / seconds);
}

void write(report::Table& table, Play play, const Engine& engine, const Row& row) {
  table.key("play", name(play)).key("engine", engine.name()).key("setting", engine.setting());
  table.sum("runs", row.runs).sum("movers", row.movers).sum("missed", row.missed);
  table.sum("steps", row.steps).sum("incomplete", row.incomplete);
  table.min("least_energy", row.least_energy).max("most_energy", row.most_energy);
  table.max("deepest_m", row.deepest).max("speed_at_end_m_s", row.speed_at_end);
  table.hist("time_us", row.time_us);
  table.end_row();
}

std::vector<EnginePtr> all_engines() {
  std::vector<EnginePtr> engines = batuta_engines();
#ifdef BATUTA_WORLDS_BULLET
  for (EnginePtr& engine : bullet_engines()) engines.push_back(std::move(engine));
#else
  std::fprintf(stderr, "worlds: Bullet was skipped, its package is not installed\n");
#endif
  return engines;
}

int compare(const report::Options& options) {
  const std::vector<EnginePtr> engines = all_engines();
  report::Table table(options, "worlds");
  const report::Range runs = report::share_of(options, report::pick(options, 1, 2, 20));
  report::Progress progress("worlds", engines.size() * std::size(kPlays));
  for (const Play play : kPlays) {
    const bool is_part = options.mode == report::Mode::kTiny && play != Play::kVolley;
    const double seconds = is_part ? 0.25 : duration(play);
    for (const EnginePtr& engine : engines) {
      Row row;
      for (std::uint64_t i = runs.first; i < runs.last; ++i) run(*engine, play, seconds, i, row);
      write(table, play, *engine, row);
      progress.advance();
    }
  }
  return table.write();
}

}  // namespace
}  // namespace batuta::worlds

int main(int argc, char** argv) {
  using namespace batuta;
  return worlds::compare(report::parse(
      argc, argv,
      {"worlds", "batuta's world and Bullet's on the same scenes: time, energy, penetration.",
       "10 minutes"}));
}
