// SPDX-License-Identifier: MIT
#include "batuta/fencing/grip.hpp"

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

}  // namespace

template <class Scalar>
Status validate(const GripSettings<Scalar>& settings) {
  const bool good = is_positive(settings.strength) && is_positive(settings.min_regain) &&
                    is_positive(settings.max_regain) &&
                    settings.max_regain >= settings.min_regain &&
                    is_positive(settings.recover_time) && is_positive(settings.lever);
  return good ? Status::kOk : Status::kInvalidArgument;
}

template <class Scalar>
Scalar regain_time(const GripSettings<Scalar>& settings, Scalar impulse, Scalar lag,
                   Scalar inverse_mass) {
  if (!(impulse > Scalar(0))) return Scalar(0);
  const Scalar acceleration = settings.strength * inverse_mass;
  const Scalar fetching = std::sqrt(Scalar(6) * lag / acceleration);
  if (!is_finite(fetching)) return settings.max_regain;  // nothing moves such a blade
  return clamp(max_of(impulse / settings.strength, fetching), settings.min_regain,
               settings.max_regain);
}

template <class Scalar>
Pose<Scalar> caught(const Motion<Scalar>& flight, Scalar elapsed, const Pose<Scalar>& hand,
                    Scalar parameter) {
  if (parameter >= Scalar(1)) return hand;
  const Scalar s = max_of(parameter, Scalar(0));
  const Scalar by_hand = s * s * (Scalar(3) - Scalar(2) * s);
  const Scalar free = Scalar(1) - by_hand;
  const Vec3<Scalar> p_free = flight.X_WB.p_W + elapsed * flight.twist.v_W;
  const Vec3<Scalar> turn = (free * elapsed) * flight.twist.w_W;
  return {free * p_free + by_hand * hand.p_W,
          detail::composed(exp_map(turn), interpolated(flight.X_WB.q_WB, hand.q_WB, by_hand))};
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
  regain_ = 0;
  phase_ = GripPhase::kHeld;
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
Pose<Scalar> Grip<Scalar>::planned_at(Scalar t) const {
  if (phase_ == GripPhase::kHeld) return hand_at(t);
  const Scalar elapsed = max_of(t - flight_start_, Scalar(0));
  return caught(flight_, elapsed, hand_at(t), elapsed / regain_);
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
  const Offset<Scalar> offset = offset_of(body.X_WB, hand_at(feedback.time));
  const Scalar lag = offset.shift_W.norm() + settings_.lever * offset.turn_W.norm();
  regain_ = regain_time(settings_, feedback.impulse, lag, body.inverse_mass);
  flight_ = free_flight(body, regain_);
  if (!is_valid(flight_)) flight_ = still(body.X_WB, regain_);  // turns beyond what can be told
  flight_start_ = feedback.time;
  phase_ = GripPhase::kRegaining;
}

template <class Scalar>
void Grip<Scalar>::on_step_end(const Body<Scalar>& /*body*/, Scalar dt) {
  hand_ = still(target_, Scalar(0));
  step_ = 0;
  if (phase_ == GripPhase::kHeld) return;
  flight_start_ -= dt;
  if (-flight_start_ >= regain_) phase_ = GripPhase::kHeld;
}

template <class Scalar>
Scalar Grip<Scalar>::control() const {
  if (phase_ == GripPhase::kHeld) return Scalar(1);
  return clamp(-flight_start_ / regain_, Scalar(0), Scalar(1));
}

#define BATUTA_INSTANTIATE(S)                                      \
  template Status validate(const GripSettings<S>&);                \
  template S regain_time(const GripSettings<S>&, S, S, S);         \
  template Pose<S> caught(const Motion<S>&, S, const Pose<S>&, S); \
  template class Grip<S>;
BATUTA_FOR_EACH_SCALAR(BATUTA_INSTANTIATE)
#undef BATUTA_INSTANTIATE

}  // namespace batuta::fencing
