// SPDX-License-Identifier: MIT
// What a certificate is made of: heights against the motion itself, polynomials against roots that
// are chosen, and how far four expansions see.
#include "../../../src/detection/certificate.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "moving.hpp"

namespace batuta {
namespace {

using namespace testing_detection;
using Polynomial = Cubic<double>;
using V = Vec3<double>;

constexpr double kU = kRoundOff<double>;

double value(const Polynomial& c, double h) {
  return c[0] + h * (c[1] + h * (c[2] + h * c[3]));
}

/// The state of a pair at theta, as a advancement has it but for what rounding may do, which is
/// nothing.
PairState<double> state_at(const MovingPair<double>& pair, double theta) {
  PairState<double> state{
      {}, {}, pair.B.v, TurnPowers<double>(pair.A.turn_rate), TurnPowers<double>(pair.B.turn_rate),
      {}, {}};
  state.bounds =
      term_bounds<double>(pair.scale, length(state.travel), {state.turn_A.turn, pair.A.longest_arm},
                          {state.turn_B.turn, pair.B.longest_arm});
  set_state<double>(state.A, pair.A, Vec3<double>::Zero(), pair.A.turn_rate * theta);
  set_state<double>(state.B, pair.B, pair.B.v * theta, pair.B.turn_rate * theta);
  return state;
}

/// A pair at theta, and a normal from there on: N(h) = n + m h + m2 h^2.
struct Held {
  MovingPair<double> pair;
  PairState<double> state;
  double theta = 0;
  double R = 0;
  Vec3<double> n;
  NormalMotion<double> N{Vec3<double>::Zero(), Vec3<double>::Zero()};
};

Held random_held(std::mt19937& random) {
  const auto made =
      make_moving_pair(random_moving<double>(random, 1), random_moving<double>(random, 1));
  EXPECT_TRUE(made.ok());
  const double theta = 0.5 + 0.5 * signed_unit(random);
  return {made.value, state_at(made.value, theta), theta, 0.2,
          unit<double>(random_vector(random, 1))};
}

/// N(h).(q_j - p_i) - R |N(h)|, of the capsules where they then are.
double clearance(const Held& held, std::size_t i, std::size_t j, double h) {
  const detail::CapsulesAt<double> at = detail::capsules_at(held.pair, held.theta + h);
  const Vec3<double> ends_A[2] = {at.A.axis.a, at.A.axis.b};
  const Vec3<double> ends_B[2] = {at.B.axis.a, at.B.axis.b};
  const Vec3<double> N = held.n + held.N.m * h + held.N.m2 * (h * h);
  return N.dot(ends_B[j] - ends_A[i]) - held.R * N.norm();
}

double bound(const Clearances<double>& f, std::size_t i, std::size_t j, double h) {
  return value(f.B[j], h) - value(f.A[i], h) + f.fourth * (h * h * h * h);
}

/// That it is a lower bound, and no lower than `slack`; both but for rounding, some u of all
/// lengths, of which there are less than 32 m.
void expect_bound(const Clearances<double>& f, const Held& held, double h, double slack) {
  const double rounding = 64 * kU * 32;
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t j = 0; j < 2; ++j) {
      const double truth = clearance(held, i, j, h);
      EXPECT_LE(bound(f, i, j, h), truth + rounding) << i << j << ' ' << h;
      EXPECT_GE(bound(f, i, j, h), truth - slack - rounding) << i << j << ' ' << h;
    }
  }
}

TEST(Hold, FixedNormal_BoundsTheClearanceToFourthOrder) {
  std::mt19937 random(4);
  for (int k = 0; k < 200; ++k) {
    const Held held = random_held(random);
    Clearances<double> f;
    hold(f, held.n, held.state, held.R);
    for (const double h : {0.0, 0.001, 0.03, 0.3}) {
      if (held.theta + h > 1) continue;
      expect_bound(f, held, h, 2 * held.state.bounds.last_fourth * std::pow(h, 4));
    }
  }
}

/// What rounding may do is taken off, term by term.
TEST(Hold, Magnitudes_AreTakenOff) {
  std::mt19937 random(5);
  Held held = random_held(random);
  Clearances<double> without;
  hold(without, held.n, held.state, held.R);
  held.state.magnitudes = {1, 20, 300, 4000, 50000};
  Clearances<double> with;
  hold(with, held.n, held.state, held.R);
  for (const double h : {0.0, 0.5, 1.0}) {
    const double taken = 1 + h * (20 + h * (300 + h * (4000 + h * 50000)));
    EXPECT_NEAR(bound(without, 0, 1, h) - bound(with, 0, 1, h), taken, 64 * kU * taken) << h;
  }
}

