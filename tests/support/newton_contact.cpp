// SPDX-License-Identifier: MIT
#include "newton_contact.hpp"

#include <array>

#include "batuta/geometry/direction.hpp"
#include "batuta/mechanics/mass.hpp"
#include "draws.hpp"

namespace batuta::test {

namespace {

using V = Vec3<double>;

struct Shape {
  double half = 0;
  double radius = 0;
};

/// A body whose place is still to be found, with its axis along z of its own frame.
Shape random_body(Draws& draws, Collider<double>& body) {
  Shape shape;
  shape.radius = draws.between(0.01, 0.1);
  shape.half = shape.radius * draws.between(0, 20);
  const Capsule<double> capsule{{V(0, 0, -shape.half), V(0, 0, shape.half)}, shape.radius};
  const auto mass = solid_capsule(capsule, draws.between(500, 8000)).value;
  body.X_WB.q_WB = draws.rotation();
  body.inverse_mass = 1 / mass.mass;
  body.inverse_moments = mass.inertia_S.diagonal().cwiseInverse();
  body.twist.v_W = draws.in_ball(3);
  body.twist.w_W = draws.in_ball(10);
  return shape;
}

/// Puts the body where a random place of its side, with outward normal -away, is at the origin.
void place(Draws& draws, const Shape& shape, const V& away, Collider<double>& body) {
  const V axis = detail::to_matrix(body.X_WB.q_WB).col(2);
  V side = away - away.dot(axis) * axis;
  const double along = shape.half * draws.signed_unit();
  body.X_WB.p_W = shape.radius * side.normalized() + along * axis;
}

/// A direction that is perpendicular to both axes: the normal of two sides that touch.
V common_normal(const Collider<double>& A, const Collider<double>& B) {
  return detail::to_matrix(A.X_WB.q_WB)
      .col(2)
      .cross(detail::to_matrix(B.X_WB.q_WB).col(2))
      .normalized();
}

/// One scalar constraint: an impulse along d on A and -d on B.
struct Row {
  V d;
  double k = 0;
  double total = 0;
};

V turned(const Collider<double>& body, const V& torque) {
  const Mat3<double> R = detail::to_matrix(body.X_WB.q_WB);
  return R * body.inverse_moments.cwiseProduct(R.transpose() * torque);
}

V point_velocity(const Strike& strike, const TwistPair& twists) {
  return velocity_at(strike.A.X_WB, twists.A, strike.contact.point_W) -
         velocity_at(strike.B.X_WB, twists.B, strike.contact.point_W);
}

void apply(const Strike& strike, const V& J, TwistPair& twists) {
  const V& p = strike.contact.point_W;
  twists.A.v_W += strike.A.inverse_mass * J;
  twists.A.w_W += turned(strike.A, (p - strike.A.X_WB.p_W).cross(J));
  twists.B.v_W -= strike.B.inverse_mass * J;
  twists.B.w_W -= turned(strike.B, (p - strike.B.X_WB.p_W).cross(J));
}

Row row_along(const Strike& strike, const V& d) {
  TwistPair unit;
  apply(strike, d, unit);
  return {d, d.dot(point_velocity(strike, unit)), 0};
}

void solve(const Strike& strike, double target, double low, double high, Row& row,
           TwistPair& twists) {
  const double wanted = row.total + (target - row.d.dot(point_velocity(strike, twists))) / row.k;
  const double total = clamp(wanted, low, high);
  apply(strike, (total - row.total) * row.d, twists);
  row.total = total;
}

bool collides(const Strike& strike) {
  return strike.contact.normal_BA_W.dot(point_velocity(strike, {strike.A.twist, strike.B.twist})) <
         0;
}

/// @param answer  gives the twists after
template <class Answer>
EnergyTally tally(int count, std::uint64_t seed, const Answer& answer) {
  EnergyTally result;
  result.worst_gain = -1;
  for (int i = 0; i < count; ++i) {  // Bound: count
    const Strike strike = random_strike(seed, static_cast<std::uint64_t>(i));
    if (!collides(strike)) continue;
    const double gain = relative_gain(strike, answer(strike));
    ++result.cases;
    if (gain > kGain) ++result.gains;
    result.worst_gain = max_of(result.worst_gain, gain);
  }
  return result;
}

}  // namespace

Strike random_strike(std::uint64_t seed, std::uint64_t index) {
  Draws draws(seed, 0, index);
  Strike strike;
  const Shape shape_A = random_body(draws, strike.A);
  const Shape shape_B = random_body(draws, strike.B);
  const V n = common_normal(strike.A, strike.B);
  strike.contact = {V::Zero(), n, 0};
  place(draws, shape_A, n, strike.A);
  place(draws, shape_B, -n, strike.B);
  return strike;
}

TwistPair newton_contact(const Strike& strike, double restitution, double friction, int rounds) {
  const V& n = strike.contact.normal_BA_W;
  const V t = detail::perpendicular(n);
  TwistPair twists{strike.A.twist, strike.B.twist};
  Row normal = row_along(strike, n);
  std::array<Row, 2> tangents{row_along(strike, t), row_along(strike, n.cross(t))};
  const double target = -restitution * n.dot(point_velocity(strike, twists));
  for (int round = 0; round < rounds; ++round) {  // Bound: rounds
    solve(strike, target, 0, std::numeric_limits<double>::max(), normal, twists);
    const double most = friction * normal.total;
    for (Row& row : tangents) solve(strike, 0, -most, most, row, twists);
  }
  return twists;
}

double kinetic_energy(const Collider<double>& body, const Twist<double>& twist) {
  const V w_B = detail::to_matrix(body.X_WB.q_WB).transpose() * twist.w_W;
  double twice = body.inverse_mass > 0 ? twist.v_W.squaredNorm() / body.inverse_mass : 0;
  for (int i = 0; i < 3; ++i) {
    if (body.inverse_moments[i] > 0) twice += w_B[i] * w_B[i] / body.inverse_moments[i];
  }
  return twice / 2;
}

double relative_gain(const Strike& strike, const TwistPair& after) {
  const double before =
      kinetic_energy(strike.A, strike.A.twist) + kinetic_energy(strike.B, strike.B.twist);
  return (kinetic_energy(strike.A, after.A) + kinetic_energy(strike.B, after.B)) / before - 1;
}

EnergyTally tally_newton(double restitution, double friction, int rounds, int count,
                         std::uint64_t seed) {
  return tally(count, seed, [&](const Strike& strike) {
    return newton_contact(strike, restitution, friction, rounds);
  });
}

EnergyTally tally_closed_form(const FrictionLaw<double>& law, int count, std::uint64_t seed) {
  return tally(count, seed, [&](const Strike& strike) {
    const auto hit = friction_impulse(strike.A, strike.B, strike.contact, law);
    return TwistPair{hit.value.twist_A, hit.value.twist_B};
  });
}

}  // namespace batuta::test
