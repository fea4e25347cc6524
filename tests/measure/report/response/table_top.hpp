// SPDX-License-Identifier: MIT
#pragma once
// Four ways in which capsules stay in contact, to be stepped and looked at. All are 1 m long from
// end to end, so that a length is also its share of a capsule's length. But for the bridge, bodies
// do not turn: nothing holds a rod on one post, or two blades, from slipping off each other.

#include <array>
#include <cstdint>

#include "batuta/fencing/grip.hpp"
#include "batuta/world/world.hpp"
#include "draws.hpp"

namespace batuta::report {

enum class Play : std::uint8_t {
  kRest,    ///< under its weight, a rod lies across a fixed post
  kSlide,   ///< the same, sliding along the post
  kBridge,  ///< a rod that may turn slides along two posts: three bodies, more than the paper
            ///< treats
  kPress,   ///< two hands press crossed blades together and draw them along each other
};
inline constexpr std::array<Play, 4> kPlays = {Play::kRest, Play::kSlide, Play::kBridge,
                                               Play::kPress};

inline const char* name(Play play) {
  constexpr std::array<const char*, 4> kNames = {"rest", "slide", "bridge", "press"};
  return kNames[static_cast<std::size_t>(play)];
}

/// Whether weight, not a hand, holds the bodies together.
inline bool lies(Play play) {
  return play != Play::kPress;
}

/// A hand that can be open: then its body flies by its momenta.
template <class S>
struct OpenHand : fencing::Grip<S> {
  bool open = true;

  PlannedMotion<S> plan(const Body<S>& body, S t, S duration) const {
    return open ? FreeFlight<S>{}.plan(body, t, duration)
                : fencing::Grip<S>::plan(body, t, duration);
  }
};

constexpr SceneOptions table_scene_options() {
  SceneOptions scene;
  scene.max_bodies = 3;
  scene.max_pairs = 3;
  scene.max_contacts = 32;
  scene.max_events = 64;
  return scene;
}
template <class SearchT>
using TableScene = Scene<table_scene_options, SearchT, OpenHand<typename SearchT::Scalar>>;

/// A world in one of the plays, with the weight that bodies have in it. Frame W: z up.
template <class SceneT>
class TableTop {
 public:
  using S = typename SceneT::Scalar;

  static constexpr S kStep = S(1e-3);        ///< s
  static constexpr S kSpeed = S(0.5);        ///< of a rod along its posts, m/s
  static constexpr S kDrawSpeed = S(0.1);    ///< of the hands along the blades, m/s
  static constexpr S kPressSpeed = S(0.2);   ///< of the hands towards each other, m/s
  static constexpr S kReach = S(0.05);       ///< how far each hand wants to be beyond the other, m
  static constexpr S kGravity = S(9.80665);  ///< m/s^2

  /// @param number  of the variant: where the rod starts, and how far it is turned
  /// @returns false where the world refuses the settings or a body
  bool set_up(Play play, std::uint64_t number, const WorldSettings<SceneT>& settings) {
    play_ = play;
    gap_ = settings.separation;
    test::Draws draws(kSeed, 0, number);
    for (S& vary : vary_) vary = static_cast<S>(draws.signed_unit());
    if (world_.configure(settings) != Status::kOk) return false;
    return lies(play) ? add_rod_on_posts() : add_blades();
  }

  /// One step of kStep.
  Status step() {
    if (lies(play_)) {
      actor(0).body.momentum.linear_W.z() -= kGravity * kStep * kMass;
    } else {
      command(0);
      command(1);
    }
    ++steps_;
    return world_.step(kStep);
  }

  const World<SceneT>& world() const { return world_; }
  /// Pairs that are in contact: the first body with each of the others.
  int pairs() const { return world_.size() - 1; }
  /// Gap of pair k from the poses as they are stored, computed in double, m.
  double gap(int k) const { return capsule_gap(shape(0), shape(k + 1)).gap; }
  /// How far the first body has slid along the others, m, and would have with nothing in its way.
  double travel() const { return static_cast<double>(actor(0).body.X_WB.p_W.y()) - start_y_; }
  double free_travel() const { return static_cast<double>(speed() * kStep) * steps_; }

 private:
  static constexpr std::uint64_t kSeed = 42;
  static constexpr S kRadius = S(0.005);
  static constexpr S kHalfAxis = S(0.495);
  static constexpr S kMass = S(0.5);
  static constexpr S kPostOffset = S(0.35);

