// SPDX-License-Identifier: MIT
#pragma once
// Time of contact that never misses. From an instant at which the capsules are apart, the longest
// step is taken that a normal, moving with them, proves free; then again, until the gap is within
// the contact tolerance or the end is reached [Kavan §3, in place of its stepping]. Derivation,
// proof and the meaning of every constant: src/detection/advancement.md.

#include "batuta/detection/moving_pair.hpp"

namespace batuta {

namespace detail {

/// What rounding can do to a certificate, over the length L of the query: so much is added to the
/// radii, and no rounding error lets a contact pass. L = S + turn_A bounding_radius_A + turn_B
/// bounding_radius_B: what turning could do to each bounding radius counts as a length
/// (advancement.md, "Rounding").
template <class Scalar>
inline constexpr Scalar kInflation = 72 * kRoundOff<Scalar>;

/// Least contact tolerance over L that a search can resolve; a smaller one is raised to it.
template <class Scalar>
inline constexpr Scalar kLeastContactTolerance = 96 * kRoundOff<Scalar>;

}  // namespace detail

/// Most distance evaluations that a search may be given.
inline constexpr std::uint32_t kMaxBudget = 4096;

/// How far search_advancement() and search_translation() go.
template <class Scalar>
struct AdvancementOptions {
  /// A gap of at most contact_tolerance times S counts as contact, S = MovingPair::scale; in
  /// [0, 1].
  Scalar contact_tolerance = Scalar(1e-6);
  /// Distance evaluations, at most kMaxBudget. Where they do not suffice the answer is kBudget:
  /// with these 30, to 1 of the 20,300 queries with exact answers (docs/searching.md).
  std::uint32_t budget = 30;
};

/// @returns kOk | kInvalidArgument: an option out of the range stated beside it
template <class Scalar>
Status validate(const AdvancementOptions<Scalar>& options);

/// The gap, m, that counts as contact for this pair: contact_tolerance times S, and at least
/// kLeastContactTolerance times L.
template <class Scalar>
Scalar contact_tolerance_of(const MovingPair<Scalar>& pair,
                            const AdvancementOptions<Scalar>& options);

namespace detail {

/// eps, m: kInflation L, what rounding can do to this pair.
template <class Scalar>
Scalar inflation_of(const MovingPair<Scalar>& pair);

}  // namespace detail

/// First contact in [0, duration]; none is missed. With eps = inflation_of() and tau =
/// contact_tolerance_of():
/// @param seed_AB  a normal that may separate the pair, such as the witness of the last search of
///   the same two; zero: the line between the middles of the axes is tried. It can save
///   evaluations, and never changes what is proven.
/// @returns SearchResult:
///   kFree: the true gap is > 0 on all of [0, duration]. The witness is the last one that was
///     needed; with evaluations == 0 only its normal is set, the one that separates;
///   kContact: the true gap is > 0 on [0, t_free], and at t_free it is at most tau + eps. t_hit:
///     where the witness foresees the gap to vanish, or to be least (a graze within the contact
///     tolerance). The witness is two points within the contact tolerance of contact: the closest
///     ones, or those nearest to each other on the features that were closest at the last
///     evaluation;
///   kTouching: the gap at t = 0 is at most tau; gap_rate tells whether the two part;
///   kBudget: free on [0, t_free], unknown after; without evaluations the witness is not set;
///   kInvalid: options out of range; a distance that cannot be told; L above kLargestCoordinate; or
///     a duration or L so small, other than zero, that its digits are lost: below min / u.
/// Bound: options.budget evaluations.
template <class Scalar>
SearchResult<Scalar> search_advancement(const MovingPair<Scalar>& pair,
                                        const AdvancementOptions<Scalar>& options,
                                        const Vec3<Scalar>& seed_AB = detail::zero<Scalar>());

}  // namespace batuta
