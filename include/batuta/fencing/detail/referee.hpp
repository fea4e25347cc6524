// SPDX-License-Identifier: MIT
#pragma once
// The bodies of both fencers, and who touches them first: each blade against the other fencer's
// body, until the bout is over [Kavan §5]. The part of a duel that a scene without targets leaves
// out. Frame W, SI units.

#include "batuta/fencing/detail/touch_rule.hpp"

namespace batuta::fencing {

/// Both fencers as targets, and the bout. Defined in fencing/detail/referee_definitions.hpp.
/// Allocates: never. RAM in float: 2 (1 kB + FencerBuild).
template <class SceneT>
class Referee {
 public:
  using Scalar = typename SceneT::Scalar;
  using Search = typename SceneT::Search;
  using Blade = Actor<BladesOf<SceneT>>;
  using Settings = DuelSettings<SceneT>;

  /// Nobody is touched.
  void begin();

  /// Who fences on a side. @pre valid
  void take_place(Side side, const FencerBuild<Scalar>& build);
  /// Puts a fencer somewhere, still, and his blade. @pre finite
  void stand(Side side, const Stance<Scalar>& stance, const Pose<Scalar>& X_WB);

  /// The fencer goes to a stance in the coming step of length dt. @pre finite; dt > 0
  void follow(Side side, const Stance<Scalar>& stance, const Blade& blade, Scalar dt);

  /// What stops a fencer's blade, which is where it is, in the coming step of length dt; after
  /// follow() of both.
  Steel<Scalar> steel_for(Side side, const Blade& blade, Scalar dt) {
    Pose<Scalar>& start_WB = at(side).start_WB;
    const Twist<Scalar> came = motion_between(start_WB, blade.body.X_WB, dt).twist;
    start_WB = blade.body.X_WB;
    return {&at(other(side)).target, part_of(blade, 0), came};
  }

  /// What brings a fencer's blade out of the other's body after the world's step, W, m.
  Vec3<Scalar> way_out(Side side, const Blade& blade) {
    return at(other(side))
        .target.way_out(part_of(blade, 0), at(side).start_WB, blade.body.X_WB, kSteelParts);
  }

  /// The halt is over, both are on guard: the next exchange.
  void resume();

  /// After the world's step. Both blades are looked at before either touch is judged; the earlier
  /// one is noted first, the left one of two at once. In a halt nobody looks.
  /// @param blades  of the left and the right fencer, where they are now
  /// @param steel   what stopped them
  /// @param now     steps that were over before this one, and its length
  /// Bound: 2 (kMostCorners + 1) touch searches, and one more for each part that the point enters
  /// without a touch.
  void judge(const std::array<const Blade*, 2>& blades, const std::array<Steel<Scalar>, 2>& steel,
             const Settings& settings, const Moment<Scalar>& now, DuelReport& report);

  /// Nobody scores until both are on guard again. @pre the bout is not over
  void call_halt(const Settings& settings);

  const Bout<Scalar>& bout() const { return bout_; }
  const BodyShape<Scalar>& body_W(Side side) const { return at(side).target.shape(); }

  /// What was read is a state that steps of length dt can go on from.
  bool is_sound(const Settings& settings, Scalar dt) const;

  /// Its state, for record/archive.hpp.
  template <class ArchiveT>
  void archive(ArchiveT& ar) {
    auto& [places, bout] = *this;
    ar(places, bout);
  }

 private:
  /// The point's way through one piece of a step.
  struct PointWay {
    Capsule<Scalar> start_W;  ///< where it is at the start of the step
    MovingCapsule<Scalar> point;
    Scalar from = 0;               ///< s
    Twist<Scalar> came;            ///< Steel::came
    detail::Command<Scalar> hand;  ///< what it has of the weapon
  };

  struct RefereeSide {
    FencerBuild<Scalar> build;
    Target<Scalar> target;
    Pose<Scalar> start_WB;  ///< the blade's body at the start of the step
    Vec3<Scalar> hand_W = batuta::detail::zero<Scalar>();  ///< where the hand is wanted at its end
    Scalar control = 1;                                    ///< of the hand, at its start
    PartMask closed = 0;  ///< parts of the other that the point is in, and did not touch

    template <class ArchiveT>
    void archive(ArchiveT& ar) {
      auto& [limbs, body, start, hand, held, shut] = *this;
      ar(limbs, body, start, hand, held, shut);
    }
  };

  RefereeSide& at(Side side) { return places_[index_of(side)]; }
  const RefereeSide& at(Side side) const { return places_[index_of(side)]; }
  TouchSearch<Scalar> touch_by(Side side, const Blade& blade, const Twist<Scalar>& came,
                               const Settings& settings, Scalar dt, DuelReport& report);
  static Scalar touch_speed(const PointWay& way, const MovingCapsule<Scalar>& part,
                            const TouchSearch<Scalar>& found);
  void touch_in(Side side, const PointWay& way, const Settings& settings, DuelReport& report,
                TouchSearch<Scalar>& search);
  Scalar slip_of(Side side, const Blade& blade) const;
  bool was_outside(Side side, const Capsule<Scalar>& point_W, BodyPart part) const;
  void close_all();
  void reopen(Side side, const Capsule<Scalar>& point_W);
  void note(Side by, const TouchSearch<Scalar>& search, const Settings& settings,
            std::uint32_t step);
  bool is_within_window(const Settings& settings, const Moment<Scalar>& second) const;
  bool is_exchange_over(const Settings& settings, std::uint32_t next_step) const;
  void end_exchange(const Settings& settings);

  std::array<RefereeSide, 2> places_;
  Bout<Scalar> bout_;
};

/// Stands in its place where there is nobody to touch.
struct NoReferee {
  static constexpr OpenBout bout() { return {}; }

  template <class ArchiveT>
  void archive(ArchiveT& ar) {
    ar.constant(0);
  }
};

template <class SceneT>
using RefereeOf = std::conditional_t<SceneT::kTargets, Referee<SceneT>, NoReferee>;

}  // namespace batuta::fencing
