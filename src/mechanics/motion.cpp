// SPDX-License-Identifier: MIT
#include "batuta/mechanics/motion.hpp"

namespace batuta {

template <class Scalar>
Motion<Scalar> still(const Pose<Scalar>& X_WB, Scalar duration) {
  return {X_WB, {}, duration};
}

template <class Scalar>
Motion<Scalar> linear(const Pose<Scalar>& X_WB, const Vec3<Scalar>& v_W, Scalar duration) {
  return {X_WB, {v_W, Vec3<Scalar>::Zero()}, duration};
}

template <class Scalar>
Motion<Scalar> motion_between(const Pose<Scalar>& X0_WB, const Pose<Scalar>& X1_WB,
                              Scalar duration) {
  BATUTA_ASSERT(duration > Scalar(0));
  const Quat<Scalar> turn = X1_WB.q_WB * X0_WB.q_WB.conjugate();
  const Vec3<Scalar> v_W = (X1_WB.p_W - X0_WB.p_W) / duration;
  return {X0_WB, {v_W, log_map(turn) / duration}, duration};
}

template <class Scalar>
Pose<Scalar> pose_at(const Motion<Scalar>& motion, Scalar t) {
  const Vec3<Scalar> turn = t * motion.twist.w_W;
  Pose<Scalar> X_WB = {motion.X_WB.p_W + t * motion.twist.v_W, motion.X_WB.q_WB};
  // Without a turn the quaternion stays as it is, to the last bit.
  if (turn != Vec3<Scalar>::Zero()) X_WB.q_WB = renewed(Quat<Scalar>(exp_map(turn) * X_WB.q_WB));
  return X_WB;
}

template <class Scalar>
bool is_valid(const Motion<Scalar>& motion) {
  // What is not finite makes them so: infinity times zero is NaN.
  const Vec3<Scalar> end = motion.X_WB.p_W + motion.duration * motion.twist.v_W;
  const Vec3<Scalar> turn = motion.duration * motion.twist.w_W;
  return is_finite(end) && is_finite(motion.X_WB.q_WB) && motion.duration >= Scalar(0) &&
         turn.squaredNorm() <= detail::kMaxAngle<Scalar> * detail::kMaxAngle<Scalar>;
}

#define BATUTA_INSTANTIATE(Scalar)                                                          \
  template Motion<Scalar> still(const Pose<Scalar>&, Scalar);                               \
  template Motion<Scalar> linear(const Pose<Scalar>&, const Vec3<Scalar>&, Scalar);         \
  template Motion<Scalar> motion_between(const Pose<Scalar>&, const Pose<Scalar>&, Scalar); \
  template Pose<Scalar> pose_at(const Motion<Scalar>&, Scalar);                             \
  template bool is_valid(const Motion<Scalar>&);
BATUTA_FOR_EACH_SCALAR(BATUTA_INSTANTIATE)
#undef BATUTA_INSTANTIATE

}  // namespace batuta
