// SPDX-License-Identifier: MIT
// Random scenes in which contacts are separated.
#include "random_runs.hpp"

namespace batuta::test {

BATUTA_RANDOM_LAWS(kPaper);
BATUTA_RANDOM_LAWS(kPaperLed);
BATUTA_RANDOM_LAWS(kPaperCramped);

}  // namespace batuta::test
