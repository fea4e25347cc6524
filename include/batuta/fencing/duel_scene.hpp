// SPDX-License-Identifier: MIT
#pragma once
// The scene of a duel, and what its features bring: who drives the blades, and which settings there
// are. What a scene leaves out is an empty base (world/actor.hpp).

#include "batuta/control/stick.hpp"
#include "batuta/fencing/bout.hpp"
#include "batuta/fencing/grip.hpp"
#include "batuta/fencing/target.hpp"
#include "batuta/world/world.hpp"

namespace batuta::fencing {

/// Two blades. Derive, and hide what is different:
///   struct Drill : DuelScene<float, Advancement<float>> { static constexpr bool kTargets = false;
///   };
/// Scene::Controller is the duel's own (BladeController) whatever the scene says.
template <class S, class SearchT>
struct DuelScene : Scene {
  /// Of lengths and times.
  using Scalar = S;
  /// How blades and touches are found.
  using Search = SearchT;
  /// Distance evaluations of one search.
  static constexpr std::uint32_t kBudget = SearchT::kDefaultBudget;
  /// Two blades.
  static constexpr int kMaxBodies = 2;
  /// One pair.
  static constexpr int kMaxPairs = 1;
  /// Contacts answered in one step.
  static constexpr int kMaxContacts = 8;
  /// Events kept for reading after a step.
  static constexpr int kMaxEvents = 16;
  /// Off: each blade is carried by a Hand, which has whatever strength it takes; Fencer::grip is
  /// not looked at.
  static constexpr bool kGrip = true;
  /// Off: blades only, nobody can be touched; Fencer::build is not looked at.
  static constexpr bool kTargets = true;
  /// Off: Duel::held_hand_W() is absent, and what needs it: nothing of room haptics is linked.
  static constexpr bool kHaptics = true;
};

/// Where a blade was when a contact of the step was answered, for the touches of the same step.
template <class Scalar>
struct Waypoint {
  Scalar time = 0;    ///< in the step, s
  Pose<Scalar> X_WB;  ///< of the blade then
};

/// The corners of a blade's way in the step.
template <class Scalar, int N>
struct Corners {
  FixedList<Waypoint<Scalar>, N> corners;  ///< in the order of time
};
/// Corners, in a scene whose fencers can be touched.
template <class SceneT>
using CornersOf =
    FeatureIf<SceneT::kTargets, Corners<typename SceneT::Scalar, SceneT::kMaxContacts>, 16>;

/// Grip or hand, which remembers the corners of the blade's way where there is somebody to touch.
template <class SceneT>
struct BladeController : CornersOf<SceneT> {
  /// Of lengths and times.
  using Scalar = typename SceneT::Scalar;

  std::conditional_t<SceneT::kGrip, Grip<Scalar>, Hand<Scalar>>
      carrier;  ///< what carries the blade

  /// Takes the blade where it is. @returns kOk | kInvalidArgument (settings)
  Status take(const Pose<Scalar>& X_WB, [[maybe_unused]] const GripSettings<Scalar>& settings) {
    if constexpr (SceneT::kGrip) {
      carrier.place(X_WB);
      return carrier.configure(settings);
    } else {
      carrier.target_W = X_WB;
      return Status::kOk;
    }
  }
  /// Where the blade is wanted at the end of the coming step of length dt. @pre finite; dt > 0
  void command(const Pose<Scalar>& X_WB, Scalar dt) {
    if constexpr (SceneT::kTargets) this->corners.clear();
    if constexpr (SceneT::kGrip) {
      carrier.command(X_WB, dt);
    } else {
      carrier.target_W = X_WB;
      carrier.step = dt;
    }
  }

  /// That of the carrier.
  PlannedMotion<Scalar> plan(const Body<Scalar>& body, Scalar t, Scalar duration) const {
    return carrier.plan(body, t, duration);
  }
  /// Keeps the corner, and tells the carrier.
  void on_contact(const Body<Scalar>& body, const Feedback<Scalar>& feedback) {
    // Never full: the world answers at most kMaxContacts in a step.
    if constexpr (SceneT::kTargets) this->corners.push({feedback.time, body.X_WB});
    carrier.on_contact(body, feedback);
  }
  /// Tells the carrier.
  void on_step_end(const Body<Scalar>& body, Scalar dt) { carrier.on_step_end(body, dt); }
};

/// The scene as its world runs it.
template <class SceneT>
struct BladesOf : SceneT {
  /// Grip or hand, by the scene.
  using Controller = BladeController<SceneT>;
};

/// What there is to say about touches.
template <class SceneT>
struct TouchSettings {
  /// A second touch within this time counts as double, us, 0 ... 10000000
  std::int32_t double_window_us = 40000;
  /// Search for touches.
  typename SceneT::Search::Options touch = SearchOf<SceneT>::options();
  PartMask target = kAllParts;  ///< parts where a touch counts: the weapon's convention
};
/// TouchSettings, in a scene whose fencers can be touched.
template <class SceneT>
using TouchSettingsOf = FeatureIf<SceneT::kTargets, TouchSettings<SceneT>, 17>;

/// What a duel has to be told.
/// @tparam SearchT  how blades and touches are found: Advancement, or the paper's Stepping to
///   compare it with
/// @tparam SceneT  DuelScene, or what is derived from it
template <class Scalar, class SearchT = Advancement<Scalar>,
          class SceneT = DuelScene<Scalar, SearchT>>
struct DuelSettings : TouchSettingsOf<SceneT> {
  std::int32_t step_us = 1000;            ///< length of a step, us, 100 ... 20000
  StickSettings stick;                    ///< of both sticks
  WorldSettings<BladesOf<SceneT>> world;  ///< blades: defaults of duel_settings()
  Salle<Scalar> salle;                    ///< where the fencers stand
};

/// Settings that suit the two fencers of the library. For a scene of one's own, include
/// fencing/duel_definitions.hpp.
template <class Scalar, class SearchT = Advancement<Scalar>,
          class SceneT = DuelScene<Scalar, SearchT>>
DuelSettings<Scalar, SearchT, SceneT> duel_settings();

}  // namespace batuta::fencing
