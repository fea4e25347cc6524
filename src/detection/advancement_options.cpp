// SPDX-License-Identifier: MIT
// Apart from the search itself: search_translation() has the same options, and must not link it.
#include "batuta/detection/advancement.hpp"
#include "expansion.hpp"

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

template Status validate(const AdvancementOptions<float>&);
template Status validate(const AdvancementOptions<double>&);
template float slab_of(const MovingPair<float>&, const AdvancementOptions<float>&);
template double slab_of(const MovingPair<double>&, const AdvancementOptions<double>&);

}  // namespace batuta
