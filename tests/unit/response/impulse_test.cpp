// SPDX-License-Identifier: MIT
#include "batuta/response/impulse.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace batuta {
namespace {

using V = Vec3<double>;

template <class Scalar = double>
Collider<Scalar> collider(const V& c, const V& v, double inverse_mass, const V& inverse_moments,
                          const V& w = V::Zero()) {
  Collider<Scalar> body;
  body.X_WB.p_W = c.cast<Scalar>();
  body.twist = {v.cast<Scalar>(), w.cast<Scalar>()};
  body.inverse_mass = static_cast<Scalar>(inverse_mass);
  body.inverse_moments = inverse_moments.cast<Scalar>();
  return body;
}

template <class Scalar = double>
Contact<Scalar> at(const V& point, const V& normal_BA) {
  return {point.cast<Scalar>(), normal_BA.cast<Scalar>(), Scalar(0)};
}

const V kSoft(1, 1, 1);
const V kO = V::Zero();

TEST(Impulse, EqualMassesHeadOn_ExchangeVelocities) {  // I01
  const auto A = collider({-1, 0, 0}, {3, 0, 0}, 0.5, kSoft);
  const auto B = collider({1, 0, 0}, {-1, 0, 0}, 0.5, kSoft);
  const auto hit = collision_impulse(A, B, at(kO, {-1, 0, 0}), 1.0);
  ASSERT_TRUE(hit.ok());
  EXPECT_EQ(hit.value.v_rel, -4);
  EXPECT_EQ(hit.value.magnitude, 8);  // 2 kg times 4 m/s
  EXPECT_EQ(hit.value.twist_A.v_W, V(-1, 0, 0));
  EXPECT_EQ(hit.value.twist_B.v_W, V(3, 0, 0));
  EXPECT_EQ(hit.value.twist_A.w_W, kO);
  EXPECT_EQ(hit.value.on_A.linear_W, V(-8, 0, 0));
  EXPECT_EQ(hit.value.on_B.linear_W, V(8, 0, 0));
}

TEST(Impulse, NoRestitution_LeavesNoNormalVelocity) {  // I02
  const auto A = collider({-1, 0.5, 0}, {3, 2, 0}, 0.5, {1, 2, 3}, {0, 0, 1});
  const auto B = collider({1, 0, 0.25}, {-1, 0, 1}, 0.25, {3, 2, 1}, {1, 0, 0});
  const auto contact = at(kO, {-1, 0, 0});
  const auto hit = collision_impulse(A, B, contact, 0.0);
  const double after =
      relative_velocity(contact, A.X_WB, hit.value.twist_A, B.X_WB, hit.value.twist_B);
  EXPECT_NEAR(after, 0, 1e-15);
}

TEST(Impulse, ImmovableCentre_OnlySpinChanges) {  // I03: pivoted blade, hit at the tip
  const auto A = collider(kO, kO, 0, {0, 0, 4}, {0, 0, -2});
  const auto B = collider({1, -1, 0}, kO, 0, kO);
  const auto hit = collision_impulse(A, B, at({1, 0, 0}, {0, 1, 0}), 1.0);
  EXPECT_EQ(hit.value.twist_A.v_W, kO);
  EXPECT_EQ(hit.value.twist_A.w_W, V(0, 0, 2));
  EXPECT_EQ(hit.value.magnitude, 1);  // I (w+ - w) / lever = 4 / 4 / 1
}

TEST(Impulse, CentreOfPercussion_LeavesTheHiltAtRest) {  // I04: rod of length 1, hit at 2/3
  const auto rod = collider({0.5, 0, 0}, kO, 1, {0, 12, 12});
  const auto ball = collider({2.0 / 3, 1, 0}, {0, -1, 0}, 1, kSoft);
  const auto hit = collision_impulse(rod, ball, at({2.0 / 3, 0, 0}, {0, -1, 0}), 0.5);
  ASSERT_GT(hit.value.magnitude, 0);
  const V hilt = velocity_at(rod.X_WB, hit.value.twist_A, V(0, 0, 0));
  EXPECT_NEAR(hilt.norm(), 0, 1e-15);
}

TEST(Impulse, InfiniteMass_Stays) {  // I05
  const auto A = collider({-1, 0, 0}, {3, 0, 0}, 0.5, kSoft);
  const auto wall = collider({1, 0, 0}, {-1, 0, 0}, 0, kO, {0, 0, 2});
  const auto hit = collision_impulse(A, wall, at(kO, {-1, 0, 0}), 1.0);
  EXPECT_EQ(hit.value.twist_B.v_W, wall.twist.v_W);
  EXPECT_EQ(hit.value.twist_B.w_W, wall.twist.w_W);
  EXPECT_EQ(hit.value.twist_A.v_W, V(-5, 0, 0));
  const auto both = collision_impulse(wall, wall, at({0, 5, 0}, {0, 1, 0}), 1.0);
  EXPECT_TRUE(both.ok());
  EXPECT_EQ(both.value.magnitude, 0);
  EXPECT_EQ(both.value.on_A.linear_W, kO);
}

template <class Scalar>
class ImpulseOf : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(ImpulseOf, Scalars);

TYPED_TEST(ImpulseOf, AnyMassRatio_BouncesByRestitution) {  // I06
  for (const double ratio : {1e-9, 1e-3, 1.0, 1e3, 1e9}) {
    const auto A = collider<TypeParam>({-1, 0, 0}, {1, 0, 0}, ratio, kSoft);
    const auto B = collider<TypeParam>({1, 0, 0}, {-1, 0, 0}, 1, kSoft);
    const auto contact = at<TypeParam>(kO, {-1, 0, 0});
    const auto hit = collision_impulse(A, B, contact, TypeParam(0.5));
    const auto after =
        relative_velocity(contact, A.X_WB, hit.value.twist_A, B.X_WB, hit.value.twist_B);
    EXPECT_NEAR(static_cast<double>(after), 1, 8 * static_cast<double>(kRoundOff<TypeParam>));
  }
}

TYPED_TEST(ImpulseOf, Grazing_StillTurnsTheVelocity) {  // I07
  const auto A = collider<TypeParam>({-1, 0, 0}, {1e-12, 1, 0}, 1, kSoft);
  const auto B = collider<TypeParam>({1, 0, 0}, kO, 1, kSoft);
  const auto hit = collision_impulse(A, B, at<TypeParam>(kO, {-1, 0, 0}), TypeParam(1));
  EXPECT_GT(hit.value.magnitude, TypeParam(0));
  EXPECT_LE(hit.value.twist_A.v_W.x(), TypeParam(0));
  EXPECT_EQ(hit.value.twist_A.v_W.y(), TypeParam(1));
}

TYPED_TEST(ImpulseOf, Receding_ChangesNothing) {  // I12
  const auto A = collider<TypeParam>({-1, 0, 0}, {-1, 0, 0}, 1, kSoft, {1, 2, 3});
  const auto B = collider<TypeParam>({1, 0, 0}, {0, 1, 0}, 1, kSoft);
  const auto hit = collision_impulse(A, B, at<TypeParam>(kO, {-1, 0, 0}), TypeParam(1));
  ASSERT_TRUE(hit.ok());
  EXPECT_EQ(hit.value.magnitude, TypeParam(0));
  EXPECT_EQ(hit.value.v_rel, TypeParam(1));
  EXPECT_EQ(hit.value.twist_A.v_W, A.twist.v_W);
  EXPECT_EQ(hit.value.twist_A.w_W, A.twist.w_W);
}

TYPED_TEST(ImpulseOf, LargestNumbers_AreAnswered) {
  using Scalar = TypeParam;
  constexpr Scalar kLargest = std::numeric_limits<Scalar>::max();
  const Vec3<Scalar> across(0, kLargest, kLargest);
  Collider<Scalar> A = collider<Scalar>({1, 0, 0}, {-1, 0, 0}, 1, kO);
  const Collider<Scalar> B = collider<Scalar>({-1, 0, 0}, kO, 1, kO);
  A.twist.v_W += across;  // numbers whose sum is none
  const auto hit = collision_impulse(A, B, at<Scalar>(kO, {1, 0, 0}), Scalar(1));
  ASSERT_TRUE(hit.ok());
  EXPECT_EQ(hit.value.magnitude, 1);
  EXPECT_EQ(hit.value.twist_A.v_W, across);
  EXPECT_EQ(hit.value.twist_B.v_W, Vec3<Scalar>(-1, 0, 0));
}

TYPED_TEST(ImpulseOf, BadInput_IsRefused) {
  using Body = Collider<TypeParam>;
  const auto good = collider<TypeParam>({-1, 0, 0}, {1, 0, 0}, 1, kSoft);
  const auto contact = at<TypeParam>(kO, {-1, 0, 0});
  constexpr TypeParam kNan = std::numeric_limits<TypeParam>::quiet_NaN();
  constexpr TypeParam kInfinity = std::numeric_limits<TypeParam>::infinity();
  const auto refused = [&](auto change) {
    Body bad = good;
    change(bad);
    return !collision_impulse(bad, good, contact, TypeParam(0)).ok() &&
           !collision_impulse(good, bad, contact, TypeParam(0)).ok();
  };
  EXPECT_TRUE(refused([](Body& b) { b.inverse_mass = TypeParam(-1); }));
  EXPECT_TRUE(refused([](Body& b) { b.inverse_mass = kInfinity; }));
  EXPECT_TRUE(refused([](Body& b) { b.inverse_moments.y() = TypeParam(-1); }));
  EXPECT_TRUE(refused([](Body& b) { b.inverse_moments.y() = kNan; }));
  EXPECT_TRUE(refused([](Body& b) { b.twist.v_W.x() = kNan; }));
  EXPECT_TRUE(refused([](Body& b) { b.twist.w_W.x() = kInfinity; }));
  EXPECT_TRUE(refused([](Body& b) { b.X_WB.p_W.x() = kNan; }));
  EXPECT_TRUE(refused([](Body& b) { b.X_WB.q_WB.x() = kNan; }));
  for (const TypeParam e : {TypeParam(-0.1), TypeParam(1.1), kNan}) {
    EXPECT_FALSE(collision_impulse(good, good, contact, e).ok());
  }
  Contact<TypeParam> nowhere = contact;
  nowhere.point_W.x() = kNan;
  EXPECT_FALSE(collision_impulse(good, good, nowhere, TypeParam(0)).ok());
  nowhere = contact;
  nowhere.normal_BA_W.x() = kInfinity;
  EXPECT_FALSE(collision_impulse(good, good, nowhere, TypeParam(0)).ok());
}

/// Calls use(bad) with every number of `good`, one at a time, not finite.
template <class Scalar, class T, class Use>
void with_each_not_finite(const T& good, std::size_t count, const Use& use) {
  constexpr Scalar kInfinity = std::numeric_limits<Scalar>::infinity();
  for (std::size_t i = 0; i < count; ++i) {
    for (const Scalar x : {std::numeric_limits<Scalar>::quiet_NaN(), kInfinity, -kInfinity}) {
      T bad = good;
      static_cast<Scalar*>(static_cast<void*>(&bad))[i] = x;
      use(bad, i);
    }
  }
}

/// Where they meet and where they part, and where zeros are what is multiplied: nothing of a body
/// lies beside the normal, and it does not turn.
TYPED_TEST(ImpulseOf, AnyNumberThatIsNotFinite_IsRefused) {
  using S = TypeParam;
  constexpr std::size_t kOfCollider = 7 + 6 + 4;
  static_assert(sizeof(Collider<S>) == kOfCollider * sizeof(S));
  constexpr std::size_t kOfContact = 6;  // the gap is not asked
  const auto still = collider<S>({-1, 0, 0}, kO, 1, kSoft);
  const auto met = at<S>(kO, {-1, 0, 0});
  for (const double v : {1.0, 0.0, -1.0}) {
    const auto moving = collider<S>({1, 0, 0}, {v, 0, 0}, 1, kSoft);
    const auto is_refused = [](const auto& A, const auto& B, const auto& contact) {
      return collision_impulse(A, B, contact, S(0)).status == Status::kInvalidArgument;
    };
    ASSERT_FALSE(is_refused(still, moving, met));
    with_each_not_finite<S>(still, kOfCollider, [&](const Collider<S>& bad, std::size_t i) {
      EXPECT_TRUE(is_refused(bad, moving, met)) << v << ' ' << i;
      EXPECT_TRUE(is_refused(moving, bad, met)) << v << ' ' << i;
      EXPECT_TRUE(is_refused(bad, bad, met)) << v << ' ' << i;
    });
    with_each_not_finite<S>(met, kOfContact, [&](const Contact<S>& bad, std::size_t i) {
      EXPECT_TRUE(is_refused(still, moving, bad)) << v << ' ' << i;
    });
  }
}

TYPED_TEST(ImpulseOf, JTooLargeForTheScalar_IsRefused) {
  const double tiny = static_cast<double>(std::numeric_limits<TypeParam>::min());
  const auto A = collider<TypeParam>({-1, 0, 0}, {1e3, 0, 0}, tiny, kO);
  const auto B = collider<TypeParam>({1, 0, 0}, kO, tiny, kO);
  EXPECT_FALSE(collision_impulse(A, B, at<TypeParam>(kO, {-1, 0, 0}), TypeParam(1)).ok());
}

double signed_unit(std::mt19937& random) {
  return static_cast<double>(random()) * 0x1p-31 - 1;
}
V random_vector(std::mt19937& random) {
  const double x = signed_unit(random);
  const double y = signed_unit(random);
  return {x, y, signed_unit(random)};
}

Body<double> random_body(std::mt19937& random) {
  const Pose<double> X_WB{2 * random_vector(random), exp_map<double>(3 * random_vector(random))};
  const V moments = V(1.1, 1.1, 1.1) + random_vector(random);
  auto body = make_body<double>(X_WB, 2 + signed_unit(random), moments).value;
  body.momentum = {random_vector(random), random_vector(random)};
  return body;
}

V angular_momentum(const Body<double>& body) {
  return body.X_WB.p_W.cross(body.momentum.linear_W) + body.momentum.angular_W;
}

TEST(Impulse, RandomCollisions_ConserveAndNeverGainEnergy) {  // I09
  std::mt19937 random(12);
  int collided = 0;
  for (int i = 0; i < 20000; ++i) {
    Body<double> A = random_body(random);
    Body<double> B = random_body(random);
    const auto contact = at(random_vector(random), random_vector(random).normalized());
    const double restitution = 0.5 + 0.5 * signed_unit(random);
    const auto hit = collision_impulse(collider_of(A), collider_of(B), contact, restitution);
    ASSERT_TRUE(hit.ok());
    const double energy = kinetic_energy(A) + kinetic_energy(B);
    const V p = A.momentum.linear_W + B.momentum.linear_W;
    const V H = angular_momentum(A) + angular_momentum(B);
    const double v_after =
        relative_velocity(contact, A.X_WB, hit.value.twist_A, B.X_WB, hit.value.twist_B);
    for (const auto& [body, change] :
         {std::pair{&A, hit.value.on_A}, std::pair{&B, hit.value.on_B}}) {
      body->momentum.linear_W += change.linear_W;
      body->momentum.angular_W += change.angular_W;
    }
    EXPECT_LE((A.momentum.linear_W + B.momentum.linear_W - p).norm(), 1e-14);
    EXPECT_LE((angular_momentum(A) + angular_momentum(B) - H).norm(), 1e-13);
    EXPECT_LE(kinetic_energy(A) + kinetic_energy(B), energy * (1 + 1e-13));
    EXPECT_LE((twist_of(A).v_W - hit.value.twist_A.v_W).norm(), 1e-13);
    EXPECT_LE((twist_of(A).w_W - hit.value.twist_A.w_W).norm(), 1e-12);
    if (hit.value.v_rel >= 0) continue;
    ++collided;
    EXPECT_NEAR(v_after, -restitution * hit.value.v_rel,
                1e-13 * (1 + 1 / A.inverse_moments.minCoeff()));
  }
  EXPECT_GT(collided, 8000);
}

}  // namespace
}  // namespace batuta
