// SPDX-License-Identifier: MIT
#include "batuta/detection/stepping.hpp"

#include "batuta/detection/speed_bound.hpp"

namespace batuta {

namespace {

/// [0, duration] in `count` equal parts, an integer that Scalar holds exactly, or infinity.
template <class Scalar>
struct Steps {
  Scalar duration = 0;
  Scalar count = 1;

  /// End of step i, without drift: the last one is `duration` to the bit.
  Scalar end_of(std::uint32_t i) const { return static_cast<Scalar>(i) / count * duration; }
};

/// Absolute epsilon, m; 0 if there is none for this pair. @pre valid options
template <class Scalar>
Scalar epsilon_of(const MovingPair<Scalar>& pair, const SteppingOptions<Scalar>& options) {
  if (options.unit == EpsilonIn::kMetres) return options.epsilon;
  const Scalar epsilon = options.epsilon * min_of(pair.A.radius, pair.B.radius);
  return is_finite(epsilon) ? epsilon : Scalar(0);
}

/// Least integer >= x, at least 1. Beyond 2^31 every x is a fine count as it is.
template <class Scalar>
Scalar round_up(Scalar x) {
  constexpr Scalar kWhole = Scalar(2147483648.0);
  if (!(x < kWhole)) return x;
  const Scalar below = static_cast<Scalar>(static_cast<std::uint32_t>(x));
  return max_of(Scalar(1), below < x ? below + Scalar(1) : below);
}

/// [Kavan eq. 17]: no gap changes by more than epsilon in one step.
template <class Scalar>
Steps<Scalar> steps_for(const MovingPair<Scalar>& pair, Scalar epsilon) {
  constexpr Scalar kUp =
      1 + 4 * kRoundOff<Scalar>;  // covers the rounding of this product and quotient
  const Scalar travel = pair.duration * closing_speed_bound(pair);
  return {pair.duration, round_up(kUp * (travel / epsilon))};
}

/// Last free instant, and whether the step after it ends in contact or there was none left. The
/// bracket is not valid where a gap could not be told.
template <class Scalar>
struct SteppingSearch {
  detail::Bracket<Scalar> bracket;
  bool hit = false;
};

/// @pre first is the gap at t = 0, and positive
template <class Scalar>
SteppingSearch<Scalar> run_search(const MovingPair<Scalar>& pair, const Steps<Scalar>& steps,
                                  const CapsuleGap<Scalar>& first, std::uint32_t max_steps) {
  SteppingSearch<Scalar> search;
  search.bracket.witness = first;
  search.bracket.evaluations = 1;
  for (std::uint32_t i = 0; i < max_steps; ++i) {  // Bound: max_steps
    if (!(static_cast<Scalar>(i) < steps.count)) break;
    const Scalar t = steps.end_of(i + 1);
    const CapsuleGap<Scalar> gap = gap_at(pair, t);
    ++search.bracket.evaluations;
    search.bracket.valid = gap.proximity != Proximity::kInvalid;
    if (!search.bracket.valid) break;
    search.bracket.t_hit = t;
    search.hit = !(gap.gap > Scalar(0));
    if (search.hit) break;
    search.bracket.t_free = t;
    search.bracket.witness = gap;
  }
  return search;
}

template <class Scalar>
SearchResult<Scalar> result_of(const MovingPair<Scalar>& pair, Outcome outcome,
                               const detail::Bracket<Scalar>& bracket) {
  if (!bracket.valid) return {};
  SearchResult<Scalar> result;
  result.outcome = outcome;
  result.t_free = bracket.t_free;
  result.t_hit = bracket.t_hit;
  result.witness = bracket.witness;
  result.gap_rate = detail::gap_rate_at(pair, bracket.witness, bracket.t_free);
  result.evaluations = bracket.evaluations;
  return result;
}

template <class Scalar>
bool is_valid(const MovingPair<Scalar>& pair) {
  return pair.duration >= Scalar(0) && is_finite(pair.scale);
}

}  // namespace

template <class Scalar>
Status validate(const SteppingOptions<Scalar>& options) {
  const bool good = is_positive(options.epsilon) && options.unit <= EpsilonIn::kMetres &&
                    options.max_steps >= 1 && options.halvings >= 0 &&
                    options.halvings <= detail::kMaxHalvings;
  return good ? Status::kOk : Status::kInvalidArgument;
}

template <class Scalar>
SearchResult<Scalar> search_stepping(const MovingPair<Scalar>& pair,
                                     const SteppingOptions<Scalar>& options) {
  if (validate(options) != Status::kOk || !is_valid(pair)) return {};
  const Scalar epsilon = epsilon_of(pair, options);
  if (!(epsilon > Scalar(0))) return {};
  const CapsuleGap<Scalar> first = gap_at(pair, Scalar(0));
  if (first.proximity == Proximity::kInvalid) return {};
  if (!(first.gap > Scalar(0))) {
    return result_of(pair, Outcome::kTouching, {Scalar(0), Scalar(0), first, 1});
  }
  if (closing_speed_bound(pair) == Scalar(0) || pair.duration == Scalar(0)) {
    return result_of(pair, Outcome::kFree, {pair.duration, pair.duration, first, 1});
  }
  const Steps<Scalar> steps = steps_for(pair, epsilon);
  SteppingSearch<Scalar> search = run_search(pair, steps, first, options.max_steps);
  if (search.hit) {
    return result_of(pair, Outcome::kContact,
                     detail::bisect(pair, search.bracket, options.halvings));
  }
  const bool complete = !(steps.count > static_cast<Scalar>(options.max_steps));
  search.bracket.t_hit = pair.duration;
  return result_of(pair, complete ? Outcome::kFree : Outcome::kBudget, search.bracket);
}

#define BATUTA_INSTANTIATE(S)                          \
  template Status validate(const SteppingOptions<S>&); \
  template SearchResult<S> search_stepping(const MovingPair<S>&, const SteppingOptions<S>&);
BATUTA_FOR_EACH_SCALAR(BATUTA_INSTANTIATE)
#undef BATUTA_INSTANTIATE

}  // namespace batuta
