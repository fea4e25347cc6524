// SPDX-License-Identifier: MIT
// A stick with a hand of half a kilogram swings on a sampled spring: its energy, which the spring
// feeds where it is too stiff.

#include "parts.hpp"
#include "passive_loop.hpp"
#include "worst_hand.hpp"

namespace batuta::report {
namespace {

constexpr double kPeriod = 1e-3;
constexpr double kDamping = 0.2;
constexpr double kMuch = 1e4;  ///< times the energy at first: seen enough
constexpr int kPoints = 40;

struct Kind {
  const char* name;
  test::Way way;
};
constexpr Kind kKinds[] = {
    {"off", {false, true, 0}}, {"on", {true, true, 0}}, {"on but untold", {true, false, 0}}};

test::LoopSettings loop_with(double share) {
  test::LoopSettings loop;
  loop.axis.period = kPeriod;
  loop.axis.mass = 0.05;
  loop.axis.hand_mass = 0.45;
  loop.axis.hand_stiffness = 20;
  loop.axis.damping = kDamping;
  loop.gains.stiffness = share * test::stiffness_bound(test::plain_device(kPeriod, kDamping), 0);
  return loop;
}

/// A row every so many periods: the most energy since the row before.
void write_run(Table& table, double share, const Kind& kind, int steps) {
  test::PassiveLoop<double> loop(loop_with(share), kind.way);
  double most = 0;
  const int span = steps / kPoints;
  for (int i = 1; i <= steps; ++i) {
    loop.look();
    loop.pass();
    if (loop.energy() <= kMuch) most = max_of(most, loop.energy());
    if (i % span != 0) continue;
    const bool is_over = loop.energy() > kMuch;
    table.key("of_bound", share)
        .key("controller", kind.name)
        .key("time", i * kPeriod)
        .max("energy", is_over ? std::numeric_limits<double>::quiet_NaN() : most)
        .max("cannot", loop.observer().cannot_count() > 0 ? 1 : 0);
    table.end_row();
    most = 0;
  }
}

}  // namespace

int report_energy(const Options& options) {
  const int steps = static_cast<int>(pick(options, 1000, 8000, 40'000));
  Table table(options, "haptics_energy");
  for (const double share : {0.9, 1.2, 1.5, 1.9, 2.5, 4.0}) {
    for (const Kind& kind : kKinds) write_run(table, share, kind, steps);
  }
  return table.write();
}

}  // namespace batuta::report
