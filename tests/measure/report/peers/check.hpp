// SPDX-License-Identifier: MIT
#pragma once
// Simple questions with known answers, put to every adapter, so that what the comparison shows is
// the engines' doing and not that of wrong frames, lever arms or units in between.

#include "roster.hpp"

namespace batuta::peers {

/// Asks every peer that is there, and says on standard output what it answered.
/// @returns how many answers are not what the engine's method must give
int check(const Roster& roster);

}  // namespace batuta::peers
