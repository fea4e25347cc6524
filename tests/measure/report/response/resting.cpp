// SPDX-License-Identifier: MIT
// Bodies at rest: what D costs and buys where bodies settle (SceneOptions::resting), and beside it
// the answer by impulses alone, the micro-collisions of Mirtich and Canny that the paper names.

#include "resting.hpp"

#include <chrono>
#include <cstdio>
#include <cstdlib>

#include "draws.hpp"
#include "parts.hpp"

namespace batuta::report {
namespace {

using test::Pile;

constexpr std::array<double, 9> kDistances = {1e-6, 3e-6, 1e-5, 3e-5, 1e-4, 3e-4, 1e-3, 3e-3, 1e-2};
/// Restitution of the micro-collisions: none, and one that keeps the bodies apart.
constexpr std::array<double, 2> kMicroRestitutions = {0, 0.5};
/// Steps of a run: until the rod has settled, and then while it is looked at.
constexpr int kBefore = 500;
constexpr int kObserved = 4000;

/// Nothing is separated: what approaches gets an impulse, however slow. All else is the same.
constexpr SceneOptions micro_scene_options() {
  SceneOptions scene = test::rubbing_scene_options();
  scene.resting = RestingContact::kNone;
  return scene;
}
template <class S>
using MicroScene = Scene<micro_scene_options, Advancement<S>, test::FreeOrHand<S>>;

struct Setup {
  Pile pile = Pile::kAcross;
  double distance = 0;     ///< D, m
  double restitution = 0;  ///< of the rod
};

struct Account {
  std::uint64_t left =
      0;  ///< runs in which the rod was lifted off its posts: not at rest, not judged
  std::uint64_t steps = 0;
  std::uint64_t evaluations = 0;
  std::uint64_t most_evaluations = 0;  ///< in one step
  std::uint64_t answers = 0;
  std::uint64_t frozen = 0;
  std::uint64_t incomplete = 0;  ///< steps whose report says that something did not fit
  double penetration = 0;        ///< deepest at the end of a step or at a contact, m
  double least_gap = std::numeric_limits<double>::infinity();  ///< m
  double jitter = 0;  ///< from the lowest to the highest that its middle was in a run, m
  double drift = 0;   ///< the furthest that an end went sideways in a run, m
  double step_ns = std::numeric_limits<double>::infinity();
};

template <class SceneT>
void begin(World<SceneT>& world, const Setup& setup, std::uint64_t number) {
  using S = typename SceneT::Scalar;
  WorldSettings<SceneT> settings;
  settings.separation = static_cast<S>(setup.distance);
  if (world.configure(settings) != Status::kOk) {
    std::fprintf(stderr, "resting: D = %g m is refused\n", setup.distance);
    std::exit(1);
  }
  test::pile_up(world, setup.pile, setup.distance);
  Actor<SceneT>& rod = *world.get(world.id_at(0));
  rod.restitution = static_cast<S>(setup.restitution);
  // Not quite in the middle: along the posts in a groove, across them else.
  test::Draws draws(42, 1, number);
  const auto aside = static_cast<S>(0.05 * draws.signed_unit());
  (setup.pile == Pile::kAcross ? rod.body.X_WB.p_W.x() : rod.body.X_WB.p_W.y()) = aside;
}

template <class SceneT>
void count(const World<SceneT>& world, Account& account) {
  const auto& report = world.report();
  ++account.steps;
  account.evaluations += report.evaluations;
  account.most_evaluations = std::max<std::uint64_t>(account.most_evaluations, report.evaluations);
  account.frozen += report.frozen;
  account.incomplete += report.complete() ? 0 : 1;
  for (const auto& event : world.events()) {
    if (event.kind == EventKind::kEnd) continue;
    ++account.answers;
    account.penetration = std::max(account.penetration, -static_cast<double>(event.contact.gap));
  }
  const double gap = test::least_gap(world);
  account.least_gap = std::min(account.least_gap, gap);
  account.penetration = std::max(account.penetration, -gap);
}

/// What a run tells, added up with those before.
void add(Account& sum, const Account& run) {
  sum.steps += run.steps;
  sum.evaluations += run.evaluations;
  sum.most_evaluations = std::max(sum.most_evaluations, run.most_evaluations);
  sum.answers += run.answers;
  sum.frozen += run.frozen;
  sum.incomplete += run.incomplete;
  sum.penetration = std::max(sum.penetration, run.penetration);
  sum.least_gap = std::min(sum.least_gap, run.least_gap);
  sum.jitter = std::max(sum.jitter, run.jitter);
  sum.drift = std::max(sum.drift, run.drift);
  sum.step_ns = std::min(sum.step_ns, run.step_ns);
}

/// One run. @returns whether the rod was still on its posts at the end
template <class SceneT>
bool observe(const Setup& setup, std::uint64_t number, Account& account) {
  using S = typename SceneT::Scalar;
  using Clock = std::chrono::steady_clock;
  World<SceneT> world;
  begin(world, setup, number);
  const World<SceneT>& shown = world;
  for (int i = 0; i < kBefore; ++i) (void)world.step(static_cast<S>(test::kTick));
  const Capsule<double> start = test::seen(test::body_in(shown, 0));
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  double seconds = 0;
  for (int i = 0; i < kObserved; ++i) {
    const auto before = Clock::now();
    (void)world.step(static_cast<S>(test::kTick));
    seconds += std::chrono::duration<double>(Clock::now() - before).count();
    count(shown, account);
    const Capsule<double> now = test::seen(test::body_in(shown, 0));
    const double height = (now.axis.a.z() + now.axis.b.z()) / 2;
    low = std::min(low, height);
    high = std::max(high, height);
    for (const Vec3<double>& moved :
         {Vec3<double>(now.axis.a - start.axis.a), Vec3<double>(now.axis.b - start.axis.b)}) {
      account.drift = std::max(account.drift, moved.head<2>().norm());
    }
  }
  account.jitter = std::max(account.jitter, high - low);
  account.step_ns = std::min(account.step_ns, 1e9 * seconds / kObserved);
  return test::least_gap(shown) < 2 * test::kRodRadius;
}

template <class SceneT>
void add_row(Table& table, const char* method, const Setup& setup, Range runs) {
  Account account;
  for (std::uint64_t number = runs.first; number < runs.last; ++number) {
    Account run;
    if (observe<SceneT>(setup, number, run)) {
      add(account, run);
    } else {
      ++account.left;
    }
  }
  const bool any = account.steps > 0;
  const double none = std::numeric_limits<double>::quiet_NaN();
  table.key("method", method)
      .key("pile", setup.pile == Pile::kAcross ? "across" : "groove")
      .key("scalar", std::is_same_v<typename SceneT::Scalar, float> ? "float" : "double")
      .key("distance", setup.distance)
      .sum("left", account.left)
      .sum("steps", account.steps)
      .sum("evaluations", account.evaluations)
      .max("most_evaluations", static_cast<double>(account.most_evaluations))
      .sum("answers", account.answers)
      .sum("frozen", account.frozen)
      .sum("incomplete", account.incomplete)
      .max("penetration_m", account.penetration)
      .min("least_gap_m", any ? account.least_gap : none)
      .max("jitter_m", account.jitter)
      .max("drift_m", account.drift)
      .min("time_step_ns", any ? account.step_ns : none)
      .min("time_step_in_plain", any ? account.step_ns / plain_ns() : none);
  table.end_row();
}

template <class S>
void add_rows(Table& table, Pile pile, Range runs) {
  for (const double distance : kDistances) {
    add_row<test::RubbingScene<S>>(table, "settling", {pile, distance, 0}, runs);
  }
  for (const double restitution : kMicroRestitutions) {
    const char* const method =
        restitution > 0 ? "micro-collisions C = 0.5" : "micro-collisions C = 0";
    add_row<MicroScene<S>>(table, method, {pile, 1e-4, restitution}, runs);
  }
}

}  // namespace

int report_resting(const Options& options) {
  const Range runs = share_of(options, pick(options, 1, 2, 20));
  Table table(options, "resting");
  Progress progress("resting", 4);
  for (const Pile pile : {Pile::kAcross, Pile::kGroove}) {
    add_rows<float>(table, pile, runs);
    progress.advance();
    add_rows<double>(table, pile, runs);
    progress.advance();
  }
  return table.write();
}

}  // namespace batuta::report
