// SPDX-License-Identifier: MIT
#include "batuta/detection/bisection.hpp"

namespace batuta {

template <class Scalar>
detail::Bracket<Scalar> detail::bisect(const MovingPair<Scalar>& pair,
                                       const detail::Bracket<Scalar>& start, int halvings) {
  detail::Bracket<Scalar> bracket = start;
  for (int i = 0; i < halvings && i < detail::kMaxHalvings; ++i) {  // Bound: kMaxHalvings
    const Scalar middle = bracket.t_free + (bracket.t_hit - bracket.t_free) / 2;
    if (!(bracket.t_free < middle && middle < bracket.t_hit)) break;  // neighbouring numbers
    const CapsuleGap<Scalar> gap = gap_at(pair, middle);
    ++bracket.evaluations;
    bracket.valid = gap.proximity != Proximity::kInvalid;
    if (!bracket.valid) break;
    if (gap.gap > Scalar(0)) {
      bracket.t_free = middle;
      bracket.witness = gap;
    } else {
      bracket.t_hit = middle;
    }
  }
  return bracket;
}

#define BATUTA_INSTANTIATE(S) \
  template detail::Bracket<S> detail::bisect(const MovingPair<S>&, const detail::Bracket<S>&, int);
BATUTA_FOR_EACH_SCALAR(BATUTA_INSTANTIATE)
#undef BATUTA_INSTANTIATE

}  // namespace batuta
