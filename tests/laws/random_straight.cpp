// SPDX-License-Identifier: MIT
// Random scenes of bodies that do not turn, of both engines.
#include "random_runs.hpp"

namespace batuta::test {

BATUTA_RANDOM_LAWS(kStraight);
BATUTA_RANDOM_LAWS(kSmallBalls);
BATUTA_RANDOM_LAWS(kSmallCramped);

}  // namespace batuta::test
