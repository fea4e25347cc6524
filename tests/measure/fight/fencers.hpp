// SPDX-License-Identifier: MIT
#pragma once
// Who fences in the trials: the library's fencers, with a map of the tool's own or with theirs.

#include "keys.hpp"
#include "trial.hpp"

namespace fight {

/// Two of the first fencer.
/// @param keys  null: the library's own; else they stay where they are while somebody fences
Pair pair_with(const Keys* keys);

}  // namespace fight
