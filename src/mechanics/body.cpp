// SPDX-License-Identifier: MIT
#include "batuta/mechanics/body.hpp"

namespace batuta {
namespace {

template <class Scalar>
bool is_finite_pose(const Pose<Scalar>& X) {
  return is_finite(X.p_W) && is_finite(X.q_WB);
}

/// 1 / x in 0 (for infinite x) to the largest finite number; NaN where x has no such inverse.
template <class Scalar>
Scalar inverse_or_nan(Scalar x) {
  const Scalar inverse = x > Scalar(0) ? Scalar(1) / x : std::numeric_limits<Scalar>::quiet_NaN();
  return is_finite(inverse) ? inverse : std::numeric_limits<Scalar>::quiet_NaN();
}

template <class Scalar>
Scalar inverse_or_zero(Scalar x) {
  return x > Scalar(0) ? Scalar(1) / x : Scalar(0);
}

/// R diag(d) R^T x: the diagonal is applied in the body frame.
template <class Scalar>
Vec3<Scalar> scaled_in_body(const Quat<Scalar>& q_WB, const Vec3<Scalar>& d,
                            const Vec3<Scalar>& x_W) {
  const Mat3<Scalar> R = detail::to_matrix(q_WB);
  const Vec3<Scalar> x_B = R.transpose() * x_W;
  return R * Vec3<Scalar>(d.cwiseProduct(x_B));
}

}  // namespace

template <class Scalar>
Result<Body<Scalar>> make_body(const Pose<Scalar>& X_WB, Scalar mass, const Vec3<Scalar>& moments) {
  Body<Scalar> body;
  body.X_WB = {X_WB.p_W, renewed(X_WB.q_WB)};
  body.inverse_mass = inverse_or_nan(mass);
  // Bound: three axes
  for (int i = 0; i < 3; ++i) body.inverse_moments(i) = inverse_or_nan(moments(i));
  const bool points = X_WB.q_WB.coeffs().cwiseAbs().maxCoeff() > Scalar(0);
  const bool usable = points && is_finite_pose(X_WB) && is_finite(body.inverse_mass) &&
                      is_finite(body.inverse_moments);
  return usable ? success(body) : failure<Body<Scalar>>(Status::kInvalidArgument);
}

template <class Scalar>
Vec3<Scalar> to_world(const Pose<Scalar>& X_WB, const Vec3<Scalar>& x_B) {
  return X_WB.p_W + X_WB.q_WB * x_B;
}

template <class Scalar>
Vec3<Scalar> to_body(const Pose<Scalar>& X_WB, const Vec3<Scalar>& x_W) {
  return X_WB.q_WB.conjugate() * Vec3<Scalar>(x_W - X_WB.p_W);
}

template <class Scalar>
Capsule<Scalar> to_world(const Pose<Scalar>& X_WB, const Capsule<Scalar>& capsule_B) {
  return {{to_world(X_WB, capsule_B.axis.a), to_world(X_WB, capsule_B.axis.b)}, capsule_B.radius};
}

template <class Scalar>
Mat3<Scalar> detail::inverse_inertia_W(const Body<Scalar>& body) {
  const Mat3<Scalar> R = detail::to_matrix(body.X_WB.q_WB);
  Mat3<Scalar> sum = Mat3<Scalar>::Zero();
  for (int i = 0; i < 3; ++i) {                                   // Bound: three axes
    const Mat3<Scalar> square = R.col(i) * R.col(i).transpose();  // symmetric to the last bit
    sum += body.inverse_moments(i) * square;
  }
  return sum;
}

template <class Scalar>
Vec3<Scalar> detail::velocity_of(const Body<Scalar>& body) {
  return body.inverse_mass * body.momentum.linear_W;
}

template <class Scalar>
Twist<Scalar> twist_of(const Body<Scalar>& body) {
  return {detail::velocity_of(body),
          scaled_in_body(body.X_WB.q_WB, body.inverse_moments, body.momentum.angular_W)};
}

template <class Scalar>
Momentum<Scalar> momentum_of(const Body<Scalar>& body, const Twist<Scalar>& twist) {
  Vec3<Scalar> moments;
  // Bound: three axes
  for (int i = 0; i < 3; ++i) moments(i) = inverse_or_zero(body.inverse_moments(i));
  return {inverse_or_zero(body.inverse_mass) * twist.v_W,
          scaled_in_body(body.X_WB.q_WB, moments, twist.w_W)};
}

template <class Scalar>
Vec3<Scalar> velocity_at(const Pose<Scalar>& X_WB, const Twist<Scalar>& twist,
                         const Vec3<Scalar>& x_W) {
  return twist.v_W + twist.w_W.cross(Vec3<Scalar>(x_W - X_WB.p_W));
}

namespace detail {

template <class Scalar>
void drop_held(Body<Scalar>& body) {
  constexpr Scalar kRoundings = 16;  // of a turn into B
  Momentum<Scalar>& momentum = body.momentum;
  Vec3<Scalar> held_B = body.X_WB.q_WB.conjugate() * momentum.angular_W;
  int axes = 0;
  for (int i = 0; i < 3; ++i) {  // Bound: 3
    if (body.inverse_moments[i] == Scalar(0)) continue;
    held_B[i] = 0;
    ++axes;
  }
  if (axes != 1) return;
  momentum.linear_W.setZero();
  const Scalar rounding = kRoundings * kRoundOff<Scalar> * momentum.angular_W.cwiseAbs().maxCoeff();
  if (!(held_B.cwiseAbs().maxCoeff() > rounding)) return;
  momentum.angular_W -= body.X_WB.q_WB * held_B;
}

}  // namespace detail

template <class Scalar>
Vec3<Scalar> torque_of(const Pose<Scalar>& X_WB, const Vec3<Scalar>& force_W,
                       const Vec3<Scalar>& x_W) {
  return Vec3<Scalar>(x_W - X_WB.p_W).cross(force_W);
}

template <class Scalar>
Status apply(Body<Scalar>& body, const Vec3<Scalar>& force_W, const Vec3<Scalar>& torque_W,
             Scalar dt) {
  const bool inputs = is_finite(force_W) && is_finite(torque_W) && is_finite(dt);
  if (!inputs || dt < Scalar(0)) return Status::kInvalidArgument;
  Momentum<Scalar> next = body.momentum;
  if (body.inverse_mass != Scalar(0)) next.linear_W += dt * force_W;
  if (body.inverse_moments != Vec3<Scalar>::Zero()) next.angular_W += dt * torque_W;
  if (!is_finite(next.linear_W) || !is_finite(next.angular_W)) return Status::kInvalidArgument;
  body.momentum = next;
  return Status::kOk;
}

template <class Scalar>
Status apply_impulse(Body<Scalar>& body, const Vec3<Scalar>& impulse_W, const Vec3<Scalar>& x_W) {
  return apply(body, impulse_W, torque_of(body.X_WB, impulse_W, x_W), Scalar(1));
}

template <class Scalar>
Scalar kinetic_energy(const Body<Scalar>& body) {
  const Vec3<Scalar> b_B = body.X_WB.q_WB.conjugate() * body.momentum.angular_W;
  const Scalar moving = body.inverse_mass * body.momentum.linear_W.squaredNorm();
  const Scalar turning = body.inverse_moments.dot(Vec3<Scalar>(b_B.cwiseProduct(b_B)));
  return (moving + turning) / 2;
}

#define BATUTA_INSTANTIATE(Scalar)                                                                \
  template Result<Body<Scalar>> make_body(const Pose<Scalar>&, Scalar, const Vec3<Scalar>&);      \
  template Vec3<Scalar> to_world(const Pose<Scalar>&, const Vec3<Scalar>&);                       \
  template Vec3<Scalar> to_body(const Pose<Scalar>&, const Vec3<Scalar>&);                        \
  template Capsule<Scalar> to_world(const Pose<Scalar>&, const Capsule<Scalar>&);                 \
  template Mat3<Scalar> detail::inverse_inertia_W(const Body<Scalar>&);                           \
  template Vec3<Scalar> detail::velocity_of(const Body<Scalar>&);                                 \
  template void detail::drop_held(Body<Scalar>&);                                                 \
  template Twist<Scalar> twist_of(const Body<Scalar>&);                                           \
  template Momentum<Scalar> momentum_of(const Body<Scalar>&, const Twist<Scalar>&);               \
  template Vec3<Scalar> velocity_at(const Pose<Scalar>&, const Twist<Scalar>&,                    \
                                    const Vec3<Scalar>&);                                         \
  template Vec3<Scalar> torque_of(const Pose<Scalar>&, const Vec3<Scalar>&, const Vec3<Scalar>&); \
  template Status apply(Body<Scalar>&, const Vec3<Scalar>&, const Vec3<Scalar>&, Scalar);         \
  template Status apply_impulse(Body<Scalar>&, const Vec3<Scalar>&, const Vec3<Scalar>&);         \
  template Scalar kinetic_energy(const Body<Scalar>&);
BATUTA_FOR_EACH_SCALAR(BATUTA_INSTANTIATE)
#undef BATUTA_INSTANTIATE

}  // namespace batuta
