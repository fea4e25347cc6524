// SPDX-License-Identifier: MIT
#include "batuta/detection/sphere_flight.hpp"

#include "straight_extent.hpp"

namespace batuta {

namespace {

/// Least contact tolerance over S: the entry is aimed at half of it, with room on either side for
/// the error of the aim and for eps (sphere_flight.md).
template <class Scalar>
constexpr Scalar kLeastFlightTolerance = 128 * kRoundOff<Scalar>;

/// Share of the least contact tolerance that is eps: what rounding can do to the evaluation that
/// certifies.
template <class Scalar>
constexpr Scalar kEvaluationShare = Scalar(0.125);

/// m, added to S: what is shorter by u counts as nothing, and no square that matters underflows.
template <class Scalar>
constexpr Scalar kLeastLength = Scalar(0x1p-40);

/// |start + travel theta|. Kept apart: three calls, and no three copies.
template <class Scalar>
[[gnu::noinline]] Scalar distance_at(const Vec3<Scalar>& start, const Vec3<Scalar>& travel,
                                     Scalar theta) {
  const Scalar x = start.x() + travel.x() * theta;
  const Scalar y = start.y() + travel.y() * theta;
  const Scalar z = start.z() + travel.z() * theta;
  return std::sqrt(x * x + y * y + z * z);
}

template <class Scalar>
Scalar least_tolerance(Scalar apart, Scalar length, Scalar radii) {
  return kLeastFlightTolerance<Scalar> * (apart + length + radii + kLeastLength<Scalar>);
}

template <class Scalar>
bool are_not_negative(Scalar a, Scalar b, Scalar c) {
  return a >= Scalar(0) && b >= Scalar(0) && c >= Scalar(0);
}

}  // namespace

template <class Scalar>
SphereResult<Scalar> search_spheres(const SphereFlight<Scalar>& flight, Scalar contact_tolerance) {
  const Vec3<Scalar>& start = flight.between;
  const Vec3<Scalar> travel = flight.v * flight.duration;
  const Scalar radii = flight.radii;
  const Scalar apart = distance_at<Scalar>(start, travel, Scalar(0));
  const Scalar square = travel.squaredNorm();
  const Scalar length = std::sqrt(square);
  const Scalar least = least_tolerance(apart, length, radii);
  const Scalar closing = -start.dot(travel);
  SphereResult<Scalar> result;
  result.closing = closing;
  result.gap = apart - radii;
  if (!is_finite(least * least) || !are_not_negative(radii, flight.duration, contact_tolerance))
    return result;
  const Scalar tau = max_of(contact_tolerance, least);
  result.outcome = Outcome::kTouching;
  if (!(result.gap > tau)) return result;

  const Scalar rho = radii + tau / 2;
  const Scalar nearest = closing / square;
  const Scalar miss = distance_at<Scalar>(start, travel, nearest);
  const Scalar half_chord = std::sqrt((rho - miss) * (rho + miss));
  const Scalar entry = (apart - rho) * (apart + rho) / (closing + length * half_chord);
  const Scalar theta = min_of(nearest, entry);
  result.outcome = Outcome::kFree;
  result.t_free = flight.duration;
  result.t_hit = flight.duration;
  if (!(closing > Scalar(0) && miss <= rho && theta < Scalar(1))) return result;

  const Scalar distance = distance_at<Scalar>(start, travel, theta);
  const Scalar gap = distance - radii;
  result.outcome = Outcome::kBudget;
  result.t_free = 0;
  if (!(gap > least * kEvaluationShare<Scalar>)) return result;
  result.outcome = Outcome::kContact;
  result.t_free = theta * flight.duration;
  const Scalar foreseen = theta + gap * distance / (closing - theta * square);
  result.t_hit = clamp(foreseen, theta, min_of(nearest, Scalar(1))) * flight.duration;
  return result;
}

template <class Scalar>
Scalar detail::contact_gap_of(const SphereFlight<Scalar>& flight, Scalar contact_tolerance) {
  const Vec3<Scalar>& start = flight.between;
  const Vec3<Scalar> travel = flight.v * flight.duration;
  const Scalar length = std::sqrt(travel.squaredNorm());
  const Scalar least =
      least_tolerance(distance_at<Scalar>(start, travel, Scalar(0)), length, flight.radii);
  return max_of(contact_tolerance, least) + least * kEvaluationShare<Scalar>;
}

template <class Scalar>
Aabb<Scalar> detail::sphere_aabb(const detail::StraightMotion<Scalar>& center, Scalar radius) {
  Aabb<Scalar> box;
  for (int i = 0; i < 3; ++i) {  // Bound: 3
    const SweptExtent<Scalar> extent =
        swept_extent<Scalar>(center.p_W[i], center.v_W[i] * center.duration, {-radius, radius});
    box.low[static_cast<std::size_t>(i)] = extent.low;
    box.high[static_cast<std::size_t>(i)] = extent.high;
  }
  return box;
}

#define BATUTA_INSTANTIATE(Scalar)                                                   \
  template SphereResult<Scalar> search_spheres(const SphereFlight<Scalar>&, Scalar); \
  template Scalar detail::contact_gap_of(const SphereFlight<Scalar>&, Scalar);       \
  template Aabb<Scalar> detail::sphere_aabb(const detail::StraightMotion<Scalar>&, Scalar);
BATUTA_FOR_EACH_SCALAR(BATUTA_INSTANTIATE)
#undef BATUTA_INSTANTIATE

}  // namespace batuta
