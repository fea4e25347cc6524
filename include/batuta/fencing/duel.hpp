// SPDX-License-Identifier: MIT
#pragma once
// Two fencers, two sticks, one bout [Kavan §5]: stick -> keyframes -> hand -> grip -> blade in the
// world; then each blade against the other fencer's body, until somebody is touched. Frame W
// (salle), SI units. Time is a count of steps and a time within the step, so that it is as fine
// after an hour as at the start.

#include "batuta/fencing/fencer.hpp"
#include "batuta/fencing/stick.hpp"
#include "batuta/fencing/target.hpp"
#include "batuta/world/world.hpp"

namespace batuta {

/// An instant of a bout.
template <class Scalar>
struct Moment {
  std::uint32_t step = 0;  ///< steps that were over
  Scalar in_step = 0;      ///< s
};

/// Where a blade was when a contact of the step was answered, for the touches of the same step.
template <class Scalar>
struct Waypoint {
  Scalar time = 0;  ///< in the step, s
  Pose<Scalar> X_WB;
};

/// A grip that remembers the corners of its way in the step.
template <class Scalar, int N>
struct BladeDriver {
  Grip<Scalar> grip;
  FixedList<Waypoint<Scalar>, N> corners;

  Course<Scalar> course(const Body<Scalar>& body, Scalar t, Scalar duration) const {
    return grip.course(body, t, duration);
  }
  void on_contact(const Body<Scalar>& body, const Feedback<Scalar>& feedback) {
    corners.push(
        {feedback.time, body.X_WB});  // never full: the world answers at most N contacts in a step
    grip.on_contact(body, feedback);
  }
  void on_step_end(const Body<Scalar>& body, Scalar dt) { grip.on_step_end(body, dt); }
};

template <class S, class SearchT>
struct DuelScene : Scene {
  using Scalar = S;
  using Search = SearchT;
  static constexpr std::uint32_t kBudget = SearchT::kDefaultBudget;
  static constexpr int kMaxBodies = 2;
  static constexpr int kMaxPairs = 1;
  static constexpr int kMaxContacts = 8;
  static constexpr int kMaxEvents = 16;
  using Driver = BladeDriver<S, kMaxContacts>;
};

/// @tparam SearchT  how blades and touches are found: Advancement, or the paper's Stepping to
///   compare it with
template <class Scalar, class SearchT = Advancement<Scalar>>
struct DuelSettings {
  std::int32_t step_us = 1000;  ///< length of a step, us, 100 ... 20000
  std::int32_t double_window_us =
      40000;  ///< a second touch within this time counts as double, us, >= 0
  StickSettings stick;
  WorldSettings<DuelScene<Scalar, SearchT>> world;  ///< blades: defaults of duel_settings()
  /// Search for touches.
  typename SearchT::Options touch = SearchOf<DuelScene<Scalar, SearchT>>::options();
  PartMask target = kAllParts;  ///< parts where a touch counts: the weapon's convention
  Salle<Scalar> salle;
};

/// Settings that suit the two fencers of the library.
template <class Scalar, class SearchT = Advancement<Scalar>>
DuelSettings<Scalar, SearchT> duel_settings();

enum class BoutState : std::uint8_t {
  kFencing,
  kLockout,  ///< somebody is touched; the other may still touch within the window
  kTouched,  ///< over: one touch
  kDouble,   ///< over: two touches within the window
};

template <class Scalar>
struct Touch {
  Side by = Side::kLeft;              ///< whose blade
  BodyPart part = BodyPart::kPelvis;  ///< where on the other
  Moment<Scalar> when;
  Contact<Scalar> contact;  ///< the normal points out of the one who is touched
  Scalar place = 0;         ///< on the blade: 0 guard ... 1 tip
  /// False: a search ended without an answer at an earlier time; it may not be the first. In a step
  /// in which a blade was held, `when` is known to within StepReport::time_held, for the hold is
  /// spread over the blade's way between two corners.
  bool certain = true;
};

template <class Scalar>
struct Bout {
  BoutState state = BoutState::kFencing;
  FixedList<Touch<Scalar>, 2> touches;  ///< in the order of time

  bool is_over() const { return state == BoutState::kTouched || state == BoutState::kDouble; }
};

/// Sums over the bout. The lower half is zero in a healthy bout.
struct DuelReport {
  std::uint32_t blows = 0;             ///< colliding contacts of the blades
  std::uint32_t rests = 0;             ///< resting contacts: blades leaning on each other
  std::uint64_t evaluations = 0;       ///< distance evaluations of all searches
  std::uint32_t touch_searches = 0;    ///< body parts that the hierarchy could not rule out
  std::uint32_t incomplete_steps = 0;  ///< the world's report was not complete(): blades were held
  std::uint32_t budget_outs = 0;       ///< searches that ran out of their budget, blade or touch
  std::uint32_t searches_invalid = 0;  ///< searches that could not be asked, blade or touch
};

/// Built into the library for float and double with Advancement, and with Stepping; a program links
/// the one that it names.
template <class Scalar, class SearchT = Advancement<Scalar>>
class Duel {
 public:
  using SceneType = DuelScene<Scalar, SearchT>;
  using Settings = DuelSettings<Scalar, SearchT>;
  using WorldType = World<SceneType>;

