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

/// Its square, a turn counting as the way of what is a metre away, m^2.
template <class Scalar>
Scalar size_of(const Offset<Scalar>& offset) {
  return offset.shift_W.squaredNorm() + offset.turn_W.squaredNorm();
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

/// m/s: a blade that lags by more was hindered
template <class Scalar>
constexpr Scalar kHinderedSpeed = Scalar(0.02F);
/// Where a hand has turned this far from the flight, the shortest way between them may soon be the
/// other way round: cosine of half of 2.5 rad.
template <class Scalar>
constexpr Scalar kFarCosine = Scalar(0.3153F);

template <class Scalar>
bool is_far(const Quat<Scalar>& a, const Quat<Scalar>& b) {
  const Scalar cosine = a.dot(b);
  return cosine * cosine < kFarCosine<Scalar> * kFarCosine<Scalar>;
}

}  // namespace

template <class Scalar>
Status validate(const GripSettings<Scalar>& settings) {
  const std::array<Scalar, 10> positive = {
      settings.torque,        settings.force,        settings.min_regain, settings.max_regain,
      settings.recover_time,  settings.largest_turn, settings.forte,      settings.composure,
      settings.settle_torque, settings.max_lost};
  bool good = settings.weight == CatchWeight::kSmooth || settings.weight == CatchWeight::kLinear;
  for (const Scalar value : positive) {  // Bound: 10
    good = good && is_positive(value) && value <= kLargestGrip<Scalar>;
  }
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
  const Scalar speed = twist.w_W.norm();
  const Scalar longest =
      speed * elapsed > state.largest_turn ? state.largest_turn / speed : elapsed;
  const Scalar kept = min_of((Scalar(1) - state.turn) * elapsed, longest);
  const Quat<Scalar> q = batuta::detail::composed(
      exp_map<Scalar>(kept * twist.w_W), interpolated(flight.X_WB.q_WB, hand.q_WB, state.turn));
  const Quat<Scalar> free_q = exp_map<Scalar>(longest * twist.w_W) * flight.X_WB.q_WB;
  const Vec3<Scalar> free_W = flight.X_WB.p_W + elapsed * twist.v_W + free_q * state.hand_B;
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
Catch<Scalar> Grip<Scalar>::catch_at(Scalar t) const {
  const Scalar elapsed = max_of(t - pull_start_, Scalar(0));
  return {hand_B_, weight_of(settings_.weight, elapsed / turn_regain_),
          weight_of(settings_.weight, elapsed / place_regain_), settings_.largest_turn};
}

template <class Scalar>
Pose<Scalar> Grip<Scalar>::planned_at(Scalar t) const {
  if (is_held()) return hand_at(t);
  const Scalar elapsed = max_of(t - flight_start_, Scalar(0));
  return caught(flight_, elapsed, hand_at(t), catch_at(t));
}

template <class Scalar>
PlannedMotion<Scalar> Grip<Scalar>::plan(const Body<Scalar>& body, Scalar t,
                                         Scalar duration) const {
  const Scalar horizon = max_of(step_ - t, kLeastHorizon<Scalar> * step_);
  if (!(horizon > Scalar(0))) return {still(body.X_WB, duration), false};
  const Offset<Scalar> offset = offset_of(body.X_WB, planned_at(t));
  const Scalar kept = Scalar(1) - horizon / max_of(settings_.recover_time, max_of(step_, horizon));
  const Pose<Scalar> wanted = moved_by(planned_at(t + horizon), offset, kept);
  Motion<Scalar> motion = motion_between(body.X_WB, wanted, horizon);
  motion.duration = duration;
  return {motion, false};
}

/// The blade flies from `time` on; a hand that was beaten stays so for what is left of its time.
template <class Scalar>
void Grip<Scalar>::start_flight(const Motion<Scalar>& flight, Scalar time) {
  lost_ = is_held() ? Scalar(0) : max_of(lost_ - (time - flight_start_), Scalar(0));
  flight_ = is_valid(flight) ? flight : still(flight.X_WB, settings_.max_regain);
  flight_start_ = time;
  pull_start_ = max_of(step_, time);
}

/// How long arm and wrist take to have the blade again.
/// @param impulse  N s  @param hand  where the hand wants B
template <class Scalar>
void Grip<Scalar>::set_regain(const HandBlow<Scalar>& blow, Scalar impulse,
                              const Body<Scalar>& body, const Pose<Scalar>& hand) {
  const Scalar turn = offset_of(body.X_WB, hand).turn_W.norm();
  const Scalar shift = (to_world(body.X_WB, hand_B_) - to_world(hand, hand_B_)).norm();
  turn_regain_ = regain_time<Scalar>(
      settings_, {settings_.torque, blow.moment, turn, inverse_inertia_about(hand_B_, body)});
  place_regain_ =
      regain_time<Scalar>(settings_, {settings_.force, impulse, shift, body.inverse_mass});
}

template <class Scalar>
void Grip<Scalar>::on_contact(const Body<Scalar>& body, const Feedback<Scalar>& feedback) {
  if (!(feedback.impulse > Scalar(0))) return;  // a separation shows in the body's pose, and fades
  const Vec3<Scalar> lever_W = feedback.point_W - to_world(body.X_WB, hand_B_);
  const HandBlow<Scalar> blow{lever_W.norm(), lever_W.cross(feedback.impulse_W).norm()};
  // Of a weapon whose flight is bent: as it turns now. In so long a time it may turn by half a
  // turn, of which no bent flight is known.
  start_flight(batuta::detail::steady_flight(body, settings_.max_regain), feedback.time);
  set_regain(blow, feedback.impulse_W.norm(), body, hand_at(feedback.time));
  lost_ = max_of(lost_, lost_time(settings_, blow));
}

/// The flight begins anew where the blade is, with a share of the velocity that was planned.
template <class Scalar>
void Grip<Scalar>::go_on_from(const Body<Scalar>& body, Scalar share, Scalar dt) {
  const Scalar since = max_of(dt - max_of(flight_start_, Scalar(0)), kLeastHorizon<Scalar> * dt);
  Motion<Scalar> flight = motion_between(planned_at(dt - since), planned_at(dt), since);
  flight.X_WB = body.X_WB;
  flight.duration = settings_.max_regain;
  flight.twist.v_W *= share;
  flight.twist.w_W *= share;
  start_flight(flight, dt);
  set_regain({}, Scalar(0), body, target_);
}

/// What the blade made of the way that was planned for the step, or since the blow in it, 0 ... 1.
/// A turn counts as the way of what is a metre away; what lags by no more than kHinderedSpeed has
/// made it all.
template <class Scalar>
Scalar Grip<Scalar>::share_made(const Pose<Scalar>& X_WB, Scalar dt) const {
  const Pose<Scalar> end = planned_at(dt);
  const Offset<Scalar> lack = offset_of(end, X_WB);
  const Scalar least = kHinderedSpeed<Scalar> * dt;
  if (!(size_of(lack) > least * least)) return Scalar(1);
  const Offset<Scalar> way = offset_of(end, planned_at(max_of(flight_start_, Scalar(0))));
  const Scalar whole = size_of(way);
  const Scalar along = lack.shift_W.dot(way.shift_W) + lack.turn_W.dot(way.turn_W);
  if (!(along > least * std::sqrt(whole))) return Scalar(1);
  return max_of(Scalar(1) - along / whole, Scalar(0));
}

template <class Scalar>
void Grip<Scalar>::on_step_end(const Body<Scalar>& body, Scalar dt) {
  if (!is_held()) {
    const Scalar made = share_made(body.X_WB, dt);
    if (made < Scalar(1) || is_far(flight_.X_WB.q_WB, target_.q_WB)) go_on_from(body, made, dt);
  }
  hand_ = still(target_, Scalar(0));
  step_ = 0;
  if (is_held()) return;
  flight_start_ -= dt;
  pull_start_ -= dt;
  const bool is_back =
      -flight_start_ >= lost_ && -pull_start_ >= max_of(turn_regain_, place_regain_);
  if (is_back) turn_regain_ = place_regain_ = lost_ = 0;
}

template <class Scalar>
GripPhase Grip<Scalar>::phase() const {
  if (is_held()) return GripPhase::kHeld;
  return -flight_start_ < lost_ ? GripPhase::kBeaten : GripPhase::kRegaining;
}

template <class Scalar>
Scalar Grip<Scalar>::control() const {
  if (is_held()) return Scalar(1);
  if (phase() == GripPhase::kBeaten) return Scalar(0);
  return clamp(-pull_start_ / max_of(turn_regain_, place_regain_), Scalar(0), Scalar(1));
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
