// SPDX-License-Identifier: MIT
#include "law.hpp"

#include <cmath>

namespace batuta::report {

std::string name_of(int rounds) {
  return rounds == 0 ? "closed form" : "Newton " + std::to_string(rounds);
}

test::TwistPair answer(const test::Strike& strike, const Law& law) {
  if (law.rounds > 0) {
    return test::newton_contact(strike, law.friction.restitution, law.friction.friction,
                                law.rounds);
  }
  const auto hit = friction_impulse(strike.A, strike.B, strike.contact, law.friction);
  return {hit.value.twist_A, hit.value.twist_B};
}

double normal_velocity(const test::Strike& strike, const test::TwistPair& twists) {
  return relative_velocity(strike.contact, strike.A.X_WB, twists.A, strike.B.X_WB, twists.B);
}

Effect effect_of(const test::Strike& strike, const Law& law, const test::TwistPair& after) {
  const double before = normal_velocity(strike, {strike.A.twist, strike.B.twist});
  const double rebound = normal_velocity(strike, after) + law.friction.restitution * before;
  const Vec3<double> J = (after.A.v_W - strike.A.twist.v_W) / strike.A.inverse_mass;
  const double normal = J.dot(strike.contact.normal_BA_W);
  const Vec3<double> across = J - normal * strike.contact.normal_BA_W;
  return {test::relative_gain(strike, after), std::abs(rebound / before), normal, across.norm()};
}

}  // namespace batuta::report
