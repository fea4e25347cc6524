// SPDX-License-Identifier: MIT
#pragma once
// Between the arrays of batuta/c.h and the library's types.

#include "batuta/c.h"
#include "batuta/core/arithmetic.hpp"
#include "batuta/detection/advancement.hpp"

namespace batuta::detail {

/// A status as C knows it.
constexpr std::int32_t code_of(Status status) {
  return static_cast<std::int32_t>(status);
}
static_assert(code_of(Status::kOk) == BATUTA_OK &&
                  code_of(Status::kInvalidArgument) == BATUTA_INVALID_ARGUMENT &&
                  code_of(Status::kPoolFull) == BATUTA_POOL_FULL &&
                  code_of(Status::kStaleHandle) == BATUTA_STALE_HANDLE &&
                  code_of(Status::kDegenerate) == BATUTA_DEGENERATE &&
                  code_of(Status::kUnavailable) == BATUTA_UNAVAILABLE,
              "the statuses of batuta/c.h are the library's");

/// Three numbers as a vector.
template <class Scalar>
Vec3<Scalar> vector_of(const Scalar* numbers) {
  return {numbers[0], numbers[1], numbers[2]};
}
/// A vector as three numbers.
template <class Scalar>
void put(const Vec3<Scalar>& v, Scalar* numbers) {
  for (int i = 0; i < 3; ++i) numbers[i] = v[i];  // Bound: 3
}

/// capsule[7] as a capsule.
template <class Scalar>
Capsule<Scalar> capsule_of(const Scalar* numbers) {
  return {{vector_of(numbers), vector_of(numbers + 3)}, numbers[6]};
}
/// A capsule as capsule[7].
template <class Scalar>
void put(const Capsule<Scalar>& capsule, Scalar* numbers) {
  put(capsule.axis.a, numbers);
  put(capsule.axis.b, numbers + 3);
  numbers[6] = capsule.radius;
}

/// pose[7] as a pose, its quaternion renewed.
/// @returns kOk | kInvalidArgument: not finite, or a quaternion of length 0
template <class Scalar>
Result<Pose<Scalar>> pose_of(const Scalar* numbers) {
  const Vec3<Scalar> p_W = vector_of(numbers);
  const Quat<Scalar> q_WB(numbers[3], numbers[4], numbers[5], numbers[6]);
  const bool good = is_finite(p_W) && is_finite(q_WB) && !q_WB.coeffs().isZero(0);
  if (!good) return failure<Pose<Scalar>>(Status::kInvalidArgument);
  return success(Pose<Scalar>{p_W, renewed(q_WB)});
}

/// twist[6] as a twist.
template <class Scalar>
Twist<Scalar> twist_from(const Scalar* numbers) {
  return {vector_of(numbers), vector_of(numbers + 3)};
}

/// moving[20] as a capsule in motion. Only the pose is looked at here: what is done with the others
/// refuses them. @returns kOk | kInvalidArgument: what pose_of() refuses
template <class Scalar>
Result<MovingCapsule<Scalar>> moving_of(const Scalar* numbers, Scalar duration) {
  const auto X_WB = pose_of(numbers + BATUTA_CAPSULE_NUMBERS);
  const Scalar* const twist = numbers + BATUTA_CAPSULE_NUMBERS + BATUTA_POSE_NUMBERS;
  MovingCapsule<Scalar> moving;
  moving.capsule_B = capsule_of(numbers);
  moving.motion = {X_WB.value, twist_from(twist), duration};
  return {X_WB.status, moving};
}
static_assert(BATUTA_CAPSULE_NUMBERS + BATUTA_POSE_NUMBERS + BATUTA_TWIST_NUMBERS ==
              BATUTA_MOVING_NUMBERS);

/// Answers one pair after the other, up to the first that is refused.
/// @param resolve  of the pair at an index: a status as C knows it
/// @returns how many were answered. Bound: count
template <class Resolve>
std::size_t answer_each(std::size_t count, Resolve resolve) {
  std::size_t i = 0;
  while (i < count && resolve(i) == BATUTA_OK) ++i;
  return i;
}

}  // namespace batuta::detail
