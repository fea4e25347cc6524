// SPDX-License-Identifier: MIT
// What spares a search, and which candidate is first: each beside a brute force of its own.
#include "batuta/world/detail/pairs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "draws.hpp"
#include "row_rig.hpp"
#include "scenes.hpp"

namespace batuta {
using namespace detail;
namespace {

MovingCapsule<double> draw_mover(test::Draws& draws) {
  MovingCapsule<double> moving;
  const Vec3<double> a = draws.in_ball(0.3);
  const Vec3<double> b = draws.in_ball(0.3);
  const Vec3<double> p = draws.in_ball(2);
  const Quat<double> q = draws.rotation();
  const Vec3<double> v = draws.in_ball(3);
  const Vec3<double> w = draws.in_ball(20);
  moving.capsule_B = {{a, b}, 0.05};
  moving.motion.X_WB = {p, q};
  moving.motion.twist = {v, w};
  moving.motion.duration = draws.between(0.001, 0.1);
  return moving;
}

/// Where an end is after t, seen from a point that goes straight on: by Rodrigues' formula, and not
/// by the library's motion.
Vec3<double> end_after(const MovingCapsule<double>& moving, const Vec3<double>& end_B, double t) {
  const Motion<double>& motion = moving.motion;
  const Vec3<double> arm = motion.X_WB.q_WB * end_B;
  const double rate = motion.twist.w_W.norm();
  const Vec3<double> axis = motion.twist.w_W / rate;
  const Vec3<double> turned = std::cos(rate * t) * arm + std::sin(rate * t) * axis.cross(arm) +
                              ((1 - std::cos(rate * t)) * axis.dot(arm)) * axis;
  return motion.X_WB.p_W + t * motion.twist.v_W + turned;
}

TEST(EndsAlong, AtAllTimes_NoEndIsBeyondWhatTheyAllow) {
  constexpr double kNoise = 1e-12;  // m, of both computations
  test::Draws draws(2026, 14, 1);
  for (int run = 0; run < 2000; ++run) {
    const MovingCapsule<double> moving = draw_mover(draws);
    const Vec3<double> origin = draws.in_ball(2);
    const Vec3<double> origin_v = draws.in_ball(3);
    const Vec3<double> normal = draws.rotation() * Vec3<double>::UnitX();
    const auto ends = ends_along<double>(moving, origin, origin_v, normal, 1.0);
    const double allowed = std::max(ends.first, ends.last + ends.bend);
    const Segment<double>& axis = moving.capsule_B.axis;
    for (int k = 0; k <= 64; ++k) {
      const double t = moving.motion.duration * k / 64;
      for (const Vec3<double>& end_B : {axis.a, axis.b}) {
        const Vec3<double> at = end_after(moving, end_B, t) - origin - t * origin_v;
        // Between both ends of the time the bound is concave: the line, and the bend so far.
        const double share = static_cast<double>(k) / 64;
        const double line = ends.first + share * (ends.last - ends.first);
        ASSERT_LE(normal.dot(at), line + share * share * ends.bend + kNoise);
        ASSERT_LE(normal.dot(at), allowed + kNoise);
      }
    }
  }
}

TEST(EndsAlong, OppositeSign_IsTheOtherSide) {
  test::Draws draws(2026, 14, 2);
  for (int run = 0; run < 200; ++run) {
    const MovingCapsule<double> moving = draw_mover(draws);
    const Vec3<double> zero = Vec3<double>::Zero();
    const Vec3<double> normal = draws.rotation() * Vec3<double>::UnitX();
    const Vec3<double> opposite = -normal;
    const auto least = ends_along<double>(moving, zero, zero, normal, -1.0);
    const auto most = ends_along<double>(moving, zero, zero, opposite, 1.0);
    EXPECT_DOUBLE_EQ(least.first, -most.first);
    EXPECT_DOUBLE_EQ(least.last, -most.last);
    EXPECT_EQ(least.bend, most.bend);
  }
}

CandidatePair<double> contact_at(ProxyPair pair, double free_for, double near_after) {
  CandidatePair<double> candidate;
  candidate.pair = pair;
  candidate.outcome = Outcome::kContact;
  candidate.asked = true;
  candidate.free_for = free_for;
  candidate.near_after = near_after;
  return candidate;
}

TEST(CandidateOrder, EveryOrderOfStoring_ChoosesTheSamePair) {
  std::array<CandidatePair<double>, 4> stored = {
      contact_at({3, 4}, 0.5, 0.4), contact_at({0, 9}, 0.6, 0.45), contact_at({1, 2}, 0.7, 0.55),
      contact_at({2, 3}, 0.5, 0.5)};
  const auto by_pair = [](const auto& P, const auto& Q) { return precedes(P.pair, Q.pair); };
  std::sort(stored.begin(), stored.end(), by_pair);
  int orders = 0;
  do {
    FixedList<CandidatePair<double>, 4> candidates;
    for (const auto& candidate : stored) candidates.push(candidate);
    const int earliest = CandidateOrder::earliest(candidates);
    // (2, 3) and (3, 4) are free until 0.5; the lower pair is first.
    EXPECT_TRUE(is_same(candidates[earliest].pair, {2, 3}));
    // (0, 9) is near from 0.45 and ties; (1, 2) is near from 0.55 only.
    const auto nobody = [](ProxyPair) { return false; };
    const int chosen = CandidateOrder::among_ties(candidates, earliest, nobody);
    EXPECT_TRUE(is_same(candidates[chosen].pair, {0, 9}));
    ++orders;
  } while (std::next_permutation(stored.begin(), stored.end(), by_pair));
  EXPECT_EQ(orders, 24);
}

TEST(CandidateOrder, FurtherContacts_ComeInTheOrderOfTheirPairs) {
  FixedList<CandidatePair<double>, 6> candidates;
  candidates.push(contact_at({3, 4}, 0.5, 0.5));
  candidates.push(contact_at({2, 3}, 0.6, 0.4));
  candidates.push(contact_at({0, 9}, 0.6, 0.4));  // before the last one
  candidates.push(contact_at({1, 7}, 0.6, 0.4));  // had its answer
  candidates.push(contact_at({2, 8}, 0.6, 0.4));
  candidates[4].outcome = Outcome::kBudget;
  const auto has_had = [](ProxyPair pair) { return is_same(pair, {1, 7}); };
  const int first = CandidateOrder::next_contact(candidates, {0, 9}, has_had);
  ASSERT_EQ(first, 1);
  const int second = CandidateOrder::next_contact(candidates, candidates[first].pair, has_had);
  ASSERT_EQ(second, 0);
  EXPECT_EQ(CandidateOrder::next_contact(candidates, {3, 4}, has_had), CandidateOrder::kNone);
}

// Two balls of radius R at rest, whose lengths are R and 3 R: apart beyond a gap of 2 kInflation
// times the sum of them, which is 576 u R, whatever R is.
TEST(StaysApart, NoiseGoesWithTheLengths) {
  for (const double R : {0x1p-10, 1.0, 0x1p10}) {
    for (const double noise : {512.0, 640.0, -640.0}) {
      Bodies<test::Row> bodies{1};
      bodies.settings.gravity_W.setZero();
      bodies.dt = test::kStep;
      for (std::size_t i = 0; i < 2; ++i) {
        Actor<test::Row> ball;
        ball.capsule_B = Capsule<double>::sphere(Vec3<double>::Zero(), R);
        ball.body.X_WB.p_W.x() = i == 0 ? 0 : (2 + noise * kRoundOff<double>)*R;
        EXPECT_TRUE(bodies.actors.make(ball).ok());
        (void)bodies.begin(i);
        bodies.plan(i);
      }
      EXPECT_EQ(stays_apart(bodies, {0, 1}, Vec3<double>::UnitX()), noise > 576) << R << noise;
    }
  }
}

}  // namespace
}  // namespace batuta
