// SPDX-License-Identifier: MIT
#include "batuta/mechanics/rotation.hpp"

#include "batuta/geometry/direction.hpp"

namespace batuta {
namespace {

/// A sum of squares between these bounds has neither overflowed nor lost digits to underflow.
template <class Scalar>
constexpr Scalar kLeastSafeSquare = std::numeric_limits<Scalar>::min() / kRoundOff<Scalar>;
template <class Scalar>
constexpr Scalar kMostSafeSquare = std::numeric_limits<Scalar>::max();

/// theta^2 up to which sin(theta / 2) / theta is 1/2 and cos(theta / 2) is 1 to within u / 2
/// (rotation.md).
template <class Scalar>
constexpr Scalar kTinySquare = 4 * kRoundOff<Scalar>;

/// theta^2 up to which left_jacobian() takes its series (rotation.md).
template <class Scalar>
constexpr Scalar kSeriesSquare = Scalar(0);
template <>
constexpr float kSeriesSquare<float> = 0x1p-4F;
template <>
constexpr double kSeriesSquare<double> = 0x1p-14;

template <class Scalar>
Quat<Scalar> with_positive_w(const Quat<Scalar>& q) {
  return q.w() < Scalar(0) ? Quat<Scalar>(-q.coeffs()) : q;
}

template <class Scalar>
Mat3<Scalar> cross_matrix(const Vec3<Scalar>& r) {
  Mat3<Scalar> M;
  M << Scalar(0), -r.z(), r.y(), r.z(), Scalar(0), -r.x(), -r.y(), r.x(), Scalar(0);
  return M;
}

/// The weights of [r]x and [r]x^2 in the left Jacobian.
template <class Scalar>
struct JacobianWeights {
  Scalar first;   ///< (1 - cos theta) / theta^2
  Scalar second;  ///< (theta - sin theta) / theta^3
};

template <class Scalar>
JacobianWeights<Scalar> jacobian_weights(Scalar square) {
  if (square <= kSeriesSquare<Scalar>) {
    const Scalar first = Scalar(1) / 2 - square * (Scalar(1) / 24 - square * (Scalar(1) / 720));
    return {first, Scalar(1) / 6 - square * (Scalar(1) / 120)};
  }
  const Scalar theta = std::sqrt(square);
  const detail::SinCos<Scalar> half = detail::sin_cos(theta / Scalar(2));
  const Scalar sin_over_theta = Scalar(2) * half.sin * half.cos / theta;
  return {Scalar(2) * half.sin * half.sin / square, (Scalar(1) - sin_over_theta) / square};
}

}  // namespace

template <class Scalar>
Quat<Scalar> renewed(const Quat<Scalar>& q) {
  const Scalar square = q.squaredNorm();
  if (square >= kLeastSafeSquare<Scalar> && square <= kMostSafeSquare<Scalar>) {
    return Quat<Scalar>(q.coeffs() * (Scalar(1) / std::sqrt(square)));
  }
  const Scalar size = q.coeffs().cwiseAbs().maxCoeff();
  if (!is_finite(q) || size == Scalar(0)) return Quat<Scalar>::Identity();
  const Quat<Scalar> scaled(q.coeffs() / size);
  return Quat<Scalar>(scaled.coeffs() / std::sqrt(scaled.squaredNorm()));
}

template <class Scalar>
Quat<Scalar> detail::composed(const Quat<Scalar>& q_AB, const Quat<Scalar>& q_BC) {
  return renewed<Scalar>(q_AB * q_BC);
}

template <class Scalar>
Mat3<Scalar> detail::to_matrix(const Quat<Scalar>& q) {
  return q.toRotationMatrix();
}

template <class Scalar>
Mat3<Scalar> detail::to_matrix(const detail::AxisAngle<Scalar>& turn) {
  return detail::to_matrix(detail::to_quaternion(turn));
}

template <class Scalar>
Quat<Scalar> detail::to_quaternion(const Mat3<Scalar>& R) {
  // Four times the squares of w, x, y, z. The largest is at least 1.
  const Scalar xx = R(0, 0), yy = R(1, 1), zz = R(2, 2);
  const Scalar squares[4] = {Scalar(1) + xx + yy + zz, Scalar(1) + xx - yy - zz,
                             Scalar(1) - xx + yy - zz, Scalar(1) - xx - yy + zz};
  int largest = 0;
  for (int i = 1; i < 4; ++i) {  // Bound: four components
    if (squares[i] > squares[largest]) largest = i;
  }
  // The row of the symmetric matrix 4 q q^T that belongs to the largest component is parallel to q.
  const Scalar wx = R(2, 1) - R(1, 2), wy = R(0, 2) - R(2, 0), wz = R(1, 0) - R(0, 1);
  const Scalar xy = R(0, 1) + R(1, 0), yz = R(1, 2) + R(2, 1), zx = R(2, 0) + R(0, 2);
  const Quat<Scalar> rows[4] = {{squares[0], wx, wy, wz},
                                {wx, squares[1], xy, zx},
                                {wy, xy, squares[2], yz},
                                {wz, zx, yz, squares[3]}};
  return with_positive_w(renewed(rows[largest]));
}

template <class Scalar>
Quat<Scalar> detail::to_quaternion(const detail::AxisAngle<Scalar>& turn) {
  const detail::SinCos<Scalar> half = detail::sin_cos(turn.angle / Scalar(2));
  const Vec3<Scalar> v = half.sin * turn.axis;
  return with_positive_w(Quat<Scalar>(half.cos, v.x(), v.y(), v.z()));
}

template <class Scalar>
detail::AxisAngle<Scalar> detail::to_axis_angle(const Quat<Scalar>& q) {
  const Quat<Scalar> positive = with_positive_w(q);
  const Vec3<Scalar> v = positive.vec();
  const Scalar size = length(v);
  if (!(size > Scalar(0))) return {};
  return {v / size, Scalar(2) * detail::arc_tangent(size, positive.w())};
}

template <class Scalar>
detail::AxisAngle<Scalar> detail::to_axis_angle(const Mat3<Scalar>& R) {
  return detail::to_axis_angle(detail::to_quaternion(R));
}

template <class Scalar>
Quat<Scalar> exp_map(const Vec3<Scalar>& rotation_vector) {
  const Scalar square = rotation_vector.squaredNorm();
  Scalar w = Scalar(1);
  Scalar factor = Scalar(0.5);  // sin(theta / 2) / theta
  if (square > kTinySquare<Scalar>) {
    const Scalar theta = std::sqrt(square);
    const detail::SinCos<Scalar> half = detail::sin_cos(theta / Scalar(2));
    w = half.cos;
    factor = half.sin / theta;
  }
  const Vec3<Scalar> v = factor * rotation_vector;
  return {w, v.x(), v.y(), v.z()};
}

template <class Scalar>
Vec3<Scalar> log_map(const Quat<Scalar>& q) {
  const detail::AxisAngle<Scalar> turn = detail::to_axis_angle(q);
  return turn.angle * turn.axis;
}

template <class Scalar>
Mat3<Scalar> detail::left_jacobian(const Vec3<Scalar>& rotation_vector) {
  const JacobianWeights<Scalar> weight = jacobian_weights(rotation_vector.squaredNorm());
  const Mat3<Scalar> M = cross_matrix(rotation_vector);
  const Mat3<Scalar> MM = M * M;
  return Mat3<Scalar>::Identity() + weight.first * M + weight.second * MM;
}

template <class Scalar>
Quat<Scalar> interpolated(const Quat<Scalar>& q0, const Quat<Scalar>& q1, Scalar t) {
  if (t == Scalar(0)) return q0;
  if (t == Scalar(1)) return q1;
  const Vec3<Scalar> whole = log_map(Quat<Scalar>(q1 * q0.conjugate()));
  return detail::composed(exp_map(Vec3<Scalar>(t * whole)), q0);
}

#define BATUTA_INSTANTIATE(Scalar)                                                  \
  template Quat<Scalar> renewed(const Quat<Scalar>&);                               \
  template Mat3<Scalar> detail::to_matrix(const Quat<Scalar>&);                     \
  template Mat3<Scalar> detail::to_matrix(const detail::AxisAngle<Scalar>&);        \
  template Quat<Scalar> detail::composed(const Quat<Scalar>&, const Quat<Scalar>&); \
  template Quat<Scalar> detail::to_quaternion(const Mat3<Scalar>&);                 \
  template Quat<Scalar> detail::to_quaternion(const detail::AxisAngle<Scalar>&);    \
  template detail::AxisAngle<Scalar> detail::to_axis_angle(const Quat<Scalar>&);    \
  template detail::AxisAngle<Scalar> detail::to_axis_angle(const Mat3<Scalar>&);    \
  template Quat<Scalar> exp_map(const Vec3<Scalar>&);                               \
  template Vec3<Scalar> log_map(const Quat<Scalar>&);                               \
  template Mat3<Scalar> detail::left_jacobian(const Vec3<Scalar>&);                 \
  template Quat<Scalar> interpolated(const Quat<Scalar>&, const Quat<Scalar>&, Scalar);
BATUTA_FOR_EACH_SCALAR(BATUTA_INSTANTIATE)
#undef BATUTA_INSTANTIATE

}  // namespace batuta
