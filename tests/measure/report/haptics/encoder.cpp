// SPDX-License-Identifier: MIT
// A stick at rest between two steps of its encoder: how far it still goes, back and forth.

#include "parts.hpp"
#include "sampled_loop.hpp"

namespace batuta::report {
namespace {

constexpr double kFriction = 0.02;
constexpr double kStep = 1e-3;
constexpr double kBound = 2 * kFriction / kStep;

void write_row(Table& table, double period, double share, int steps) {
  test::LoopSettings loop;
  loop.axis.period = period;
  loop.axis.mass = 0.05;
  loop.axis.damping = 0.2;
  loop.axis.friction = kFriction;
  loop.encoder_step = kStep;
  loop.gains.stiffness = share * kBound;
  loop.centre = 0.5 * kStep;
  const double way = test::last_way(loop, 0.3 * kStep, 0, steps);
  table.key("period_ms", 1e3 * period)
      .key("of_bound", share)
      .max("steps_per_second", way / kStep / (0.2 * steps * period));
  table.end_row();
}

}  // namespace

int report_encoder(const Options& options) {
  const double seconds = static_cast<double>(pick(options, 1, 5, 60));
  Table table(options, "haptics_encoder");
  for (const double period : {0.25e-3, 1e-3}) {
    for (const double share : {0.5, 0.8, 0.9, 0.95, 0.99, 1.01, 1.05, 1.1, 1.2, 1.5, 2.0}) {
      write_row(table, period, share, static_cast<int>(seconds / period));
    }
  }
  return table.write();
}

}  // namespace batuta::report
