// SPDX-License-Identifier: MIT
#include "batuta/response/friction.hpp"

#include <gtest/gtest.h>

#include <cstring>

#include "newton_contact.hpp"

namespace batuta {
namespace {

using V = Vec3<double>;
const V kO = V::Zero();
const V kUp = V::UnitZ();

template <class Scalar>
Contact<Scalar> floor_contact() {
  return {Vec3<Scalar>::Zero(), Vec3<Scalar>::UnitZ(), Scalar(0)};
}

/// A solid ball of radius 1 and mass 1 on the floor z = 0: K is 1 along n and 7/2 across.
template <class Scalar = double>
Collider<Scalar> ball(const V& v, const V& w = kO) {
  Collider<Scalar> body;
  body.X_WB.p_W = Vec3<Scalar>::UnitZ();
  body.twist = {v.cast<Scalar>(), w.cast<Scalar>()};
  body.inverse_mass = 1;
  body.inverse_moments = Vec3<Scalar>::Constant(Scalar(2.5));
  return body;
}
template <class Scalar = double>
Collider<Scalar> fixed() {
  return {};
}

template <class Scalar>
bool same_bits(const Vec3<Scalar>& a, const Vec3<Scalar>& b) {
  return std::memcmp(a.data(), b.data(), 3 * sizeof(Scalar)) == 0;
}
template <class Scalar>
bool same_bits(const Impulse<Scalar>& a, const Impulse<Scalar>& b) {
  return std::memcmp(&a.magnitude, &b.magnitude, sizeof(Scalar)) == 0 &&
         same_bits(a.on_A.linear_W, b.on_A.linear_W) &&
         same_bits(a.on_A.angular_W, b.on_A.angular_W) &&
         same_bits(a.on_B.linear_W, b.on_B.linear_W) &&
         same_bits(a.on_B.angular_W, b.on_B.angular_W) && same_bits(a.twist_A.v_W, b.twist_A.v_W) &&
         same_bits(a.twist_A.w_W, b.twist_A.w_W) && same_bits(a.twist_B.v_W, b.twist_B.v_W) &&
         same_bits(a.twist_B.w_W, b.twist_B.w_W);
}

V point_velocity(const test::Strike& strike, const Impulse<double>& hit) {
  return velocity_at(strike.A.X_WB, hit.twist_A, strike.contact.point_W) -
         velocity_at(strike.B.X_WB, hit.twist_B, strike.contact.point_W);
}
V across(const V& v, const V& n) {
  return v - v.dot(n) * n;
}

TEST(Friction, BallOnWall_SlidesOppositeToItsSlip) {  // I08 mu = .5
  const auto hit =
      friction_impulse(ball({6, 8, -1}), fixed(), floor_contact<double>(), {1.0, 0.5, 0.0});
  ASSERT_TRUE(hit.ok());
  EXPECT_DOUBLE_EQ(hit.value.magnitude, 2);
  EXPECT_LE((hit.value.on_A.linear_W - V(-0.6, -0.8, 2)).norm(), 1e-15);
  EXPECT_LE((hit.value.twist_A.v_W - V(5.4, 7.2, 1)).norm(), 4e-15);
  EXPECT_LE((hit.value.twist_A.w_W - 2.5 * V(-0.8, 0.6, 0)).norm(), 1e-15);
}

TEST(Friction, BallOnWall_SticksAndRollsOn) {
  const auto hit =
      friction_impulse(ball({0.7, 0, -1}), fixed(), floor_contact<double>(), {1.0, 0.5, 0.0});
  // 2/7 of the slip's momentum: the ball keeps 5/7 of its speed and rolls.
  EXPECT_LE((hit.value.on_A.linear_W - V(-0.2, 0, 2)).norm(), 1e-15);
  EXPECT_LE((hit.value.twist_A.v_W - V(0.5, 0, 1)).norm(), 1e-15);
  EXPECT_LE((hit.value.twist_A.w_W - V(0, 0.5, 0)).norm(), 1e-15);
}

TEST(Friction, RubberBall_TurnsItsSlipRound) {  // I08: slip reversal
  const auto hit =
      friction_impulse(ball({0.7, -0.35, -1}), fixed(), floor_contact<double>(), {1.0, 1e6, 1.0});
  const V slip = velocity_at({kUp, Quat<double>::Identity()}, hit.value.twist_A, kO);
  EXPECT_LE((slip - V(-0.7, 0.35, 1)).norm(), 2e-15);
  // Elastic in all three directions.
  const auto A = ball({0.7, -0.35, -1});
  EXPECT_NEAR(test::kinetic_energy(A, hit.value.twist_A), test::kinetic_energy(A, A.twist), 1e-15);
}

TEST(Friction, ContactAtRest_SlidesWithinTheCone) {
  for (const double v_n : {1e-3, 1e-9, 1e-30}) {
    const auto hit =
        friction_impulse(ball({10, 0, -v_n}), fixed(), floor_contact<double>(), {0.0, 0.3, 0.0});
    ASSERT_TRUE(hit.ok());
    EXPECT_NEAR(hit.value.magnitude, v_n, 1e-15 * v_n);
    EXPECT_NEAR(hit.value.on_A.linear_W.x(), -0.3 * v_n, 1e-15 * v_n);
    EXPECT_EQ(hit.value.twist_A.v_W.z(), 0);
  }
}

TEST(Friction, Sticking_StopsTheSlip) {
  int stuck = 0;
  for (std::uint64_t i = 0; i < 2000; ++i) {
    const test::Strike strike = test::random_strike(3, i);
    const V& n = strike.contact.normal_BA_W;
    const auto hit = friction_impulse(strike.A, strike.B, strike.contact, {0.0, 1e6, 0.0});
    if (hit.value.magnitude == 0) continue;
    if (across(hit.value.on_A.linear_W, n).norm() > 0.99e6 * hit.value.magnitude) continue;
    ++stuck;
    EXPECT_LE(point_velocity(strike, hit.value).norm(), 1e-12);
  }
  EXPECT_GT(stuck, 600);
}

TEST(Friction, MuToInfinity_IsALimit) {
  for (std::uint64_t i = 0; i < 300; ++i) {
    const test::Strike strike = test::random_strike(4, i);
    const auto high = friction_impulse(strike.A, strike.B, strike.contact, {0.3, 1e9, 0.2});
    const auto most = friction_impulse(strike.A, strike.B, strike.contact,
                                       {0.3, std::numeric_limits<double>::max(), 0.2});
    ASSERT_TRUE(high.ok() && most.ok());
    EXPECT_LE((high.value.on_A.linear_W - most.value.on_A.linear_W).norm(),
              1e-6 * most.value.on_A.linear_W.norm());
  }
}

template <class Scalar>
class FrictionOf : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(FrictionOf, Scalars);

TYPED_TEST(FrictionOf, NoFriction_IsThePapersImpulseToTheLastBit) {  // I08 mu = 0
  for (const V& v : {V(1, 2, -3), V(1, 0, 3), V(0, 0, -1e-12)}) {
    const auto A = ball<TypeParam>(v, {1, 2, 3});
    const auto hit = friction_impulse<TypeParam>(A, fixed<TypeParam>(), floor_contact<TypeParam>(),
                                                 {TypeParam(0.3), 0, TypeParam(0.5)});
    const auto plain = collision_impulse<TypeParam>(A, fixed<TypeParam>(),
                                                    floor_contact<TypeParam>(), TypeParam(0.3));
    EXPECT_TRUE(same_bits(hit.value, plain.value));
  }
}

TYPED_TEST(FrictionOf, HeadOn_ExchangesVelocities) {  // I01, I02: no slip, no friction
  for (const TypeParam e : {TypeParam(0), TypeParam(1)}) {
    auto B = ball<TypeParam>({0, 0, 1});
    B.X_WB.p_W = -Vec3<TypeParam>::UnitZ();
    const auto A = ball<TypeParam>({0, 0, -3});
    const auto hit = friction_impulse<TypeParam>(A, B, floor_contact<TypeParam>(), {e, 1, 0});
    EXPECT_EQ(hit.value.twist_A.v_W.z(), -1 + 2 * e);
    EXPECT_EQ(hit.value.twist_B.v_W.z(), -1 - 2 * e);
    EXPECT_EQ(hit.value.twist_A.w_W.norm(), TypeParam(0));
  }
}

TYPED_TEST(FrictionOf, RecedingOrImmovable_ChangesNothing) {  // I05, I12
  const auto away = ball<TypeParam>({3, 0, 1}, {1, 2, 3});
  auto dragged = fixed<TypeParam>();
  dragged.twist.v_W = Vec3<TypeParam>(5, 0, -1);
  for (const auto& A : {away, dragged}) {
    const auto hit = friction_impulse<TypeParam>(A, fixed<TypeParam>(), floor_contact<TypeParam>(),
                                                 {TypeParam(0.5), TypeParam(0.5), 0});
    ASSERT_TRUE(hit.ok());
    EXPECT_EQ(hit.value.magnitude, TypeParam(0));
    EXPECT_TRUE(same_bits(hit.value.twist_A.v_W, A.twist.v_W));
    EXPECT_TRUE(same_bits(hit.value.twist_A.w_W, A.twist.w_W));
    EXPECT_EQ(hit.value.on_A.linear_W.norm(), TypeParam(0));
  }
}

TYPED_TEST(FrictionOf, MovingBelt_DragsAlong) {  // I05: infinite mass that moves
  auto belt = fixed<TypeParam>();
  belt.twist.v_W = Vec3<TypeParam>(2, 0, 0);
  const auto hit = friction_impulse<TypeParam>(ball<TypeParam>({0, 0, -1}), belt,
                                               floor_contact<TypeParam>(), {0, TypeParam(0.25), 0});
  EXPECT_NEAR(static_cast<double>(hit.value.twist_A.v_W.x()), 0.25, 1e-6);
  EXPECT_TRUE(same_bits(hit.value.twist_B.v_W, belt.twist.v_W));
}

TYPED_TEST(FrictionOf, Hinge_TakesNoImpulseWhereNothingGives) {  // I03: K of rank one
  for (int axis = 0; axis < 3; ++axis) {
    Collider<TypeParam> door;
    door.X_WB.p_W = Vec3<TypeParam>(TypeParam(-0.7), TypeParam(0.4), TypeParam(0.3));
    door.X_WB.q_WB = exp_map<TypeParam>({TypeParam(0.3), TypeParam(-0.5), TypeParam(0.2)});
    door.inverse_moments[axis] = 2;
    door.twist.w_W = detail::to_matrix(door.X_WB.q_WB).col(axis);
    auto contact = floor_contact<TypeParam>();
    const TypeParam rate = relative_velocity(contact, door.X_WB, door.twist, {}, {});
    if (rate > TypeParam(0)) door.twist.w_W = -door.twist.w_W;
    const auto hit = friction_impulse<TypeParam>(door, fixed<TypeParam>(), contact,
                                                 {TypeParam(0.5), TypeParam(1e6), 1});
    const auto plain =
        collision_impulse<TypeParam>(door, fixed<TypeParam>(), contact, TypeParam(0.5));
    ASSERT_GT(plain.value.magnitude, TypeParam(0));
    EXPECT_TRUE(same_bits(hit.value, plain.value)) << axis;
  }
}

TYPED_TEST(FrictionOf, BallJoint_StopsWhateverCanMove) {  // I03: K of rank two, K r = 0
  for (const V& r : {V(1, 0, 0), V(0, 1, 0), V(0.6, 0.8, 0), V(0.6, 0, 0.8)}) {
    Collider<TypeParam> joint;
    joint.X_WB.p_W = -r.cast<TypeParam>();
    joint.inverse_moments = Vec3<TypeParam>(1, 2, 3);
    joint.twist.w_W = Vec3<TypeParam>(1, 1, 1);
    auto contact = floor_contact<TypeParam>();
    if (relative_velocity(contact, joint.X_WB, joint.twist, {}, {}) > TypeParam(0)) {
      joint.twist.w_W = -joint.twist.w_W;
    }
    const auto hit =
        friction_impulse<TypeParam>(joint, fixed<TypeParam>(), contact, {0, TypeParam(1e6), 0});
    ASSERT_GT(hit.value.magnitude, TypeParam(0));
    const auto v = velocity_at(joint.X_WB, hit.value.twist_A, contact.point_W);
    EXPECT_LE(v.norm(), 32 * kRoundOff<TypeParam>);
  }
}

/// A rod of length 2 that stands on its lower end and leans by the given sine.
template <class Scalar>
Collider<Scalar> leaning_rod(double sine, const V& v, const V& w) {
  Collider<Scalar> rod = ball<Scalar>(v, w);
  rod.X_WB.p_W = V(-sine, 0, std::sqrt(1 - sine * sine)).cast<Scalar>();
  rod.inverse_moments = Vec3<Scalar>(3, 3, 3000);
  return rod;
}

TYPED_TEST(FrictionOf, PainlevesRod_NeverGains) {  // I10
  constexpr double kU = static_cast<double>(kRoundOff<TypeParam>);
  for (const double sine : {0.1, 0.3, 0.5, 0.6, 0.8, 0.99}) {
    for (const double spin : {-20.0, -1.0, 0.0, 1.0, 20.0}) {
      for (const double mu : {0.5, 2.0, 10.0}) {
        for (const double e_t : {-1.0, 0.0, 1.0}) {
          const auto rod = leaning_rod<TypeParam>(sine, {3, 0.1, -30}, {0, spin, 0.5});
          const auto hit = friction_impulse<TypeParam>(
              rod, fixed<TypeParam>(), floor_contact<TypeParam>(),
              {1, static_cast<TypeParam>(mu), static_cast<TypeParam>(e_t)});
          ASSERT_TRUE(hit.ok());
          const auto energy = [&](const Twist<TypeParam>& twist) {
            auto exact = leaning_rod<double>(sine, kO, kO);
            exact.inverse_moments = rod.inverse_moments.template cast<double>();
            return test::kinetic_energy(
                exact, {twist.v_W.template cast<double>(), twist.w_W.template cast<double>()});
          };
          EXPECT_LE(energy(hit.value.twist_A), energy(rod.twist) * (1 + 16 * kU));
        }
      }
    }
  }
}

TYPED_TEST(FrictionOf, BadInput_IsRefused) {
  constexpr TypeParam kNan = std::numeric_limits<TypeParam>::quiet_NaN();
  constexpr TypeParam kInfinity = std::numeric_limits<TypeParam>::infinity();
  const auto A = ball<TypeParam>({1, 0, -1});
  const auto contact = floor_contact<TypeParam>();
  const auto refused = [&](const Collider<TypeParam>& body, const FrictionLaw<TypeParam>& law) {
    return !friction_impulse(body, fixed<TypeParam>(), contact, law).ok();
  };
  const TypeParam half(0.5);
  EXPECT_FALSE(refused(A, {half, half, half}));
  for (const TypeParam bad : {TypeParam(-0.1), kNan, kInfinity}) {
    EXPECT_TRUE(refused(A, {half, bad, half}));
    EXPECT_TRUE(refused(A, {bad, half, half}));
  }
  for (const TypeParam bad : {TypeParam(-1.1), TypeParam(1.1), kNan}) {
    EXPECT_TRUE(refused(A, {half, half, bad}));
    EXPECT_TRUE(refused(A, {half, TypeParam(0), bad}));
  }
  auto body = A;
  body.twist.v_W.x() = kInfinity;
  EXPECT_TRUE(refused(body, {half, half, half}));
  body = A;  // finite, but what comes of it is not
  body.twist.v_W.x() = std::numeric_limits<TypeParam>::max();
  body.inverse_mass = std::numeric_limits<TypeParam>::min();
  body.inverse_moments.setZero();
  EXPECT_TRUE(refused(body, {half, std::numeric_limits<TypeParam>::max(), half}));
}

/// Plastic and without friction: what slides goes on sliding.
TYPED_TEST(FrictionOf, LawThatNobodyChose_TakesTheNormalVelocityAndNothingElse) {
  const auto A = ball<TypeParam>({3, 4, -2}, {1, 2, 3});
  const auto hit =
      friction_impulse<TypeParam>(A, fixed<TypeParam>(), floor_contact<TypeParam>(), {});
  ASSERT_TRUE(hit.ok());
  EXPECT_EQ(hit.value.twist_A.v_W, (Vec3<TypeParam>(3, 4, 0)));
  EXPECT_EQ(hit.value.twist_A.w_W, A.twist.w_W);
  const FrictionLaw<TypeParam> rough{0, TypeParam(1e6)};
  const auto stuck =
      friction_impulse<TypeParam>(A, fixed<TypeParam>(), floor_contact<TypeParam>(), rough);
  const Vec3<TypeParam> at = Vec3<TypeParam>::Zero();
  const Vec3<TypeParam> slip = velocity_at(A.X_WB, stuck.value.twist_A, at);
  // Stopped, not turned round; 16 u of speeds up to 8.
  EXPECT_LE(slip.norm(), 16 * 8 * kRoundOff<TypeParam>);
}

/// Lengths a power of two as large, at the same velocities of points: mass, moments and impulses
/// are whole powers of two as large, and nothing is rounded otherwise. Down to rods of 2 um, whose
/// impulses have no squares in float.
TYPED_TEST(FrictionOf, OtherSize_HasTheSameVelocities) {
  using S = TypeParam;
  const auto struck = [](S size) {
    Collider<S> rod;
    rod.X_WB.p_W = size * Vec3<S>(0, 0, S(0.01));
    rod.twist.v_W = {S(5e-6), S(3e-6), S(-0.02)};
    rod.twist.w_W = Vec3<S>(S(0.001), S(-0.002), S(0.003)) / size;
    const S mass = 5 * size * size * size;
    rod.inverse_mass = 1 / mass;
    rod.inverse_moments = Vec3<S>(S(4e3), S(2.5), S(2.5)) / (mass * size * size);
    const Collider<S> floor;
    Contact<S> contact = floor_contact<S>();
    contact.point_W = size * Vec3<S>(S(0.25), 0, 0);
    const auto hit = friction_impulse<S>(rod, floor, contact, {1, S(0.5), 0});
    EXPECT_EQ(hit.status, Status::kOk);
    Twist<S> twist = hit.value.twist_A;
    twist.w_W *= size;
    return twist;
  };
  const Twist<S> truth = struck(1);
  for (int k = 1; k <= 20; ++k) {
    const Twist<S> scaled = struck(std::ldexp(S(1), -k));
    EXPECT_EQ(scaled.v_W, truth.v_W) << k;
    EXPECT_EQ(scaled.w_W, truth.w_W) << k;
  }
}

}  // namespace
}  // namespace batuta