/// The clearances along a normal that moves.
Clearances<double> moved(const Held& held, double horizon) {
  const PairState<double>& state = held.state;
  Clearances<double> f;
  hold(f, held.n, state, held.R);
  add_rate(f.A, held.N.m, 0.0, state.A, state.turn_A);
  add_rate(f.B, held.N.m, held.N.m.dot(state.travel), state.B, state.turn_B);
  add_bend(f.A, held.N.m2, 0.0, state.A, state.turn_A);
  add_bend(f.B, held.N.m2, held.N.m2.dot(state.travel), state.B, state.turn_B);
  take_toll(f, held.n, held.N, state, held.R, horizon);
  return f;
}

/// Twice all terms beyond the third order of N.(q - p), which the bound leaves out, and what
/// |N| <= 1 + (m^2/2 + n.m2) h^2 + m m2 h^3 + m2^2 h^4/2 gives away, m across n: of (1 + x)^(1/2)
/// <= 1 + x/2 at most x^2/8, and of m.m2 <= m m2 the whole, twice.
double slack_of(const Held& held, double h, double horizon) {
  const TermBounds<double>& bounds = held.state.bounds;
  const double m = held.N.m.norm();
  const double m2 = held.N.m2.norm();
  const double fourth = bounds.last_fourth + m * bounds.sixth_third + m2 * bounds.half_second;
  const double fifth = m * bounds.last_fourth + m2 * bounds.sixth_third;
  const double h2 = h * h;
  const double tail =
      2 * h2 * h2 * (fourth + horizon * (fifth + horizon * m2 * bounds.last_fourth));
  const double x = m * m * h2 + 2 * m2 * h2 + 2 * m * m2 * h2 * h + m2 * m2 * h2 * h2;
  return tail + held.R * (x * x / 8 + 2 * m * m2 * h2 * h + m2 * m2 * h2 * h2);
}

TEST(TakeToll, MovingNormal_BoundsTheClearanceToFourthOrder) {
  std::mt19937 random(6);
  constexpr double kHorizon = 0.25;
  for (int k = 0; k < 300; ++k) {
    Held held = random_held(random);
    held.theta *= 1 - kHorizon;
    held.state = state_at(held.pair, held.theta);
    const Vec3<double> m = random_vector(random, k % 3 == 0 ? 0 : 0.5);
    const Vec3<double> m2 = random_vector(random, k % 3 == 1 ? 0 : 0.5);
    held.N.m = m - held.n * held.n.dot(m);
    held.N.m2 = k % 2 == 0 ? m2 : Vec3<double>(m2 - held.n * held.n.dot(m2));
    const Clearances<double> f = moved(held, kHorizon);
    for (const double h : {0.0, 0.001, 0.03, kHorizon}) {
      expect_bound(f, held, h, slack_of(held, h, kHorizon));
    }
  }
}

TEST(FirstRoot, ChosenRoots_AreFound) {
  EXPECT_DOUBLE_EQ(first_root(6.0, -3.0, 0.0), 2.0) << "a line";
  EXPECT_DOUBLE_EQ(first_root(6.0, -1.0, -1.0), 2.0) << "(2 - h) (3 + h)";
  EXPECT_DOUBLE_EQ(first_root(6.0, 1.0, -1.0), 3.0) << "(3 - h) (2 + h)";
  EXPECT_DOUBLE_EQ(first_root(8.0, 0.0, -2.0), 2.0) << "2 (2 - h) (2 + h)";
  EXPECT_DOUBLE_EQ(first_root(6.0, -5.0, 1.0), 1.2) << "(2 - h) (3 - h): its tangent";
}

