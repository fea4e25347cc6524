// SPDX-License-Identifier: MIT
#pragma once
// Two fencers, two sticks, one bout [Kavan §5]: stick -> keyframes -> hand -> grip -> blade in the
// world; then each blade against the other fencer's body, until somebody is touched. Frame W
// (salle), SI units.

// First, as in world.hpp.
#include "batuta/fencing/duel_scene.hpp"

#include "batuta/fencing/detail/footwork.hpp"
#include "batuta/fencing/detail/referee.hpp"

namespace batuta::fencing {

/// A bout between two fencers, step by step.
/// Built into the library for float and double with Advancement, and with Stepping; a program links
/// the one that it names. For a scene of one's own, include fencing/duel_definitions.hpp.
/// @tparam SceneT  a DuelScene: what it leaves out is absent
template <class SceneT = DuelScene<>>
class Duel : private detail::DuelVerdict<SceneT>, private detail::OtherVerdict<SceneT> {
  using Played = typename detail::DuelVerdict<SceneT>::Played;

 public:
  using StatedScene = SceneT;  ///< for duel_settings()
  /// Of lengths and times.
  using Scalar = typename Played::Scalar;
  /// The scene as its world runs it.
  using SceneType = BladesOf<Played>;
  /// What configure() takes.
  using Settings = DuelSettings<SceneT>;
  /// The world of the two blades.
  using WorldType = World<SceneType>;

  /// Not configured: step() does nothing but say so.
  Duel() = default;
  Duel(const Duel&) = delete;
  Duel& operator=(const Duel&) = delete;

  /// Puts both fencers on guard and starts a new bout. Stack in float: about 1.5 kB.
  /// @pre the keys of both maps outlive this duel, or its next configure()
  /// @returns kOk | kInvalidArgument (settings, settings.world, settings.touch or a fencer's data
  /// out of range; nothing changed: a running bout goes on)
  Status configure(const Settings& settings, const Fencer<Scalar>& left,
                   const Fencer<Scalar>& right);
  /// The same of fencers that are made whenever they are needed, one at a time, where none is kept:
  /// as duel.configure(settings, first_fencer<float>, second_fencer<float>). Each call must make
  /// the same one. Stack in float: about 2.4 kB.
  /// @returns as above; kInvalidArgument where one is null, too
  Status configure(const Settings& settings, FencerMaker<Scalar> left, FencerMaker<Scalar> right);

  /// One step. After the bout is over it changes nothing. The first step after a halt begins with
  /// both fencers on guard, where configure() puts them, and with their sticks at the centre, from
  /// where they go to where they are held, no faster than StickSettings::max_speed. The blades know
  /// nothing of the exchange before.
  /// @param left, right  a new sample of the fencer's device, or null where there is none
  /// @returns kOk | kUnavailable (the bout is over) | kInvalidArgument (not configured)
  /// Bound: one World::step() and, with targets, 2 (kMostCorners + 1) touch searches, and for
  /// each plan of a blade one Target::stop().
  Status step(const InputSample* left, const InputSample* right);

  /// Bout; OpenBout in a scene without targets.
  decltype(auto) bout() const { return scoring_.bout(); }
  /// Sums over the bout.
  const DuelReport& report() const { return scoring_.report; }
  /// Steps made since configure().
  std::uint32_t steps() const { return steps_; }
  /// us since the start of the bout: exact to the step, the rest rounded.
  std::uint64_t time_us(const Moment<Scalar>& moment) const {
    return fencing::time_us(moment, settings_.step_us);
  }

  /// Length of a step, s; 0: not configured.
  Scalar dt() const { return dt_; }

  /// The step's own report and contact events; body slot 0 is the left blade, 1 the right one.
  const WorldType& world() const { return world_; }
  /// The stick of a fencer, as it is after the last step.
  const StickTracker<Scalar>& stick(Side side) const { return at(side).stick; }
  /// Where a fencer's feet have carried him. @pre the scene has feet
  template <class S = Played>
  const Feet<Scalar>& feet(Side side) const {
    static_assert(S::kFeet, "Duel: without feet there is no feet(); fencers stay where they are");
    return scoring_.feet[index_of(side)];
  }
  /// Where a fencer's frame F is, W: x towards the opponent.
  Pose<Scalar> X_WF(Side side) const;
  /// The grip of a fencer on the blade. @pre configured; the scene has grip
  template <class S = Played>
  const Grip<Scalar>& grip(Side side) const {
    static_assert(S::kGrip, "Duel: without grip there is no grip(); a Hand carries each blade");
    return blade_of(side).controller.carrier;
  }
  /// Pose and Jacobian of the hand where the stick wants it, W.
  const KeyedPose<Scalar>& hand(Side side) const { return at(side).hand; }
  /// Where a hand is that holds the blade as it is now; hand() is where the stick wants it.
  /// @pre configured; the scene has haptics
  template <class S = Played>
  Pose<Scalar> held_hand_W(Side side) const {
    static_assert(S::kHaptics, "Duel: without haptics there is no held_hand_W()");
    return chained(blade_of(side).body.X_WB, inverse(at(side).weapon.X_HB));
  }
  /// The blade of a fencer as it is now. @pre configured
  Capsule<Scalar> blade_W(Side side) const;
  /// The body of a fencer that can be touched, as it is now, W. @pre configured; the scene has
  /// targets
  template <class S = Played>
  const BodyShape<Scalar>& body_W(Side side) const {
    static_assert(S::kTargets, "Duel: without targets there is no body_W(); fencers have no body");
    return scoring_.body_W(side);
  }

