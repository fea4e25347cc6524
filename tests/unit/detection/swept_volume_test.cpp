// SPDX-License-Identifier: MIT
#include "batuta/detection/swept_volume.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "batuta/geometry/direction.hpp"
#include "moving.hpp"
#include "swept_truth.hpp"

namespace batuta {
namespace {

using namespace testing_detection;

constexpr double kPi = 3.14159265358979324;

template <class Scalar>
class SweptVolumeOf : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(SweptVolumeOf, Scalars);

/// How far the capsule sticks out of the swept volume along direction i, m; the truth comes from
/// the poses.
template <class Scalar, int K>
double leak(const Kdop<Scalar, K>& swept, const Capsule<double>& capsule, int i) {
  const Vec3<double> up = detail::kdop_direction<double, K>(i);
  const auto k = static_cast<std::size_t>(i);
  const double over = support(capsule, up) - static_cast<double>(swept.high[k]);
  const double under = support<double>(capsule, -up) + static_cast<double>(swept.low[k]);
  return max_of(over, under);
}

template <class Scalar, int K>
void expect_no_leak(const MovingCapsule<Scalar>& m, int samples) {
  const Kdop<Scalar, K> exact = detail::swept_kdop<Scalar, K>(m);
  const Kdop<Scalar, K> coarse = detail::coarse_swept_kdop<Scalar, K>(m);
  for (int j = 0; j <= samples; ++j) {
    const double t = static_cast<double>(m.motion.duration) * j / samples;
    const Capsule<double> capsule = capsule_by_pose(m, t);
    for (int i = 0; i < K / 2; ++i) {
      ASSERT_LE((leak<Scalar, K>(exact, capsule, i)), 0) << t << ' ' << i;
      ASSERT_LE((leak<Scalar, K>(coarse, capsule, i)), 0) << t << ' ' << i;
    }
  }
}

constexpr std::array<double, 11> kTurns = {0,       1e-7, 1e-3, 0.0624, 0.0626, 0.3,
                                           kPi / 2, kPi,  4,    5,      7 * kPi};

/// How far a face of the coarse form may be outside of the exact one, over the lever: that of the
/// chord, or, up to 1/16 rad, of the tangent.
double coarseness(double turn) {
  return turn * turn / (turn <= 0.0625 ? 1 : 8);
}

TYPED_TEST(SweptVolumeOf, DenseSamples_NeverLeak) {  // B01, B02
  std::mt19937 random(6);
  for (const double turn : kTurns) {
    for (int i = 0; i < 40; ++i) {
      const double scale = std::exp2(8 * signed_unit(random));
      const auto m = random_moving<TypeParam>(random, turn, scale);
      expect_no_leak<TypeParam, 6>(m, 200);
      expect_no_leak<TypeParam, 14>(m, 50);
      expect_no_leak<TypeParam, 18>(m, 50);
      expect_no_leak<TypeParam, 26>(m, 50);
    }
  }
}

TYPED_TEST(SweptVolumeOf, FarFromTheOrigin_NeverLeaks) {
  std::mt19937 random(7);
  for (int i = 0; i < 50; ++i) {
    auto m = random_moving<TypeParam>(random, 2);
    m.motion.X_WB.p_W += Vec3<TypeParam>(TypeParam(1e4), TypeParam(-1e4), TypeParam(1e4));
    expect_no_leak<TypeParam, 26>(m, 100);
  }
}

template <class Scalar, int K>
void expect_holds_both_ends(const MovingCapsule<Scalar>& m, const Vec3<Scalar>& end_W) {
  const Kdop<Scalar, K> swept = detail::swept_kdop<Scalar, K>(m);
  const Vec3<Scalar>& start_W = m.motion.X_WB.p_W;
  for (int i = 0; i < K / 2; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const double start =
        detail::kdop_direction<double, K>(i).dot(start_W.template cast<double>() / 4);
    const double end = detail::kdop_direction<double, K>(i).dot(end_W.template cast<double>() / 4);
    ASSERT_LE(max_of(start, end), static_cast<double>(swept.high[k]) / 4) << K << ' ' << i;
    ASSERT_GE(min_of(start, end), static_cast<double>(swept.low[k]) / 4) << K << ' ' << i;
  }
}

// Where sums of lengths overflow, infinity - infinity or 0 * infinity must not make a face vanish.
TYPED_TEST(SweptVolumeOf, StartBeyondAllSums_NeverLeaks) {
  auto m = moving<TypeParam>({{0, 0, 0}, {0, 0, 0}, {0, 1, 0}, 0.5, {0, 0, 0}, {0, 0, 1}});
  m.motion.X_WB.p_W.fill(std::numeric_limits<TypeParam>::max() * TypeParam(0.55));
  m.motion.X_WB.p_W.z() *= -1;  // (1, 1, 1) . start is a number, but not its first sum
  const Kdop<TypeParam, 26> swept = detail::swept_kdop<TypeParam, 26>(m);
  for (std::size_t i = 0; i < swept.low.size(); ++i) {
    ASSERT_LE(swept.low[i], std::numeric_limits<TypeParam>::lowest()) << i;
    ASSERT_GE(swept.high[i], std::numeric_limits<TypeParam>::max()) << i;
  }
}

TYPED_TEST(SweptVolumeOf, TravelBeyondAllNumbers_NeverLeaks) {
  constexpr TypeParam kMost = std::numeric_limits<TypeParam>::max();
  for (const TypeParam share : {TypeParam(0.05), TypeParam(0.12), TypeParam(0.3), TypeParam(0.9)}) {
    for (const TypeParam duration : {TypeParam(1), TypeParam(8)}) {
      auto m = moving<TypeParam>({{0, 0, 0}, {0, 0, 0}, {0, 1, 0}, 0.5, {0, 0, 0}, {0, 0, 1}});
      const Vec3<TypeParam> way(1, TypeParam(-0.5), TypeParam(0.25));
      m.motion.twist.v_W = kMost * share * way;
      m.motion.duration = duration;
      // It comes at least that far, for its longest component is a number there.
      const Vec3<TypeParam> end_W = kMost * min_of(share * duration, TypeParam(0.5)) * way;
      expect_holds_both_ends<TypeParam, 6>(m, end_W);
      expect_holds_both_ends<TypeParam, 14>(m, end_W);
      expect_holds_both_ends<TypeParam, 18>(m, end_W);
      expect_holds_both_ends<TypeParam, 26>(m, end_W);
    }
  }
}

TYPED_TEST(SweptVolumeOf, TravelAtTheSpeedOfTheEnd_NeverLeaks) {  // B03: a double extremum
  for (const double v : {-2.0, 2.0}) {
    const auto m =
        moving<TypeParam>({{0, 0, 0}, {1, 0, 0}, {0, 0, 0}, 0.1, {0, v, 0}, {0, 0, 2}}, 3);
    expect_no_leak<TypeParam, 26>(m, 1000);
  }
}

TYPED_TEST(SweptVolumeOf, AxisAlongADirection_IsTight) {  // B04
  const auto m = moving<TypeParam>({{0, 0, 0}, {0, 0, -1}, {0, 0, 2}, 0.25, {0, 0, 0}, {0, 0, 9}});
  const auto box = swept_aabb(m);
  EXPECT_NEAR(static_cast<double>(box.high[0]), 0.25, 1e-4);
  EXPECT_NEAR(static_cast<double>(box.high[2]), 2.25, 1e-4);
  EXPECT_NEAR(static_cast<double>(box.low[2]), -1.25, 1e-4);
}

/// The directions of the 26-DOP, both ways, and a few others.
template <class Scalar>
std::vector<Vec3<Scalar>> some_directions(std::mt19937& random) {
  std::vector<Vec3<Scalar>> directions;
  for (int i = 0; i < 13; ++i) {
    directions.push_back(detail::kdop_direction<Scalar, 26>(i));
    directions.push_back(-directions.back());
  }
  for (int i = 0; i < 6; ++i) directions.push_back(random_vector(random, 1).cast<Scalar>());
  return directions;
}

/// Never below the truth, and above it by what is promised; without what it is moved outward by,
/// within 8 u S of it, S the sum of the lengths, and the rounding of the turn.
template <class Scalar>
void expect_true_support(const MovingCapsule<Scalar>& m, const Vec3<Scalar>& direction) {
  const detail::CapsuleSweep<Scalar> sweep = detail::capsule_sweep(m);
  const Exact size = direction.template cast<Exact>().norm();
  const Exact over = detail::swept_support(sweep, direction) - true_support(m, direction);
  const Exact reach = max_of(length(m.capsule_B.axis.a), length(m.capsule_B.axis.b));
  const Exact slip = 12 * kRoundOff<Scalar> * static_cast<Exact>(sweep.turn) * reach;
  const Exact sum = reach + m.capsule_B.radius + length(sweep.start_W) + length(sweep.travel_W);
  ASSERT_GE(over, 0) << sweep.turn;
  ASSERT_LE(over, size * (2 * sweep.outward + slip)) << sweep.turn;
  ASSERT_NEAR(static_cast<double>((over / size - sweep.outward) / sum), 0,
              static_cast<double>(8 * kRoundOff<Scalar> + slip / sum))
      << sweep.turn;
}

template <class Scalar>
void expect_true_supports(const MovingCapsule<Scalar>& m, std::mt19937& random) {
  for (const Vec3<Scalar>& d : some_directions<Scalar>(random)) expect_true_support(m, d);
}

TYPED_TEST(SweptVolumeOf, Support_IsTheTrueMaximum) {  // B01, B02
  std::mt19937 random(11);
  for (const double turn : kTurns) {
    for (int i = 0; i < 12; ++i) {
      auto m = random_moving<TypeParam>(random, turn, std::exp2(8 * signed_unit(random)));
      m.motion.twist.v_W *= std::array{TypeParam(1), TypeParam(0.1), TypeParam(0)}[i % 3U];
      expect_true_supports(m, random);
    }
  }
}

TYPED_TEST(SweptVolumeOf, SupportAtAnyScale_IsTheTrueMaximum) {
  std::mt19937 random(12);
  const double huge = static_cast<double>(kLargestCoordinate<TypeParam>) / 16;
  const double tiny = static_cast<double>(std::numeric_limits<TypeParam>::min()) * 0x1p40;
  for (const double scale : {tiny, std::sqrt(tiny), std::sqrt(huge), huge}) {
    for (int i = 0; i < 5; ++i) {
      expect_true_supports(random_moving<TypeParam>(random, 3, scale), random);
    }
  }
}

// Hundreds of turns: the first or the last extreme is found without counting them off.
TYPED_TEST(SweptVolumeOf, SupportOfALongSpin_IsTheTrueMaximum) {
  std::mt19937 random(13);
  for (const double turn : {100.0, static_cast<double>(detail::kMaxAngle<TypeParam>)}) {
    for (const double drift : {0.0, 1.0, 50.0}) {
      auto m = moving<TypeParam>({{1, 2, 3},
                                  {0.5, -0.25, 1},
                                  {-1, 0.5, -0.5},
                                  0.1,
                                  drift * random_vector(random, 1),
                                  0.999 * turn * Vec3<double>(0.48, -0.6, 0.64)});
      for (const Vec3<TypeParam>& d :
           {Vec3<TypeParam>(1, 0, 0), Vec3<TypeParam>(0, -1, 1), Vec3<TypeParam>(0, 0, 1)}) {
        expect_true_support(m, d);
      }
    }
  }
}

TYPED_TEST(SweptVolumeOf, SpinBeyondTheAngles_StillHoldsTheCapsule) {
  for (const double w : {1.0, 1e12}) {
    const auto m =
        moving<TypeParam>({{0, 0, 0}, {0, 1, 0}, {0, 0, 0}, 0.25, {1, 0, 0}, {0, 0, w}}, 1e5);
    const Aabb<TypeParam> box = swept_aabb(m);
    EXPECT_GE(box.high[0], TypeParam(1e5 + 1.25));
    EXPECT_LE(box.low[0], TypeParam(-1.25));
    EXPECT_LE(box.low[1], TypeParam(-1.25));
  }
}

// B03: the end just stands still on its way: two extremes become one.
TYPED_TEST(SweptVolumeOf, SupportAtTheSpeedOfTheEnd_IsTheTrueMaximum) {
  std::mt19937 random(14);
  for (const double way : {-1.0, 1.0}) {
    for (const double off : {-1e-3, -16.0, -2.0, -1.0, 0.0, 1.0, 2.0, 16.0, 1e-3}) {
      const double ulps = std::abs(off) < 1 ? off : off * 2 * double(kRoundOff<TypeParam>);
      for (const double turn : {0.3, kPi / 2, kPi, 3.5, 2 * kPi, 7 * kPi}) {
        const auto m = moving<TypeParam>({{0, 0, 0},
                                          {0.75, 0, 0},
                                          {0, 0, 0},
                                          0.1,
                                          {0, way * 0.75 * turn * (1 + ulps), 0},
                                          {0, 0, turn}});
        expect_true_supports(m, random);
      }
    }
  }
}

TYPED_TEST(SweptVolumeOf, SupportAlongTheAxisOfTurn_IsThatOfTheTravel) {  // B04
  std::mt19937 random(15);
  for (const double turn : kTurns) {
    for (const double v : {-3.0, 0.0, 0.5}) {
      expect_true_supports(
          moving<TypeParam>({{0, 0, 0}, {1, 0, -1}, {0, 1, 2}, 0.25, {0, 0, v}, {0, 0, turn}}),
          random);
    }
  }
}

TYPED_TEST(SweptVolumeOf, SupportInNoTime_IsThatOfTheCapsule) {
  std::mt19937 random(16);
  for (int i = 0; i < 20; ++i) {
    auto m = random_moving<TypeParam>(random, 3);
    m.motion.duration = 0;
    expect_true_supports(m, random);
  }
}

template <class Scalar, int K>
void expect_tight(const MovingCapsule<Scalar>& m) {
  const Kdop<Scalar, K> swept = detail::swept_kdop<Scalar, K>(m);
  const detail::CapsuleSweep<Scalar> sweep = detail::capsule_sweep(m);
  const double slack = 2 * double(sweep.outward) + 24 * double(kRoundOff<Scalar> * sweep.turn);
  for (int i = 0; i < K / 2; ++i) {
    const Vec3<Scalar> up = detail::kdop_direction<Scalar, K>(i);
    const auto k = static_cast<std::size_t>(i);
    const double over = double(swept.high[k] - true_support(m, up));
    const double under = double(-swept.low[k] - true_support<Scalar>(m, -up));
    EXPECT_GE(min_of(over, under), 0) << K << ' ' << i;
    EXPECT_LE(max_of(over, under), slack * double(length(up))) << K << ' ' << i;
  }
}

TYPED_TEST(SweptVolumeOf, Faces_TouchTheSweptCapsule) {  // B01
  std::mt19937 random(17);
  for (const double turn : kTurns) {
    const auto m = random_moving<TypeParam>(random, turn);
    expect_tight<TypeParam, 6>(m);
    expect_tight<TypeParam, 14>(m);
    expect_tight<TypeParam, 18>(m);
    expect_tight<TypeParam, 26>(m);
  }
}

TYPED_TEST(SweptVolumeOf, HundredThousandSamples_NeverLeak) {  // B01
  std::mt19937 random(18);
  expect_no_leak<TypeParam, 26>(random_moving<TypeParam>(random, kPi), 100000);
}

TYPED_TEST(SweptVolumeOf, CoarseForm_IsLargerByChordOrTangentAtMost) {
  std::mt19937 random(19);
  int smaller = 0;
  for (const double turn : kTurns) {
    for (int i = 0; i < 100; ++i) {
      const auto m = random_moving<TypeParam>(random, turn);
      const auto exact = detail::swept_kdop<TypeParam, 26>(m);
      const auto coarse = detail::coarse_swept_kdop<TypeParam, 26>(m);
      const auto sweep = detail::capsule_sweep(m);
      const TypeParam slack = 4 * sweep.outward;
      const TypeParam sagitta = static_cast<TypeParam>(coarseness(double(sweep.turn))) *
                                max_of(length(m.capsule_B.axis.a), length(m.capsule_B.axis.b));
      for (std::size_t k = 0; k < 13; ++k) {
        ASSERT_LE(exact.high[k], coarse.high[k] + slack);
        ASSERT_GE(exact.low[k], coarse.low[k] - slack);
        ASSERT_LE(coarse.high[k], exact.high[k] + TypeParam(1.74) * sagitta + 2 * slack);
        if (exact.high[k] < coarse.high[k] - slack) ++smaller;
      }
    }
  }
  EXPECT_GT(smaller, 3000);
}

TYPED_TEST(SweptVolumeOf, AtRest_IsTheBoxOfTheCapsule) {
  std::mt19937 random(8);
  for (int i = 0; i < 50; ++i) {
    auto m = random_moving<TypeParam>(random, 0);
    m.motion.twist = {};
    const auto swept = swept_aabb(m);
    const Capsule<double> capsule = capsule_by_pose(m, 0);
    for (int d = 0; d < 3; ++d) {
      const double slack = -leak<TypeParam, 6>(swept, capsule, d);
      EXPECT_LE(slack, 200 * static_cast<double>(kRoundOff<TypeParam>) * 8);
    }
  }
}

TYPED_TEST(SweptVolumeOf, CoarseBox_IsNoLargerThanThatOfTheSphereAndTheTangent) {
  std::mt19937 random(9);
  for (const double turn : kTurns) {
    for (int i = 0; i < 100; ++i) {
      const auto m = random_moving<TypeParam>(random, turn);
      const auto box = detail::coarse_swept_aabb(m);
      const auto ball = detail::swept_sphere(m);
      const TypeParam lever = max_of(length(m.capsule_B.axis.a), length(m.capsule_B.axis.b));
      const TypeParam tangent = turn <= 0.0625 ? TypeParam(coarseness(turn)) * lever : TypeParam(0);
      const TypeParam slack = 512 * kRoundOff<TypeParam> + TypeParam(1.01) * tangent;
      for (int d = 0; d < 3; ++d) {
        const auto k = static_cast<std::size_t>(d);
        EXPECT_LE(box.high[k], max_of(ball.start_W[d], ball.end_W[d]) + ball.radius + slack);
        EXPECT_GE(box.low[k], min_of(ball.start_W[d], ball.end_W[d]) - ball.radius - slack);
      }
    }
  }
}

TYPED_TEST(SweptVolumeOf, SmallTurnOfABlade_IsMuchSmallerThanTheSphere) {
  const auto m = moving<TypeParam>(
      {{0, 0, 0}, {-0.3, 0, 0}, {0.7, 0, 0}, 0.005, {1, 0, 0}, {0, 0, 5}}, 1.0 / 60);
  const auto box = swept_aabb(m);
  const double height = static_cast<double>(box.high[1] - box.low[1]);
  const double ball = 2 * static_cast<double>(detail::swept_sphere(m).radius);
  EXPECT_LT(height, 0.11 * ball);
  const double exact =
      1.0 * std::sin(5.0 / 60) + 0.01;  // both ends rise and fall: 0.7 sin + 0.3 sin
  EXPECT_NEAR(height, exact, 1e-3);
}

TYPED_TEST(SweptVolumeOf, Sphere_HoldsTheCapsule) {
  std::mt19937 random(10);
  for (int i = 0; i < 300; ++i) {
    const auto m = random_moving<TypeParam>(random, 9);
    const auto ball = detail::swept_sphere(m);
    for (int j = 0; j <= 20; ++j) {
      const Capsule<double> capsule = capsule_by_pose(m, j / 20.0);
      const Vec3<double> start = ball.start_W.template cast<double>();
      const Vec3<double> end = ball.end_W.template cast<double>();
      for (const Vec3<double>& p : {capsule.axis.a, capsule.axis.b}) {
        const double off = closest_point(Segment<double>{start, end}, p).distance;
        ASSERT_LE(off + capsule.radius, static_cast<double>(ball.radius));
      }
    }
  }
}

TYPED_TEST(SweptVolumeOf, SpheresOverlap_RoundsTowardsYes) {
  const detail::SweptSphere<TypeParam> P{{0, 0, 0}, {10, 0, 0}, TypeParam(0.1)};
  const auto at = [](double y) {
    const auto z = static_cast<TypeParam>(y);
    return detail::SweptSphere<TypeParam>{{5, z, -3}, {5, z, 3}, TypeParam(0.2)};
  };
  EXPECT_TRUE(overlaps(P, at(0)));
  EXPECT_TRUE(overlaps(P, at(0.3)));
  EXPECT_FALSE(overlaps(P, at(0.301)));
  EXPECT_FALSE(overlaps(P, at(50)));
}

TYPED_TEST(SweptVolumeOf, PendulumDip_SurvivesTheBroadPhase) {  // B06: the pair of T37
  const double turn = 40 * kPi / 180;
  const Vec3<double> d(-std::sin(turn / 2), 0, -std::cos(turn / 2));
  const auto A = moving<TypeParam>({{0, 0, 0}, {-2, 0, 0}, {2, 0, 0}, 0.05});
  const auto B = moving<TypeParam>({{0, 0, 1.05}, 0.5 * d, d, 0.05, {0, 0, 0}, {0, -turn, 0}});
  EXPECT_TRUE(overlaps(swept_aabb(A), swept_aabb(B)));
  EXPECT_TRUE(overlaps(detail::coarse_swept_aabb(A), detail::coarse_swept_aabb(B)));
  EXPECT_TRUE(overlaps(detail::swept_kdop<TypeParam, 26>(A), detail::swept_kdop<TypeParam, 26>(B)));
  EXPECT_TRUE(overlaps(detail::swept_sphere(A), detail::swept_sphere(B)));
}

}  // namespace
}  // namespace batuta
