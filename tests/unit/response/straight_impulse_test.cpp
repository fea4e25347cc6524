// SPDX-License-Identifier: MIT
#include "batuta/response/straight_impulse.hpp"

#include <gtest/gtest.h>

#include <random>

#include "batuta/response/impulse.hpp"

namespace batuta {
namespace {

template <class Scalar>
class StraightImpulse : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(StraightImpulse, Scalars);

template <class Scalar>
StraightBody<Scalar> body_of(Scalar inverse_mass, const Vec3<Scalar>& momentum_W) {
  return {Vec3<Scalar>::Zero(), momentum_W, inverse_mass};
}

template <class Scalar>
class Draw {
 public:
  Scalar in(Scalar low, Scalar high) {
    return low + (high - low) * Scalar(std::generate_canonical<double, 53>(source_));
  }
  Vec3<Scalar> vector() { return {in(-1, 1), in(-1, 1), in(-1, 1)}; }
  /// One in four is fixed.
  StraightBody<Scalar> body() {
    const bool fixed = source_() % 4 == 0;
    return body_of<Scalar>(fixed ? Scalar(0) : std::pow(Scalar(10), in(-2, 2)), vector());
  }

 private:
  std::mt19937 source_{20061107};
};

template <class Scalar>
Scalar closing_speed(const StraightBody<Scalar>& A, const StraightBody<Scalar>& B,
                     const Vec3<Scalar>& n) {
  return n.dot(velocity_of(A) - velocity_of(B));
}

/// v_rel becomes -C v_rel, momentum is kept, only along the normal, energy does not grow.
TYPED_TEST(StraightImpulse, AnyCollision_KeepsItsLaws) {
  using S = TypeParam;
  const S rounding = 64 * kRoundOff<S>;
  Draw<S> draw;
  int collisions = 0;
  for (int i = 0; i < 20000; ++i) {
    auto A = draw.body();
    auto B = draw.body();
    const auto before_A = A;
    const auto before_B = B;
    const Vec3<S> n = draw.vector().normalized();
    const S restitution = draw.in(0, 1);
    const S v_rel = closing_speed(A, B, n);
    const auto hit = detail::straight_impulse(A, B, n, restitution);
    const S size = velocity_of(A).norm() + velocity_of(B).norm() + std::abs(v_rel);
    ASSERT_NEAR(hit.v_rel, v_rel, rounding * size);
    const bool changes = v_rel < S(0) && A.inverse_mass + B.inverse_mass > S(0);
    ASSERT_EQ(hit.impulse > S(0), changes);
    ASSERT_EQ(A.p_W, before_A.p_W);
    if (!changes) {
      ASSERT_EQ(A.momentum_W, before_A.momentum_W);
      ASSERT_EQ(B.momentum_W, before_B.momentum_W);
      continue;
    }
    ++collisions;
    ASSERT_NEAR(closing_speed(A, B, n), -restitution * v_rel, rounding * size);
    const Vec3<S> J_W = hit.impulse * n;
    const S momenta = before_A.momentum_W.norm() + before_B.momentum_W.norm() + hit.impulse;
    const Vec3<S> J_A = A.inverse_mass > S(0) ? J_W : Vec3<S>(Vec3<S>::Zero());
    const Vec3<S> J_B = B.inverse_mass > S(0) ? J_W : Vec3<S>(Vec3<S>::Zero());
    ASSERT_LE((A.momentum_W - before_A.momentum_W - J_A).norm(), rounding * momenta);
    ASSERT_LE((B.momentum_W - before_B.momentum_W + J_B).norm(), rounding * momenta);
    const S energy = kinetic_energy(before_A) + kinetic_energy(before_B);
    ASSERT_LE(kinetic_energy(A) + kinetic_energy(B), energy * (1 + rounding) + rounding * size);
  }
  EXPECT_GT(collisions, 5000);
}

/// The kernel for bodies that turn, on spheres hit through their centres.
TYPED_TEST(StraightImpulse, CentralHit_AsOfBodiesThatCouldTurn) {
  using S = TypeParam;
  Draw<S> draw;
  for (int i = 0; i < 2000; ++i) {
    auto A = draw.body();
    auto B = draw.body();
    Contact<S> contact;
    contact.normal_BA_W = draw.vector().normalized();
    Collider<S> at_A;
    Collider<S> at_B;
    at_A.twist.v_W = velocity_of(A);
    at_B.twist.v_W = velocity_of(B);
    at_A.inverse_mass = A.inverse_mass;
    at_B.inverse_mass = B.inverse_mass;
    at_A.inverse_moments = at_B.inverse_moments = {1, 1, 1};
    const auto same = collision_impulse(at_A, at_B, contact, S(0.5));
    ASSERT_TRUE(same.ok());
    const auto hit = detail::straight_impulse(A, B, contact.normal_BA_W, S(0.5));
    ASSERT_NEAR(hit.impulse, same.value.magnitude, 64 * kRoundOff<S> * (1 + hit.impulse));
  }
}

TYPED_TEST(StraightImpulse, EqualBallsHeadOn_SwapTheirVelocities) {
  auto A = body_of<TypeParam>(1, {-3, 2, 0});
  auto B = body_of<TypeParam>(1, {1, 0, 5});
  const auto hit = detail::straight_impulse<TypeParam>(A, B, {1, 0, 0}, 1);
  EXPECT_EQ(hit.v_rel, TypeParam(-4));
  EXPECT_EQ(hit.impulse, TypeParam(4));
  EXPECT_EQ(A.momentum_W, Vec3<TypeParam>(1, 2, 0));
  EXPECT_EQ(B.momentum_W, Vec3<TypeParam>(-3, 0, 5));
}

TYPED_TEST(StraightImpulse, FixedBodies_StayAsTheyAre) {
  auto wall = body_of<TypeParam>(0, {7, 7, 7});
  auto ball = body_of<TypeParam>(2, {-1, 0, 0});
  EXPECT_EQ(detail::straight_impulse<TypeParam>(ball, wall, {1, 0, 0}, 1).impulse, TypeParam(2));
  EXPECT_EQ(ball.momentum_W, Vec3<TypeParam>(1, 0, 0));
  EXPECT_EQ(wall.momentum_W, Vec3<TypeParam>(7, 7, 7));
  auto other = wall;
  EXPECT_EQ(detail::straight_impulse<TypeParam>(other, wall, {1, 0, 0}, 1).impulse, TypeParam(0));
  EXPECT_EQ(other.momentum_W, wall.momentum_W);
}

TYPED_TEST(StraightImpulse, WhatIsNotFinite_ChangesNothing) {
  using S = TypeParam;
  const S nan = std::numeric_limits<S>::quiet_NaN();
  const S infinity = std::numeric_limits<S>::infinity();
  for (const S bad : {nan, infinity}) {
    auto A = body_of<S>(1, {-1, 0, 0});
    auto B = body_of<S>(1, {1, 0, 0});
    EXPECT_EQ(detail::straight_impulse<S>(A, B, {1, 0, 0}, bad).impulse, S(0));
    EXPECT_EQ(detail::straight_impulse<S>(A, B, {1, bad, 0}, 1).impulse, S(0));
    auto C = body_of<S>(bad, {-1, 0, 0});
    EXPECT_EQ(detail::straight_impulse<S>(C, B, {1, 0, 0}, 1).impulse, S(0));
    EXPECT_EQ(A.momentum_W, Vec3<S>(-1, 0, 0));
    EXPECT_EQ(B.momentum_W, Vec3<S>(1, 0, 0));
    EXPECT_EQ(C.momentum_W, Vec3<S>(-1, 0, 0));
  }
}

}  // namespace
}  // namespace batuta
