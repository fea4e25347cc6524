// SPDX-License-Identifier: MIT
#include "batuta/detection/moving_pair.hpp"

#include <gtest/gtest.h>

#include <array>
#include <limits>

#include "moving.hpp"

namespace batuta {
namespace {

using namespace testing_detection;

constexpr double kRoundings = 4;  // of a gap, in u S (1 + turn)

template <class Scalar>
class MovingPairOf : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(MovingPairOf, Scalars);

template <class Scalar>
double rounding(const MovingPair<Scalar>& pair, double turn) {
  return kRoundings * static_cast<double>(kRoundOff<Scalar> * pair.scale) * (1 + turn);
}

TYPED_TEST(MovingPairOf, RandomMotion_AgreesWithThePoses) {
  std::mt19937 random(1);
  for (int i = 0; i < 2000; ++i) {
    const double turn = i % 4 == 0 ? 0 : 3;
    const auto A = random_moving<TypeParam>(random, turn);
    const auto B = random_moving<TypeParam>(random, turn);
    const auto pair = make_moving_pair(A, B);
    ASSERT_TRUE(pair.ok());
    for (const double t : {0.0, 0.25, 0.5, 1.0}) {
      const auto found = gap_at(pair.value, static_cast<TypeParam>(t));
      const auto truth = capsule_gap(capsule_by_pose(A, t), capsule_by_pose(B, t));
      ASSERT_NEAR(static_cast<double>(found.gap), truth.gap, rounding(pair.value, 6)) << i;
    }
  }
}

TYPED_TEST(MovingPairOf, Start_IsTheStartPoseToTheLastBit) {
  std::mt19937 random(2);
  for (int i = 0; i < 500; ++i) {
    auto A = random_moving<TypeParam>(random, 9);
    auto B = random_moving<TypeParam>(random, 9);
    A.motion.X_WB.p_W.setZero();
    const auto pair = make_moving_pair(A, B);
    const auto at_start = detail::capsules_at(pair.value, TypeParam(0));
    const auto truth = to_world(B.motion.X_WB, B.capsule_B);
    EXPECT_EQ(at_start.A.axis.a, to_world(A.motion.X_WB, A.capsule_B).axis.a);
    EXPECT_EQ(at_start.B.axis.a, truth.axis.a);
    EXPECT_EQ(at_start.B.axis.b, truth.axis.b);
  }
}

TYPED_TEST(MovingPairOf, CommonVelocityAndFarOrigin_CostNoDigits) {
  Capsule64 a{{0, 0, 0}, {0, -1, 0}, {0, 1, 0}, 0.125};
  Capsule64 b{{3, 0, 0}, {0, -1, 0}, {0, 1, 0}, 0.125, {-4, 0, 0}};
  const auto near = make_moving_pair(moving<TypeParam>(a), moving<TypeParam>(b));
  const Vec3<double> shift(65536, -65536, 65536);
  const Vec3<double> wind(4096, 8192, 0);
  for (Capsule64* c : {&a, &b}) {
    c->center += shift;
    c->v += wind;
  }
  const auto far = make_moving_pair(moving<TypeParam>(a), moving<TypeParam>(b));
  const auto t = static_cast<TypeParam>(0.3);
  const auto found = gap_at(far.value, t);
  EXPECT_EQ(found.gap, gap_at(near.value, t).gap);
  EXPECT_EQ(far.value.scale, near.value.scale);
  const Vec3<TypeParam> origin = shift.cast<TypeParam>();
  EXPECT_EQ(far.value.origin_W, origin);
  // Points are relative to the origin at t = 0: A has gone with the wind.
  EXPECT_EQ(found.surface_A.x(), TypeParam(4096) * t + TypeParam(0.125));
}

TYPED_TEST(MovingPairOf, GapRate_IsTheSlopeOfTheGap) {
  std::mt19937 random(3);
  int checked = 0;
  for (int i = 0; i < 300; ++i) {
    const auto A = random_moving<double>(random, 2);
    const auto B = random_moving<double>(random, 2);
    const auto pair = make_moving_pair(A, B);
    constexpr double kStep = 1e-6;
    const auto here = gap_at(pair.value, 0.5);
    const double before = gap_at(pair.value, 0.5 - kStep).gap;
    const double after = gap_at(pair.value, 0.5 + kStep).gap;
    if (std::abs(after - 2 * here.gap + before) > 1e-8) continue;  // a kink between features
    EXPECT_NEAR(detail::gap_rate_at(pair.value, here, 0.5), (after - before) / (2 * kStep), 1e-3)
        << i;
    ++checked;
  }
  EXPECT_GT(checked, 250);
}

TYPED_TEST(MovingPairOf, Scale_IsAnUpperBound) {
  const Capsule64 a{{0, 0, 0}, {0, -1, 0}, {0, 2, 0}, 0.1};
  const Capsule64 b{{3, 4, 0}, {0, 0, 0}, {1, 0, 0}, 0.2, {0, 0, 6}};
  const auto pair = make_moving_pair(moving<TypeParam>(a, 2), moving<TypeParam>(b, 2));
  const double scale = 5 + 12 + 2 + 1 + 0.3;
  EXPECT_GE(static_cast<double>(pair.value.scale), scale * (1 - 1e-7));
  EXPECT_LE(static_cast<double>(pair.value.scale), scale * (1 + 1e-5));
}

TYPED_TEST(MovingPairOf, WhatMakesNoSense_IsInvalid) {
  const auto good = moving<TypeParam>({{0, 0, 0}, {0, -1, 0}, {0, 1, 0}, 0.1});
  const auto far = moving<TypeParam>({{3, 0, 0}, {0, -1, 0}, {0, 1, 0}, 0.1});
  constexpr TypeParam kNan = std::numeric_limits<TypeParam>::quiet_NaN();
  constexpr TypeParam kInfinity = std::numeric_limits<TypeParam>::infinity();
  constexpr TypeParam kHuge = std::numeric_limits<TypeParam>::max();
  ASSERT_TRUE(make_moving_pair(good, far).ok());
  std::array<MovingCapsule<TypeParam>, 9> bad;
  bad.fill(far);
  bad[0].capsule_B.radius = TypeParam(-0.1);
  bad[1].capsule_B.axis.a.x() = kNan;
  bad[2].motion.X_WB.p_W.y() = kInfinity;
  bad[3].motion.duration = TypeParam(2);
  bad[4].motion.twist.w_W.z() = TypeParam(2) * detail::kMaxAngle<TypeParam>;
  bad[5].motion.twist.v_W.x() = kNan;
  bad[6].motion.twist.v_W.x() = kHuge;
  bad[7].motion.X_WB.q_WB.w() = kNan;
  bad[8].capsule_B.radius = kInfinity;
  for (std::size_t i = 0; i < bad.size(); ++i) {
    if (i == 6) bad[i].motion.X_WB.p_W.x() = kHuge;  // each is finite, their sum is not
    EXPECT_EQ(make_moving_pair(good, bad[i]).status, Status::kInvalidArgument) << i;
    EXPECT_EQ(make_moving_pair(bad[i], good).status, Status::kInvalidArgument) << i;
  }
  auto backwards = good;
  backwards.motion.duration = TypeParam(-1);
  EXPECT_FALSE(make_moving_pair(backwards, backwards).ok());
}

TYPED_TEST(MovingPairOf, AnyNumberThatIsNotFinite_IsInvalid) {
  using Moving = MovingCapsule<TypeParam>;
  constexpr TypeParam kInfinity = std::numeric_limits<TypeParam>::infinity();
  const auto good =
      moving<TypeParam>({{0, 0, 0}, {0, -1, 0}, {0, 1, 0}, 0.1, {1, 2, 3}, {0.1, 0, 0}});
  constexpr std::size_t kNumbers = sizeof(Moving) / sizeof(TypeParam);  // it has nothing else
  static_assert(kNumbers == 7 + 7 + 6 + 1);
  for (std::size_t i = 0; i < kNumbers; ++i) {
    for (const TypeParam x : {std::numeric_limits<TypeParam>::quiet_NaN(), kInfinity, -kInfinity}) {
      Moving bad = good;
      static_cast<TypeParam*>(static_cast<void*>(&bad))[i] = x;
      EXPECT_EQ(make_moving_pair(good, bad).status, Status::kInvalidArgument) << i << ' ' << x;
      EXPECT_EQ(make_moving_pair(bad, good).status, Status::kInvalidArgument) << i << ' ' << x;
      EXPECT_EQ(make_moving_pair(bad, bad).status, Status::kInvalidArgument) << i << ' ' << x;
    }
  }
}

// Whatever is accepted can be measured.
TYPED_TEST(MovingPairOf, ScaleBeyondTheLargestCoordinate_IsRefused) {
  constexpr TypeParam kLargest = kLargestCoordinate<TypeParam>;
  const auto A = moving<TypeParam>({{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, 0.5});
  auto B = A;
  B.motion.X_WB.p_W.x() = kLargest / 2;
  const auto pair = make_moving_pair(A, B);
  ASSERT_TRUE(pair.ok());
  EXPECT_EQ(gap_at(pair.value, TypeParam(1)).proximity, Proximity::kSeparated);
  B.motion.X_WB.p_W.x() = kLargest * TypeParam(2.5);
  EXPECT_EQ(make_moving_pair(A, B).status, Status::kInvalidArgument);
  B = A;
  B.motion.twist.v_W.y() = kLargest * TypeParam(2);
  EXPECT_EQ(make_moving_pair(A, B).status, Status::kInvalidArgument);
}

/// A velocity that both have is in no length of the pair; where it leads beyond the numbers, no
/// contact can be told.
TYPED_TEST(MovingPairOf, MotionThatEndsBeyondTheNumbers_IsRefused) {
  using S = TypeParam;
  const S fast = std::numeric_limits<S>::max() / 2;
  MovingCapsule<S> A;
  A.capsule_B = {{{0, 0, -1}, {0, 0, 1}}, S(0.1)};
  A.motion.twist.v_W = {fast, 0, 0};
  A.motion.duration = 1;
  MovingCapsule<S> B = A;
  B.motion.X_WB.p_W = {1, 0, 0};
  EXPECT_EQ(make_moving_pair(A, B).status, Status::kOk);
  A.motion.duration = B.motion.duration = 10;
  EXPECT_EQ(make_moving_pair(A, B).status, Status::kInvalidArgument);
}

}  // namespace
}  // namespace batuta
