// SPDX-License-Identifier: MIT
// Cases with answers known in closed form, and the defined answers of the degenerate ones.

#include "batuta/geometry/segment.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "batuta/geometry/direction.hpp"
#include "exact_distance.hpp"

namespace batuta {
namespace {

template <class Scalar>
class SegmentTest : public testing::Test {
 protected:
  struct Case {
    std::string name;
    Segment<Scalar> A, B;
    double distance;
    double s, u;  // negative: not looked at
  };

  static void check(const Case& c) {
    SCOPED_TRACE(c.name);
    const double tolerance =
        4 * kRoundOff<Scalar> * static_cast<double>(exact::visible_length(c.A, c.B));
    const ClosestPoints<Scalar> x = closest_points(c.A, c.B);
    EXPECT_NEAR(x.distance, c.distance, tolerance);
    EXPECT_NEAR(x.normal_AB.norm(), 1, 4 * kRoundOff<Scalar>);
    EXPECT_LE(static_cast<double>(exact::distance_at(c.A, c.B, x.s, x.u)), c.distance + tolerance);
    if (c.s >= 0) {
      EXPECT_NEAR(x.s, c.s, 8 * kRoundOff<Scalar>);
      EXPECT_NEAR(x.u, c.u, 8 * kRoundOff<Scalar>);
    }
    const Scalar size = max_of(detail::largest_component(x.p_A), detail::largest_component(x.p_B));
    const Scalar rounding = 4 * kRoundOff<Scalar> * size;
    EXPECT_LE(detail::largest_component<Scalar>(x.p_A - c.A.at(x.s)), tolerance + rounding);
    EXPECT_LE(detail::largest_component<Scalar>(x.p_B - c.B.at(x.u)), tolerance + rounding);
  }
};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(SegmentTest, Scalars);

TYPED_TEST(SegmentTest, At_IsExactAtBothEnds) {
  using Scalar = TypeParam;
  const Segment<Scalar> segment{{Scalar(0.1), Scalar(1e6), 0}, {Scalar(0.7), Scalar(-3e-6), 5}};
  EXPECT_EQ(segment.at(0), segment.a);
  EXPECT_EQ(segment.at(1), segment.b);
  EXPECT_EQ((Segment<Scalar>{{0, 0, 0}, {2, 4, 8}}.at(Scalar(0.25))), Vec3<Scalar>(0.5, 1, 2));
}

/// As of two points at the origin.
TYPED_TEST(SegmentTest, AnswersThatNobodyGave_ContradictNothing) {
  using Scalar = TypeParam;
  const ClosestPoints<Scalar> pair;
  EXPECT_EQ(pair.distance, (pair.p_B - pair.p_A).norm());
  EXPECT_EQ(pair.p_A, Segment<Scalar>().at(pair.s));
  EXPECT_EQ(pair.p_B, Segment<Scalar>().at(pair.u));
  EXPECT_EQ(pair.s, 0);
  EXPECT_EQ(pair.u, 0);
  EXPECT_EQ(pair.normal_AB, Vec3<Scalar>(1, 0, 0));
  const PointOnSegment<Scalar> point;
  EXPECT_EQ(point.s, 0);
  EXPECT_EQ(point.point, Segment<Scalar>().at(point.s));
  EXPECT_EQ(point.distance, 0);
}

TYPED_TEST(SegmentTest, ClosedForms_AllRegions) {
  using Query = typename TestFixture::Case;
  const std::vector<Query> cases = {
      {"interior-interior", {{-1, 0, 0}, {1, 0, 0}}, {{0, -2, 3}, {0, 2, 3}}, 3, 0.5, 0.5},
      {"end-interior", {{2, 0, 0}, {5, 0, 0}}, {{0, -1, 0}, {0, 3, 0}}, 2, 0, 0.25},
      {"interior-end", {{0, -1, 0}, {0, 3, 0}}, {{2, 0, 0}, {5, 0, 0}}, 2, 0.25, 0},
      {"end-end", {{0, 0, 0}, {1, 0, 0}}, {{4, 4, 0}, {5, 5, 0}}, 5, 1, 0},
      {"far ends", {{0, 0, 0}, {1, 0, 0}}, {{-5, 9, 0}, {-3, 4, 0}}, 5, 0, 1},
      {"crossing", {{-1, 0, 0}, {1, 0, 0}}, {{0, -1, 0}, {0, 3, 0}}, 0, 0.5, 0.25},
      {"meeting at an end", {{0, 0, 0}, {1, 0, 0}}, {{1, 0, 0}, {1, 1, 0}}, 0, 1, 0},
      {"a tee", {{0, 0, 0}, {1, 0, 0}}, {{0.5, 0, 0}, {0.5, 0, 2}}, 0, 0.5, 0},
      {"touching end to end in line", {{0, 0, 0}, {1, 0, 0}}, {{1, 0, 0}, {2, 0, 0}}, 0, 1, 0},
      {"in line, apart", {{0, 0, 0}, {1, 0, 0}}, {{3, 0, 0}, {5, 0, 0}}, 2, 1, 0},
      {"parallel, not side by side", {{0, 0, 0}, {1, 0, 0}}, {{4, 4, 0}, {6, 4, 0}}, 5, 1, 0},
      {"point and segment", {{1, 2, 0}, {1, 2, 0}}, {{0, 0, 0}, {4, 0, 0}}, 2, 0, 0.25},
      {"two points", {{0, 0, 0}, {0, 0, 0}}, {{2, 3, 6}, {2, 3, 6}}, 7, 0, 0},
  };
  for (const Query& c : cases) this->check(c);
}

TYPED_TEST(SegmentTest, ParallelSideBySide_GivesTheMiddleOfTheOverlap) {
  using Query = typename TestFixture::Case;
  const std::vector<Query> cases = {
      {"whole", {{0, 0, 0}, {4, 0, 0}}, {{0, 1, 0}, {4, 1, 0}}, 1, 0.5, 0.5},
      {"opposite ways", {{0, 0, 0}, {4, 0, 0}}, {{4, 1, 0}, {0, 1, 0}}, 1, 0.5, 0.5},
      {"half", {{0, 0, 0}, {4, 0, 0}}, {{2, 1, 0}, {6, 1, 0}}, 1, 0.75, 0.25},
      {"inside", {{0, 0, 0}, {8, 0, 0}}, {{2, 1, 0}, {4, 1, 0}}, 1, 0.375, 0.5},
      {"one point of overlap", {{0, 0, 0}, {1, 0, 0}}, {{1, 1, 0}, {2, 1, 0}}, 1, 1, 0},
      {"in line and nested", {{0, 0, 0}, {8, 0, 0}}, {{2, 0, 0}, {4, 0, 0}}, 0, 0.375, 0.5},
      {"up to rounding",
       {{0, 0, 0}, {4, 0, 0}},
       {{0, 1, 0}, {4, 1 + 2 * kRoundOff<TypeParam>, 0}},
       1,
       0.5,
       0.5},
      {"uneven", {{1, 2, 0}, {1, -2, 0}}, {{-1, 2, 0}, {-1, -2, 0}}, 2, 0.5, 0.5},
      {"the same", {{1, 2, 3}, {3, 4, 5}}, {{1, 2, 3}, {3, 4, 5}}, 0, 0.5, 0.5},
  };
  for (const Query& c : cases) this->check(c);
}

TYPED_TEST(SegmentTest, PublishedTroublePairs_AreSolved) {
  using Scalar = TypeParam;
  using Query = typename TestFixture::Case;
  const auto p = [](double x, double y, double z) {
    return Vec3<Scalar>(Vec3<double>(x, y, z).cast<Scalar>());
  };
  const auto truth = [](const Segment<Scalar>& A, const Segment<Scalar>& B) {
    return static_cast<double>(exact::least_distance(A, B));
  };
  const Segment<Scalar> A1{p(0.012711, -0.000688, -0.001097), p(0.012895, -0.000686, -0.001133)};
  const Segment<Scalar> B1{p(0.012676, -0.000689, -0.000999), p(0.012859, -0.000687, -0.001034)};
  EXPECT_NEAR(truth(A1, B1), 8.96815e-5, 2e-9);
  this->check(Query{"yarn", A1, B1, truth(A1, B1), -1, -1});
  const Segment<Scalar> A2{p(2.2352092822407803, -1.7068004885705972, 0),
                           p(1.4357507764403734, -4.4188128129047435, 0)};
  const Segment<Scalar> B2{p(1.8515323877379666, -1.5936985848524166, 0),
                           p(1.2171034035398707, -3.7458793566829809, 0)};
  EXPECT_NEAR(truth(A2, B2), 0.4, 1e-6);
  this->check(Query{"nearly parallel", A2, B2, truth(A2, B2), -1, -1});
  this->check(Query{"parallel", {{1, 2, 0}, {1, -2, 0}}, {{-1, 2, 0}, {-1, -2, 0}}, 2, 0.5, 0.5});
}

TYPED_TEST(SegmentTest, Normal_PointsFromAToB) {
  using Scalar = TypeParam;
  using V = Vec3<Scalar>;
  const auto x = closest_points<Scalar>({{-1, 0, 0}, {1, 0, 0}}, {{0, -1, 2}, {0, 1, 2}});
  EXPECT_EQ(x.normal_AB, V(0, 0, 1));
  EXPECT_FALSE(x.arbitrary);
}

TYPED_TEST(SegmentTest, NormalWherePointsCoincide_FollowsTheConvention) {
  using Scalar = TypeParam;
  using V = Vec3<Scalar>;
  const auto crossing = closest_points<Scalar>({{-1, 0, 0}, {1, 0, 0}}, {{0, -1, 0}, {0, 1, 0}});
  EXPECT_TRUE(crossing.arbitrary);
  EXPECT_EQ(std::abs(crossing.normal_AB.z()), 1);
  const auto nested = closest_points<Scalar>({{0, 0, 0}, {8, 0, 0}}, {{2, 0, 0}, {4, 0, 0}});
  EXPECT_TRUE(nested.arbitrary);
  EXPECT_EQ(nested.normal_AB.x(), 0);
  const auto on_it = closest_points<Scalar>({{0, 0, 0}, {0, 0, 0}}, {{-1, -1, 0}, {1, 1, 0}});
  EXPECT_TRUE(on_it.arbitrary);
  EXPECT_NEAR(on_it.normal_AB.dot(V(1, 1, 0)), 0, 4 * kRoundOff<Scalar>);
  const auto points = closest_points<Scalar>({{1, 2, 3}, {1, 2, 3}}, {{1, 2, 3}, {1, 2, 3}});
  EXPECT_TRUE(points.arbitrary);
  EXPECT_EQ(points.normal_AB, V::UnitX());
  EXPECT_EQ(points.distance, 0);
}

TYPED_TEST(SegmentTest, NormalOfCrossingSegments_StandsOnBothAtEveryAngle) {
  using Scalar = TypeParam;
  Scalar angle = 1;
  for (int i = 0; i < (sizeof(Scalar) == 4 ? 5 : 12); ++i, angle /= 10) {
    const Segment<Scalar> A{{-1, 0, 0}, {1, 0, 0}};
    const Segment<Scalar> B{{-1, -angle, 0}, {1, angle, 0}};
    const auto x = closest_points(A, B);
    EXPECT_TRUE(x.arbitrary);
    EXPECT_EQ(std::abs(x.normal_AB.z()), 1) << "angle " << angle;
    EXPECT_NEAR(x.distance, 0, 4 * kRoundOff<Scalar>);
  }
}

TYPED_TEST(SegmentTest, ScaleByAPowerOfTwo_ScalesTheAnswerExactly) {
  using Scalar = TypeParam;
  const Segment<Scalar> A{{Scalar(0.3), Scalar(-1.1), Scalar(0.7)}, {Scalar(1.9), Scalar(0.4), 0}};
  const Segment<Scalar> B{{Scalar(0.9), Scalar(1.3), Scalar(-0.2)}, {Scalar(1.1), -1, Scalar(0.8)}};
  const auto x = closest_points(A, B);
  const int largest = std::numeric_limits<Scalar>::max_exponent - 6;
  for (int e = 28 - largest; e <= largest; e += 7) {
    const Scalar k = std::ldexp(Scalar(1), e);
    const auto y = closest_points<Scalar>({k * A.a, k * A.b}, {k * B.a, k * B.b});
    EXPECT_EQ(y.s, x.s) << e;
    EXPECT_EQ(y.u, x.u) << e;
    EXPECT_EQ(y.distance, k * x.distance) << e;
    EXPECT_EQ(y.normal_AB, x.normal_AB) << e;
  }
}

TYPED_TEST(SegmentTest, SubnormalAndLargestCoordinates_AreOrdinary) {
  using Scalar = TypeParam;
  for (const Scalar k :
       {std::numeric_limits<Scalar>::denorm_min(), kLargestCoordinate<Scalar> / 4}) {
    const auto x =
        closest_points<Scalar>({{-k, 0, 0}, {k, 0, 0}}, {{0, -2 * k, 3 * k}, {0, 2 * k, 3 * k}});
    EXPECT_EQ(x.s, Scalar(0.5));
    EXPECT_EQ(x.u, Scalar(0.5));
    EXPECT_EQ(x.distance, 3 * k);
    EXPECT_EQ(x.normal_AB, Vec3<Scalar>(0, 0, 1));
  }
}

TYPED_TEST(SegmentTest, DistanceFromTheOrigin_CostsNothing) {
  using Scalar = TypeParam;
  const Vec3<Scalar> offset(16384, -16384, 16384);
  const Segment<Scalar> A{{0, 0, 0}, {4, Scalar(0.5), 1}};
  const Segment<Scalar> B{{1, 2, -3}, {3, -1, 2}};
  const auto near = closest_points(A, B);
  const auto far =
      closest_points<Scalar>({A.a + offset, A.b + offset}, {B.a + offset, B.b + offset});
  EXPECT_EQ(near.s, far.s);
  EXPECT_EQ(near.u, far.u);
  EXPECT_EQ(near.distance, far.distance);
}

TYPED_TEST(SegmentTest, PointAndSegment_AgreesWithClosedForms) {
  using Scalar = TypeParam;
  using V = Vec3<Scalar>;
  const Segment<Scalar> segment{{0, 0, 0}, {4, 0, 0}};
  const auto beside = closest_point<Scalar>(segment, {1, 3, 4});
  EXPECT_EQ(beside.s, Scalar(0.25));
  EXPECT_EQ(beside.point, V(1, 0, 0));
  EXPECT_EQ(beside.distance, 5);
  EXPECT_EQ(closest_point<Scalar>({segment.b, segment.a}, {1, 3, 4}).s, Scalar(0.75));
  EXPECT_EQ(closest_point<Scalar>(segment, {-3, 4, 0}).s, 0);
  EXPECT_EQ(closest_point<Scalar>(segment, {7, 4, 0}).point, segment.b);
  EXPECT_EQ(closest_point<Scalar>({segment.a, segment.a}, {2, 3, 6}).distance, 7);
  EXPECT_EQ(closest_point<Scalar>(segment, {2, 0, 0}).distance, 0);
}

// Lengths that have to be scaled, at coordinates that could not be.
TEST(ClosestPoints, TinyLengthsFarFromTheOrigin_AreNotScaledAway) {
  const auto near = [](float x, float y) {
    return closest_points<float>({{0, y, 0}, {0, y, 0}}, {{x, y, 0}, {x, y, 0}});
  };
  EXPECT_EQ(near(1e-35F, 300).distance, 1e-35F);
  EXPECT_EQ(near(1e-20F, 1e16F).distance, 1e-20F);
  EXPECT_EQ(near(1e-35F, 300).p_B, Vec3<float>(1e-35F, 300, 0));
  const Segment<float> A{{0, 1e30F, 0}, {1e-9F, 1e30F, 0}};
  const Segment<float> B{{0, 1e30F, 1e-9F}, {1e-9F, 1e30F, 1e-9F}};
  EXPECT_EQ(closest_points<float>(A, B).distance, 1e-9F);
}

// A query in the lowest octaves of the window, the second segment far shorter: its cross product
// would lose bits unscaled.
TEST(ClosestPoints, ShortBesideSmall_IsStillWithinFourRoundOffs) {
  const Segment<float> A{{0x1.d18beep-31F, -0x1.905faap-30F, 0x1.19ec3ep-31F},
                         {-0x1.680e08p-24F, 0x1.35a66p-23F, -0x1.b41458p-25F}};
  const Segment<float> B{{0x1.4a8d0ap-48F, -0x1.c9d002p-51F, -0x1.564e9p-51F},
                         {-0x1.844ff6p-43F, 0x1.0ce7fp-45F, 0x1.921f6p-46F}};
  const auto found = closest_points<float>(A, B);
  const auto wide = [](const Segment<float>& s) {
    return Segment<double>{s.a.cast<double>(), s.b.cast<double>()};
  };
  const double least = closest_points<double>(wide(A), wide(B)).distance;
  const double reached = (wide(B).at(double{found.u}) - wide(A).at(double{found.s})).norm();
  const double size = (wide(A).b - wide(A).a).norm();
  EXPECT_LE(reached - least, 4 * size * static_cast<double>(kRoundOff<float>));
}

}  // namespace
}  // namespace batuta
