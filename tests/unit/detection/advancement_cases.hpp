// SPDX-License-Identifier: MIT
#pragma once
// A hand-made case put to the search, and its answer put before the reference.

#include <gtest/gtest.h>

#include <string>

#include "batuta/detection/advancement.hpp"
#include "cases.hpp"
#include "claims.hpp"

namespace batuta::testing_detection {

/// More than any case needs: outcomes are looked at with it, counts by themselves.
inline constexpr std::uint32_t kAmple = 2048;
inline constexpr double kContactTolerance = 1e-6;  // m

/// Slab in m; a search takes it relative to the size of the query.
template <class Scalar>
AdvancementOptions<Scalar> options_for(const MovingPair<Scalar>& pair,
                                       double contact_tolerance = kContactTolerance,
                                       std::uint32_t budget = kAmple) {
  AdvancementOptions<Scalar> options;
  options.contact_tolerance =
      min_of(static_cast<Scalar>(contact_tolerance) / pair.scale, Scalar(1));
  options.budget = budget;
  return options;
}

template <class Scalar>
struct Asked {
  MovingCapsule<Scalar> A;
  MovingCapsule<Scalar> B;
  MovingPair<Scalar> pair;
  AdvancementOptions<Scalar> options;
};

template <class Scalar>
Asked<Scalar> ask(const MovingCapsule<Scalar>& A, const MovingCapsule<Scalar>& B,
                  double contact_tolerance = kContactTolerance, std::uint32_t budget = kAmple) {
  const Result<MovingPair<Scalar>> pair = make_moving_pair(A, B);
  EXPECT_TRUE(pair.ok());
  return {A, B, pair.value, options_for(pair.value, contact_tolerance, budget)};
}
template <class Scalar>
Asked<Scalar> ask(const Case& c, double contact_tolerance = kContactTolerance,
                  std::uint32_t budget = kAmple) {
  return ask<Scalar>(moving<Scalar>(c.A), moving<Scalar>(c.B), contact_tolerance, budget);
}

/// Everything that the answer claims, held against the truth about the numbers that were asked.
template <class Scalar>
void expect_true_claims(const Asked<Scalar>& asked, const SearchResult<Scalar>& found,
                        const std::string& what) {
  const test::Truth truth(asked.A, asked.B);
  const test::Claim claim = test::claim_of(asked.pair, asked.options, found);
  const test::Findings findings = judge(claim, truth);
  EXPECT_FALSE(findings.missed) << what << ": overlap " << findings.overlap;
  EXPECT_FALSE(findings.late) << what << ": overlap " << findings.overlap;
  EXPECT_FALSE(findings.false_contact) << what << ": gap " << findings.gap_at_free;
  EXPECT_FALSE(findings.loose) << what << ": gap " << findings.gap_at_free;
  EXPECT_FALSE(findings.disordered) << what << ": " << claim.t_free << ' ' << claim.t_hit;
  EXPECT_FALSE(findings.invalid) << what;
  EXPECT_LE(found.evaluations, asked.options.budget) << what;
}

template <class Scalar>
SearchResult<Scalar> search_truly(const Asked<Scalar>& asked, const std::string& what) {
  const SearchResult<Scalar> found = search_advancement(asked.pair, asked.options);
  expect_true_claims(asked, found, what);
  return found;
}

/// kFree where the case is free, else kContact, or kTouching where it starts within the contact
/// tolerance.
inline void expect_outcome(const Case& c, Outcome outcome) {
  if (c.t == kNever) {
    EXPECT_EQ(outcome, Outcome::kFree) << c.name;
  } else {
    EXPECT_TRUE(outcome == Outcome::kContact || outcome == Outcome::kTouching) << c.name;
  }
}

}  // namespace batuta::testing_detection
