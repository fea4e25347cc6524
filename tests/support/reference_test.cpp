// SPDX-License-Identifier: MIT
#include "reference.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "../vectors/judge_file.hpp"
#include "contact_row.hpp"
#include "draws.hpp"
#include "exact_distance.hpp"

namespace batuta::test {
namespace {

using Wide = long double;

constexpr double kPi = 3.14159265358979324;

MovingCapsule<double> rod(const Vec3<double>& center, const Vec3<double>& half, double radius) {
  MovingCapsule<double> m;
  m.capsule_B = {{-half, half}, radius};
  m.motion.X_WB.p_W = center;
  m.motion.duration = 1;
  return m;
}
MovingCapsule<double> ball(const Vec3<double>& center, double radius, const Vec3<double>& v) {
  MovingCapsule<double> m = rod(center, Vec3<double>::Zero(), radius);
  m.motion.twist.v_W = v;
  return m;
}
MovingCapsule<double> turning_bar(double rate) {
  MovingCapsule<double> m = rod({0, 0, 0}, {1, 0, 0}, 0.05);
  m.motion.twist.w_W = {0, 0, rate};
  return m;
}

Wide first_contact(const Reference<Wide>& truth) {
  const March<Wide> march = truth.march(1e-16L * truth.scale());
  EXPECT_EQ(march.verdict, Verdict::kReached);
  return march.t_free;
}

void expect_least_distance(const Segment<double>& A, const Segment<double>& B) {
  const auto wide = [](const Segment<double>& s) {
    return std::array<Vec3<Wide>, 2>{s.a.cast<Wide>(), s.b.cast<Wide>()};
  };
  const Wide found = nearest_points<Wide>(wide(A), wide(B)).distance;
  const Wide S = exact::visible_length(A, B);
  EXPECT_NEAR(static_cast<double>(found), static_cast<double>(exact::least_distance(A, B)),
              static_cast<double>(S) * 1e-15);
}

TEST(ReferenceDistance, RandomAxes_IsTheLeast) {
  Draws draws(1, 0, 0);
  for (int i = 0; i < 2000; ++i) {  // Bound: 2000 pairs
    const Vec3<double> a = draws.direction();
    const Vec3<double> b = draws.direction();
    const Vec3<double> c = draws.in_ball(2);
    const Vec3<double> d = draws.direction();
    expect_least_distance({a, b}, {c, c + d});
    const double tilt = draws.power_of_two(-40, 0);
    expect_least_distance({a, b}, {c, c + (b - a) + tilt * d});
  }
}

TEST(ReferenceDistance, Degenerate_IsTheLeast) {
  const Vec3<double> o = Vec3<double>::Zero();
  const Vec3<double> x = Vec3<double>::UnitX();
  const Vec3<double> y = Vec3<double>::UnitY();
  expect_least_distance({o, o}, {x, x});
  expect_least_distance({o, o}, {o, o});
  expect_least_distance({-x, x}, {y, y});
  expect_least_distance({-x, x}, {-x, x});
  expect_least_distance({-x, x}, {-y, y});
  expect_least_distance({o, x}, {2 * x, 3 * x});
  expect_least_distance({-x, x}, {y, x + y});
}

TEST(Reference, TwoBalls_MeetWhereTheQuadraticSays) {
  Draws draws(2, 0, 0);
  int hits = 0;
  for (int i = 0; i < 500; ++i) {  // Bound: 500 pairs
    const Vec3<double> from = 3 * draws.direction();
    const Vec3<double> towards = draws.in_ball(0.8);
    const Vec3<double> v = draws.between(2, 8) * (towards - from);
    const Reference<Wide> truth(ball({0, 0, 0}, 0.2, {0, 0, 0}), ball(from, 0.3, v));
    const Vec3<Wide> p = from.cast<Wide>();
    const Vec3<Wide> speed = v.cast<Wide>();
    const Wide b = p.dot(speed);
    const Wide R = Wide(0.2) + Wide(0.3);
    const Wide inside = b * b - speed.squaredNorm() * (p.squaredNorm() - R * R);
    if (inside <= 0) {
      EXPECT_EQ(truth.march(1e-16L * truth.scale()).verdict, Verdict::kFree);
      continue;
    }
    ++hits;
    const Wide t = (p.squaredNorm() - R * R) / (-b + std::sqrt(inside));
    EXPECT_NEAR(static_cast<double>(first_contact(truth) - t), 0, 1e-14);
  }
  EXPECT_GT(hits, 100);
}

TEST(Reference, BarTurnsAgainstPost_MeetsAtTheArcCosine) {
  const Reference<Wide> truth(turning_bar(kPi), rod({0, 0.8, 0}, {0, 0, 1}, 0.05));
  const Wide R = Wide(0.05) + Wide(0.05);
  const Wide t = std::acos(R / Wide(0.8)) / Wide(kPi);
  EXPECT_NEAR(static_cast<double>(first_contact(truth) - t), 0, 1e-14);
  EXPECT_NEAR(static_cast<double>(t), 0.460106912325, 1e-12);
}

TEST(Reference, BarEndPassesPost_LeastGapHalfWay) {
  const Reference<double> truth(turning_bar(kPi), rod({0, 1.25, 0}, {0, 0, 1}, 0.05));
  const LeastGap<double> least = truth.least_gap(0, 1, 64);
  EXPECT_NEAR(least.gap, 0.15, 1e-14);
  EXPECT_NEAR(least.t, 0.5, 1e-6);
  EXPECT_EQ(truth.march(1e-12).verdict, Verdict::kFree);
}

TEST(Reference, TurnedBody_StartsWhereItsQuaternionSays) {
  MovingCapsule<double> A = rod({5, 0, 0}, {1, 0, 0}, 0.1);
  A.motion.X_WB.q_WB = Quat<double>(1, 0, 0, 1);  // a quarter turn about z, not of unit length
  const Reference<double> truth(A, rod({5, 3, 0}, {0, 0, 0}, 0.2));
  EXPECT_NEAR(truth.gap(0), 1.7, 1e-15);
}

TEST(Reference, BriefOverlap_IsFoundNearItsBeginning) {
  const Reference<double> truth(rod({0, 0, 0}, {0, 0, 1}, 0.01),
                                ball({-50, 0, 0}, 0.01, {1000, 0, 0}));
  const March<double> march = truth.march(1e-12 * truth.scale());
  ASSERT_EQ(march.verdict, Verdict::kReached);
  EXPECT_NEAR(march.t_free, 0.04998, 1e-12);
  EXPECT_NEAR(truth.least_gap_after(march.t_free, 24).gap, -0.02, 1e-12);
}

TEST(Reference, TooFewEvaluations_SaysUnknown) {
  const Reference<double> truth(turning_bar(kPi), rod({0, 1.10001, 0}, {0, 0, 1}, 0.05));
  const March<double> march = truth.march(1e-12, 3);
  EXPECT_EQ(march.verdict, Verdict::kUnknown);
  EXPECT_EQ(march.evaluations, 3U);
  EXPECT_LT(march.t_free, 1);
}

TEST(Reference, OverlapAtStart_IsReachedAtOnce) {
  const Reference<double> truth(turning_bar(1), rod({0, 0, 0}, {0, 0, 1}, 0.05));
  const March<double> march = truth.march(1e-12);
  EXPECT_EQ(march.verdict, Verdict::kReached);
  EXPECT_EQ(march.t_free, 0);
}

TEST(Reference, ZeroDuration_IsFreeWhereApart) {
  MovingCapsule<double> A = turning_bar(1);
  A.motion.duration = 0;
  EXPECT_EQ(Reference<double>(A, rod({0, 3, 0}, {0, 0, 1}, 0.05)).march(1e-12).verdict,
            Verdict::kFree);
}

/// Holds the reference against another's exact answers.
class TruthJudge {
 public:
  void judge(host::QueryRow& row) {
    // The quaternions as they are: the reference makes them unit in its own precision.
    const MovingCapsule<float> A = read_bits(row, "A");
    const MovingCapsule<float> B = read_bits(row, "B");
    const ContactTruth known = read_truth(row);
    ASSERT_TRUE(row.ok()) << row.error();
    const Reference<double> truth(A, B);
    const March<double> march = truth.march(2 * truth.rounding());
    ++queries_;
    // The file gives the least gap with ten digits.
    const double error = known.gap_error + 4 * truth.rounding() + 6e-10 * std::abs(known.least_gap);
    if (march.verdict == Verdict::kUnknown) {
      ++unknown_;
    } else if (known.kind == kNever) {
      expect_free(row.line(), truth, march, known, error);
    } else {
      ASSERT_EQ(march.verdict, Verdict::kReached) << "line " << row.line();
      const double late = (march.t_free - known.t) * std::abs(known.rate);
      EXPECT_LE(late, error) << "line " << row.line();
      EXPECT_TRUE(known.kind != kAtStart || march.t_free == 0) << "line " << row.line();
      EXPECT_LE(truth.least_gap_after(march.t_free, 24).gap, error) << "line " << row.line();
    }
  }

  void report(const char* /*scalar*/, const Evidence& evidence) const {
    EXPECT_GE(queries_, static_cast<long>(evidence.rows));
    EXPECT_LE(unknown_, 5);
    std::printf("reference: %ld queries, %ld left open\n", queries_, unknown_);
  }

 private:
  static void expect_free(long line, const Reference<double>& truth, const March<double>& march,
                          const ContactTruth& known, double error) {
    const double least = truth.least_gap(0, truth.duration(), 128).gap;
    EXPECT_NEAR(least, known.least_gap, error) << "line " << line;
    EXPECT_TRUE(march.verdict == Verdict::kFree || known.least_gap <= error) << "line " << line;
  }

  long queries_ = 0;
  long unknown_ = 0;
};

TEST(Reference, KnownAnswers_AreTheSame) {
  judge_file<TruthJudge>(kTimes, "double");
}

}  // namespace
}  // namespace batuta::test
