// SPDX-License-Identifier: MIT
#pragma once
// How a free rigid body turns, by Euler's equations J w' = (J w) x w, q' = q w / 2, integrated in
// long double by the classic method of Runge and Kutta. It shares no formula with
// src/mechanics/motion.cpp. Frame B: principal axes.

#include "batuta/core/types.hpp"

namespace batuta::report {

using Wide = long double;

struct Spin {
  Quat<Wide> q_WB = Quat<Wide>::Identity();
  Vec3<Wide> w_B = Vec3<Wide>::Zero();  ///< rad/s
};

/// @param moments  kg m^2, > 0
/// @param steps    equal ones, >= 1
Spin turned_by_euler(Spin spin, const Vec3<Wide>& moments, Wide duration, long steps);

}  // namespace batuta::report
