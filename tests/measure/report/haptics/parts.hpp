// SPDX-License-Identifier: MIT
#pragma once
// The parts of this section; each writes a file of its own and returns the exit code of the
// program. All are the same in every run and cost little: every shard computes all of them.

#include "section.hpp"

namespace batuta::report {

/// haptics_onset.csv: where a sampled spring on a stick without a hand shakes, against the bound.
int report_onsets(const Options& options);

/// haptics_hands.csv: the same with dampers, delays, and the worst hands.
int report_hands(const Options& options);

/// haptics_encoder.csv: what an encoder's steps keep moving.
int report_encoder(const Options& options);

/// haptics_energy.csv: what a hand gets, with and without the passivity controller.
int report_energy(const Options& options);

}  // namespace batuta::report
