// SPDX-License-Identifier: MIT
#pragma once
// The map as a picture, like [Kavan Fig. 5]: for each key the hand, the guard and the blade as the
// fencer sees them from behind his hand, before the opponent on guard.

#include <ostream>

#include "trial.hpp"

namespace fight {

/// Of the map that the fencer has.
void draw_map(const batuta::fencing::Fencer<float>& fencer, std::ostream& out);

}  // namespace fight
