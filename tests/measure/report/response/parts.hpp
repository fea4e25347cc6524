// SPDX-License-Identifier: MIT
#pragma once
// The parts of this section; each writes a file of its own and returns the exit code of the
// program.

#include "section.hpp"

namespace batuta::report {

/// separation.csv: what the separation distance D costs and buys.
int report_separation(const Options& options);

/// resting.csv: D where bodies settle, and impulses alone beside it.
int report_resting(const Options& options);

/// keyframes.csv: error of the interpolated hand against the number of keys.
int report_keyframes(const Options& options);

}  // namespace batuta::report
