// SPDX-License-Identifier: MIT
#pragma once
// Boxes that should hold a moving capsule, in double whatever they were computed in, and what one
// really needs.

#include <array>
#include <cstdint>

#include "batuta/detection/swept_volume.hpp"

namespace batuta::report {

enum class Form : std::uint8_t {
  kExact,   ///< swept_aabb()
  kCoarse,  ///< coarse_swept_aabb()
  kSphere,  ///< the box of swept_sphere(), the paper's volume
  kEnds,    ///< the union of the boxes at both ends of the step: what many engines take
};
inline constexpr std::array<Form, 4> kForms = {Form::kExact, Form::kCoarse, Form::kSphere,
                                               Form::kEnds};
const char* name(Form form);

/// The library's forms are computed in float.
Aabb<double> box_of(Form form, const MovingCapsule<float>& moving);

/// Box of the capsule's places at `samples` + 1 equally spaced times, by its poses: never larger
/// than what the motion needs, and smaller by at most (turn / samples)^2 / 8 of its lever.
Aabb<double> sampled_box(const MovingCapsule<float>& moving, int samples);

/// How far `inner` sticks out of `box` at most, m; negative: it does not.
double leak(const Aabb<double>& box, const Aabb<double>& inner);

double volume(const Aabb<double>& box);

}  // namespace batuta::report