/// Random ones: above zero on all of the stretch; and no shorter than the tangent and the least
/// bend make it, which are the polynomial itself where only the bend is negative.
TEST(PositiveStretch, RandomPolynomials_ArePositiveOnIt) {
  std::mt19937 random(7);
  int inside = 0;
  for (int k = 0; k < 2000; ++k) {
    const Polynomial c{1 + signed_unit(random), 4 * signed_unit(random), 4 * signed_unit(random),
                       4 * signed_unit(random)};
    const double fourth = -2 - 2 * signed_unit(random);
    const double stretch = positive_stretch(c, fourth, 1.0);
    inside += stretch < 1 ? 1 : 0;
    EXPECT_GT(stretch, 0) << k;
    EXPECT_LE(stretch, 1) << k;
    for (int i = 1; i <= 64; ++i) {
      const double h = stretch * i / 64;
      EXPECT_GE(value(c, h) + fourth * std::pow(h, 4), 0) << k << ": " << h;
    }
  }
  EXPECT_GT(inside, 500);
}

TEST(PositiveStretch, ParabolaThatOpensDownwards_ReachesItsRoot) {
  const double found = positive_stretch<double>({6, 1, -1, 0}, 0, 10);
  EXPECT_LE(found, 3.0);
  EXPECT_GE(found, 3.0 * (1 - 32 * kU));
}

TEST(PositiveStretch, AboveZeroAllAlong_IsTheWindow) {
  EXPECT_EQ(positive_stretch<double>({1.01, -1, 0, 0}, 0, 1), 1.0) << "a line";
  EXPECT_EQ(positive_stretch<double>({1.01, 0, -1, 0}, 0, 1), 1.0);
  EXPECT_EQ(positive_stretch<double>({1.01, 0, 0, -1}, 0, 1), 1.0);
  EXPECT_EQ(positive_stretch<double>({1.01, 0, 0, 0}, -1, 1), 1.0);
  EXPECT_EQ(positive_stretch<double>({0.01, 5, 5, 5}, 0, 1), 1.0);
}

TEST(PositiveStretch, NothingToBeginWith_IsNothing) {
  EXPECT_EQ(positive_stretch<double>({0, -1, 0, 0}, 0, 1), 0.0);
  EXPECT_EQ(positive_stretch<double>({-1, 5, 5, 0}, 0, 1), 0.0);
  EXPECT_EQ(positive_stretch<double>({1, std::nan(""), 0, 0}, 0, 1), 0.0);
  EXPECT_EQ(positive_stretch<double>({1, -1e300, -1, 0}, 0, 1), 0.0) << "its square overflows";
}

/// Three ends are out of the way; the fourth comes. Each in turn.
TEST(PositiveStretch, OfFourPairs_TheEarliestCounts) {
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t j = 0; j < 2; ++j) {
      for (const double head_start :
           {0.0, 3.0}) {  // also of an end that is the nearer one at first
        Clearances<double> f{{}, {}, 0};
        f.A[i] = {-head_start, 4 + head_start, 0, 0};
        f.B[j] = {8 + head_start, -4 - head_start, 0, 0};
        f.A[1 - i] = {0, 0, 0, 0};
        f.B[1 - j] = {8, 0, 0, 0};
        const double truth = 1;  // 8 + 2 s - (8 + 2 s) h
        EXPECT_NEAR(positive_stretch(f, 100.0), truth, 32 * kU) << i << j << head_start;
      }
    }
  }
}

TEST(StaysAbove, LineThatReachesZero_DoesUpToThere) {
  EXPECT_TRUE(stays_above<double>({1, -1, 0, 0}, 0.99));
  EXPECT_FALSE(stays_above<double>({1, -1, 0, 0}, 1.01));
  EXPECT_FALSE(stays_above<double>({1, 0, -1, 0}, 1.01));
  EXPECT_FALSE(stays_above<double>({1, 0, 0, -1}, 1.01));
  EXPECT_FALSE(stays_above<double>({1, -0.5, -0.5, -0.5}, 1));
  EXPECT_TRUE(stays_above<double>({1, -0.25, -0.25, -0.25}, 1));
  EXPECT_FALSE(stays_above<double>({-1, 0, 0, 0}, 0.5));
}

/// In small whole numbers nothing is rounded.
TEST(MoveOrigin, WholeNumbers_AreTheSamePolynomialThere) {
  const Polynomial c{7, -5, 3, 2};
  constexpr double kFourth = -4;
  constexpr double kStep = 3;
  Polynomial at = c;
  move_origin(at, kFourth, kStep);
  for (const double h : {-3.0, -1.0, 0.0, 1.0, 2.0}) {
    const double there = kStep + h;
    EXPECT_EQ(value(at, h) + kFourth * std::pow(h, 4),
              value(c, there) + kFourth * std::pow(there, 4))
        << h;
  }
}

