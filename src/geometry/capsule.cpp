// SPDX-License-Identifier: MIT
#include "batuta/geometry/capsule.hpp"

#include "batuta/geometry/direction.hpp"

namespace batuta {
namespace {

/// The rounding errors of a radius computed by bounding_sphere(): 5 u of length(), a sum and a
/// product.
template <class Scalar>
constexpr Scalar kSphereSlack = 8 * kRoundOff<Scalar>;

template <class Scalar>
bool is_usable(const Vec3<Scalar>& point) {
  return is_finite(point) && detail::largest_component(point) <= kLargestCoordinate<Scalar>;
}

}  // namespace

template <class Scalar>
bool is_valid(const Capsule<Scalar>& capsule) {
  return is_usable(capsule.axis.a) && is_usable(capsule.axis.b) && capsule.radius >= 0 &&
         capsule.radius <= kLargestCoordinate<Scalar>;
}

template <class Scalar>
bool can_hold(const Vec3<Scalar>& place, const Capsule<Scalar>& capsule_B) {
  const Segment<Scalar>& axis = capsule_B.axis;
  const Scalar reach = max_of(detail::largest_component(axis.a), detail::largest_component(axis.b));
  return can_hold<Scalar>(place, reach + capsule_B.radius);
}

template <class Scalar>
CapsuleGap<Scalar> capsule_gap(const ClosestPoints<Scalar>& axes, Scalar radius_A,
                               Scalar radius_B) {
  CapsuleGap<Scalar> result;
  result.axes = axes;
  result.gap = axes.distance - (radius_A + radius_B);
  result.proximity = result.gap > 0   ? Proximity::kSeparated
                     : result.gap < 0 ? Proximity::kOverlapping
                                      : Proximity::kTouching;
  result.surface_A = axes.p_A + radius_A * axes.normal_AB;
  result.surface_B = axes.p_B - radius_B * axes.normal_AB;
  return result;
}

template <class Scalar>
CapsuleGap<Scalar> capsule_gap(const Capsule<Scalar>& A, const Capsule<Scalar>& B) {
  if (!is_valid(A) || !is_valid(B)) return {};
  return capsule_gap(closest_points(A.axis, B.axis), A.radius, B.radius);
}

template <class Scalar>
bool overlaps(const Capsule<Scalar>& A, const Capsule<Scalar>& B) {
  const Proximity proximity = capsule_gap(A, B).proximity;
  return proximity == Proximity::kTouching || proximity == Proximity::kOverlapping;
}

template <class Scalar>
Scalar penetration_depth(const Capsule<Scalar>& A, const Capsule<Scalar>& B) {
  return max_of(Scalar(0), -capsule_gap(A, B).gap);
}

template <class Scalar>
Result<Vec3<Scalar>> surface_normal(const Capsule<Scalar>& capsule, const Vec3<Scalar>& point) {
  if (!is_valid(capsule) || !is_usable(point)) {
    return failure<Vec3<Scalar>>(Status::kInvalidArgument);
  }
  const ClosestPoints<Scalar> nearest = closest_points<Scalar>(capsule.axis, {point, point});
  return {nearest.arbitrary ? Status::kDegenerate : Status::kOk, nearest.normal_AB};
}

template <class Scalar>
Scalar support(const Capsule<Scalar>& capsule, const Vec3<Scalar>& direction) {
  return max_of(direction.dot(capsule.axis.a), direction.dot(capsule.axis.b)) +
         capsule.radius * length(direction);
}

template <class Scalar>
Sphere<Scalar> bounding_sphere(const Capsule<Scalar>& capsule) {
  const Segment<Scalar>& axis = capsule.axis;
  const Vec3<Scalar> center = axis.at(Scalar(0.5));
  // Measured from the rounded centre: it need not be the middle, only known.
  const Scalar reach =
      max_of(length<Scalar>(axis.a - center), length<Scalar>(axis.b - center)) + capsule.radius;
  return {center, reach * (1 + kSphereSlack<Scalar>)};
}

#define BATUTA_INSTANTIATE(Scalar)                                                           \
  template bool is_valid(const Capsule<Scalar>&);                                            \
  template bool can_hold(const Vec3<Scalar>&, const Capsule<Scalar>&);                       \
  template CapsuleGap<Scalar> capsule_gap(const Capsule<Scalar>&, const Capsule<Scalar>&);   \
  template CapsuleGap<Scalar> capsule_gap(const ClosestPoints<Scalar>&, Scalar, Scalar);     \
  template bool overlaps(const Capsule<Scalar>&, const Capsule<Scalar>&);                    \
  template Scalar penetration_depth(const Capsule<Scalar>&, const Capsule<Scalar>&);         \
  template Result<Vec3<Scalar>> surface_normal(const Capsule<Scalar>&, const Vec3<Scalar>&); \
  template Scalar support(const Capsule<Scalar>&, const Vec3<Scalar>&);                      \
  template Sphere<Scalar> bounding_sphere(const Capsule<Scalar>&);

BATUTA_FOR_EACH_SCALAR(BATUTA_INSTANTIATE)
#undef BATUTA_INSTANTIATE

}  // namespace batuta