  Duel() = default;
  Duel(const Duel&) = delete;
  Duel& operator=(const Duel&) = delete;

  /// Puts both fencers on guard and starts a new bout. Stack: about 2 kB in float, for
  /// what both fencers come to before anything is changed.
  /// @returns kOk | kInvalidArgument (settings, settings.world, settings.touch or a fencer's data
  /// out of range; nothing changed: a running bout goes on)
  Status configure(const Settings& settings, const Fencer<Scalar>& left,
                   const Fencer<Scalar>& right);

  /// One step. After the bout is over it changes nothing.
  /// @param left, right  a new sample of the fencer's device, or null where there is none
  /// @returns kOk | kUnavailable (the bout is over) | kInvalidArgument (not configured)
  /// Bound: one World::step() and 2 (kMaxContacts + 1) touch searches.
  Status step(const InputSample* left, const InputSample* right);

  const Bout<Scalar>& bout() const { return bout_; }
  const DuelReport& report() const { return report_; }
  std::uint32_t steps() const { return steps_; }
  /// us since the start of the bout: exact to the step, the rest rounded.
  std::uint64_t time_us(const Moment<Scalar>& moment) const;

  /// Length of a step, s; 0: not configured.
  Scalar dt() const { return dt_; }

  /// The step's own report and contact events; body slot 0 is the left blade, 1 the right one.
  const WorldType& world() const { return world_; }
  const StickTracker<Scalar>& stick(Side side) const { return at(side).stick; }
  /// @pre configured
  const Grip<Scalar>& grip(Side side) const;
  const KeyedPose<Scalar>& hand(Side side) const {
    return at(side).hand;
  }  ///< pose and Jacobian of the hand
  /// @pre configured
  Capsule<Scalar> blade_W(Side side) const;
  const BodyShape<Scalar>& body_W(Side side) const { return at(side).target.shape(); }

  /// Everything that the next step depends on, for save() and restore() (core/snapshot.hpp), a
  /// Recorder, or hash_of(); include fencing/archive.hpp. What is read must be settings that
  /// configure() takes, two blades, sticks within their square, and numbers that are sane; else
  /// the duel is one that was not configured. Bound: its members.
  template <class ArchiveT>
  void archive(ArchiveT& ar) {
    auto& [settings, world, places, bout, report, steps, dt] = *this;
    ar(settings, world, places, bout, report, steps, dt);
    if (!ar.reading()) return;
    ar.require(dt_ == Scalar(0) || (ar.all_sane() && is_sound()));
    if (!ar.ok()) dt_ = 0;
  }

 private:
  using BodyId = typename WorldType::BodyId;

  struct Place {
    StickTracker<Scalar> stick;
    FencerGrid<Scalar> grid;
    FencerBuild<Scalar> build;
    WeaponBody<Scalar> weapon;
    Pose<Scalar> X_WF;
    KeyedPose<Scalar> hand;
    Target<Scalar> target;
    Pose<Scalar> start_WB;  ///< the blade's body at the start of the step
    BodyId blade;

    template <class ArchiveT>
    void archive(ArchiveT& ar) {
      auto& [tracker, keys, limbs, arm, origin, hand_W, body, start, id] = *this;
      ar(tracker, keys, limbs, arm, origin, hand_W, body, start, id);
    }
  };

  /// What a fencer's data come to, before anything is changed.
  struct Seat {
    FencerGrid<Scalar> grid;
    WeaponBody<Scalar> weapon;
    Pose<Scalar> X_WF;
    KeyedPose<Scalar> hand;
    Actor<SceneType> blade;
  };

  Place& at(Side side) { return places_[index_of(side)]; }
  const Place& at(Side side) const { return places_[index_of(side)]; }
  static Result<Seat> seat_for(const Fencer<Scalar>& fencer, const Pose<Scalar>& X_WF);
  static Status arm(const Fencer<Scalar>& fencer, Seat& seat);
  void take_place(Place& place, const Seat& seat, const FencerBuild<Scalar>& build);
  const Actor<SceneType>& blade_of(Side side) const;
  void move_hand(Side side, const InputSample* sample);
  void look_for_touches();
  TouchSearch<Scalar> touch_by(Side side);
  void note(Side by, const TouchSearch<Scalar>& search);
  bool within_window(const Moment<Scalar>& first, const Moment<Scalar>& second) const;
  void close_window();
  void add_up();
  bool is_sound() const;

  Settings settings_;
  WorldType world_;
  std::array<Place, 2> places_;
  Bout<Scalar> bout_;
  DuelReport report_;
  std::uint32_t steps_ = 0;
  Scalar dt_ = 0;  ///< s; 0: not configured
};

}  // namespace batuta
