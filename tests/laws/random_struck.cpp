// SPDX-License-Identifier: MIT
// Random scenes in which contacts are answered blow by blow.
#include "random_runs.hpp"

namespace batuta::test {

BATUTA_RANDOM_LAWS(kBlows);
BATUTA_RANDOM_LAWS(kBlowsCramped);
BATUTA_RANDOM_LAWS(kBlowsLed);

}  // namespace batuta::test
