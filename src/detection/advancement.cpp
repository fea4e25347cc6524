// SPDX-License-Identifier: MIT
#include "batuta/detection/advancement.hpp"

#include "advancement_search.hpp"

namespace batuta {

template <class Scalar>
SearchResult<Scalar> search_advancement(const MovingPair<Scalar>& pair,
                                        const AdvancementOptions<Scalar>& options,
                                        const Vec3<Scalar>& seed_AB) {
  if (!can_be_searched(pair, options)) return {};
  return search_inflated(pair, options, seed_AB, detail::kInflation<Scalar>);
}

#define BATUTA_INSTANTIATE(S)                                                                     \
  template SearchResult<S> search_advancement(const MovingPair<S>&, const AdvancementOptions<S>&, \
                                              const Vec3<S>&);
BATUTA_FOR_EACH_SCALAR(BATUTA_INSTANTIATE)
#undef BATUTA_INSTANTIATE

}  // namespace batuta
