// SPDX-License-Identifier: MIT

#include "batuta/haptics/hand_force.hpp"

#include "batuta/mechanics/motion.hpp"

namespace batuta::haptics {
namespace {

template <class Scalar>
bool is_finite_pose(const Pose<Scalar>& X) {
  return is_finite(X.p_W) && is_finite(X.q_WB);
}

template <class Scalar>
bool is_finite_state(const HandState<Scalar>& state) {
  return is_finite_pose(state.commanded.X_WH) && is_finite_pose(state.held_W) &&
         is_finite(state.commanded.jacobian) && state.hold >= Scalar(0) &&
         state.hold <= Scalar(1) && is_finite(state.blow.linear_W) &&
         is_finite(state.blow.angular_W);
}

}  // namespace

template <class Scalar>
Status validate(const HandForceSettings<Scalar>& settings) {
  const Status coupling = validate(settings.coupling);
  return coupling == Status::kOk ? validate(settings.transient) : coupling;
}

template <class Scalar>
Status HandForce<Scalar>::configure(const HandForceSettings<Scalar>& settings) {
  if (validate(settings) != Status::kOk) return Status::kInvalidArgument;
  *this = {};
  coupling_ = settings.coupling;
  return transient_.configure(settings.transient);
}

template <class Scalar>
Wrench<Scalar> HandForce<Scalar>::pull(const HandState<Scalar>& state, Scalar dt) {
  const auto moving = [dt, this](const Pose<Scalar>& before, const Pose<Scalar>& now) {
    MovingFrame<Scalar> frame = {now, {}};
    if (started_) frame.twist = motion_between(before, now, dt).twist;
    return frame;
  };
  const Wrench<Scalar> whole = raw_coupling_wrench(
      coupling_, moving(commanded_W_, state.commanded.X_WH), moving(held_W_, state.held_W));
  limited_ = is_at_limit(coupling_, whole);
  return {state.hold * whole.force_W, state.hold * whole.moment_W};
}

/// Of a step that is not felt, and of which nothing is kept.
template <class Scalar>
Vec2<Scalar> HandForce<Scalar>::invalid() {
  invalid_ = true;
  limited_ = false;
  started_ = false;
  stored_ = 0;
  return Vec2<Scalar>::Zero();
}

/// What mixed() leaves out of the coupling, and what the pulse of the blow had to.
template <class Scalar>
void HandForce<Scalar>::compare(const Vec2<Scalar>& blow, const Vec2<Scalar>& coupling) {
  const Scalar beyond =
      (blow + coupling).cwiseAbs().maxCoeff() / transient_.max_force() - Scalar(1);
  const Scalar most = max_of(transient_.excess(), beyond);
  excess_ = clamp(most, Scalar(0), std::numeric_limits<Scalar>::max());
}

template <class Scalar>
Vec2<Scalar> HandForce<Scalar>::advance(const HandState<Scalar>& state, Scalar dt) {
  excess_ = 0;
  limited_ = false;
  invalid_ = false;
  if (!is_finite_state(state)) return invalid();
  const StickJacobian<Scalar>& jacobian = state.commanded.jacobian;
  const Vec2<Scalar> coupling = stick_force(jacobian, pull(state, dt));
  stored_ = state.hold * stored_energy(coupling_, state.commanded.X_WH, state.held_W);
  if (!is_finite(coupling) || !is_finite(stored_)) return invalid();
  const Vec2<Scalar> impulse =
      stick_force<Scalar>(jacobian, {state.blow.linear_W, state.blow.angular_W});
  if (transient_.strike(impulse) != Status::kOk) return invalid();
  commanded_W_ = state.commanded.X_WH;
  held_W_ = state.held_W;
  started_ = true;
  const Vec2<Scalar> blow = transient_.advance(dt);
  compare(blow, coupling);
  return mixed(blow, coupling, transient_.max_force());
}

#define BATUTA_INSTANTIATE(S)                            \
  template Status validate(const HandForceSettings<S>&); \
  template class HandForce<S>;
BATUTA_FOR_EACH_SCALAR(BATUTA_INSTANTIATE)
#undef BATUTA_INSTANTIATE

}  // namespace batuta::haptics
