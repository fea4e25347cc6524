// SPDX-License-Identifier: MIT
#include "rod_in_room.hpp"

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

RodInRoom::End RodInRoom::end_at(int place) const {
  const int axis = place % 3;
  const double side = place / 3 % 2 == 0 ? 1 : -1;
  const Vec3<double> c_W =
      to_world(body_.X_WB, {0, 0, place < kPlaces / 2 ? kHalfAxis : -kHalfAxis});
  End end;
  end.contact.normal_BA_W = -side * Vec3<double>::Unit(axis);
  end.contact.point_W = c_W - kRadius * end.contact.normal_BA_W;
  end.contact.gap = end.gap = kHalfRoom - side * end.contact.point_W[axis];
  return end;
}

double RodInRoom::least_gap() const {
  double least = kHalfRoom;
  for (int place = 0; place < kPlaces; ++place) least = min_of(least, end_at(place).gap);
  return least;
}

bool RodInRoom::answer_one(const Law& law) {
  for (int place = 0; place < kPlaces; ++place) {  // Bound: kPlaces
    const End end = end_at(place);
    if (end.gap > 0) continue;
    const test::Strike strike{collider_of(body_), Collider<double>{}, end.contact};
    if (normal_velocity(strike, {strike.A.twist, {}}) >= 0) continue;
    body_.momentum = momentum_of(body_, answer(strike, law).A);
    return true;
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
    if (answer_one(law)) return true;
    fly(max_of(kLeastWay, least_gap()));
  }
  return false;
}

}  // namespace batuta::report
