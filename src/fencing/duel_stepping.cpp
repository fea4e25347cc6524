// SPDX-License-Identifier: MIT
// The duel with the paper's own search, to compare with.
#include "batuta/fencing/duel_definitions.hpp"

namespace batuta::fencing {

#define BATUTA_INSTANTIATE(S)                                                 \
  template DuelSettings<DuelScene<two_fencers, Stepping<S>>> duel_settings(); \
  template class Duel<DuelScene<two_fencers, Stepping<S>>>;
BATUTA_FOR_EACH_SCALAR(BATUTA_INSTANTIATE)
#undef BATUTA_INSTANTIATE

}  // namespace batuta::fencing
