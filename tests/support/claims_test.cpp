// SPDX-License-Identifier: MIT
#include "claims.hpp"

#include <gtest/gtest.h>

namespace batuta::test {
namespace {

constexpr double kContactTolerance = 1e-6;
constexpr double kEps = 1e-15;

/// A ball of radius 0.1 comes from x = 2 towards one at the origin, in contact from t = 0.45 on.
Truth approach(double speed = 4) {
  MovingCapsule<double> A;
  A.capsule_B.radius = 0.1;
  A.motion.duration = 1;
  MovingCapsule<double> B = A;
  B.motion.X_WB.p_W = {2, 0, 0};
  B.motion.twist.v_W = {-speed, 0, 0};
  return {A, B};
}

Findings judged(Outcome outcome, double t_free, double t_hit, double speed = 4) {
  return judge({outcome, t_free, t_hit, kContactTolerance, kEps}, approach(speed));
}

TEST(Claims, TrueAnswers_AreFoundTrue) {
  EXPECT_FALSE(judged(Outcome::kContact, 0.45 - 1e-7, 0.45 + 1e-7).wrong());
  EXPECT_FALSE(judged(Outcome::kFree, 1, 1, 1.7).wrong());
  EXPECT_FALSE(judged(Outcome::kBudget, 0.3, 1).wrong());
}

TEST(Claims, FreeInContact_IsMissed) {
  const Findings found = judged(Outcome::kFree, 1, 1);
  EXPECT_TRUE(found.missed && found.wrong());
  EXPECT_NEAR(found.overlap, 0.2, 1e-9);
}

TEST(Claims, OverlapBeforeProvenTime_IsLate) {
  EXPECT_TRUE(judged(Outcome::kContact, 0.45 + 1e-9, 0.46).late);
  EXPECT_TRUE(judged(Outcome::kBudget, 0.46, 1).late);
}

TEST(Claims, ContactWithoutOne_IsFalse) {
  EXPECT_TRUE(judged(Outcome::kContact, 0.9, 1, 1.7).false_contact);
  EXPECT_TRUE(judged(Outcome::kTouching, 0, 0).false_contact);
}

TEST(Claims, ContactFarAhead_IsLoose) {
  const Findings found = judged(Outcome::kContact, 0.4, 0.46);
  EXPECT_TRUE(found.loose && found.wrong());
  EXPECT_FALSE(found.false_contact);
  EXPECT_NEAR(found.gap_at_free, 0.2, 1e-12);
}

TEST(Claims, TimesOutOfOrder_AreSaid) {
  EXPECT_TRUE(judged(Outcome::kContact, 0.4, 0.3).disordered);
  EXPECT_TRUE(judged(Outcome::kContact, -0.1, 0.3).disordered);
  EXPECT_TRUE(judged(Outcome::kContact, 0.4, 1.1).disordered);
  EXPECT_TRUE(judged(Outcome::kInvalid, 0, 0).wrong());
}

}  // namespace
}  // namespace batuta::test
