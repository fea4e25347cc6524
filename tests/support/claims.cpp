// SPDX-License-Identifier: MIT
#include "claims.hpp"

#include <algorithm>

namespace batuta::test {

double Truth::overlap_until(double t) const {
  if (march_.verdict == Verdict::kFree || t <= march_.t_free) return 0;
  // What double leaves open is a moment, or a graze: long double proves most of these free.
  const auto rest = wide_.march(2 * wide_.rounding(), march_.t_free, t);
  if (rest.verdict == Verdict::kFree) return 0;
  const long double least = wide_.least_gap_after(rest.t_free, t, 24).gap;
  return std::max(0.0, static_cast<double>(-least));
}

Findings judge(const Claim& claim, const Truth& truth) {
  Findings found;
  found.invalid = claim.outcome == Outcome::kInvalid;
  if (found.invalid) return found;
  const double end = truth.fast().duration();
  found.disordered = !(claim.t_free >= 0 && claim.t_free <= claim.t_hit && claim.t_hit <= end);
  if (found.disordered) return found;
  const bool contact = claim.outcome == Outcome::kContact;
  const bool touching = claim.outcome == Outcome::kTouching;
  found.gap_at_free = truth.fast().gap(claim.t_free);
  if (!touching) found.overlap = truth.overlap_until(claim.t_free);
  found.missed = claim.outcome == Outcome::kFree && found.overlap > 0;
  found.late = claim.outcome != Outcome::kFree && found.overlap > 0;
  if (!contact && !touching) return found;
  const double doubt = truth.fast().rounding();
  const double near = std::min(found.gap_at_free, truth.fast().gap(claim.t_hit));
  found.false_contact = near > claim.contact_tolerance + 2 * claim.inflation + doubt;
  found.loose = contact && found.gap_at_free > claim.contact_tolerance + claim.inflation + doubt;
  return found;
}

}  // namespace batuta::test
