// SPDX-License-Identifier: MIT
#pragma once
// The parts of this section; each writes files of its own and returns the exit code of the program.

#include "section.hpp"

namespace batuta::report {

/// simulation_beat.csv: one contact, against a truth that knows no steps.
int report_beat(const Options& options);

/// simulation_phrase.csv, simulation_runs.csv and simulation_blows.csv: several seconds of a bout,
/// against the finest steps in double.
int report_phrase(const Options& options);

}  // namespace batuta::report
