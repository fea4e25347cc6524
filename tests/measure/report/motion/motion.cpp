// SPDX-License-Identifier: MIT
// Section "motion" of the report: energy, momentum and height over time in the cases of cases.hpp,
// ours and Bullet's, and the error of laws against the step (laws.hpp). Judged in double from the
// states that the engines tell.

#include <cmath>
#include <cstdio>

#include "batuta/mechanics/body.hpp"
#include "cases.hpp"
#include "laws.hpp"
#include "section.hpp"

namespace batuta::worlds {
namespace {

Vec3<double> vec(const Triple& x) {
  return {x[0], x[1], x[2]};
}

struct Look {
  double energy = 0;    ///< with that of height, J
  double momentum = 0;  ///< |sum of p|, N s
  double height = 0;    ///< of the highest body, m
};

Look look_at(const Plan& plan, const Engine& engine) {
  Look look;
  Vec3<double> momentum = Vec3<double>::Zero();
  look.height = -1e9;
  for (std::size_t i = 0; i < plan.bodies.size(); ++i) {
    const BodyPlan& given = plan.bodies[i];
    if (!(given.mass > 0)) continue;
    const BodyState state = engine.state(static_cast<int>(i));
    const auto& q = state.turn;
    auto body = make_body<double>({vec(state.place), {q[0], q[1], q[2], q[3]}}, given.mass,
                                  {given.moment_across, given.moment_across, given.moment_along})
                    .value;
    body.momentum = momentum_of(body, {vec(state.v), vec(state.w)});
    look.energy += kinetic_energy(body) - given.mass * vec(plan.gravity).dot(vec(state.place));
    momentum += body.momentum.linear_W;
    look.height = std::max(look.height, state.place[2]);
  }
  look.momentum = momentum.norm();
  return look;
}

bool is_drawn(const Engine& engine) {
  const std::string name = engine.name();
  return name == "batuta 1000" || name == "batuta 60" || name == "Bullet 60" ||
         name == "Bullet 1000 touching";
}

std::vector<EnginePtr> drawn_engines() {
  std::vector<EnginePtr> all = batuta_engines();
#ifdef BATUTA_WORLDS_BULLET
  for (EnginePtr& engine : bullet_engines()) all.push_back(std::move(engine));
#else
  std::fprintf(stderr, "motion: Bullet was skipped, its package is not installed\n");
#endif
  std::vector<EnginePtr> drawn;
  for (EnginePtr& engine : all) {
    if (is_drawn(*engine)) drawn.push_back(std::move(engine));
  }
  return drawn;
}

void write_look(report::Table& table, Case which, const Engine& engine, double at_s,
                const Look& look) {
  table.key("kind", "curve").key("what", name(which)).key("who", engine.name());
  table.key("at", at_s).max("energy", look.energy).max("momentum", look.momentum);
  table.max("height_m", look.height).max("error", std::nan(""));
  table.sum("incomplete", static_cast<std::uint64_t>(engine.incomplete()));
  table.end_row();
}

void follow(report::Table& table, Case which, Engine& engine, double seconds) {
  constexpr int kLooks = 60;
  const Plan plan = plan_of(which);
  engine.load(plan);
  write_look(table, which, engine, 0, look_at(plan, engine));
  const int steps = static_cast<int>(std::lround(seconds * engine.steps_per_second()));
  for (int i = 1; i <= steps; ++i) {
    engine.step();
    if (i * kLooks / steps == (i - 1) * kLooks / steps) continue;
    write_look(table, which, engine, static_cast<double>(i) / engine.steps_per_second(),
               look_at(plan, engine));
  }
}

void write_law(report::Table& table, const LawError& law) {
  const double none = std::nan("");
  table.key("kind", "law").key("what", law.law).key("who", law.scalar).key("at", law.step_us);
  table.max("energy", none).max("momentum", none).max("height_m", none).max("error", law.error);
  table.sum("incomplete", 0).end_row();
}

/// Steps are shared out, for nothing else can be: a curve is one run.
int report_motion(const report::Options& options) {
  constexpr double kSteps_us[] = {100, 200, 500, 1000, 2000, 5000, 10000, 16667, 33333};
  report::Table table(options, "motion");
  const bool is_tiny = options.mode == report::Mode::kTiny;
  report::Progress progress("motion", std::size(kCases) + std::size(kSteps_us));
  if (options.shard == 1) {
    for (const Case which : kCases) {
      for (const EnginePtr& engine : drawn_engines()) {
        follow(table, which, *engine, is_tiny ? 0.1 : duration(which));
      }
      progress.advance();
    }
  }
  const report::Range steps = report::share_of(options, std::size(kSteps_us));
  for (std::uint64_t i = steps.first; i < steps.last; ++i) {
    for (int law = 0; law < kLaws; ++law) {
      if (is_tiny && kSteps_us[i] < 5000) continue;
      write_law(table, law_error(law, true, kSteps_us[i]));
      write_law(table, law_error(law, false, kSteps_us[i]));
    }
    progress.advance();
  }
  return table.write();
}

}  // namespace
}  // namespace batuta::worlds

int main(int argc, char** argv) {
  using namespace batuta;
  return worlds::report_motion(report::parse(
      argc, argv,
      {"motion", "Energy, momentum and height over time beside Bullet's; laws against the step.",
       "a minute"}));
}
