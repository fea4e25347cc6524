// SPDX-License-Identifier: MIT
#include "batuta/world/controller.hpp"

namespace batuta {

template <class Scalar>
PlannedMotion<Scalar> Fixed<Scalar>::plan(const Body<Scalar>& body, Scalar /*t*/,
                                          Scalar duration) const {
  return {still(body.X_WB, duration), false};
}

template <class Scalar>
void Fixed<Scalar>::on_contact(const Body<Scalar>& /*body*/, const Feedback<Scalar>& /*feedback*/) {
}

template <class Scalar>
void Fixed<Scalar>::on_step_end(const Body<Scalar>& /*body*/, Scalar /*dt*/) {}

template <class Scalar>
PlannedMotion<Scalar> FreeFlight<Scalar>::plan(const Body<Scalar>& body, Scalar /*t*/,
                                               Scalar duration) const {
  return {free_flight(body, duration), true};
}

template <class Scalar>
void FreeFlight<Scalar>::on_contact(const Body<Scalar>& /*body*/,
                                    const Feedback<Scalar>& /*feedback*/) {}

template <class Scalar>
void FreeFlight<Scalar>::on_step_end(const Body<Scalar>& /*body*/, Scalar /*dt*/) {}

template <class Scalar>
PlannedMotion<Scalar> Hand<Scalar>::plan(const Body<Scalar>& body, Scalar t,
                                         Scalar duration) const {
  if (struck) return {free_flight(body, duration), true};
  const Scalar horizon = max_of(max_of(step - t, kLeastHorizon<Scalar> * step), duration);
  if (!(horizon > Scalar(0))) return {still(body.X_WB, duration), false};
  PlannedMotion<Scalar> planned = {motion_between(body.X_WB, target_W, horizon), false};
  planned.motion.duration = duration;
  return planned;
}

template <class Scalar>
void Hand<Scalar>::on_contact(const Body<Scalar>& body, const Feedback<Scalar>& feedback) {
  struck = struck || (feedback.impulse > Scalar(0) && !is_fixed(body));
}

template <class Scalar>
void Hand<Scalar>::on_step_end(const Body<Scalar>& /*body*/, Scalar /*dt*/) {
  struck = false;
}

#define BATUTA_INSTANTIATE(Scalar)    \
  template struct Fixed<Scalar>;      \
  template struct FreeFlight<Scalar>; \
  template struct Hand<Scalar>;
BATUTA_FOR_EACH_SCALAR(BATUTA_INSTANTIATE)
#undef BATUTA_INSTANTIATE

}  // namespace batuta
