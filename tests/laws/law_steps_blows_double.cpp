// SPDX-License-Identifier: MIT
// Steps that several files of laws look at, compiled once.
#include "law_worlds.hpp"

namespace batuta {

BATUTA_STEPS_WITH_BLOWS(, double)

}  // namespace batuta
