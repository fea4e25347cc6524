// SPDX-License-Identifier: MIT
#pragma once
// Numbers to test with, the same on every machine, and long double truths to test against.

#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

#include "batuta/mechanics/motion.hpp"

namespace batuta::samples {

using Real = long double;

/// Uniform in [low, high], from the generator's bits alone.
template <class Scalar>
class Source {
 public:
  explicit Source(std::uint64_t seed) : bits_(seed) {}

  Scalar uniform(double low, double high) {
    const double unit = static_cast<double>(bits_() >> 11) * 0x1p-53;
    return static_cast<Scalar>(low + unit * (high - low));
  }
  /// Every order of magnitude between the bounds is as likely.
  Scalar log_uniform(double low, double high) {
    return static_cast<Scalar>(std::exp(uniform(std::log(low), std::log(high))));
  }
  Vec3<Scalar> vector(double size) {
    return {uniform(-size, size), uniform(-size, size), uniform(-size, size)};
  }
  Vec3<Scalar> direction() {
    Vec3<Scalar> v = vector(1);
    while (v.norm() < Scalar(0.1)) v = vector(1);
    return v.normalized();
  }
  Quat<Scalar> rotation() {
    const Vec3<Scalar> v = vector(1);
    return Quat<Scalar>(uniform(-1, 1), v.x(), v.y(), v.z()).normalized();
  }
  std::uint64_t bits() { return bits_(); }

 private:
  std::mt19937_64 bits_;
};

/// Error of `value` in units of the last place of Scalar at the true value.
template <class Scalar>
double ulps(Scalar value, Real truth) {
  using Limits = std::numeric_limits<Scalar>;
  if (truth == 0) return value == Scalar(0) ? 0 : Limits::infinity();
  int exponent = 0;
  (void)std::frexp(truth, &exponent);
  exponent = std::max(exponent, Limits::min_exponent);
  return static_cast<double>(std::fabs(static_cast<Real>(value) - truth) /
                             std::ldexp(Real(1), exponent - Limits::digits));
}

template <class Scalar>
Vec3<Real> real(const Vec3<Scalar>& v) {
  return v.template cast<Real>();
}
template <class Scalar>
Mat3<Real> real(const Mat3<Scalar>& M) {
  return M.template cast<Real>();
}
template <class Scalar>
Quat<Real> real(const Quat<Scalar>& q) {
  return Quat<Real>(q.coeffs().template cast<Real>());
}

/// exp of a rotation vector by the definition, in long double.
inline Quat<Real> true_exp(const Vec3<Real>& r) {
  const Real angle = r.norm();
  if (angle == 0) return Quat<Real>::Identity();
  const Vec3<Real> v = std::sin(angle / 2) / angle * r;
  return {std::cos(angle / 2), v.x(), v.y(), v.z()};
}

/// Distance of two rotations: the smaller |p - q|, |p + q|; half the angle between them if small.
template <class Scalar>
double apart(const Quat<Scalar>& p, const Quat<Real>& q) {
  const auto a = (real(p).coeffs() - q.coeffs()).norm();
  const auto b = (real(p).coeffs() + q.coeffs()).norm();
  return static_cast<double>(std::min(a, b));
}

template <class Scalar>
double relative_error(const Vec3<Scalar>& value, const Vec3<Real>& truth) {
  return static_cast<double>((real(value) - truth).norm() / truth.norm());
}

/// Unit round-off of Scalar as a double, to state bounds with.
template <class Scalar>
constexpr double u = static_cast<double>(kRoundOff<Scalar>);

}  // namespace batuta::samples
