// SPDX-License-Identifier: MIT
#include "batuta/detection/bisection.hpp"

namespace batuta {

template <class Scalar>
Bracket<Scalar> bisect(const MovingPair<Scalar>& pair, const Bracket<Scalar>& start, int halvings) {
  Bracket<Scalar> bracket = start;
  for (int i = 0; i < halvings && i < kMaxHalvings; ++i) {  // Bound: kMaxHalvings
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

template Bracket<float> bisect(const MovingPair<float>&, const Bracket<float>&, int);
template Bracket<double> bisect(const MovingPair<double>&, const Bracket<double>&, int);

}  // namespace batuta
