// SPDX-License-Identifier: MIT
#include "numbers.hpp"

namespace batuta::detail {
namespace {

template <class Scalar, class Out>
std::int32_t closest_points_for(const Scalar* A, const Scalar* B, Out* out) {
  if (A == nullptr || B == nullptr || out == nullptr) return BATUTA_INVALID_ARGUMENT;
  if (!rounds_each_operation<Scalar>()) return BATUTA_UNAVAILABLE;
  const CapsuleGap<Scalar> found = capsule_gap(capsule_of(A), capsule_of(B));
  if (found.proximity == Proximity::kInvalid) return BATUTA_INVALID_ARGUMENT;
  out->gap = found.gap;
  out->distance = found.axes.distance;
  out->s = found.axes.s;
  out->u = found.axes.u;
  put(found.axes.p_A, out->p_A);
  put(found.axes.p_B, out->p_B);
  put(found.axes.normal_AB, out->normal_AB);
  out->arbitrary = found.axes.arbitrary ? 1 : 0;
  return BATUTA_OK;
}

template <class Scalar, class Out>
std::size_t closest_points_for_each(const Scalar* A, const Scalar* B, std::size_t count, Out* out) {
  if (A == nullptr || B == nullptr || out == nullptr) return 0;
  return answer_each(count, [=](std::size_t i) {
    const std::size_t at = i * BATUTA_CAPSULE_NUMBERS;
    return closest_points_for(A + at, B + at, out + i);
  });
}

}  // namespace
}  // namespace batuta::detail

std::int32_t batuta_closest_points_f(const float* A, const float* B, batuta_closest_f* out) {
  return batuta::detail::closest_points_for(A, B, out);
}

std::int32_t batuta_closest_points_d(const double* A, const double* B, batuta_closest_d* out) {
  if constexpr (BATUTA_WITH_DOUBLE == 1) {
    return batuta::detail::closest_points_for(A, B, out);
  } else {
    return BATUTA_UNAVAILABLE;
  }
}

std::size_t batuta_closest_points_many_f(const float* A, const float* B, std::size_t count,
                                         batuta_closest_f* out) {
  return batuta::detail::closest_points_for_each(A, B, count, out);
}

std::size_t batuta_closest_points_many_d(const double* A, const double* B, std::size_t count,
                                         batuta_closest_d* out) {
  if constexpr (BATUTA_WITH_DOUBLE == 1) {
    return batuta::detail::closest_points_for_each(A, B, count, out);
  } else {
    return 0;
  }
}
