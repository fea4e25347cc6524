// SPDX-License-Identifier: MIT
#pragma once
// What happens in a beat, without any step: the limit that shorter and shorter steps should come
// to. It takes the fencers' data, the surface through their key poses and the mass of their weapons
// from the library; the instant of contact, the impulse, the flight and the regaining hand are
// computed here, in long double, from [Kavan eq. 26, 32] and src/fencing/grip.md.

#include <array>

#include "beat.hpp"

namespace batuta::report {

using Wide = long double;

/// Where a blade is at one instant, and how it moves; frame W.
struct BladeState {
  Vec3<Wide> center;  ///< of mass
  Quat<Wide> q_WB;
  Vec3<Wide> v_W;  ///< of the centre of mass
  Vec3<Wide> w_W;
};

/// A blade as its fencer leads it.
class LedBlade {
 public:
  /// @param plan  of the left stick; the right one rests at its centre
  LedBlade(Side side, const BeatPlan& plan);

  /// Where the stick is at time t, and how fast it moves.
  Vec2<double> stick(double t) const;
  Vec2<double> stick_rate(double t) const;
  /// In the hand, at time t, s.
  BladeState held(double t) const;
  /// The two ends of its axis, guard and tip.
  std::array<Vec3<Wide>, 2> ends(const BladeState& state) const;
  /// (I^-1) v, in W.
  Vec3<Wide> turned_by(const BladeState& state, const Vec3<Wide>& angular_momentum) const;
  Vec3<Wide> angular_momentum(const BladeState& state) const;

  const WeaponBody<double>& weapon() const { return weapon_; }
  const GripSettings<double>& grip() const { return grip_; }
  /// Where the hand holds it.
  Vec3<Wide> hand_B() const;

 private:
  double report(int k) const;

  Side side_;
  BeatPlan plan_;
  FencerMap<double> map_;
  Pose<double> X_WF_;
  WeaponBody<double> weapon_;
  GripSettings<double> grip_;
};

class BeatTruth {
 public:
  explicit BeatTruth(const BeatPlan& plan);

  /// Of the first contact, s; negative: there is none.
  double time() const { return static_cast<double>(time_); }
  double impulse() const { return static_cast<double>(impulse_); }  ///< N s
  /// @param t  s, up to the second contact, if there is one
  Tips tips(double t) const;
  /// Just before and just after the contact, of the left and the right blade.
  const std::array<BladeState, 2>& before() const { return before_; }
  const std::array<BladeState, 2>& after() const { return after_; }
  const LedBlade& blade(Side side) const { return blades_[index_of(side)]; }
  /// From B, the right one, to A, the left one.
  const Vec3<Wide>& normal() const { return normal_; }
  const Vec3<Wide>& point() const { return point_; }
  /// Of the blades in the hands, m.
  Wide held_gap(Wide t) const;

 private:
  void strike();
  Vec3<Wide> tip(Side side, double t) const;
  static Wide weight(double effort, Wide blow, const GripSettings<double>& grip, Wide elapsed);

  std::array<LedBlade, 2> blades_;
  std::array<BladeState, 2> before_;
  std::array<BladeState, 2> after_;
  Vec3<Wide> normal_ = Vec3<Wide>::Zero();
  Vec3<Wide> point_ = Vec3<Wide>::Zero();
  Wide time_ = -1;
  Wide impulse_ = 0;
};

}  // namespace batuta::report
