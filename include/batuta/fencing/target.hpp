// SPDX-License-Identifier: MIT
#pragma once
// What a blade wants to hit: a moving body under a box, and boxes of its parts that are refitted in
// each step that asks for them [Kavan §5, refs 10 and 16], and the search for the first touch.
// Frame W, SI units; times run from 0 to the step's length.

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

/// So deep a blade may press into a body, m: a jacket gives way as far as the tip of an epee does
/// before it says that it touches (src/fencing/target.md, "Steel").
template <class Scalar>
inline constexpr Scalar kGive = Scalar(0.002F);

/// One fencer's body over one step.
/// Allocates: never. RAM in float: 1 kB.
template <class Scalar>
class Target {
 public:
  /// The body stands still as given.
  void place(const BodyShape<Scalar>& shape_W);
  /// The same as pose_body() has it. @pre validate(build) says kOk; finite
  void place(const FencerBuild<Scalar>& build, const Stance<Scalar>& stance);

  /// The body goes to `shape_W` in `dt`: every bone with the constant twist of the shortest turn,
  /// and the radius that it has in `shape_W`.
  /// @pre dt > 0; finite
  /// Bound: one pass over kBodyParts bones.
  void move_to(const BodyShape<Scalar>& shape_W, Scalar dt);
  /// The same to where pose_body() has it. @pre validate(build) says kOk; finite; dt > 0
  void move_to(const FencerBuild<Scalar>& build, const Stance<Scalar>& stance, Scalar dt);

  /// The first touch of a blade that moves over [from, from + blade.motion.duration] of the step.
  /// The first blade that comes near in a step has the boxes of the parts refitted.
  /// @tparam Search  of detection/search.hpp
  /// Bound: kBodyParts searches, one pass over kBodyParts bones.
  template <class Search>
  TouchSearch<Scalar> find_touch(const MovingCapsule<Scalar>& blade, Scalar from,
                                 const typename Search::Options& options,
                                 PartMask parts = kAllParts) {
    TouchSearch<Scalar> first;
    first.known_until = from + blade.motion.duration;
    first.complete = true;
    const PartMask reached = parts_reached(blade, parts);
    for (std::size_t i = 0; i < kParts; ++i) {  // Bound: kBodyParts
      if ((reached >> i & 1U) == 0) continue;
      search_part<Search>(i, {blade, from}, options, first);
    }
    return first;
  }

  /// A motion of a blade over [from, from + motion.duration] of the step that would end deeper than
  /// kGive in a part becomes the one that does not: as by blows without a bounce, in which the body
  /// does not give way. A blade that is deeper already comes out, at 1 m/s where it is deepest.
  /// From a body that stands no energy comes but for that, and then no more than makes the blade's
  /// speed greater by 1 m/s (target.md, "Energy").
  /// @param blade    where the motion begins, and what resists it; its momenta are not looked at
  /// @param blade_B  what may not go in
  /// @returns whether the motion was changed; not where it is invalid or takes no time
  /// Bound: 12 blows, before each one kBodyParts boxes and gaps; for a blade that is not near, one
  /// box.
  bool stop(const Body<Scalar>& blade, const Capsule<Scalar>& blade_B, Scalar from, PartMask parts,
            Motion<Scalar>& motion);

  /// Where a blade that made its way otherwise than planned has come too deep, what brings it out,
  /// W, m. @param X0_WB, X1_WB  at the start and at the end of the step
  /// @pre the poses are finite, their rotations of unit length
  /// Bound: kBodyParts boxes and gaps.
  Vec3<Scalar> way_out(const Capsule<Scalar>& blade_B, const Pose<Scalar>& X0_WB,
                       const Pose<Scalar>& X1_WB, PartMask parts);

