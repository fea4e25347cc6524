// SPDX-License-Identifier: MIT
#pragma once
// One body about to meet the fixed floor z = 0 at the origin. Frame W, z up.

#include <cmath>

#include "batuta/mechanics/mass.hpp"
#include "newton_contact.hpp"

namespace batuta::report {

/// A solid body of mass 1 whose lower end is at the origin.
/// @param lean  angle from the upright towards -x, rad
inline Collider<double> rod_on_floor(double lean, double half, double radius) {
  const Vec3<double> end(0, 0, half);
  const auto mass = solid_capsule(Capsule<double>{{-end, end}, radius}, 1.0).value;
  Collider<double> body;
  body.X_WB.q_WB = {std::cos(lean / 2), 0, -std::sin(lean / 2), 0};
  body.X_WB.p_W = {-half * std::sin(lean), 0, half * std::cos(lean) + radius};
  body.inverse_mass = 1;
  body.inverse_moments = mass.mass * mass.inertia_S.diagonal().cwiseInverse();
  return body;
}

/// @pre a body that approaches the floor at the origin
inline test::Strike strike_on_floor(const Collider<double>& body) {
  return {body, Collider<double>{}, {Vec3<double>::Zero(), Vec3<double>::UnitZ(), 0}};
}

}  // namespace batuta::report
