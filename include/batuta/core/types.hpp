// SPDX-License-Identifier: MIT
#pragma once
// Names the few fixed-size types of Eigen in use; library and user see the same Eigen
// (detail/eigen.hpp). Scalar is float on targets; double is the oracle on the host.

#include <cfloat>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "batuta/core/detail/eigen.hpp"

#if defined(__FAST_MATH__) || __FINITE_MATH_ONLY__ || defined(__ASSOCIATIVE_MATH__) || \
    defined(__RECIPROCAL_MATH__) || defined(__NO_SIGNED_ZEROS__)
#error "batuta: -ffast-math changes results and removes the checks for NaN; compile without it"
#endif

#ifdef _M_FP_FAST  // deviation: names-of-compilers
#error "batuta: /fp:fast changes results; compile with /fp:precise"
#endif

#if FLT_EVAL_METHOD != 0
#error \
    "batuta: arithmetic must round to the type (FLT_EVAL_METHOD 0); on 32-bit x86 use -msse2 -mfpmath=sse"
#endif

#ifdef BATUTA_BUILDING_CORE
// The core has no matrices whose size is known at run time only: their storage cannot be had there.
namespace Eigen::internal {
template <>
float* conditional_aligned_new_auto<float, true>(std::size_t) = delete;
template <>
double* conditional_aligned_new_auto<double, true>(std::size_t) = delete;
}  // namespace Eigen::internal
#endif

/// The scalars that the kernels in src/ are built for: instantiate(S) once for each.
#if BATUTA_WITH_DOUBLE
#define BATUTA_FOR_EACH_SCALAR(instantiate) instantiate(float) instantiate(double)
#else
#define BATUTA_FOR_EACH_SCALAR(instantiate) instantiate(float)
#endif

/// The library. What a user is meant to write stands here; batuta::detail is machinery.
namespace batuta {

/// Two numbers, as a column.
template <class Scalar>
using Vec2 = Eigen::Matrix<Scalar, 2, 1>;
/// Three numbers, as a column.
template <class Scalar>
using Vec3 = Eigen::Matrix<Scalar, 3, 1>;
/// A matrix of 3 x 3 numbers.
template <class Scalar>
using Mat3 = Eigen::Matrix<Scalar, 3, 3>;
/// A quaternion; what the library stores and returns as a rotation is of unit length.
template <class Scalar>
using Quat = Eigen::Quaternion<Scalar>;

/// Unit round-off u: half the spacing of Scalar at 1 (2^-24 for float, 2^-53 for double).
template <class Scalar>
inline constexpr Scalar kRoundOff = std::numeric_limits<Scalar>::epsilon() / 2;

namespace detail {

/// Whether a type is one that the library may be used with: float or double.
template <class Scalar>
inline constexpr bool kIsScalar = std::is_same_v<Scalar, float> || std::is_same_v<Scalar, double>;

}  // namespace detail

/// The lesser of two. Comparison forms with one meaning on every compiler, also for signed zeros
/// and NaN: the first wins a tie.
template <class Scalar>
constexpr Scalar min_of(Scalar a, Scalar b) {
  return b < a ? b : a;
}
/// The greater of two; the first wins a tie.
template <class Scalar>
constexpr Scalar max_of(Scalar a, Scalar b) {
  return a < b ? b : a;
}
/// x within [low, high]. NaN stays NaN. @pre low <= high
template <class Scalar>
constexpr Scalar clamp(Scalar x, Scalar low, Scalar high) {
  return x < low ? low : (high < x ? high : x);
}

/// False for NaN and for both infinities.
template <class Scalar, std::enable_if_t<std::is_floating_point_v<Scalar>, int> = 0>
constexpr bool is_finite(Scalar x) {
  return x - x == Scalar(0);
}
/// False where a component is NaN or infinite.
template <class Derived>
bool is_finite(const Eigen::MatrixBase<Derived>& m) {
  return (m - m).sum() == typename Derived::Scalar(0);  // NaN where any of them is not finite
}

namespace detail {

/// (0, 0, 0). Zero() of Eigen costs each file that includes this some classes.
template <class Scalar>
Vec3<Scalar> zero() {
  Vec3<Scalar> none;
  none.x() = 0;
  none.y() = 0;
  none.z() = 0;
  return none;
}

/// sum += x. By component, as above; kept apart, because a call is smaller.
template <class Scalar>
[[gnu::noinline]] void add_to(Vec3<Scalar>& sum, const Vec3<Scalar>& x) {
  sum.x() += x.x();
  sum.y() += x.y();
  sum.z() += x.z();
}

/// (1, 0, 0). UnitX() of Eigen costs each file that includes this some classes; the three numbers
/// at once, each image some hundred bytes.
template <class Scalar>
Vec3<Scalar> unit_x() {
  Vec3<Scalar> x = zero<Scalar>();
  x.x() = 1;
  return x;
}

/// 0 where all components are finite, else NaN: several can be added up and looked at once.
// By component: an expression of Eigen's costs each file that includes this some classes.
template <class Scalar>
Scalar nan_unless_finite(const Vec3<Scalar>& v) {
  return Scalar(0) * v.x() + Scalar(0) * v.y() + Scalar(0) * v.z();
}
template <class Scalar>
Scalar nan_unless_finite(const Quat<Scalar>& q) {
  return Scalar(0) * q.x() + Scalar(0) * q.y() + Scalar(0) * q.z() + Scalar(0) * q.w();
}

}  // namespace detail

/// False where a component is NaN or infinite.
// Kept apart, as the one below: a call is smaller than the sum.
template <class Scalar>
[[gnu::noinline]] bool is_finite(const Vec3<Scalar>& v) {
  return detail::nan_unless_finite(v) == Scalar(0);
}
/// False where a component is NaN or infinite.
template <class Scalar>
[[gnu::noinline]] bool is_finite(const Quat<Scalar>& q) {
  return detail::nan_unless_finite(q) == Scalar(0);
}

namespace detail {

/// Whether an inverse mass or moment is that of something: of what is fixed, or of a finite one.
template <class Scalar>
bool is_inverse(Scalar x) {
  return x == Scalar(0) || (x > Scalar(0) && Scalar(1) / x <= std::numeric_limits<Scalar>::max());
}

/// Whether all components are zero, of either sign.
template <class Scalar>
bool is_zero(const Vec3<Scalar>& v) {
  return v.x() == Scalar(0) && v.y() == Scalar(0) && v.z() == Scalar(0);
}
/// Whether all components are equal numbers; NaN equals none.
template <class Scalar>
bool is_same(const Vec3<Scalar>& a, const Vec3<Scalar>& b) {
  return a.x() == b.x() && a.y() == b.y() && a.z() == b.z();
}
template <class Scalar>
bool is_same(const Quat<Scalar>& a, const Quat<Scalar>& b) {
  return a.x() == b.x() && a.y() == b.y() && a.z() == b.z() && a.w() == b.w();
}

}  // namespace detail

/// Finite and above zero: what a length, a time or a mass must be that something is divided by.
template <class Scalar>
constexpr bool is_positive(Scalar x) {
  return is_finite(x) && x > Scalar(0);
}

}  // namespace batuta
