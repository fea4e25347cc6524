// SPDX-License-Identifier: MIT
#pragma once
// The members of a stick's and a key pose's state, for record/archive.hpp.

#include "batuta/control/keyframes.hpp"
#include "batuta/control/stick.hpp"
#include "batuta/record/detail/mechanics.hpp"

namespace batuta {

inline void archive(Archive& ar, StickSettings& settings) {
  auto& [min_interval_us, max_interval_us, stale_after_us, max_speed] = settings;
  ar(min_interval_us, max_interval_us, stale_after_us, max_speed);
}

inline void archive(Archive& ar, StickReport& report) {
  auto& [used, restarts, repeated, backward, invalid, lost, clamped, slowed, stale_steps] = report;
  ar(used, restarts, repeated, backward, invalid, lost, clamped, slowed, stale_steps);
}

template <class Scalar>
void archive(Archive& ar, KeyedPose<Scalar>& pose) {
  auto& [X_WH, jacobian] = pose;
  ar(X_WH, jacobian);
}

}  // namespace batuta
