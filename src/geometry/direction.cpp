// SPDX-License-Identifier: MIT
#include "batuta/geometry/direction.hpp"

namespace batuta {

namespace {

/// Whether a square neither overflowed nor lost digits to underflow (direction.md).
template <class Scalar>
bool is_sound(Scalar square) {
  constexpr Scalar kLeast = std::numeric_limits<Scalar>::min() / kRoundOff<Scalar>;
  return square >= kLeast && square <= std::numeric_limits<Scalar>::max();
}

}  // namespace

template <class Scalar>
Scalar length(const Vec3<Scalar>& v) {
  Scalar square = v.squaredNorm();
  if (is_sound(square)) return std::sqrt(square);
  const Scalar largest = detail::largest_component(v);
  if (largest == 0) return square;  // 0, or NaN where a component beside zeros is
  square = Vec3<Scalar>(v / largest).squaredNorm();
  return largest * std::sqrt(square);
}

template <class Scalar>
Vec3<Scalar> unit(const Vec3<Scalar>& v) {
  Vec3<Scalar> w = v;
  Scalar square = v.squaredNorm();
  if (!is_sound(square)) {
    const Scalar largest = detail::largest_component(v);
    BATUTA_ASSERT(largest != 0);
    w = v / largest;
    square = w.squaredNorm();
  }
  return w / std::sqrt(square);
}

template <class Scalar>
Vec3<Scalar> detail::perpendicular(const Vec3<Scalar>& v) {
  const Vec3<Scalar> size = v.cwiseAbs();
  Vec3<Scalar> across(-v.y(), v.x(), 0);
  if (size.x() <= size.y() && size.x() <= size.z()) {
    across = {0, -v.z(), v.y()};
  } else if (size.y() <= size.z()) {
    across = {v.z(), 0, -v.x()};
  }
  return unit(across);
}

#define BATUTA_INSTANTIATE(S)            \
  template S length(const Vec3<S>&);     \
  template Vec3<S> unit(const Vec3<S>&); \
  template Vec3<S> detail::perpendicular(const Vec3<S>&);
BATUTA_FOR_EACH_SCALAR(BATUTA_INSTANTIATE)
#undef BATUTA_INSTANTIATE

}  // namespace batuta
