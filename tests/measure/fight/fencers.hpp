// SPDX-License-Identifier: MIT
#pragma once
// Who fences in the trials: the library's fencers, with a map of the tool's own or with theirs.

#include "keys.hpp"
#include "trial.hpp"

namespace fight {

/// Which of the library's fencers.
enum class Who { kFirst, kSecond };

/// @param keys  null: the library's own; else they stay where they are while somebody fences
Pair pair_with(const Keys* keys, Who attacker = Who::kFirst, Who defender = Who::kFirst);

}  // namespace fight
