// SPDX-License-Identifier: MIT
#pragma once
// The parts of this section; each writes a file of its own and returns the exit code of the
// program.

#include "section.hpp"

namespace batuta::report {

/// friction_blows.csv: single contacts of two random capsules.
int report_blows(const Options& options);

/// friction_map.csv: where one body sticks and where it slides.
int report_slip_map(const Options& options);

/// friction_cases.csv: blows that are known for trouble.
int report_cases(const Options& options);

/// friction_chain.csv: energy over a sequence of contacts.
int report_chain(const Options& options);

}  // namespace batuta::report
