// SPDX-License-Identifier: MIT
#pragma once
// What a blade wants to hit: a moving body under a hierarchy of k-DOPs that is refitted each step
// [Kavan §5, refs 10 and 16], and the search for the first touch. Frame W, SI units; times run from
// 0 to the step's length.

#include "batuta/detection/search.hpp"
#include "batuta/fencing/skeleton.hpp"
#include "batuta/geometry/kdop.hpp"
#include "batuta/response/contact.hpp"

namespace batuta::fencing {

/// k of the target's hierarchy: boxes. More directions cost every step more than they save in the
/// few steps in which a blade is near.
inline constexpr int kTargetK = 6;

/// Which parts a search may leave out.
using PartMask = std::uint32_t;
/// Every part of a body.
inline constexpr PartMask kAllParts = (PartMask{1} << kBodyParts) - 1;
/// No part for what is none of the kBodyParts.
constexpr PartMask mask_of(BodyPart part) {
  const auto i = static_cast<unsigned>(part);
  return i < static_cast<unsigned>(kBodyParts) ? PartMask{1} << i : PartMask{0};
}

/// The first touch of a blade, and how far the answer reaches. A blade whose way of a step is
/// searched in one piece although a hold kept it still for a part of that time is where it is said
/// to be to within the hold: times are then known to StepReport::time_held.
template <class Scalar>
struct TouchSearch {
  bool found = false;                 ///< there is a touch
  BodyPart part = BodyPart::kPelvis;  ///< the lower one of several at the same time
  Scalar t_free = 0;                  ///< blade and part are apart here, s
  Scalar t_hit = 0;                   ///< and touch here
  Contact<Scalar> contact;            ///< at t_free; the normal points out of the body
  Scalar place = 0;                   ///< on the blade's axis: 0 at axis.a ... 1 at axis.b
  /// Every part has been searched up to here; the end of the motion if all searches were finished.
  /// A touch found later than this may not have been the first; none found means none *up to here*.
  Scalar known_until = 0;
  bool complete = false;               ///< known_until is the end of the motion
  std::uint16_t searches = 0;          ///< parts that the hierarchy could not rule out
  std::uint16_t budget_outs = 0;       ///< of these, ended without an answer: Outcome::kBudget
  std::uint16_t searches_invalid = 0;  ///< of these, could not be asked: Outcome::kInvalid
  std::uint32_t evaluations = 0;       ///< distance evaluations of all searches

  /// Whether the answer is the first touch, or that there is none: no search ended without an
  /// answer at an earlier time.
  bool certain() const { return found ? known_until >= t_free : complete; }
};

/// One fencer's body over one step.
/// Allocates: never. RAM in float: 1 kB.
template <class Scalar>
class Target {
 public:
  /// The body stands still as given.
  void place(const BodyShape<Scalar>& shape_W);

  /// The body goes to `shape_W` in `dt`: every bone with the constant twist of the shortest turn.
  /// Refits the hierarchy.
  /// @pre dt > 0; finite
  /// Bound: one forward and one backward pass over kBodyParts bones.
  void move_to(const BodyShape<Scalar>& shape_W, Scalar dt);

  /// The first touch of a blade that moves over [from, from + blade.motion.duration] of the step.
  /// @tparam Search  of detection/search.hpp
  /// Bound: kBodyParts searches; no recursion, no stack.
  template <class Search>
  TouchSearch<Scalar> find_touch(const MovingCapsule<Scalar>& blade, Scalar from,
                                 const typename Search::Options& options,
                                 PartMask parts = kAllParts) const {
    TouchSearch<Scalar> first;
    first.known_until = from + blade.motion.duration;
    first.complete = true;
    const PartMask reached = parts_reached(blade, parts);
    for (std::size_t i = 0; i < kParts; ++i) {  // Bound: kBodyParts
      if ((reached >> i & 1U) == 0) continue;
      const auto pair = pair_with(i, blade, from);
      const SearchResult<Scalar> result =
          pair.ok() ? Search::search(pair.value, options, Vec3<Scalar>::Zero())
                    : SearchResult<Scalar>{};
      take({result, pair.value.origin_W}, static_cast<BodyPart>(i), from, first);
    }
    return first;
  }

  /// Where the body is at the end of the step.
  const BodyShape<Scalar>& shape() const { return shape_W_; }
  /// The part's motion over the step; of duration 0 where the body has only been placed.
  /// @pre one of the kBodyParts
  MovingCapsule<Scalar> part(BodyPart part) const;
  /// Holds the part and all that it carries during the whole step. @pre one of the kBodyParts
  const Kdop<Scalar, kTargetK>& hull(BodyPart part) const {
    BATUTA_ASSERT(static_cast<std::size_t>(part) < kParts);
    return hulls_[static_cast<std::size_t>(part)];
  }

  /// Its state, for record/archive.hpp.
  template <class ArchiveT>
  void archive(ArchiveT& ar) {
    auto& [start_W, shape_W, dt, hulls] = *this;
    ar(start_W, shape_W, dt, hulls);
  }

 private:
  static constexpr auto kParts = static_cast<std::size_t>(kBodyParts);
  using Hull = Kdop<Scalar, kTargetK>;

  struct PartSearch {
    SearchResult<Scalar> result;  ///< kInvalid at first
    Vec3<Scalar> origin_W = Vec3<Scalar>::Zero();
  };

  void go_to(const BodyShape<Scalar>& shape_W, Scalar dt);
  Hull own_hull(std::size_t part) const;
  PartMask parts_reached(const MovingCapsule<Scalar>& blade, PartMask wanted) const;
  Result<MovingPair<Scalar>> pair_with(std::size_t part, const MovingCapsule<Scalar>& blade,
                                       Scalar from) const;
  static void take(const PartSearch& search, BodyPart part, Scalar from,
                   TouchSearch<Scalar>& first);

  BodyShape<Scalar> start_W_{};       ///< at the start of the step
  BodyShape<Scalar> shape_W_{};       ///< at its end
  Scalar dt_ = 0;                     ///< length of the step, s; 0: placed
  std::array<Hull, kParts> hulls_{};  ///< with all that it carries
};

}  // namespace batuta::fencing
