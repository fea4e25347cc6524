// SPDX-License-Identifier: MIT
// Where a spring shakes a stick that nobody holds.

#include "parts.hpp"
#include "worst_hand.hpp"

namespace batuta::report {

int report_onsets(const Options& options) {
  const double slow = static_cast<double>(pick(options, 20, 100, 1000));
  Table table(options, "haptics_onset");
  for (const double period : {0.25e-3, 0.5e-3, 1e-3, 2e-3, 5e-3}) {
    for (const double damping : {0.1, 0.8}) {
      for (const double mass : {0.02, 0.05}) {
        const auto profile = test::plain_device(period, damping);
        table.key("period_ms", 1e3 * period)
            .key("damping", damping)
            .key("mass", mass)
            .max("bound", test::stiffness_bound(profile, 0))
            .max("in_time", test::mass_onset_in_time(profile, mass, slow))
            .max("by_radius", test::mass_onset_by_radius(profile, mass));
        table.end_row();
      }
    }
  }
  return table.write();
}

}  // namespace batuta::report
