// SPDX-License-Identifier: MIT
#pragma once
// Whether the answer of a search is true: every claim in include/batuta/detection/advancement.hpp
// is held against the reference.

#include "batuta/detection/advancement.hpp"
#include "reference.hpp"

namespace batuta::test {

/// What the reference finds out about one query, for any number of answers to it.
class Truth {
 public:
  template <class Scalar>
  Truth(const MovingCapsule<Scalar>& A, const MovingCapsule<Scalar>& B)
      : fast_(A, B), wide_(A, B), march_(fast_.march(2 * fast_.rounding())) {}

  const Reference<double>& fast() const { return fast_; }
  const Reference<long double>& wide() const { return wide_; }
  /// In double, down to a gap that rounding makes doubtful.
  const March<double>& march() const { return march_; }

  /// Deepest overlap that could be found in [0, t], m. 0: proven to have none, or none found.
  /// Decided in long double where double could be wrong.
  double overlap_until(double t) const;

 private:
  Reference<double> fast_;
  Reference<long double> wide_;
  March<double> march_;
};

/// An answer, free of its scalar.
struct Claim {
  Outcome outcome = Outcome::kInvalid;
  double t_free = 0;             ///< s
  double t_hit = 0;              ///< s
  double contact_tolerance = 0;  ///< tau, m
  double inflation = 0;          ///< eps, m
};
/// L of advancement.hpp, m.
template <class Scalar>
Scalar query_length_of(const MovingPair<Scalar>& pair) {
  const Scalar swept =
      pair.A.turn_rate * pair.A.bounding_radius + pair.B.turn_rate * pair.B.bounding_radius;
  return pair.scale + pair.duration * swept;
}

template <class Scalar>
Claim claim_of(const MovingPair<Scalar>& pair, const AdvancementOptions<Scalar>& options,
               const SearchResult<Scalar>& found) {
  return {found.outcome, static_cast<double>(found.t_free), static_cast<double>(found.t_hit),
          static_cast<double>(contact_tolerance_of(pair, options)),
          static_cast<double>(detail::kInflation<Scalar> * query_length_of(pair))};
}

/// What is wrong with an answer; all false: nothing.
struct Findings {
  bool missed = false;         ///< kFree, and there is overlap
  bool late = false;           ///< overlap at or before t_free of kContact or kBudget
  bool false_contact = false;  ///< kContact or kTouching, and the gap is > tau + 2 eps there
  bool loose = false;          ///< kContact, and the gap at t_free is > tau + eps
  bool disordered = false;     ///< not 0 <= t_free <= t_hit <= duration
  bool invalid = false;        ///< kInvalid
  double overlap = 0;          ///< deepest, within what was claimed free, m
  double gap_at_free = 0;      ///< the gap at t_free, m

  bool wrong() const { return missed || late || false_contact || loose || disordered || invalid; }
};
Findings judge(const Claim& claim, const Truth& truth);

}  // namespace batuta::test
