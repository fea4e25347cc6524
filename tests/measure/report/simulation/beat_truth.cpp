// SPDX-License-Identifier: MIT
#include "beat_truth.hpp"

#include <cmath>

#include "reference.hpp"

namespace batuta::report {
using namespace fencing;
namespace {

constexpr double kReportS = 1e-6 * kReportUs;
constexpr Wide kLook = 1e-4L;  ///< s; blades that beat do not meet and part within such a time
constexpr int kHalvings = 60;

/// Reports that a stick has got by time t: it is on its way to the last of them.
int last_report(double t) {
  return std::min(kBeatReports - 1, static_cast<int>(std::floor(t / kReportS)));
}

/// The quaternion of a turn by the vector, by its definition.
Quat<Wide> turn(const Vec3<Wide>& vector) {
  const Wide angle = vector.norm();
  if (angle == 0) return Quat<Wide>::Identity();
  return Quat<Wide>(Eigen::AngleAxis<Wide>(angle, vector / angle));
}

/// The moment that two of the three share: weapons are bodies of revolution.
Wide transverse_moment(const Vec3<double>& moments) {
  const double xy = std::abs(moments.x() - moments.y());
  const double yz = std::abs(moments.y() - moments.z());
  const double zx = std::abs(moments.z() - moments.x());
  const bool both_yz = yz <= xy && yz <= zx;
  return both_yz || xy <= zx ? static_cast<Wide>(moments.y()) : static_cast<Wide>(moments.z());
}

}  // namespace

LedBlade::LedBlade(Side side, const BeatPlan& plan) : side_(side), plan_(plan) {
  const Fencer<double> fencer =
      side == Side::kLeft ? first_fencer<double>() : second_fencer<double>();
  X_WF_ = Salle<double>{}.X_WF(side);
  map_ = fencer.map;
  weapon_ = fencer.weapon;
  grip_ = fencer.grip;
}

Vec3<Wide> LedBlade::hand_B() const {
  return -(weapon_.X_HB.q_WB.cast<Wide>().conjugate() * weapon_.X_HB.p_W.cast<Wide>());
}

double LedBlade::report(int k) const {
  if (side_ == Side::kRight || k < 0) return 0;
  return static_cast<double>(left_report(plan_, k).y);
}

Vec2<double> LedBlade::stick(double t) const {
  const int k = last_report(t);
  const double share = t / kReportS - k;
  return {0, report(k - 1) + share * (report(k) - report(k - 1))};
}

Vec2<double> LedBlade::stick_rate(double t) const {
  const int k = last_report(t);
  return {0, (report(k) - report(k - 1)) / kReportS};
}

BladeState LedBlade::held(double t) const {
  const KeyedPose<double> hand = hand_at(map_, stick(t), X_WF_);
  const Twist<double> led = hand_twist(hand.jacobian, stick_rate(t));
  BladeState state;
  state.q_WB = (hand.X_WH.q_WB.cast<Wide>() * weapon_.X_HB.q_WB.cast<Wide>()).normalized();
  const Vec3<Wide> lever = hand.X_WH.q_WB.cast<Wide>() * weapon_.X_HB.p_W.cast<Wide>();
  state.center = hand.X_WH.p_W.cast<Wide>() + lever;
  state.w_W = led.w_W.cast<Wide>();
  state.v_W = led.v_W.cast<Wide>() + state.w_W.cross(lever);
  return state;
}

std::array<Vec3<Wide>, 2> LedBlade::ends(const BladeState& state) const {
  return {Vec3<Wide>(state.center + state.q_WB * weapon_.blade_B.axis.a.cast<Wide>()),
          Vec3<Wide>(state.center + state.q_WB * weapon_.blade_B.axis.b.cast<Wide>())};
}

Vec3<Wide> LedBlade::turned_by(const BladeState& state, const Vec3<Wide>& angular_momentum) const {
  const Vec3<Wide> in_B = state.q_WB.conjugate() * angular_momentum;
  return state.q_WB * Vec3<Wide>(in_B.cwiseQuotient(weapon_.moments.cast<Wide>()));
}

Vec3<Wide> LedBlade::angular_momentum(const BladeState& state) const {
  const Vec3<Wide> in_B = state.q_WB.conjugate() * state.w_W;
  return state.q_WB * Vec3<Wide>(in_B.cwiseProduct(weapon_.moments.cast<Wide>()));
}

Wide BeatTruth::held_gap(Wide t) const {
  std::array<std::array<Vec3<Wide>, 2>, 2> ends;
  Wide radii = 0;
  for (std::size_t i = 0; i < 2; ++i) {
    ends[i] = blades_[i].ends(blades_[i].held(static_cast<double>(t)));
    radii += static_cast<Wide>(blades_[i].weapon().blade_B.radius);
  }
  return test::nearest_points(ends[0], ends[1]).distance - radii;
}

BeatTruth::BeatTruth(const BeatPlan& plan)
    : blades_{LedBlade(Side::kLeft, plan), LedBlade(Side::kRight, plan)} {
  constexpr Wide kEnd = static_cast<Wide>(kReportS) * kBeatReports;
  Wide free = 0;
  while (free + kLook < kEnd && held_gap(free + kLook) > 0) free += kLook;
  if (free + kLook >= kEnd) return;
  Wide hit = free + kLook;
  for (int i = 0; i < kHalvings; ++i) {
    const Wide middle = (free + hit) / 2;
    (held_gap(middle) > 0 ? free : hit) = middle;
  }
  time_ = hit;
  strike();
}

void BeatTruth::strike() {
  std::array<std::array<Vec3<Wide>, 2>, 2> ends;
  for (std::size_t i = 0; i < 2; ++i) {
    before_[i] = blades_[i].held(static_cast<double>(time_));
    ends[i] = blades_[i].ends(before_[i]);
  }
  const auto nearest = test::nearest_points(ends[0], ends[1]);
  normal_ = (nearest.on_A - nearest.on_B).normalized();
  point_ = nearest.on_B + normal_ * static_cast<Wide>(blades_[1].weapon().blade_B.radius);
  Wide closing = 0;
  Wide give = 0;
  for (std::size_t i = 0; i < 2; ++i) {
    const Wide sign = i == 0 ? 1 : -1;
    const Vec3<Wide> lever = point_ - before_[i].center;
    const Vec3<Wide> spin = blades_[i].turned_by(before_[i], lever.cross(normal_));
    closing -= sign * normal_.dot(before_[i].v_W + before_[i].w_W.cross(lever));
    give += 1 / static_cast<Wide>(blades_[i].weapon().mass) + normal_.dot(spin.cross(lever));
  }
  const auto bounce = static_cast<Wide>(first_fencer<double>().weapon.restitution);
  impulse_ = (1 + bounce) * closing / give;
  for (std::size_t i = 0; i < 2; ++i) {
    const Vec3<Wide> push = (i == 0 ? impulse_ : -impulse_) * normal_;
    const Vec3<Wide> lever = point_ - before_[i].center;
    after_[i] = before_[i];
    after_[i].v_W += push / static_cast<Wide>(blades_[i].weapon().mass);
    after_[i].w_W += blades_[i].turned_by(before_[i], lever.cross(push));
  }
}

/// How much of a pose is the hand's, so long after the blow.
Wide BeatTruth::weight(double effort, Wide blow, const GripSettings<double>& grip, Wide elapsed) {
  // A blade that was in its hand lags behind nothing: the blow alone says how long.
  const double taken = static_cast<double>(blow) / effort;
  const double regain = std::min(std::max(taken, grip.min_regain), grip.max_regain);
  const Wide s = std::min<Wide>(1, elapsed / static_cast<Wide>(regain));
  return s * s * (3 - 2 * s);
}

Vec3<Wide> BeatTruth::tip(Side side, double t) const {
  const LedBlade& blade = blades_[index_of(side)];
  const BladeState hand = blade.held(t);
  if (time_ < 0 || static_cast<Wide>(t) <= time_) return blade.ends(hand)[1];
  const GripSettings<double>& grip = blade.grip();
  const BladeState& start = after_[index_of(side)];
  const Vec3<Wide> hand_B = blade.hand_B();
  const Vec3<Wide> arm = start.q_WB * hand_B;
  const Vec3<Wide> push = impulse_ * normal_;
  const Wide moment = (point_ - start.center - arm).cross(push).norm();
  const Wide elapsed = static_cast<Wide>(t) - time_;
  const Wide turned = weight(grip.torque, moment, grip, elapsed);
  const Wide placed = weight(grip.force, push.norm(), grip, elapsed);
  const Vec3<Wide> turn_rate =
      blade.angular_momentum(start) / transverse_moment(blade.weapon().moments);

  const Quat<Wide> to_hand = start.q_WB.conjugate() * hand.q_WB;
  const Eigen::AngleAxis<Wide> whole(to_hand.w() < 0 ? Quat<Wide>(-to_hand.coeffs()) : to_hand);
  const Vec3<Wide> own_turn = (1 - turned) * elapsed * turn_rate;
  const Wide kept = std::min<Wide>(1, static_cast<Wide>(grip.largest_turn) / own_turn.norm());
  BladeState now;
  now.q_WB = turn(kept * own_turn) * start.q_WB *
             Quat<Wide>(Eigen::AngleAxis<Wide>(turned * whole.angle(), whole.axis()));
  const Vec3<Wide> free = start.center + arm + elapsed * (start.v_W + turn_rate.cross(arm));
  const Vec3<Wide> wanted = hand.center + hand.q_WB * hand_B;
  now.center = (1 - placed) * free + placed * wanted - now.q_WB * hand_B;
  return blade.ends(now)[1];
}

Tips BeatTruth::tips(double t) const {
  return {tip(Side::kLeft, t).cast<double>(), tip(Side::kRight, t).cast<double>()};
}

}  // namespace batuta::report