  /// Where a part was at the start of the step. @pre one of the kBodyParts
  Capsule<Scalar> start_of(BodyPart part) const {
    const auto i = static_cast<std::size_t>(part);
    BATUTA_ASSERT(i < kParts);
    return {start_W_[i], shape_W_[i].radius};
  }
  /// Where it is at its end.
  const BodyShape<Scalar>& shape() const { return shape_W_; }
  /// The part's motion over the step; of duration 0 where the body has only been placed.
  /// @pre one of the kBodyParts
  MovingCapsule<Scalar> part(BodyPart part) const;
  /// Holds the whole body during the whole step.
  const Kdop<Scalar, kTargetK>& hull() const { return hulls_[0]; }
  /// Holds the part during the whole step. @pre one of the kBodyParts
  Kdop<Scalar, kTargetK> hull(BodyPart part) const {
    BATUTA_ASSERT(static_cast<std::size_t>(part) < kParts);
    return own_hull(static_cast<std::size_t>(part));
  }

  /// Its state, for record/archive.hpp.
  template <class ArchiveT>
  void archive(ArchiveT& ar) {
    auto& [start_W, shape_W, dt, ends, hulls, is_fitted] = *this;
    ar(start_W, shape_W, dt, ends, hulls[0]);
    is_fitted = is_fitted && !ar.reading();  // the same hulls come of the same shapes
  }

 private:
  static constexpr auto kParts = static_cast<std::size_t>(kBodyParts);
  using Hull = Kdop<Scalar, kTargetK>;

  /// A blade where a motion of it begins and ends, W, and when.
  struct BladeWay {
    Capsule<Scalar> start;
    Capsule<Scalar> end;
    Scalar from = 0;
    Scalar duration = 0;
  };
  /// Where a blade would end too deep.
  struct Dent {
    Contact<Scalar> contact;  ///< of the blade with the part, at the end of the motion
    Scalar depth = 0;         ///< beyond what is allowed, m
    BodyPart part = BodyPart::kPelvis;
    Scalar comes_out = 0;  ///< at this speed, where it is too deep when the motion begins, m/s
  };
  /// A piece of a blade's way, and when it begins.
  struct BladePiece {
    const MovingCapsule<Scalar>& blade;
    Scalar from;
  };

  /// Kept apart from the search in it: what makes the pair is not there while it runs.
  [[gnu::noinline]] Result<MovingPair<Scalar>> pair_with(std::size_t part,
                                                         const BladePiece& piece) const;
  template <class Search>
  [[gnu::noinline]] void search_part(std::size_t part, const BladePiece& piece,
                                     const typename Search::Options& options,
                                     TouchSearch<Scalar>& first) const {
    const auto pair = pair_with(part, piece);
    const auto result = pair.ok() ? Search::search(pair.value, options, Vec3<Scalar>::Zero())
                                  : SearchResult<Scalar>{};
    take({result, pair.value.origin_W, static_cast<BodyPart>(part), piece.from}, first);
  }

  struct PartSearch {
    const SearchResult<Scalar>& result;
    const Vec3<Scalar>& origin_W;  ///< of its pair
    BodyPart part;
    Scalar from;
  };

  void start_from_here();
  void arrive(Scalar dt);
  void stay();
  void set_way(const Aabb<Scalar>& ends, Scalar dt);
  Hull hull_of_all(const Aabb<Scalar>& ends) const;
  void fit();
  Hull own_hull(std::size_t part) const;
  PartMask parts_in(const Hull& box, PartMask wanted);
  PartMask parts_reached(const MovingCapsule<Scalar>& blade, PartMask wanted);
  Segment<Scalar> axis_at(std::size_t part, Scalar t) const;
  Dent dent_in(std::size_t part, const BladeWay& way) const;
  Vec3<Scalar> velocity_of(BodyPart part, const Vec3<Scalar>& p_W) const;
  Dent deepest_dent(const MovingCapsule<Scalar>& blade, Scalar from, PartMask parts);
  static void take(const PartSearch& search, TouchSearch<Scalar>& first);

  std::array<Segment<Scalar>, kParts> start_W_{};  ///< axes at the start of the step
  BodyShape<Scalar> shape_W_{};                    ///< at its end
  Scalar dt_ = 0;                                  ///< length of the step, s; 0: placed
  Aabb<Scalar> ends_{{}, {}};  ///< of the ends of all axes, at the end of the step
  /// The first: of the whole body. The others: of their parts, where they are fitted.
  std::array<Hull, kParts> hulls_{};
  bool is_fitted_ = false;
};

}  // namespace batuta::fencing
