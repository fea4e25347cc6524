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
  const Scalar square = v.squaredNorm();
  if (is_sound(square)) return std::sqrt(square);
  const Scalar largest = largest_component(v);
  if (largest == 0) return 0;
  return largest * std::sqrt(Vec3<Scalar>(v / largest).squaredNorm());
}

template <class Scalar>
Vec3<Scalar> unit(const Vec3<Scalar>& v) {
  BATUTA_ASSERT(largest_component(v) != 0);
  const Scalar square = v.squaredNorm();
  if (is_sound(square)) return v / std::sqrt(square);
  const Vec3<Scalar> w = v / largest_component(v);
  return w / std::sqrt(w.squaredNorm());
}

template <class Scalar>
Vec3<Scalar> perpendicular(const Vec3<Scalar>& v) {
  const Vec3<Scalar> size = v.cwiseAbs();
  if (size.x() <= size.y() && size.x() <= size.z()) {
    return unit<Scalar>({0, -v.z(), v.y()});
  }
  if (size.y() <= size.z()) return unit<Scalar>({v.z(), 0, -v.x()});
  return unit<Scalar>({-v.y(), v.x(), 0});
}

#define BATUTA_INSTANTIATE(S)            \
  template S length(const Vec3<S>&);     \
  template Vec3<S> unit(const Vec3<S>&); \
  template Vec3<S> perpendicular(const Vec3<S>&);
BATUTA_FOR_EACH_SCALAR(BATUTA_INSTANTIATE)
#undef BATUTA_INSTANTIATE

}  // namespace batuta
