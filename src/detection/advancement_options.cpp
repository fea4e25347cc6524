// SPDX-License-Identifier: MIT
// Apart from the search itself: search_translation() has the same options, and must not link it.
#include "batuta/detection/advancement.hpp"
#include "expansion.hpp"

namespace batuta {

namespace {

/// Zero, or so far above the least normal number that no product with a share of it loses more than
/// rounding does.
template <class Scalar>
bool has_all_digits(Scalar x) {
  return x == Scalar(0) || x >= std::numeric_limits<Scalar>::min() / kRoundOff<Scalar>;
}

}  // namespace

template <class Scalar>
Status validate(const AdvancementOptions<Scalar>& options) {
  const bool good = options.contact_tolerance >= Scalar(0) &&
                    options.contact_tolerance <= Scalar(1) && options.budget <= kMaxBudget;
  return good ? Status::kOk : Status::kInvalidArgument;
}

template <class Scalar>
Scalar contact_tolerance_of(const MovingPair<Scalar>& pair,
                            const AdvancementOptions<Scalar>& options) {
  return max_of(options.contact_tolerance * pair.scale,
                detail::kLeastContactTolerance<Scalar> * query_length(pair));
}

template <class Scalar>
Scalar detail::inflation_of(const MovingPair<Scalar>& pair) {
  return detail::kInflation<Scalar> * query_length(pair);
}

template <class Scalar>
bool can_be_searched(const MovingPair<Scalar>& pair, const AdvancementOptions<Scalar>& options) {
  const Scalar length = query_length(pair);
  return validate(options) == Status::kOk && has_all_digits(pair.duration) &&
         has_all_digits(length) && length <= kLargestCoordinate<Scalar>;
}

#define BATUTA_INSTANTIATE(S)                                                          \
  template Status validate(const AdvancementOptions<S>&);                              \
  template S contact_tolerance_of(const MovingPair<S>&, const AdvancementOptions<S>&); \
  template S detail::inflation_of(const MovingPair<S>&);                               \
  template bool can_be_searched(const MovingPair<S>&, const AdvancementOptions<S>&);
BATUTA_FOR_EACH_SCALAR(BATUTA_INSTANTIATE)
#undef BATUTA_INSTANTIATE

}  // namespace batuta
