// SPDX-License-Identifier: MIT
#include "batuta/fencing/grip.hpp"

#include <array>

namespace batuta::fencing {
namespace {

/// How far a blade is from where it should be: a shift and a turn, both in W.
template <class Scalar>
struct Offset {
  Vec3<Scalar> shift_W = Vec3<Scalar>::Zero();
  Vec3<Scalar> turn_W = Vec3<Scalar>::Zero();
};

template <class Scalar>
Offset<Scalar> offset_of(const Pose<Scalar>& actual, const Pose<Scalar>& wanted) {
  return {actual.p_W - wanted.p_W, log_map<Scalar>(actual.q_WB * wanted.q_WB.conjugate())};
}

template <class Scalar>
Pose<Scalar> moved_by(const Pose<Scalar>& pose, const Offset<Scalar>& offset, Scalar share) {
  return {pose.p_W + share * offset.shift_W,
          renewed<Scalar>(exp_map<Scalar>(share * offset.turn_W) * pose.q_WB)};
}

/// 1 over the inertia that resists a turn about the hand: the blade's own, the larger of its three,
/// and that of its mass at its distance. 0: nothing turns it.
template <class Scalar>
Scalar inverse_inertia_about(const Vec3<Scalar>& hand_B, const Body<Scalar>& body) {
  const Scalar own = body.inverse_moments.minCoeff();
  if (!(own > Scalar(0)) || !(body.inverse_mass > Scalar(0))) return Scalar(0);
  // 1 / (1 / own + r^2 / inverse_mass)
  return own * body.inverse_mass / (body.inverse_mass + own * hand_B.squaredNorm());
}

template <class Scalar>
Scalar weight_of(CatchWeight weight, Scalar parameter) {
  const Scalar s = clamp(parameter, Scalar(0), Scalar(1));
  return weight == CatchWeight::kLinear ? s : s * s * (Scalar(3) - Scalar(2) * s);
}

}  // namespace

template <class Scalar>
Status validate(const GripSettings<Scalar>& settings) {
  const std::array<Scalar, 10> positive = {
      settings.torque,        settings.force,        settings.min_regain, settings.max_regain,
      settings.recover_time,  settings.largest_turn, settings.forte,      settings.composure,
      settings.settle_torque, settings.max_lost};
  bool good = settings.weight == CatchWeight::kSmooth || settings.weight == CatchWeight::kLinear;
  for (const Scalar value : positive) good = good && is_positive(value);  // Bound: 10
  return good && settings.max_regain >= settings.min_regain ? Status::kOk
                                                            : Status::kInvalidArgument;
}

template <class Scalar>
Scalar regain_time(const GripSettings<Scalar>& settings, const GripLoad<Scalar>& load) {
  const Scalar fetching = std::sqrt(Scalar(6) * load.lag / (load.effort * load.inverse_inertia));
  if (!is_finite(fetching)) return settings.max_regain;  // nothing moves such a blade
  return clamp(max_of(load.blow / load.effort, fetching), settings.min_regain, settings.max_regain);
}

template <class Scalar>
Scalar lost_time(const GripSettings<Scalar>& settings, const HandBlow<Scalar>& blow) {
  if (!(blow.reach > settings.forte) || !(blow.moment > settings.composure)) return Scalar(0);
  return min_of((blow.moment - settings.composure) / settings.settle_torque, settings.max_lost);
}

template <class Scalar>
Pose<Scalar> caught(const Motion<Scalar>& flight, Scalar elapsed, const Pose<Scalar>& hand,
                    const Catch<Scalar>& state) {
  if (state.turn >= Scalar(1) && state.place >= Scalar(1)) return hand;
  const Twist<Scalar>& twist = flight.twist;
  const Scalar way = (Scalar(1) - state.turn) * elapsed;
  const Scalar turned = way * twist.w_W.norm();
  const Scalar kept = turned > state.largest_turn ? way * (state.largest_turn / turned) : way;
  const Quat<Scalar> q = detail::composed(exp_map<Scalar>(kept * twist.w_W),
                                          interpolated(flight.X_WB.q_WB, hand.q_WB, state.turn));
  const Vec3<Scalar> start_W = to_world(flight.X_WB, state.hand_B);
  const Vec3<Scalar> arm_W = start_W - flight.X_WB.p_W;
  const Vec3<Scalar> free_W = start_W + elapsed * (twist.v_W + twist.w_W.cross(arm_W));
  const Vec3<Scalar> held_W =
      (Scalar(1) - state.place) * free_W + state.place * to_world(hand, state.hand_B);
  return {held_W - q * state.hand_B, q};
}

template <class Scalar>
Status Grip<Scalar>::configure(const GripSettings<Scalar>& settings) {
  const Status status = validate(settings);
  if (status == Status::kOk) settings_ = settings;
  return status;
}

template <class Scalar>
void Grip<Scalar>::place(const Pose<Scalar>& X_WB) {
  target_ = X_WB;
  hand_ = still(X_WB, Scalar(0));
  step_ = 0;
  turn_regain_ = place_regain_ = lost_ = 0;
  is_held_ = true;
}

template <class Scalar>
void Grip<Scalar>::command(const Pose<Scalar>& X_WB, Scalar step) {
  BATUTA_ASSERT(is_finite(step) && step > Scalar(0));
  hand_ = motion_between(target_, X_WB, step);
  hand_.duration =
      (Scalar(1) + kLeastHorizon<Scalar>)*step;  // what is planned late looks beyond the step
  target_ = X_WB;
  step_ = step;
}

template <class Scalar>
Pose<Scalar> Grip<Scalar>::hand_at(Scalar t) const {
  return pose_at(hand_, min_of(t, hand_.duration));
}

template <class Scalar>
Catch<Scalar> Grip<Scalar>::catch_at(Scalar elapsed) const {
  return {hand_B_, weight_of(settings_.weight, elapsed / turn_regain_),
          weight_of(settings_.weight, elapsed / place_regain_), settings_.largest_turn};
}

template <class Scalar>
Pose<Scalar> Grip<Scalar>::planned_at(Scalar t) const {
  if (is_held_) return hand_at(t);
  const Scalar elapsed = max_of(t - flight_start_, Scalar(0));
  return caught(flight_, elapsed, hand_at(t), catch_at(elapsed));
}

template <class Scalar>
PlannedMotion<Scalar> Grip<Scalar>::plan(const Body<Scalar>& body, Scalar t,
                                         Scalar duration) const {
  const Scalar horizon = max_of(step_ - t, kLeastHorizon<Scalar> * step_);
  if (!(horizon > Scalar(0))) return {still(body.X_WB, duration), false};
  const Offset<Scalar> offset = offset_of(body.X_WB, planned_at(t));
  const Scalar kept = max_of(Scalar(1) - horizon / settings_.recover_time, Scalar(0));
  const Pose<Scalar> wanted = moved_by(planned_at(t + horizon), offset, kept);
  Motion<Scalar> motion = motion_between(body.X_WB, wanted, horizon);
  motion.duration = duration;
  return {motion, false};
}

template <class Scalar>
void Grip<Scalar>::on_contact(const Body<Scalar>& body, const Feedback<Scalar>& feedback) {
  if (!(feedback.impulse > Scalar(0))) return;  // a separation shows in the body's pose, and fades
  const Vec3<Scalar> lever_W = feedback.point_W - to_world(body.X_WB, hand_B_);
  const HandBlow<Scalar> blow{lever_W.norm(), lever_W.cross(feedback.impulse_W).norm()};
  const Scalar left = is_held_ ? Scalar(0) : lost_ - (feedback.time - flight_start_);
  lost_ = max_of(left, lost_time(settings_, blow));

  const Pose<Scalar> hand = hand_at(feedback.time);
  const Offset<Scalar> offset = offset_of(body.X_WB, hand);
  const Scalar shift = (to_world(body.X_WB, hand_B_) - to_world(hand, hand_B_)).norm();
  turn_regain_ = regain_time<Scalar>(
      settings_,
      {settings_.torque, blow.moment, offset.turn_W.norm(), inverse_inertia_about(hand_B_, body)});
  place_regain_ = regain_time<Scalar>(
      settings_, {settings_.force, feedback.impulse_W.norm(), shift, body.inverse_mass});
  flight_ = free_flight(body, settings_.max_regain);
  if (!is_valid(flight_)) flight_ = still(body.X_WB, settings_.max_regain);  // turns beyond telling
  flight_start_ = feedback.time;
  is_held_ = false;
}

template <class Scalar>
void Grip<Scalar>::on_step_end(const Body<Scalar>& /*body*/, Scalar dt) {
  hand_ = still(target_, Scalar(0));
  step_ = 0;
  if (is_held_) return;
  flight_start_ -= dt;
  is_held_ = -flight_start_ >= max_of(lost_, max_of(turn_regain_, place_regain_));
}

template <class Scalar>
GripPhase Grip<Scalar>::phase() const {
  if (is_held_) return GripPhase::kHeld;
  return -flight_start_ < lost_ ? GripPhase::kBeaten : GripPhase::kRegaining;
}

template <class Scalar>
Scalar Grip<Scalar>::control() const {
  if (is_held_) return Scalar(1);
  if (phase() == GripPhase::kBeaten) return Scalar(0);
  return clamp(-flight_start_ / max_of(turn_regain_, place_regain_), Scalar(0), Scalar(1));
}

#define BATUTA_INSTANTIATE(S)                                                    \
  template Status validate(const GripSettings<S>&);                              \
  template S regain_time(const GripSettings<S>&, const GripLoad<S>&);            \
  template S lost_time(const GripSettings<S>&, const HandBlow<S>&);              \
  template Pose<S> caught(const Motion<S>&, S, const Pose<S>&, const Catch<S>&); \
  template class Grip<S>;
BATUTA_FOR_EACH_SCALAR(BATUTA_INSTANTIATE)
#undef BATUTA_INSTANTIATE

}  // namespace batuta::fencing