  S speed() const {
    if (play_ == Play::kRest) return 0;
    return play_ == Play::kPress ? kDrawSpeed : kSpeed;
  }

  static Capsule<S> along(const Vec3<S>& axis, S half) {
    return {{Vec3<S>(-half * axis), Vec3<S>(half * axis)}, kRadius};
  }
  /// A rod or blade along `axis`, one of the axes of W, in the hand of nobody.
  Actor<SceneT> rod(const Vec3<S>& place, const Vec3<S>& axis) const {
    const Capsule<S> capsule = along(axis, kHalfAxis);
    const auto unit = solid_capsule(capsule, S(1)).value;
    const Vec3<S> moments = kMass / unit.mass * unit.inertia_S.diagonal();
    Actor<SceneT> actor;
    actor.body = make_body<S>({place, Quat<S>::Identity()}, kMass, moments).value;
    if (play_ != Play::kBridge) actor.body.inverse_moments.setZero();
    actor.capsule_B = capsule;
    return actor;
  }
  static Actor<SceneT> post(S x) {
    Actor<SceneT> actor;
    actor.body.X_WB.p_W = {x, 0, 0};
    actor.capsule_B = along(Vec3<S>::UnitY(), S(2));
    return actor;
  }

  /// Dropped from a gap between D and 2 D, not quite in the middle and not quite straight across.
  bool add_rod_on_posts() {
    const S height = 2 * kRadius + gap_ * (S(1.5) + S(0.5) * vary_[0]);
    Actor<SceneT> top = rod({S(0.05) * vary_[1], 0, height}, Vec3<S>::UnitX());
    top.body.X_WB.q_WB = exp_map(Vec3<S>(0, 0, S(0.2) * vary_[2]));
    top.body.momentum.linear_W.y() = kMass * speed();
    if (play_ == Play::kBridge) {
      return add(top) && add(post(-kPostOffset)) && add(post(kPostOffset));
    }
    return add(top) && add(post(0));
  }

  /// The pose that hand k wants after the coming step: beyond the other blade.
  Pose<S> wanted(int k) const {
    const S side = k == 0 ? S(-1) : S(1);
    const S time = kStep * static_cast<S>(steps_ + 1);
    const S pressed = min_of(kReach, kPressSpeed * time);
    const S drawn = kDrawSpeed * time + S(0.05) * vary_[3];
    const Vec3<S> along_other = k == 0 ? Vec3<S>(0, drawn, 0) : Vec3<S>(0, 0, drawn);
    return {Vec3<S>(-side * pressed, 0, 0) + along_other, Quat<S>::Identity()};
  }
  bool add_blades() {
    for (int k = 0; k < 2; ++k) {
      const S side = k == 0 ? S(-1) : S(1);
      Pose<S> start = wanted(k);
      start.p_W.x() = side * (kRadius + gap_ * (S(0.75) + S(0.25) * vary_[0]));
      Actor<SceneT> blade = rod(start.p_W, k == 0 ? Vec3<S>::UnitZ() : Vec3<S>::UnitY());
      blade.controller.open = false;
      blade.controller.place(start);
      if (!add(blade)) return false;
    }
    return true;
  }
  void command(int k) { actor(k).controller.command(wanted(k), kStep); }

  bool add(const Actor<SceneT>& added) {
    const auto id = world_.add(added);
    if (!id.ok()) return false;
    if (world_.size() == 1) start_y_ = static_cast<double>(added.body.X_WB.p_W.y());
    return true;
  }
  Actor<SceneT>& actor(int k) { return *world_.get(world_.id_at(static_cast<std::uint16_t>(k))); }
  const Actor<SceneT>& actor(int k) const {
    return *world_.get(world_.id_at(static_cast<std::uint16_t>(k)));
  }
  Capsule<double> shape(int k) const {
    const Actor<SceneT>& shown = actor(k);
    const Pose<double> pose{shown.body.X_WB.p_W.template cast<double>(),
                            shown.body.X_WB.q_WB.template cast<double>()};
    const Segment<S>& axis = shown.capsule_B.axis;
    return to_world(
        pose, Capsule<double>{{axis.a.template cast<double>(), axis.b.template cast<double>()},
                              static_cast<double>(shown.capsule_B.radius)});
  }

  World<SceneT> world_;
  Play play_ = Play::kRest;
  S gap_ = 0;                ///< D, m
  std::array<S, 4> vary_{};  ///< in [-1, 1]: what makes this variant
  int steps_ = 0;
  double start_y_ = 0;
};

}  // namespace batuta::report
