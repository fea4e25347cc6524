// SPDX-License-Identifier: MIT
#include "rod_in_room.hpp"

#include <cmath>

#include "draws.hpp"

namespace batuta::report {

RodInRoom::RodInRoom(std::uint64_t number) {
  constexpr std::uint64_t kSeed = 77;
  constexpr double kDensity = 1000;  // kg/m^3
  constexpr double kMostTurn = 5;    // rad/s
  test::Draws draws(kSeed, 0, number);
  const Vec3<double> end(0, 0, kHalfAxis);
  const auto mass = solid_capsule(Capsule<double>{{-end, end}, kRadius}, kDensity).value;
  Pose<double> X_WB;
  X_WB.q_WB = draws.rotation();
  body_ = make_body<double>(X_WB, mass.mass, mass.inertia_S.diagonal()).value;
  Twist<double> twist;
  twist.v_W = draws.direction();
  twist.w_W = draws.in_ball(kMostTurn);
  body_.momentum = momentum_of(body_, twist);
}

RodInRoom::Ends RodInRoom::ends() const {
  return {to_world(body_.X_WB, {0, 0, kHalfAxis}), to_world(body_.X_WB, {0, 0, -kHalfAxis})};
}

/// Whether an end met one of the two walls across an axis of W.
bool RodInRoom::answer_at(const Vec3<double>& end, int axis, const Law& law) {
  const double gap = kHalfRoom - kRadius - std::abs(end[axis]);
  if (gap > 0) return false;
  const Vec3<double> inward = (end[axis] > 0 ? -1 : 1) * Vec3<double>::Unit(axis);
  const test::Strike strike{
      collider_of(body_), Collider<double>{}, {end - kRadius * inward, inward, gap}};
  if (normal_velocity(strike, {strike.A.twist, {}}) >= 0) return false;
  body_.momentum = momentum_of(body_, answer(strike, law).A);
  return true;
}

bool RodInRoom::answer_one(const Ends& ends, const Law& law) {
  for (const Vec3<double>& end : ends) {
    for (int axis = 0; axis < 3; ++axis) {
      if (answer_at(end, axis, law)) return true;
    }
  }
  return false;
}

/// No point goes further than `way`, so that it cannot pass a wall that is further off.
void RodInRoom::fly(double way) {
  const Twist<double> twist = twist_of(body_);
  const double speed = twist.v_W.norm() + (kHalfAxis + kRadius) * twist.w_W.norm();
  if (speed == 0) return;
  const auto motion = free_flight(body_, way / speed);
  body_.X_WB = pose_at(motion, motion.duration);
}

bool RodInRoom::meet(const Law& law) {
  for (int look = 0; look < kMostLooks; ++look) {  // Bound: kMostLooks
    const Ends now = ends();
    if (answer_one(now, law)) return true;
    const double furthest = max_of(now[0].cwiseAbs().maxCoeff(), now[1].cwiseAbs().maxCoeff());
    fly(max_of(kLeastWay, kHalfRoom - kRadius - furthest));
  }
  return false;
}

}  // namespace batuta::report
