// SPDX-License-Identifier: MIT
#include "batuta/detection/advancement.hpp"

#include "walk.hpp"

namespace batuta {

template <class Scalar>
Status validate(const AdvancementOptions<Scalar>& options) {
  const bool good =
      options.slab >= Scalar(0) && options.slab <= Scalar(1) && options.budget <= kMaxBudget;
  return good ? Status::kOk : Status::kInvalidArgument;
}

template <class Scalar>
Scalar slab_of(const MovingPair<Scalar>& pair, const AdvancementOptions<Scalar>& options) {
  return max_of(options.slab * pair.scale, kLeastSlab<Scalar> * query_length(pair));
}

template <class Scalar>
SearchResult<Scalar> search_advancement(const MovingPair<Scalar>& pair,
                                        const AdvancementOptions<Scalar>& options,
                                        const Vec3<Scalar>& seed_AB) {
  const bool is_asked_well = validate(options) == Status::kOk && pair.duration >= Scalar(0) &&
                             query_length(pair) <= kLargestCoordinate<Scalar>;
  if (!is_asked_well) return {};
  return search_inflated(pair, options, seed_AB, kInflation<Scalar>);
}

#define BATUTA_INSTANTIATE(Scalar)                                                       \
  template Status validate(const AdvancementOptions<Scalar>&);                           \
  template Scalar slab_of(const MovingPair<Scalar>&, const AdvancementOptions<Scalar>&); \
  template SearchResult<Scalar> search_advancement(                                      \
      const MovingPair<Scalar>&, const AdvancementOptions<Scalar>&, const Vec3<Scalar>&);
BATUTA_INSTANTIATE(float)
BATUTA_INSTANTIATE(double)
#undef BATUTA_INSTANTIATE

}  // namespace batuta