/// (1 - h)^2: an expansion about h proves half of what is left, so n of them prove 1 - 2^-n.
TEST(ProvenFree, DoubleRoot_IsHalvedByEachExpansion) {
  Clearances<double> f{{}, {}, 0};
  for (Polynomial& b : f.B) b = {1, -2, 1, 0};
  const double truth = 1 - std::pow(0.5, kMaxRounds);
  EXPECT_NEAR(proven_free(f, 1.0), truth, 64 * kU * kMaxRounds);
}

/// A line is known to its end, by one.
TEST(ProvenFree, Line_IsProvenToItsRootAndNoFurther) {
  Clearances<double> f{{}, {}, 0};
  for (Polynomial& b : f.B) b = {3, -4, 0, 0};
  const double found = proven_free(f, 1.0);
  EXPECT_LE(found, 0.75);
  EXPECT_GE(found, 0.75 * (1 - 32 * kU));
  for (Polynomial& b : f.B) b = {3, -4, 0, 0};
  EXPECT_EQ(proven_free(f, 0.5), 0.5);
}

/// Above zero on all that is proven; and often more is than by the first expansion.
TEST(ProvenFree, RandomPolynomials_ArePositiveOnIt) {
  std::mt19937 random(8);
  int beyond = 0;
  for (int k = 0; k < 2000; ++k) {
    const Polynomial c{1 + signed_unit(random), 3 * signed_unit(random), 3 * signed_unit(random),
                       3 * signed_unit(random)};
    const double fourth = -1 - signed_unit(random);
    Clearances<double> f{{}, {c, c}, fourth};
    beyond += proven_free(f, 1.0) > positive_stretch(c, fourth, 1.0) ? 1 : 0;
    f = {{}, {c, c}, fourth};
    const double proven = proven_free(f, 1.0);
    for (int i = 1; i <= 64; ++i) {
      const double h = proven * i / 64;
      EXPECT_GE(value(c, h) + fourth * std::pow(h, 4), 0) << k << ": " << h;
    }
  }
  EXPECT_GT(beyond, 200);
}

TEST(HorizonOf, Turn_IsKeptWithinWhatThePolynomialsSee) {
  PairState<double> state{
      {}, {}, Vec3<double>::Zero(), TurnPowers<double>(5.0), TurnPowers<double>(7.0), {}, {}};
  EXPECT_DOUBLE_EQ(horizon_of(state, 1.0), kHorizonTurn<double> / 12);
  EXPECT_EQ(horizon_of(state, 0.2), 0.2) << "2.4 rad are left";
}

/// Of ends that lie still at the origin: what is left of the toll is R times what the normal gains
/// in length, by powers of h: |n + m h + m2 h^2| <= 1 + (m h + m2 h^2)^2 / 2 where m and m2 lie
/// across n, and no less than that has to be paid in the lowest power of each.
TEST(TakeToll, OfANormalThatBends_IsWhatItsLengthGainsAndNoMore) {
  PairState<double> still{{}, {}, V::Zero(), TurnPowers<double>(0), TurnPowers<double>(0), {}, {}};
  still.bounds = still.magnitudes = {0, 0, 0, 0, 0};
  constexpr double kR = 0.75;
  constexpr double kRounding = 1 + 64 * kU;
  for (const double m : {0.0, 0.5}) {
    for (const double m2 : {0.0, 0.25}) {
      Clearances<double> f{{}, {}, 0};
      take_toll<double>(f, V::UnitZ(), {V(m, 0, 0), V(m2, 0, 0)}, still, kR, 1.0);
      const std::array<double, 3> gains = {kR * m * m / 2, kR * m * m2, kR * m2 * m2 / 2};
      const std::array<double, 3> tolls = {-f.B[0][2], -f.B[0][3], -f.fourth};
      for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_GE(tolls[k], gains[k]) << m << ' ' << m2 << ' ' << k;
        EXPECT_LE(tolls[k], gains[k] * kRounding) << m << ' ' << m2 << ' ' << k;
      }
      for (double h = 0; h <= 1; h += 0.125) {
        const double along = m * h + m2 * h * h;
        const double gain = kR * (std::sqrt(1 + along * along) - 1);
        EXPECT_GE(h * h * (tolls[0] + h * (tolls[1] + h * tolls[2])), gain - 4 * kU);
      }
    }
  }
}

}  // namespace
}  // namespace batuta
