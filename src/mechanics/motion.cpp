// SPDX-License-Identifier: MIT
#include "batuta/mechanics/motion.hpp"

#include <array>

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

template <class Scalar>
bool turns_about_one_axis(const Vec3<Scalar>& inverse_moments) {
  const Vec3<Scalar>& m = inverse_moments;
  return m.x() * m.y() == Scalar(0) && m.y() * m.z() == Scalar(0) && m.z() * m.x() == Scalar(0);
}

/// q turned about its own axis i.
template <class Scalar>
Quat<Scalar> turned(const Quat<Scalar>& q_WB, int i, Scalar angle) {
  const Vec3<Scalar> turn_B = angle * Vec3<Scalar>::Unit(i);
  return q_WB * exp_map(turn_B);
}

/// An axisymmetric body: steadily about the angular momentum, and about its own axis by the spin
/// that is left.
template <class Scalar>
Quat<Scalar> flown(const Body<Scalar>& body, const Revolution<Scalar>& top, Scalar duration) {
  const Quat<Scalar>& q_WB = body.X_WB.q_WB;
  const Vec3<Scalar> b_B = q_WB.conjugate() * body.momentum.angular_W;
  const Scalar spin = (body.inverse_moments(top.axis) - top.inverse_transverse) * b_B(top.axis);
  const Vec3<Scalar> steady_W = (top.inverse_transverse * duration) * body.momentum.angular_W;
  return exp_map(steady_W) * turned(q_WB, top.axis, spin * duration);
}

/// Any body: the turns that the three parts b_i^2 / (2 I_i) of the energy would make alone, one
/// after the other and back. Each keeps the angular momentum; the symmetric order makes the whole
/// of second order and free of drift.
template <class Scalar>
Quat<Scalar> flown(const Body<Scalar>& body, Scalar duration) {
  constexpr std::array<int, 5> kOrder = {0, 1, 2, 1, 0};
  Quat<Scalar> q_WB = body.X_WB.q_WB;
  for (const int i : kOrder) {  // Bound: five turns
    const Vec3<Scalar> b_B = q_WB.conjugate() * body.momentum.angular_W;
    const Scalar share = i == 2 ? duration : duration / 2;
    q_WB = turned(q_WB, i, share * (body.inverse_moments(i) * b_B(i)));
  }
  return q_WB;
}

/// Whether no part of the angular momentum turns the body by half a turn or more: beyond that, the
/// way to an orientation might not be the shortest one.
template <class Scalar>
bool turns_by_less_than_half(const Body<Scalar>& body, Scalar duration) {
  constexpr Scalar kHalfTurn = Scalar(3.14159265358979323846);
  const Scalar fastest = body.inverse_moments.maxCoeff() * length(body.momentum.angular_W);
  return fastest * duration < kHalfTurn;
}

/// Flight to an orientation at the end.
template <class Scalar>
Motion<Scalar> flight_to(const Body<Scalar>& body, const Quat<Scalar>& q_end_WB, Scalar duration) {
  const Vec3<Scalar> v_W = body.inverse_mass * body.momentum.linear_W;
  const Pose<Scalar> end{body.X_WB.p_W + duration * v_W, renewed(q_end_WB)};
  Motion<Scalar> motion = motion_between(body.X_WB, end, duration);
  motion.twist.v_W = v_W;
  return motion;
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
  const Revolution<Scalar> top = revolution_of(body.inverse_moments);
  const bool is_top = top.inverse_transverse > Scalar(0);
  Twist<Scalar> twist = twist_of(body);
  if (is_top && !body.spin_shows) twist.w_W = top.inverse_transverse * body.momentum.angular_W;
  const bool steady = (is_top && !body.spin_shows) || turns_about_one_axis(body.inverse_moments);
  if (steady || !(duration > Scalar(0))) return {body.X_WB, twist, duration};
  if (!turns_by_less_than_half(body, duration)) {
    twist.w_W = Vec3<Scalar>::Constant(std::numeric_limits<Scalar>::quiet_NaN());
    return {body.X_WB, twist, duration};
  }
  return flight_to(body, is_top ? flown(body, top, duration) : flown(body, duration), duration);
}

template <class Scalar>
bool detail::hides_spin(const Body<Scalar>& body, const Capsule<Scalar>& capsule_B) {
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
  template Motion<Scalar> free_flight(const Body<Scalar>&, Scalar);                         \
  template bool detail::hides_spin(const Body<Scalar>&, const Capsule<Scalar>&);            \
  template Pose<Scalar> pose_at(const Motion<Scalar>&, Scalar);                             \
  template bool is_valid(const Motion<Scalar>&);
BATUTA_FOR_EACH_SCALAR(BATUTA_INSTANTIATE)
#undef BATUTA_INSTANTIATE

}  // namespace batuta
