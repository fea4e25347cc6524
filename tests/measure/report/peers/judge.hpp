// SPDX-License-Identifier: MIT
#pragma once
// Holds the answers to one query against the truth.

#include "histogram.hpp"
#include "peer.hpp"
#include "reference.hpp"

namespace batuta::peers {

// Depths over S (MovingPair::scale) from which a contact must be seen: one that shows in a picture,
// one at the limit of float.
inline constexpr double kDeep = 1e-3;
inline constexpr double kSlight = 1e-6;

// Gaps over S from which none may be reported. Below the lesser one are the contact tolerances of
// certified searches in float.
inline constexpr double kFar = 1e-3;
inline constexpr double kNear = 1e-5;

/// What is true of a query, as far as answers are held against it.
class Truth {
 public:
  Truth(const MovingCapsule<float>& A, const MovingCapsule<float>& B);

  /// False: not even the reference could tell.
  bool known() const { return known_; }
  /// The gap at t = 0 is at most kSlight S. Engines leave such pairs to their discrete tests, and
  /// are not asked about them here.
  bool touching_at_start() const { return reference_.gap(0) <= kSlight * reference_.scale(); }
  double duration() const { return reference_.duration(); }
  /// What the reference's gaps may be wrong by, over S.
  double noise() const { return noise_; }
  /// Deepest overlap over S; negative: the least gap.
  double depth() const { return depth_; }
  /// First overlap, s. @pre depth() > 0
  double contact_time() const { return contact_time_; }
  /// Deepest overlap over S in [contact_time(), t].
  double depth_until(double t) const;

 private:
  test::Reference<double> reference_;
  bool known_ = false;
  double noise_ = 0;
  double depth_ = 0;
  double contact_time_ = 0;
};

/// Counts over the queries of one family for one peer.
struct Tally {
  std::uint64_t queries = 0;          ///< the others count these only
  std::uint64_t deep = 0;             ///< truth: overlap deeper than kDeep
  std::uint64_t touching = 0;         ///< truth: overlap deeper than kSlight
  std::uint64_t missed_deep = 0;      ///< of `deep`: answered "no contact"
  std::uint64_t missed_touching = 0;  ///< of `touching`
  std::uint64_t late_deep = 0;        ///< told to stop after an overlap deeper than kDeep
  std::uint64_t late_touching = 0;    ///< ... than kSlight
  std::uint64_t false_far = 0;        ///< contact reported, true gap above kFar throughout
  std::uint64_t false_near = 0;       ///< ... above kNear
  std::uint64_t gave_up = 0;          ///< said that it does not know
  std::uint64_t gave_up_deep = 0;
  report::Histogram early;  ///< how much before the true contact, over the duration
  report::Histogram late;   ///< how much after
};

/// @pre truth.known()
void judge(Tally& tally, const Truth& truth, const PeerAnswer& answer);

}  // namespace batuta::peers
