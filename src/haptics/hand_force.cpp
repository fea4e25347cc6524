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
Wrench<Scalar> HandForce<Scalar>::pull(const HandState<Scalar>& state, Scalar dt) const {
  const auto moving = [dt, this](const Pose<Scalar>& before, const Pose<Scalar>& now) {
    MovingFrame<Scalar> frame = {now, {}};
    if (started_) frame.twist = motion_between(before, now, dt).twist;
    return frame;
  };
  const Wrench<Scalar> whole = coupling_wrench(
      coupling_, moving(commanded_W_, state.commanded.X_WH), moving(held_W_, state.held_W));
  return {state.hold * whole.force_W, state.hold * whole.moment_W};
}

template <class Scalar>
Vec2<Scalar> HandForce<Scalar>::advance(const HandState<Scalar>& state, Scalar dt) {
  const StickJacobian<Scalar>& jacobian = state.commanded.jacobian;
  Vec2<Scalar> coupling = Vec2<Scalar>::Zero();
  bool finite = is_finite_state(state);
  if (finite) {
    coupling = stick_force(jacobian, pull(state, dt));
    stored_ = state.hold * stored_energy(coupling_, state.commanded.X_WH, state.held_W);
    finite = is_finite(coupling) && is_finite(stored_);
  }
  if (!finite) {
    started_ = false;
    stored_ = 0;
    return Vec2<Scalar>::Zero();
  }
  (void)transient_.strike(
      stick_force<Scalar>(jacobian, {state.blow.linear_W, state.blow.angular_W}));
  commanded_W_ = state.commanded.X_WH;
  held_W_ = state.held_W;
  started_ = true;
  return mixed(transient_.advance(dt), coupling, transient_.max_force());
}

#define BATUTA_INSTANTIATE(S)                            \
  template Status validate(const HandForceSettings<S>&); \
  template class HandForce<S>;
BATUTA_FOR_EACH_SCALAR(BATUTA_INSTANTIATE)
#undef BATUTA_INSTANTIATE

}  // namespace batuta::haptics
