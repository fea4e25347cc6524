// SPDX-License-Identifier: MIT
#include "batuta/world/detail/resolution.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace batuta {
using namespace detail;
namespace {

struct Pair {
  Body<double> A = make_body<double>({}, 2.0, {1, 1, 1}).value;
  Body<double> B = make_body<double>({{-1, 0, 0}, Quat<double>::Identity()}, 3.0, {1, 1, 1}).value;
  Contact<double> contact{{-0.5, 0, 0}, {1, 0, 0}, 1e-6};  // A on the right of B
  double restitution = 0.5;
  ResolutionOptions<double> options{0.01, 1e-3, 1e-4, 1e-9};

  ContactSide<double> party_of(Body<double>& body) {
    return {&body, twist_of(body), std::numeric_limits<double>::max()};
  }
  Result<Resolution<double>> answer() {
    const auto impulse =
        collision_impulse(collider_of(party_of(A)), collider_of(party_of(B)), contact, restitution);
    return resolve_contact(party_of(A), party_of(B), contact, impulse, options);
  }
};

TEST(Resolution, Colliding_GetsTheImpulseAndIsNotMoved) {
  Pair pair;
  pair.A.momentum.linear_W = {-2, 0, 0};  // v_A = -1, v_B = 0: j = 1.5 / (1/2 + 1/3) = 1.8
  const auto answer = pair.answer();
  ASSERT_TRUE(answer.ok());
  EXPECT_EQ(answer.value.kind, ContactKind::kColliding);
  EXPECT_NEAR(answer.value.impulse, 1.8, 1e-14);
  EXPECT_FALSE(answer.value.separated);
  EXPECT_NEAR(pair.A.momentum.linear_W.x(), -0.2, 1e-14);
  EXPECT_NEAR(pair.B.momentum.linear_W.x(), -1.8, 1e-14);
  EXPECT_EQ(pair.A.X_WB.p_W.x(), 0) << "a gap beyond the margin is left alone";
}

TEST(Resolution, CollidingWithinRounding_IsOpenedToTheMarginAndNoTimeIsCharged) {
  Pair pair;
  pair.A.momentum.linear_W = {-2, 0, 0};
  pair.contact.gap = 1e-12;
  const auto answer = pair.answer();
  ASSERT_TRUE(answer.ok());
  EXPECT_FALSE(answer.value.separated);
  EXPECT_EQ(answer.value.separation.duration, 0);
  EXPECT_NEAR(pair.A.X_WB.p_W.x() - pair.B.X_WB.p_W.x() - 1, 1e-9 - 1e-12, 1e-15);
}

TEST(Resolution, SeparationBelowRounding_IsRaisedToTheMargin) {
  Pair pair;
  pair.options.separation = 1e-15;
  pair.contact.gap = 0;
  ASSERT_TRUE(pair.answer().ok());
  EXPECT_NEAR(pair.A.X_WB.p_W.x() - pair.B.X_WB.p_W.x() - 1, 1e-9, 1e-15);
}

TEST(Resolution, Resting_IsSeparatedByInverseMassShares) {
  Pair pair;
  pair.A.momentum.linear_W = {-0.01, 0, 0};
  const auto answer = pair.answer();
  ASSERT_TRUE(answer.ok());
  EXPECT_EQ(answer.value.kind, ContactKind::kResting);
  EXPECT_EQ(answer.value.impulse, 0);
  const double shift = 1e-3 - 1e-6;
  EXPECT_NEAR(pair.A.X_WB.p_W.x(), shift * 3 / 5, 1e-15);
  EXPECT_NEAR(pair.B.X_WB.p_W.x(), -1 - shift * 2 / 5, 1e-15);
  EXPECT_EQ(pair.A.momentum.linear_W.x(), -0.01);
}

TEST(Resolution, CollidingWhileOverlapping_GetsBoth) {
  Pair pair;
  pair.A.momentum.linear_W = {-2, 0, 0};
  pair.contact.gap = -1e-3;
  const auto answer = pair.answer();
  ASSERT_TRUE(answer.ok());
  EXPECT_TRUE(answer.value.separated);
  EXPECT_GT(answer.value.impulse, 0);
  EXPECT_NEAR(pair.A.X_WB.p_W.x() - pair.B.X_WB.p_W.x(), 1 + 2e-3, 1e-14);
}

TEST(Resolution, Receding_IsLeftAloneButForRounding) {
  Pair pair;
  pair.A.momentum.linear_W = {2, 0, 0};
  pair.contact.gap = -1e-12;
  const auto answer = pair.answer();
  ASSERT_TRUE(answer.ok());
  EXPECT_EQ(answer.value.kind, ContactKind::kReceding);
  EXPECT_FALSE(answer.value.separated);
  EXPECT_EQ(answer.value.separation.duration, 0);
  EXPECT_EQ(answer.value.impulse, 0);
  EXPECT_EQ(pair.A.momentum.linear_W.x(), 2);
  EXPECT_NEAR(pair.A.X_WB.p_W.x() - pair.B.X_WB.p_W.x() - 1, 1e-9, 1e-11);
}

TEST(Resolution, FixedSide_IsNeitherPushedNorMoved) {
  Pair pair;
  pair.B.inverse_mass = 0;
  pair.B.inverse_moments.setZero();
  pair.A.momentum.linear_W = {-2, 0, 0};
  pair.contact.gap = -1e-3;
  ASSERT_TRUE(pair.answer().ok());
  EXPECT_NEAR(pair.A.momentum.linear_W.x(), 1, 1e-14);
  EXPECT_EQ(pair.B.momentum.linear_W, Vec3<double>::Zero());
  EXPECT_EQ(pair.B.momentum.angular_W, Vec3<double>::Zero());
  EXPECT_EQ(pair.B.X_WB.p_W.x(), -1);
}

TEST(Resolution, BadOptions_ChangeNothing) {
  Pair pair;
  pair.A.momentum.linear_W = {-0.01, 0, 0};
  pair.options.separation = -1;
  EXPECT_FALSE(pair.answer().ok());
  pair = {};
  pair.restitution = 2;
  EXPECT_FALSE(pair.answer().ok());
  EXPECT_EQ(pair.A.X_WB.p_W.x(), 0);
}

}  // namespace
}  // namespace batuta
