// SPDX-License-Identifier: MIT
#pragma once
// Length and direction of a vector at any scale: squares neither overflow nor vanish, because the
// largest component is taken out first. Frame: any; unit: any.

#include "batuta/core/types.hpp"

namespace batuta {

namespace detail {

/// max(|x|, |y|, |z|): between |v| / sqrt(3) and |v|, and exact.
template <class Scalar>
Scalar largest_component(const Vec3<Scalar>& v) {
  return max_of(max_of(std::abs(v.x()), std::abs(v.y())), std::abs(v.z()));
}

}  // namespace detail

/// |v|; NaN where a component is. Bound: no loop; relative error <= 5 u where |v| is not subnormal.
template <class Scalar>
Scalar length(const Vec3<Scalar>& v);

/// v / |v|, unit to 4 u.
/// @pre v is not zero
template <class Scalar>
Vec3<Scalar> unit(const Vec3<Scalar>& v);

namespace detail {

/// A unit vector at right angles to v and to the coordinate axis that v leans to least (x before y
/// before z). It turns about when v does, and jumps where the least component changes: no choice is
/// continuous everywhere.
/// @pre v is not zero
template <class Scalar>
Vec3<Scalar> perpendicular(const Vec3<Scalar>& v);

}  // namespace detail

}  // namespace batuta
