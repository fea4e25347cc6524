// SPDX-License-Identifier: MIT
#include "batuta/world/driver.hpp"

namespace batuta {

template <class Scalar>
Course<Scalar> Fixed<Scalar>::course(const Body<Scalar>& body, Scalar /*t*/,
                                     Scalar duration) const {
  return {still(body.X_WB, duration), false};
}

template <class Scalar>
void Fixed<Scalar>::on_contact(const Body<Scalar>& /*body*/, const Feedback<Scalar>& /*feedback*/) {
}

template <class Scalar>
void Fixed<Scalar>::on_step_end(const Body<Scalar>& /*body*/, Scalar /*dt*/) {}

template <class Scalar>
Course<Scalar> FreeFlight<Scalar>::course(const Body<Scalar>& body, Scalar /*t*/,
                                          Scalar duration) const {
  return {free_flight(body, duration), true};
}

template <class Scalar>
void FreeFlight<Scalar>::on_contact(const Body<Scalar>& /*body*/,
                                    const Feedback<Scalar>& /*feedback*/) {}

template <class Scalar>
void FreeFlight<Scalar>::on_step_end(const Body<Scalar>& /*body*/, Scalar /*dt*/) {}

template <class Scalar>
Course<Scalar> Hand<Scalar>::course(const Body<Scalar>& body, Scalar t, Scalar duration) const {
  // A body that was pushed aside late in the step is not fetched back at any speed: the hand aims
  // at least this share of a step ahead, and at least as far as the course lasts. It is then late
  // rather than fast.
  constexpr Scalar kLeastHorizon = Scalar(0.125);
  const Scalar horizon = max_of(max_of(step - t, kLeastHorizon * step), duration);
  if (!(horizon > Scalar(0))) return {still(body.X_WB, duration), false};
  Course<Scalar> answer = {motion_between(body.X_WB, target_W, horizon), false};
  answer.motion.duration = duration;
  return answer;
}

template <class Scalar>
void Hand<Scalar>::on_contact(const Body<Scalar>& /*body*/, const Feedback<Scalar>& /*feedback*/) {}

template <class Scalar>
void Hand<Scalar>::on_step_end(const Body<Scalar>& /*body*/, Scalar /*dt*/) {}

#define BATUTA_INSTANTIATE(Scalar)    \
  template struct Fixed<Scalar>;      \
  template struct FreeFlight<Scalar>; \
  template struct Hand<Scalar>;
BATUTA_INSTANTIATE(float)
BATUTA_INSTANTIATE(double)
#undef BATUTA_INSTANTIATE

}  // namespace batuta
