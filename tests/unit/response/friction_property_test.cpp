// SPDX-License-Identifier: MIT
// The closed form against the law with its 3x3 inverse in long double, and against the laws of
// conservation, over masses and moments of very different size. Bounds: src/response/friction.md.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "draws.hpp"
#include "friction_truth.hpp"

namespace batuta {
namespace {

using exact::Real;
using exact::RealVec;
using V = Vec3<double>;

constexpr int kCases = 100'000;  // I09

template <class Scalar>
struct Case {
  Collider<Scalar> A;
  Collider<Scalar> B;
  Contact<Scalar> contact;
  FrictionLaw<Scalar> law;
};

/// Masses 2^-range ... 2^range kg, moments unequal by up to 2^moment_range.
template <class Scalar>
Collider<Scalar> wild_body(test::Draws& draws, int mass_range, int moment_range) {
  Collider<Scalar> body;
  body.X_WB.p_W = draws.in_ball(1).cast<Scalar>();
  body.X_WB.q_WB = draws.rotation().cast<Scalar>();
  body.twist.v_W = draws.in_ball(2).cast<Scalar>();
  body.twist.w_W = draws.in_ball(2).cast<Scalar>();
  body.inverse_mass = static_cast<Scalar>(draws.power_of_two(-mass_range, mass_range + 1));
  for (int i = 0; i < 3; ++i) {
    body.inverse_moments[i] =
        body.inverse_mass * static_cast<Scalar>(draws.power_of_two(0, moment_range + 1));
  }
  return body;
}

/// Takes some of the body's freedom: a hinge, a ball joint, a slider. What cannot move is at rest.
template <class Scalar>
void hold(test::Draws& draws, Collider<Scalar>& body) {
  if (draws.chance(0.5)) {
    body.inverse_mass = 0;
    body.twist.v_W.setZero();
  }
  const Mat3<Scalar> R = detail::to_matrix(body.X_WB.q_WB);
  Vec3<Scalar> w_B = R.transpose() * body.twist.w_W;
  for (int i = 0; i < 3; ++i) {
    if (!draws.chance(0.3)) continue;
    body.inverse_moments[i] = 0;
    w_B[i] = 0;
  }
  body.twist.w_W = R * w_B;
}

template <class Scalar>
Case<Scalar> wild_case(int index, int mass_range, int moment_range) {
  test::Draws draws(20, static_cast<std::uint64_t>(mass_range), static_cast<std::uint64_t>(index));
  Case<Scalar> c;
  c.A = wild_body<Scalar>(draws, mass_range, moment_range);
  c.B = wild_body<Scalar>(draws, mass_range, moment_range);
  c.contact = {draws.in_ball(1).cast<Scalar>(), draws.direction().cast<Scalar>(), Scalar(0)};
  constexpr std::array<double, 4> kFrictions{0, 0.1, 0.5, 1e6};
  const double mu = kFrictions[static_cast<std::size_t>(4 * draws.unit())];
  const double e = draws.chance(0.3) ? 1 : draws.unit();
  const double e_t = draws.chance(0.3) ? 1 : draws.signed_unit();
  c.law = {static_cast<Scalar>(e), static_cast<Scalar>(mu), static_cast<Scalar>(e_t)};
  return c;
}

/// Sum of |momentum| |velocity| of a body, and what the blow adds: what its energy is rounded by.
template <class Scalar>
Real energy_terms(const Collider<Scalar>& body, const Twist<Scalar>& after,
                  const Momentum<Scalar>& blow) {
  const auto real = [](const Vec3<Scalar>& v) { return Real(v.template cast<Real>().norm()); };
  const Real v = std::max(real(body.twist.v_W), real(after.v_W));
  const Real w = std::max(real(body.twist.w_W), real(after.w_W));
  const Real mass = body.inverse_mass > 0 ? 1 / Real(body.inverse_mass) : 0;
  Real moment = 0;
  for (int i = 0; i < 3; ++i) {
    if (body.inverse_moments[i] > 0) moment = std::max(moment, 1 / Real(body.inverse_moments[i]));
  }
  return mass * v * v + moment * w * w + v * real(blow.linear_W) + w * real(blow.angular_W);
}

template <class Scalar>
class FrictionLawOf : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(FrictionLawOf, Scalars);

/// Largest of the ratios seen.
struct Worst {
  Real ratio = 0;
  void see(Real error, Real bound) { ratio = std::max(ratio, error / bound); }
};

TYPED_TEST(FrictionLawOf, Always_AgreesWithTheMatrixForm) {
  constexpr Real kU = Real(kRoundOff<TypeParam>);
  Worst impulse;
  Worst normal;
  int stuck = 0;
  int slid = 0;
  for (int i = 0; i < kCases / 4; ++i) {
    const auto c = wild_case<TypeParam>(i, 4, 6);
    const auto hit = friction_impulse(c.A, c.B, c.contact, c.law);
    ASSERT_TRUE(hit.ok());
    if (hit.value.magnitude == TypeParam(0)) continue;
    const auto truth = exact::friction_truth(c.A, c.B, c.contact, c.law);
    ++(truth.sticks ? stuck : slid);
    const Eigen::SelfAdjointEigenSolver<exact::RealMat> eigen(truth.K, Eigen::EigenvaluesOnly);
    const Real low = eigen.eigenvalues()[0];
    const Real high = eigen.eigenvalues()[2];
    const Real speed = Real(c.A.twist.v_W.norm() + c.A.twist.w_W.norm() * 2) +
                       Real(c.B.twist.v_W.norm() + c.B.twist.w_W.norm() * 2);
    const RealVec J = hit.value.on_A.linear_W.template cast<Real>();
    impulse.see((J - truth.J).norm(), kU * (high / low) * (high / low) * speed / low);
    const RealVec n = c.contact.normal_BA_W.template cast<Real>();
    const RealVec after = exact::velocity(c.A, hit.value.twist_A, c.contact) -
                          exact::velocity(c.B, hit.value.twist_B, c.contact);
    const Real wanted = -Real(c.law.restitution) * n.dot(truth.v0);
    normal.see(std::abs(n.dot(after) - wanted),
               kU * (speed + high * truth.J.norm() + high * speed / low));
  }
  EXPECT_GT(stuck, kCases / 50);
  EXPECT_GT(slid, kCases / 50);
  EXPECT_LE(impulse.ratio, 32);
  EXPECT_LE(normal.ratio, 4);
}

TYPED_TEST(FrictionLawOf, Always_ConservesAndNeverGains) {  // I06, I09
  constexpr Real kU = Real(kRoundOff<TypeParam>);
  Worst gain;
  Worst turning;
  Worst cone;
  Worst twist;
  int collided = 0;
  for (int i = 0; i < kCases; ++i) {
    auto c = wild_case<TypeParam>(i, 15, 20);
    test::Draws draws(21, 0, static_cast<std::uint64_t>(i));
    if (i % 2 == 0) hold(draws, c.A);
    if (i % 4 == 0) hold(draws, c.B);
    const auto hit = friction_impulse(c.A, c.B, c.contact, c.law);
    ASSERT_TRUE(hit.ok());
    if (hit.value.magnitude == TypeParam(0)) continue;
    ++collided;
    const auto& on_A = hit.value.on_A;
    const auto& on_B = hit.value.on_B;
    EXPECT_EQ(on_A.linear_W, -on_B.linear_W);
    const RealVec J = on_A.linear_W.template cast<Real>();
    const RealVec about_origin =
        c.A.X_WB.p_W.template cast<Real>().cross(J) + on_A.angular_W.template cast<Real>() -
        c.B.X_WB.p_W.template cast<Real>().cross(J) + on_B.angular_W.template cast<Real>();
    turning.see(about_origin.norm(), kU * J.norm() * 2);
    const RealVec n = c.contact.normal_BA_W.template cast<Real>();
    const Real mu = Real(c.law.friction);
    const Real excess = (J - n.dot(J) * n).norm() - mu * Real(hit.value.magnitude);
    const auto plain = collision_impulse(c.A, c.B, c.contact, c.law.restitution);
    cone.see(excess, kU * (1 + mu) * (J.norm() + Real(plain.value.magnitude)));
    const Real before =
        exact::kinetic_energy(c.A, c.A.twist) + exact::kinetic_energy(c.B, c.B.twist);
    const Real after = exact::kinetic_energy(c.A, hit.value.twist_A) +
                       exact::kinetic_energy(c.B, hit.value.twist_B);
    gain.see(after - before, kU * (energy_terms(c.A, hit.value.twist_A, on_A) +
                                   energy_terms(c.B, hit.value.twist_B, on_B)));
    const RealVec turn = exact::inverse_inertia(c.A) * on_A.angular_W.template cast<Real>();
    const RealVec done = (hit.value.twist_A.w_W - c.A.twist.w_W).template cast<Real>();
    twist.see((turn - done).norm(),
              kU * (Real(c.A.inverse_moments.maxCoeff()) * 2 * J.norm() +
                    Real(hit.value.twist_A.w_W.norm()) + Real(c.A.twist.w_W.norm())));
  }
  EXPECT_GT(collided, kCases / 3);
  EXPECT_LE(gain.ratio, 4);
  EXPECT_LE(turning.ratio, 4);
  EXPECT_LE(cone.ratio, 8);
  EXPECT_LE(twist.ratio, 4);
}

}  // namespace
}  // namespace batuta
