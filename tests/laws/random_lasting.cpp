// SPDX-License-Identifier: MIT
// Random scenes in which contacts last.
#include "random_runs.hpp"

namespace batuta::test {

BATUTA_RANDOM_LAWS(kHeap);
BATUTA_RANDOM_LAWS(kDrift);
BATUTA_RANDOM_LAWS(kCramped);
BATUTA_RANDOM_LAWS(kHands);

}  // namespace batuta::test
