// SPDX-License-Identifier: MIT
#include "batuta/detection/advancement.hpp"

#include "walk.hpp"

namespace batuta {

template <class Scalar>
SearchResult<Scalar> search_advancement(const MovingPair<Scalar>& pair,
                                        const AdvancementOptions<Scalar>& options,
                                        const Vec3<Scalar>& seed_AB) {
  if (!can_be_searched(pair, options)) return {};
  return search_inflated(pair, options, seed_AB, kInflation<Scalar>);
}

template SearchResult<float> search_advancement(const MovingPair<float>&,
                                                const AdvancementOptions<float>&,
                                                const Vec3<float>&);
template SearchResult<double> search_advancement(const MovingPair<double>&,
                                                 const AdvancementOptions<double>&,
                                                 const Vec3<double>&);

}  // namespace batuta
