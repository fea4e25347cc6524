// SPDX-License-Identifier: MIT
// The worst hands for spring, damper and delay together.

#include "parts.hpp"
#include "worst_hand.hpp"

namespace batuta::report {
using namespace haptics;
namespace {

constexpr double kPeriod = 1e-3;
constexpr double kDamping = 0.8;     ///< of the device, N s/m
constexpr double kImpedance = 1000;  ///< of the line, over the device's damping

/// NaN where nothing shakes up to kNoOnset.
double seen(double onset) {
  constexpr double kNothing = 0.99;
  return onset < kNothing * test::kNoOnset ? onset : std::numeric_limits<double>::quiet_NaN();
}

void write_row(Table& table, int delay, double share) {
  const auto profile = test::plain_device(kPeriod, kDamping, delay);
  const double damping = share * kDamping;
  const double bound = test::stiffness_bound(profile, damping);
  const double line = test::line_onset(profile, kImpedance * kDamping, [&](double of_bound) {
    return Gains<double>{of_bound * bound, damping};
  });
  table.key("delay", delay)
      .key("damper", share)
      .max("bound", bound)
      .max("mass", seen(test::lowest_mass_onset(profile, damping)))
      .max("line", seen(line));
  table.end_row();
}

}  // namespace

int report_hands(const Options& options) {
  const int most_delay = static_cast<int>(pick(options, 1, 3, 4));
  Table table(options, "haptics_hands");
  for (int delay = 0; delay <= most_delay; ++delay) {
    for (const double share : {0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8}) {
      write_row(table, delay, share);
    }
  }
  return table.write();
}

}  // namespace batuta::report
