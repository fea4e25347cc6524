// SPDX-License-Identifier: MIT
#pragma once
// The only header that includes Eigen, and sets it up: alike in every file, without a flag. A build
// that passes the same macros is welcome to.

#include <new>

#include "batuta/core/assert.hpp"

// One sentence where Eigen was first: it has set its alignment as well, and its checks, which are
// taken away so that no compiler speaks of them.
#if defined(eigen_assert) || defined(EIGEN_WORLD_VERSION)
#error \
    "batuta: include batuta headers before Eigen's own, so that Eigen's checks reach batuta_trap()"
#undef eigen_assert
#elif !defined(EIGEN_MAX_STATIC_ALIGN_BYTES)
#define EIGEN_MAX_STATIC_ALIGN_BYTES 0
#elif EIGEN_MAX_STATIC_ALIGN_BYTES != 0
#error "batuta: EIGEN_MAX_STATIC_ALIGN_BYTES must be 0: layouts are the same on host and target"
#endif
#ifndef EIGEN_DONT_VECTORIZE
#define EIGEN_DONT_VECTORIZE
#endif
#ifndef EIGEN_NO_IO
#define EIGEN_NO_IO
#endif
// Of the core alone: a user's own matrices may be of any size, here and in files without batuta.
#if defined(BATUTA_BUILDING_CORE) && !defined(EIGEN_NO_MALLOC)
#define EIGEN_NO_MALLOC
#endif
#ifndef EIGEN_MPL2_ONLY
#define EIGEN_MPL2_ONLY
#endif
#ifndef EIGEN_STACK_ALLOCATION_LIMIT
#define EIGEN_STACK_ALLOCATION_LIMIT 1024
#endif

/// A failed check of Eigen calls batuta_trap(), like an invariant of the library. Nothing asks for
/// the file's hash as a constant: at each of Eigen's checks that costs 3 % of the time that Eigen
/// takes to compile. With optimization GCC makes it one all the same.
#define eigen_assert(condition)                                          \
  do {                                                                   \
    if (BATUTA_ASSERT_LEVEL >= 2 && !(condition)) {                      \
      batuta_trap(::batuta::file_id(__FILE__), std::uint32_t{__LINE__}); \
    }                                                                    \
  } while (false)

// GCC leaves many of Eigen's operators, a line each, as calls: optimizing for size nearly all,
// which takes 2.5 times the instructions. With all of them inlined -Os makes less code than -O2,
// and faster (docs/cost.md), and the steps of a host's worlds take a tenth less time.
#if defined(__OPTIMIZE__) && defined(__GNUC__) && !defined(__clang__)
#define BATUTA_INLINE_EIGEN 1
#else
#define BATUTA_INLINE_EIGEN 0
#endif
#if BATUTA_INLINE_EIGEN
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wattributes"  // of a few that are no inline functions
#ifndef EIGEN_STRONG_INLINE
#define EIGEN_STRONG_INLINE inline __attribute__((always_inline))
#endif
#include <Eigen/src/Core/util/Macros.h>
#undef EIGEN_DEVICE_FUNC
#define EIGEN_DEVICE_FUNC __attribute__((always_inline))
#endif

#include <Eigen/Core>
#include <Eigen/Geometry>

#if BATUTA_INLINE_EIGEN
#pragma GCC diagnostic pop
#endif

#if BATUTA_INLINE_EIGEN
namespace Eigen {
namespace internal {

// Eigen hands the lesser of two on as a pointer to a function, and GCC refuses to inline that at
// -Og. The same formula, without the pointer.
#define BATUTA_WITHOUT_POINTER(name, formula, Scalar)                                             \
  template <>                                                                                     \
  EIGEN_DEVICE_FUNC inline Scalar name<PropagateFast, Scalar>(const Scalar& a, const Scalar& b) { \
    return numext::formula(a, b);                                                                 \
  }
BATUTA_WITHOUT_POINTER(pmin, mini, float)
BATUTA_WITHOUT_POINTER(pmin, mini, double)
BATUTA_WITHOUT_POINTER(pmax, maxi, float)
BATUTA_WITHOUT_POINTER(pmax, maxi, double)
#undef BATUTA_WITHOUT_POINTER

}  // namespace internal
}  // namespace Eigen
#endif

#if BATUTA_INLINE_EIGEN && defined(__OPTIMIZE_SIZE__)
namespace Eigen {

/// Eigen's own formula, in the same order, as a call: a turned vector is smaller once than at each
/// place. The bits are those of Eigen's, which a file that is compiled otherwise may bring.
template <>
[[gnu::noinline]] inline Matrix<float, 3, 1> QuaternionBase<Quaternion<float>>::_transformVector(
    const Matrix<float, 3, 1>& v) const {
  Matrix<float, 3, 1> uv = vec().cross(v);
  uv += uv;
  return v + w() * uv + vec().cross(uv);
}

namespace internal {

/// Eigen's own formula, in the same order, as a call.
template <>
struct quat_product<Architecture::Target, Quaternion<float>, Quaternion<float>, float> {
  [[gnu::noinline]] static Quaternion<float> run(const QuaternionBase<Quaternion<float>>& a,
                                                 const QuaternionBase<Quaternion<float>>& b) {
    return {a.w() * b.w() - a.x() * b.x() - a.y() * b.y() - a.z() * b.z(),
            a.w() * b.x() + a.x() * b.w() + a.y() * b.z() - a.z() * b.y(),
            a.w() * b.y() + a.y() * b.w() + a.z() * b.x() - a.x() * b.z(),
            a.w() * b.z() + a.z() * b.w() + a.x() * b.y() - a.y() * b.x()};
  }
};

}  // namespace internal
}  // namespace Eigen
#endif
#undef BATUTA_INLINE_EIGEN
