// SPDX-License-Identifier: MIT
#pragma once
// The members of the state of room geometry, for record/archive.hpp. In a header of their own, so
// that who saves nothing compiles nothing of it.

#include "batuta/geometry/capsule.hpp"
#include "batuta/geometry/kdop.hpp"
#include "batuta/record/archive.hpp"

namespace batuta {

template <class Scalar>
void archive(Archive& ar, Segment<Scalar>& segment) {
  auto& [a, b] = segment;
  ar(a, b);
}

template <class Scalar>
void archive(Archive& ar, Capsule<Scalar>& capsule) {
  auto& [axis, radius] = capsule;
  ar(axis, radius);
}

template <class Scalar, int K>
void archive(Archive& ar, Kdop<Scalar, K>& kdop) {
  auto& [low, high] = kdop;
  ar(low, high);
}

}  // namespace batuta
