// SPDX-License-Identifier: MIT
// Balls, tubes and faces entered at instants that are known, and whole casts against the distance
// of the segments, which falls and rises once: what translates is convex.
#include "../../../src/detection/rounded_parallelogram.hpp"

#include <gtest/gtest.h>

#include "moving.hpp"

namespace batuta {
namespace {

using testing_detection::random_vector;
using testing_detection::signed_unit;
using V = Vec3<double>;

constexpr double kNone = kNever<double>;

/// A leg of 3 and a hypotenuse of 5: the ball is entered 4 before the foot.
TEST(EnterBall, PythagoreanPass_IsEnteredBeforeTheFoot) {
  EXPECT_DOUBLE_EQ(enter_ball<double>({-10, 3, 0}, {2, 0, 0}, 5), 3.0);
  EXPECT_DOUBLE_EQ(enter_ball<double>({0, 0, 10}, {0, 0, -4}, 2), 2.0);
}

TEST(EnterBall, GoneByOrGoingAwayOrWithin_IsNever) {
  EXPECT_EQ(enter_ball<double>({-10, 5.001, 0}, {2, 0, 0}, 5), kNone) << "passes";
  EXPECT_EQ(enter_ball<double>({-10, 3, 0}, {-2, 0, 0}, 5), kNone) << "leaves";
  EXPECT_EQ(enter_ball<double>({-1, 0, 0}, {2, 0, 0}, 5), kNone) << "is there";
  EXPECT_EQ(enter_ball<double>({-10, 0, 0}, {0, 0, 0}, 5), kNone) << "stands";
}

/// The tube of radius 5 about 8 m along z; the pass of before, at a height.
TEST(EnterTube, BesideTheEdge_IsEnteredAsABall) {
  const detail::Side<double> side({0, 0, 8}, {2, 0, 0});
  for (const double height : {0.0, 0.5, 4.0, 8.0}) {
    EXPECT_DOUBLE_EQ(enter_tube<double>({-10, 3, height}, {2, 0, 0}, side, 5), 3.0) << height;
  }
}

TEST(EnterTube, BeyondEitherEnd_IsNever) {
  const detail::Side<double> side({0, 0, 8}, {2, 0, 0});
  for (const double height : {-100.0, -0.01, 8.01, 100.0}) {
    EXPECT_EQ(enter_tube<double>({-10, 3, height}, {2, 0, 0}, side, 5), kNone) << height;
  }
}

/// What counts is the height at the entry, not at the start.
TEST(EnterTube, SlantedPass_IsJudgedWhereItEnters) {
  const V travel{2, 0, 3};
  const detail::Side<double> side({0, 0, 8}, travel);
  EXPECT_DOUBLE_EQ(enter_tube<double>({-10, 3, -5}, travel, side, 5), 3.0) << "at 4 m";
  EXPECT_EQ(enter_tube<double>({-10, 3, 1}, travel, side, 5), kNone) << "at 10 m";
  EXPECT_EQ(enter_tube<double>({-10, 3, -10}, travel, side, 5), kNone) << "at -1 m";
}

TEST(EnterTube, EdgeWithoutLength_IsNever) {
  const detail::Side<double> side({0, 0, 0}, {2, 0, 0});
  EXPECT_EQ(enter_tube<double>({-10, 3, 0}, {2, 0, 0}, side, 5), kNone);
}

/// Two bars, 4 m along x and 6 m along y, one above the other by 7 m: 2 m/s bring them to rho = 1
/// after 3 s, while they are crossed.
Cast<double> crossing(double above, const V& travel) {
  return {{{-2, 0, 0}, {2, 0, 0}}, {{0, -3, above}, {0, 3, above}}, travel, 1.0};
}

TEST(EnterFace, CrossedBars_MeetFromEitherSide) {
  EXPECT_DOUBLE_EQ(enter_face(crossing(7, {0, 0, -2})), 3.0);
  EXPECT_DOUBLE_EQ(enter_face(crossing(-7, {0, 0, 2})), 3.0);
  for (const double x : {-1.9, 1.9}) {
    for (const double y : {-2.9, 2.9}) {
      EXPECT_DOUBLE_EQ(enter_face(crossing(7, {x / 3, y / 3, -2})), 3.0) << x << ' ' << y;
    }
  }
}

TEST(EnterFace, NotAcrossWhenLevel_IsNever) {
  for (const V& moved : {V{-2.1, 0, 0}, V{2.1, 0, 0}, V{0, -3.1, 0}, V{0, 3.1, 0}}) {
    EXPECT_EQ(enter_face(crossing(7, moved / 3 + V{0, 0, -2})), kNone)
        << moved.x() << ' ' << moved.y();
  }
}

TEST(EnterFace, WithinOrGoingAwayOrParallel_IsNever) {
  EXPECT_EQ(enter_face(crossing(0.9, {0, 0, -2})), kNone);
  EXPECT_EQ(enter_face(crossing(7, {0, 0, 2})), kNone);
  EXPECT_EQ(enter_face(crossing(7, {1, 0, 0})), kNone);
  const Cast<double> parallel{{{-2, 0, 0}, {2, 0, 0}}, {{-2, 0, 7}, {2, 0, 7}}, {0, 0, -2}, 1.0};
  EXPECT_EQ(enter_face(parallel), kNone);
}

double distance_at(const Cast<double>& cast, double t) {
  const V moved = cast.travel * t;
  return closest_points<double>(cast.A, {cast.B.a + moved, cast.B.b + moved}).distance;
}

/// Where the distance is least on [0, end]: by thirds, as it is convex.
double nearest_instant(const Cast<double>& cast, double end) {
  double low = 0;
  double high = end;
  for (int i = 0; i < 120; ++i) {
    const double third = (high - low) / 3;
    const bool left = distance_at(cast, low + third) < distance_at(cast, high - third);
    (left ? high : low) = left ? high - third : low + third;
  }
  return (low + high) / 2;
}

/// Sizes of 3 at most, so that no length is more than 24 while anything happens; a tenth at most
/// are balls or share a direction.
Cast<double> random_cast(std::mt19937& random) {
  Cast<double> cast;
  cast.A = {random_vector(random, 3), random_vector(random, 3)};
  cast.B.a = random_vector(random, 3) + V{6, 0, 0};
  cast.B.b = random_vector(random, 3) + V{6, 0, 0};
  const double kind = signed_unit(random);
  if (kind < -0.9) cast.A.b = cast.A.a;
  if (kind > 0.9) cast.B.b = cast.B.a;
  if (std::abs(kind) < 0.05) cast.B.b = cast.B.a + cast.A.direction() / 2;
  cast.travel = random_vector(random, 3) - V{6, 0, 0};
  cast.rho = 0.55 + 0.45 * signed_unit(random);
  return cast;
}

/// A radicand is a sum of squares of at most L^2, wrong by some 8 u L^2; so the distance on entry
/// is wrong by that over 2 rho, or by 8 u L where nothing grazes.
double bound_of(const Cast<double>& cast) {
  constexpr double kLongest = 24;
  return 8 * kRoundOff<double> * kLongest * (1 + kLongest / cast.rho);
}

TEST(FirstEntry, RandomCasts_AgreeWithTheDistance) {
  std::mt19937 random(20061107);
  int hits = 0;
  int misses = 0;
  constexpr double kEnd = 8;  // by then all are past each other
  for (int i = 0; i < 4000; ++i) {
    const Cast<double> cast = random_cast(random);
    if (distance_at(cast, 0) <= cast.rho) continue;
    const double bound = bound_of(cast);
    const double nearest = nearest_instant(cast, kEnd);
    const double least = distance_at(cast, nearest);
    const double found = first_entry(cast);
    if (least > cast.rho + bound) {
      ++misses;
      EXPECT_EQ(found, kNone) << i << ": " << least - cast.rho;
    } else if (least < cast.rho - bound) {
      ++hits;
      ASSERT_LE(found, nearest) << i;
      EXPECT_NEAR(distance_at(cast, found), cast.rho, bound) << i;
    }
  }
  EXPECT_GT(hits, 500);
  EXPECT_GT(misses, 500);
}

}  // namespace
}  // namespace batuta
