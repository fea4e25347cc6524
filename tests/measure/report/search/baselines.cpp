// SPDX-License-Identifier: MIT
#include "baselines.hpp"

#include <algorithm>
#include <cmath>

namespace batuta::report {

namespace {

/// Largest speed along the unit vector n, either way, that turning gives an end of the axis.
template <class Scalar>
Scalar turning_speed_along(const detail::CapsulePath<Scalar>& path, const Vec3<Scalar>& n) {
  Scalar most = 0;
  for (const detail::EndPath<Scalar>& end : path.ends) {
    most = std::max(most, std::hypot(n.dot(end.arm), n.dot(end.side)));
  }
  return path.turn_rate * most;
}

/// How fast the gap along n can shrink at any time.
template <class Scalar>
Scalar closing_speed_along(const MovingPair<Scalar>& pair, const Vec3<Scalar>& n) {
  const Scalar apart = n.dot(pair.B.v - pair.A.v);
  return std::max(Scalar(0),
                  turning_speed_along(pair.A, n) + turning_speed_along(pair.B, n) - apart);
}

template <class Scalar>
SearchResult<Scalar> result_of(Outcome outcome, Scalar t_free, Scalar t_hit,
                               std::uint32_t evaluations) {
  SearchResult<Scalar> result;
  result.outcome = outcome;
  result.t_free = t_free;
  result.t_hit = t_hit;
  result.evaluations = evaluations;
  return result;
}

}  // namespace

template <class Scalar>
SearchResult<Scalar> search_conservative(const MovingPair<Scalar>& pair, Scalar contact_tolerance,
                                         std::uint32_t budget) {
  const Scalar contact = contact_tolerance * pair.scale;
  Scalar t = 0;
  for (std::uint32_t used = 1; used <= budget; ++used) {
    const CapsuleGap<Scalar> gap = gap_at(pair, t);
    if (gap.gap <= contact) {
      return result_of(used == 1 ? Outcome::kTouching : Outcome::kContact, t, t, used);
    }
    const Scalar speed = closing_speed_along(pair, gap.axes.normal_AB);
    if (gap.gap >= speed * (pair.duration - t)) {
      return result_of(Outcome::kFree, pair.duration, pair.duration, used);
    }
    t = std::min(pair.duration, t + gap.gap / speed);
  }
  return result_of(Outcome::kBudget, t, pair.duration, budget);
}

template <class Scalar>
SearchResult<Scalar> search_false_position(const MovingPair<Scalar>& pair,
                                           const SteppingOptions<Scalar>& stepping, int iterations,
                                           FalsePosition form) {
  SteppingOptions<Scalar> coarse = stepping;
  coarse.halvings = 0;
  SearchResult<Scalar> found = search_stepping(pair, coarse);
  if (found.outcome != Outcome::kContact) return found;
  Scalar free_value = found.witness.gap;
  Scalar hit_value = gap_at(pair, found.t_hit).gap;  // not counted: stepping has taken it already
  int side = 0;                                      // which end the last iteration moved
  for (int i = 0; i < iterations && hit_value < Scalar(0); ++i) {
    const Scalar width = found.t_hit - found.t_free;
    const Scalar t = found.t_free + width * (free_value / (free_value - hit_value));
    if (!(found.t_free < t && t < found.t_hit)) break;
    const CapsuleGap<Scalar> gap = gap_at(pair, t);
    ++found.evaluations;
    const bool is_free = gap.gap > Scalar(0);
    const bool again = side == (is_free ? 1 : -1);
    const Scalar weight = form == FalsePosition::kIllinois && again ? Scalar(0.5) : Scalar(1);
    if (is_free) {
      found.t_free = t;
      found.witness = gap;
      free_value = gap.gap;
      hit_value *= weight;
    } else {
      found.t_hit = t;
      hit_value = gap.gap;
      free_value *= weight;
    }
    side = is_free ? 1 : -1;
  }
  return found;
}

#define BATUTA_INSTANTIATE(Scalar)                                                     \
  template SearchResult<Scalar> search_conservative(const MovingPair<Scalar>&, Scalar, \
                                                    std::uint32_t);                    \
  template SearchResult<Scalar> search_false_position(                                 \
      const MovingPair<Scalar>&, const SteppingOptions<Scalar>&, int, FalsePosition);
BATUTA_INSTANTIATE(float)
BATUTA_INSTANTIATE(double)
#undef BATUTA_INSTANTIATE

}  // namespace batuta::report
