// SPDX-License-Identifier: MIT
#include "batuta/mechanics/motion.hpp"

#include "batuta/geometry/direction.hpp"

namespace batuta {
namespace {

/// How far two moments of a body of revolution are apart at most, relative to them, for rounding
/// alone (motion.md).
template <class Scalar>
constexpr Scalar kEqualMoments = 32 * kRoundOff<Scalar>;

template <class Scalar>
bool are_equal_moments(Scalar inverse_a, Scalar inverse_b) {
  const Scalar low = min_of(inverse_a, inverse_b);
  const Scalar high = max_of(inverse_a, inverse_b);
  return high - low <= kEqualMoments<Scalar> * high;
}

/// A body of revolution: 1 / I_t, and which of its axes is the odd one.
template <class Scalar>
struct Revolution {
  Scalar inverse_transverse = 0;  ///< 0: it is none
  int axis = 0;
};

template <class Scalar>
Revolution<Scalar> revolution_of(const Vec3<Scalar>& inverse_moments) {
  for (int i = 0; i < 3; ++i) {  // Bound: three pairs
    const Scalar a = inverse_moments(i);
    const Scalar b = inverse_moments((i + 1) % 3);
    if (are_equal_moments(a, b)) return {a + (b - a) / 2, (i + 2) % 3};
  }
  return {};
}

/// How far an end may be from the axis, relative to its distance from the centre, for rounding of
/// the principal axes alone (motion.md).
template <class Scalar>
constexpr Scalar kOnAxis = 64 * kRoundOff<Scalar>;

template <class Scalar>
bool is_on_axis(const Vec3<Scalar>& point, int axis) {
  const Scalar reach = length(point);
  const Scalar across = max_of(std::abs(point((axis + 1) % 3)), std::abs(point((axis + 2) % 3)));
  return across <= kOnAxis<Scalar> * reach;
}

}  // namespace

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
Motion<Scalar> free_flight(const Body<Scalar>& body, Scalar duration) {
  Twist<Scalar> twist = twist_of(body);
  const Scalar inverse_transverse = revolution_of(body.inverse_moments).inverse_transverse;
  if (inverse_transverse > Scalar(0)) twist.w_W = inverse_transverse * body.momentum.b_W;
  return {body.X_WB, twist, duration};
}

template <class Scalar>
bool hides_spin(const Body<Scalar>& body, const Capsule<Scalar>& capsule_B) {
  const Revolution<Scalar> revolution = revolution_of(body.inverse_moments);
  return revolution.inverse_transverse > Scalar(0) &&
         is_on_axis(capsule_B.axis.a, revolution.axis) &&
         is_on_axis(capsule_B.axis.b, revolution.axis);
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
  const Vec3<Scalar> turn = motion.duration * motion.twist.w_W;
  return is_finite(motion.X_WB.p_W) && is_finite(motion.X_WB.q_WB) && is_finite(motion.twist.v_W) &&
         is_finite(motion.twist.w_W) && is_finite(motion.duration) &&
         motion.duration >= Scalar(0) &&
         turn.squaredNorm() <= kMaxAngle<Scalar> * kMaxAngle<Scalar>;
}

#define BATUTA_INSTANTIATE(Scalar)                                                          \
  template Motion<Scalar> still(const Pose<Scalar>&, Scalar);                               \
  template Motion<Scalar> linear(const Pose<Scalar>&, const Vec3<Scalar>&, Scalar);         \
  template Motion<Scalar> motion_between(const Pose<Scalar>&, const Pose<Scalar>&, Scalar); \
  template Motion<Scalar> free_flight(const Body<Scalar>&, Scalar);                         \
  template bool hides_spin(const Body<Scalar>&, const Capsule<Scalar>&);                    \
  template Pose<Scalar> pose_at(const Motion<Scalar>&, Scalar);                             \
  template bool is_valid(const Motion<Scalar>&);
BATUTA_INSTANTIATE(float)
BATUTA_INSTANTIATE(double)
#undef BATUTA_INSTANTIATE

}  // namespace batuta
