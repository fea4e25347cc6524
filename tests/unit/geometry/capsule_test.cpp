// SPDX-License-Identifier: MIT
#include "batuta/geometry/capsule.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace batuta {
namespace {

template <class Scalar>
class CapsuleTest : public testing::Test {
 protected:
  using C = Capsule<Scalar>;
  static constexpr Scalar kNan = std::numeric_limits<Scalar>::quiet_NaN();
  static constexpr Scalar kInfinity = std::numeric_limits<Scalar>::infinity();
  static constexpr Scalar kTolerance = 8 * kRoundOff<Scalar>;

  /// Along x from -1 to 1, radius 1/2.
  static C bar() { return {{{-1, 0, 0}, {1, 0, 0}}, Scalar(0.5)}; }
};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(CapsuleTest, Scalars);

TYPED_TEST(CapsuleTest, Validity_NeedsFiniteCoordinatesAndARadius) {
  using Scalar = TypeParam;
  Capsule<Scalar> c = this->bar();
  EXPECT_TRUE(is_valid(c));
  for (const Scalar bad :
       {this->kNan, this->kInfinity, -this->kInfinity, 2 * kLargestCoordinate<Scalar>}) {
    c = this->bar();
    c.axis.a.y() = bad;
    EXPECT_FALSE(is_valid(c));
    c = this->bar();
    c.axis.b.z() = bad;
    EXPECT_FALSE(is_valid(c));
  }
  for (const Scalar bad : {this->kNan, this->kInfinity, Scalar(-1e-6)}) {
    c = this->bar();
    c.radius = bad;
    EXPECT_FALSE(is_valid(c));
  }
  c.radius = 0;
  EXPECT_TRUE(is_valid(c));
}

TYPED_TEST(CapsuleTest, Gap_SeparatedTouchingOverlapping) {
  using Scalar = TypeParam;
  using V = Vec3<Scalar>;
  const auto ball = [](Scalar y) { return Capsule<Scalar>::sphere({0, y, 0}, Scalar(0.25)); };
  const auto apart = capsule_gap(this->bar(), ball(2));
  EXPECT_EQ(apart.proximity, Proximity::kSeparated);
  EXPECT_EQ(apart.gap, Scalar(1.25));
  EXPECT_EQ(apart.axes.normal_AB, V(0, 1, 0));
  EXPECT_EQ(apart.surface_A, V(0, Scalar(0.5), 0));
  EXPECT_EQ(apart.surface_B, V(0, Scalar(1.75), 0));
  const auto touching = capsule_gap(this->bar(), ball(Scalar(0.75)));
  EXPECT_EQ(touching.proximity, Proximity::kTouching);
  EXPECT_EQ(touching.gap, 0);
  const auto deep = capsule_gap(this->bar(), ball(Scalar(0.5)));
  EXPECT_EQ(deep.proximity, Proximity::kOverlapping);
  EXPECT_EQ(deep.gap, Scalar(-0.25));
}

TYPED_TEST(CapsuleTest, OverlapAndDepth_AgreeWithTheGap) {
  using Scalar = TypeParam;
  const auto ball = [](Scalar y) { return Capsule<Scalar>::sphere({0, y, 0}, Scalar(0.25)); };
  EXPECT_FALSE(overlaps(this->bar(), ball(2)));
  EXPECT_TRUE(overlaps(this->bar(), ball(Scalar(0.75))));
  EXPECT_TRUE(overlaps(this->bar(), ball(Scalar(0.5))));
  EXPECT_EQ(penetration_depth(this->bar(), ball(2)), 0);
  EXPECT_EQ(penetration_depth(this->bar(), ball(Scalar(0.5))), Scalar(0.25));
}

TYPED_TEST(CapsuleTest, CrossingAxes_ReportFullDepthAndAUnitNormal) {
  using Scalar = TypeParam;
  const Capsule<Scalar> post{{{0, 0, -1}, {0, 0, 1}}, Scalar(0.25)};
  const auto gap = capsule_gap(this->bar(), post);
  EXPECT_EQ(gap.gap, Scalar(-0.75));
  EXPECT_TRUE(gap.axes.arbitrary);
  EXPECT_EQ(std::abs(gap.axes.normal_AB.y()), 1);
  EXPECT_EQ(capsule_gap(this->bar(), this->bar()).gap, -1);
}

TYPED_TEST(CapsuleTest, MovingByTheDepth_EndsTheOverlap) {
  using Scalar = TypeParam;
  std::mt19937 engine(3);
  const auto number = [&] { return Scalar(engine() % 2001) / 1000 - 1; };
  int overlapping = 0;
  for (int i = 0; i < 2000; ++i) {
    Capsule<Scalar> A{{{number(), number(), number()}, {number(), number(), number()}},
                      Scalar(0.2)};
    const Capsule<Scalar> B{{{number(), number(), number()}, {number(), number(), number()}},
                            Scalar(0.1)};
    const auto before = capsule_gap(A, B);
    if (before.proximity != Proximity::kOverlapping || before.axes.arbitrary) continue;
    ++overlapping;
    const Vec3<Scalar> shift = -before.axes.normal_AB * penetration_depth(A, B);
    A.axis = {A.axis.a + shift, A.axis.b + shift};
    EXPECT_GE(capsule_gap(A, B).gap, -64 * kRoundOff<Scalar>);
  }
  EXPECT_GT(overlapping, 100);
}

TYPED_TEST(CapsuleTest, InvalidInput_IsNeverAnAnswer) {
  using Scalar = TypeParam;
  Capsule<Scalar> bad = this->bar();
  bad.axis.a.x() = this->kNan;
  EXPECT_EQ(capsule_gap(bad, this->bar()).proximity, Proximity::kInvalid);
  EXPECT_EQ(capsule_gap(this->bar(), bad).proximity, Proximity::kInvalid);
  EXPECT_FALSE(overlaps(bad, this->bar()));
  EXPECT_EQ(surface_normal(bad, {0, 0, 0}).status, Status::kInvalidArgument);
  EXPECT_EQ(surface_normal(this->bar(), {0, this->kInfinity, 0}).status, Status::kInvalidArgument);
}

TYPED_TEST(CapsuleTest, SurfaceNormal_OnTheSideTheCapsAndTheAxis) {
  using Scalar = TypeParam;
  using V = Vec3<Scalar>;
  const auto side = surface_normal<Scalar>(this->bar(), {Scalar(0.3), 0, 4});
  EXPECT_TRUE(side.ok());
  EXPECT_LE((side.value - V(0, 0, 1)).norm(), this->kTolerance);
  const auto inside = surface_normal<Scalar>(this->bar(), {Scalar(0.3), Scalar(-0.1), 0});
  EXPECT_LE((inside.value - V(0, -1, 0)).norm(), 10 * this->kTolerance) << "u S / distance";
  const auto cap = surface_normal<Scalar>(this->bar(), {4, 4, 0});
  EXPECT_NEAR(cap.value.x(), Scalar(0.6), this->kTolerance);
  EXPECT_NEAR(cap.value.y(), Scalar(0.8), this->kTolerance);
  const auto on_axis = surface_normal<Scalar>(this->bar(), {Scalar(0.25), 0, 0});
  EXPECT_EQ(on_axis.status, Status::kDegenerate);
  EXPECT_EQ(on_axis.value.x(), 0);
  EXPECT_NEAR(on_axis.value.norm(), 1, this->kTolerance);
  const auto center = surface_normal(Capsule<Scalar>::sphere({1, 2, 3}, 1), {1, 2, 3});
  EXPECT_EQ(center.status, Status::kDegenerate);
  EXPECT_EQ(center.value, V::UnitX());
}

TYPED_TEST(CapsuleTest, Support_IsTheFurthestPoint) {
  using Scalar = TypeParam;
  EXPECT_EQ(support<Scalar>(this->bar(), {1, 0, 0}), Scalar(1.5));
  EXPECT_EQ(support<Scalar>(this->bar(), {-2, 0, 0}), 3);
  EXPECT_EQ(support<Scalar>(this->bar(), {0, 0, -1}), Scalar(0.5));
  EXPECT_NEAR(support<Scalar>(this->bar(), {3, 4, 0}), Scalar(5.5), 5 * this->kTolerance);
  EXPECT_EQ(support<Scalar>(this->bar(), {0, 0, 0}), 0);
}

TYPED_TEST(CapsuleTest, BoundingSphere_HoldsTheCapsuleAndIsTight) {
  using Scalar = TypeParam;
  std::mt19937 engine(5);
  const auto number = [&] { return Scalar(engine() % 20001) / 10000 - 1; };
  for (int i = 0; i < 1000; ++i) {
    const Scalar offset = i % 2 == 0 ? Scalar(0) : Scalar(1000);
    const Capsule<Scalar> c{
        {{number() + offset, number(), number()}, {number() + offset, number(), number()}},
        std::abs(number())};
    const Sphere<Scalar> ball = bounding_sphere(c);
    using Exact = Eigen::Matrix<long double, 3, 1>;
    const Exact center = ball.center.template cast<long double>();
    const auto reach = [&](const Vec3<Scalar>& end) {
      return (end.template cast<long double>() - center).norm() + c.radius;
    };
    const long double furthest = std::max(reach(c.axis.a), reach(c.axis.b));
    const long double half =
        (c.axis.b - c.axis.a).template cast<long double>().norm() / 2 + c.radius;
    EXPECT_LE(furthest, ball.radius);
    EXPECT_LE(ball.radius - half, 16 * kRoundOff<Scalar> * (half + offset));
  }
}

TYPED_TEST(CapsuleTest, BoundingSphere_OfASphereIsItself) {
  using Scalar = TypeParam;
  const Sphere<Scalar> ball = bounding_sphere(Capsule<Scalar>::sphere({1, 2, 3}, 4));
  EXPECT_EQ(ball.center, Vec3<Scalar>(1, 2, 3));
  EXPECT_NEAR(ball.radius, 4, 4 * this->kTolerance);
}

}  // namespace
}  // namespace batuta