  /// Everything that the next step depends on, for save() and restore() (record/snapshot.hpp), a
  /// Recorder, or hash_of(); include record/duel.hpp. The keys of the fencers' maps are not among
  /// it, only their map_id(): what is read goes on with the maps of the duel that reads, those that
  /// it was configured with, or library_map(). It must have their ids, settings that configure()
  /// takes, two blades, sticks within their square, and numbers that are sane; else the duel is one
  /// that was not configured, and one of which that is not true is not written either
  /// (kInvalidArgument). Bound: its members, and the keys of both maps.
  template <class ArchiveT>
  void archive(ArchiveT& ar) {
    auto& [settings, world, places, scoring, steps, dt] = *this;
    ar(settings, world, places, scoring, steps, dt);
    if (!ar.reading() && !ar.writing()) return;
    ar.require(dt_ == Scalar(0) || (ar.all_sane() && is_sound()));
    if (ar.reading() && !ar.ok()) dt_ = 0;
  }

 private:
  using BodyId = typename WorldType::BodyId;

  struct DuelSide {
    StickTracker<Scalar> stick;
    FencerMap<Scalar> map;  ///< no keys: that of the library
    WeaponMass<Scalar> weapon;
    KeyedPose<Scalar> hand;
    BodyId blade;

    /// An address has no meaning elsewhere: the id of the map is kept, and who reads has the map.
    template <class ArchiveT>
    void archive(ArchiveT& ar) {
      auto& [tracker, keys, arm, hand_W, id] = *this;
      if (keys.keys == nullptr && ar.reading()) keys = library_map<Scalar>();
      const std::uint32_t own = map_id(keys.keys == nullptr ? library_map<Scalar>() : keys);
      std::uint32_t written = own;
      ar(tracker, written, arm, hand_W, id);
      ar.require(written == own);
    }
  };

  /// A referee and feet are bases: where there are none, they take no room.
  struct Scoring : RefereeOf<Played>, FootworkOf<Played> {
    DuelReport report;

    template <class ArchiveT>
    void archive(ArchiveT& ar) {
      RefereeOf<Played>::archive(ar);
      if constexpr (Played::kFeet) ar(this->feet, this->close_steps);
      ar(report);
    }
  };

  DuelSide& at(Side side) { return places_[index_of(side)]; }
  const DuelSide& at(Side side) const { return places_[index_of(side)]; }
  template <class Left, class Right>
  Status configure_with(const Settings& settings, const Left& left, const Right& right);
  template <class Maker>
  [[gnu::noinline]] static bool may_fence(const Maker& make, const Pose<Scalar>& X_WF);
  static KeyedPose<Scalar> hand_at_start(const FencerMap<Scalar>& map, const Pose<Scalar>& X_WF);
  template <class Maker>
  [[gnu::noinline]] static Result<Pose<Scalar>> hand_of(const Maker& make,
                                                        const Pose<Scalar>& X_WF);
  template <class Maker>
  [[gnu::noinline]] static Status arm(const Maker& make, const Pose<Scalar>& X_WH,
                                      Actor<SceneType>& blade);
  static Status put(Actor<SceneType>& blade, const WeaponMass<Scalar>& weapon,
                    const Pose<Scalar>& X_WB);
  template <class Maker>
  [[gnu::noinline]] void take_place(Side side, const Maker& make);
  template <class Maker>
  [[gnu::noinline]] void enter(Side side, const Maker& make);
  [[gnu::noinline]] void resume_after_halt();
  void stand(Side side, Actor<SceneType>& blade);
  const Actor<SceneType>& blade_of(Side side) const;
  /// Kept apart: what it needs is not there while the blades move.
  [[gnu::noinline]] void lead(const InputSample* left, const InputSample* right);
  void move_stick(Side side, const InputSample* sample);
  bool is_beaten(Side side) const;
  MapPlace<Scalar> asked_of(Side side) const;
  Scalar feet_order(Side side, Scalar asked) const;
  void walk(Scalar left, Scalar right);
  void move_hand(Side side, const MapPlace<Scalar>& asked);
  Status move_blades();
  void halt_corps_a_corps();
  void carry_blades();
  void add_up();
  bool is_sound() const;

  Settings settings_;
  WorldType world_;
  std::array<DuelSide, 2> places_;
  Scoring scoring_;
  std::uint32_t steps_ = 0;
  Scalar dt_ = 0;  ///< s; 0: not configured
};

}  // namespace batuta::fencing
