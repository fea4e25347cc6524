// SPDX-License-Identifier: MIT
#pragma once
// The parts of this section; each writes a file of its own and returns the exit code of the
// program.

#include "section.hpp"

namespace batuta::report {

/// stiff_blows.csv: energy and momentum of single contacts against the ratio of the masses.
int report_stiff_blows(const Options& options);

/// stiff_steps.csv: where flights and meetings end against the length of the step.
int report_stiff_steps(const Options& options);

}  // namespace batuta::report
