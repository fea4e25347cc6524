// SPDX-License-Identifier: MIT
// The duel as it is meant: no touch is missed.
#include "batuta/fencing/duel_definitions.hpp"

namespace batuta::fencing {

#define BATUTA_INSTANTIATE(S)                                                    \
  template DuelSettings<DuelScene<two_fencers, Advancement<S>>> duel_settings(); \
  template class Duel<DuelScene<two_fencers, Advancement<S>>>;
BATUTA_FOR_EACH_SCALAR(BATUTA_INSTANTIATE)
#undef BATUTA_INSTANTIATE

}  // namespace batuta::fencing
