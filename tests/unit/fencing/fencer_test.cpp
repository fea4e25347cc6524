// SPDX-License-Identifier: MIT
#include "batuta/fencing/fencer.hpp"

#include <gtest/gtest.h>

namespace batuta {
using namespace fencing;
namespace {

/// Both fencers of the library, each on either side, and what the numbers of fencer.cpp are chosen
/// for.
class Pairing : public ::testing::TestWithParam<int> {
 protected:
  std::array<Fencer<double>, 2> fencers;
  Salle<double> salle;

  void SetUp() override {
    fencers[0] = GetParam() % 2 == 0 ? first_fencer<double>() : second_fencer<double>();
    fencers[1] = GetParam() / 2 == 0 ? first_fencer<double>() : second_fencer<double>();
  }
  Pose<double> hand(Side side, double x, double y) const {
    return hand_at(fencers[index_of(side)].map, Vec2<double>(x, y), salle.X_WF(side)).X_WH;
  }
  Capsule<double> blade(Side side, double x, double y) const {
    return to_world(hand(side, x, y), epee<double>().parts[0].capsule_H);
  }
  BodyShape<double> body(Side side, double x, double y) const {
    return pose_body(fencers[index_of(side)].build, salle.X_WF(side), hand(side, x, y));
  }
  /// Least gap of the blade of `side` at (x, y) to the other, on guard.
  double gap_to_other(Side side, double x, double y) const {
    double least = 1e9;
    for (const auto& part : body(other(side), 0, 0)) {
      least = std::min(least, capsule_gap(blade(side, x, y), part).gap);
    }
    return least;
  }
};

// Blades overlap lengthwise and are a hand's breadth apart across: no contact, and a beat is near.
TEST_P(Pairing, Guards_AreEngagedWithoutTouching) {
  const auto gap = capsule_gap(blade(Side::kLeft, 0, 0), blade(Side::kRight, 0, 0));
  EXPECT_GT(gap.gap, 0.07);
  EXPECT_LT(gap.gap, 0.15);
  EXPECT_GT(gap.axes.s, 0.3);  // nearest in the outer parts of the blades, not at the tips
  EXPECT_LT(gap.axes.s, 0.95);
  for (const Side side : {Side::kLeft, Side::kRight}) EXPECT_GT(gap_to_other(side, 0, 0), 0.25);
}

TEST_P(Pairing, OnlyLunges_ReachTheOpponent) {
  for (const Side side : {Side::kLeft, Side::kRight}) {
    for (double x = -1; x <= 1; x += 0.125) {
      for (double y = -1; y <= 0.125; y += 0.125) EXPECT_GT(gap_to_other(side, x, y), 0.15);
    }
    for (const double line : {-1.0, -0.5, 0.5, 1.0}) EXPECT_LT(gap_to_other(side, line, 1), 0.0);
  }
}

// A parry sweeps across the line of the other's guard: the blades' order changes, so they must meet
// on the way.
TEST_P(Pairing, ParryLeft_CrossesTheEngagedBlade) {
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const auto parry = blade(side, -1, 0);
    const auto guard = blade(side, 0, 0);
    const auto engaged = blade(other(side), 0, 0);
    const auto side_of = [&engaged](const Capsule<double>& mine) {
      return capsule_gap(mine, engaged).axes.normal_AB.y() > 0;
    };
    EXPECT_NE(side_of(parry), side_of(guard));
  }
}
INSTANTIATE_TEST_SUITE_P(All, Pairing, ::testing::Values(0, 1, 2, 3));

/// No blade points away from the opponent, not even in a parry.
TEST(Fencer, Map_IsInRangeAndPointsTheBladeForward) {
  for (const auto& fencer : {first_fencer<double>(), second_fencer<double>()}) {
    EXPECT_EQ(validate(fencer.map), Status::kOk);
    for (double y = -1; y <= 1; y += 0.125) {
      for (double x = -1; x <= 1; x += 0.125) {
        const auto hand = hand_at(fencer.map, Vec2<double>(x, y)).X_WH;
        EXPECT_GT((hand.q_WB * Vec3<double>::UnitX()).x(), 0.7) << x << ", " << y;
      }
    }
    EXPECT_EQ(validate(fencer.grip), Status::kOk);
  }
}

/// How far the hands of all lunges are as far as each other, as a share of the way from guard: 2 cm
/// of 82, and what the surface adds between keys.
constexpr double kLungeSpread = 0.03;

/// The trunk goes forward with the hand of a lunge, and of nothing before it.
TEST(Fencer, Build_LungesWithTheMap) {
  for (const auto& fencer : {first_fencer<double>(), second_fencer<double>()}) {
    const auto share = [&fencer](double x, double y) {
      const auto hand = hand_at(fencer.map, Vec2<double>(x, y)).X_WH;
      return lunge_share(fencer.build, hand.p_W.x());
    };
    EXPECT_EQ(share(0, 0), 0);
    EXPECT_EQ(share(0, 1), 1);
    for (const double x : {-1.0, -0.5, 0.5, 1.0}) EXPECT_NEAR(share(x, 1), 1, kLungeSpread) << x;
    for (double x = -1; x <= 1; x += 0.125) EXPECT_LT(share(x, -1), 0.1) << x;
  }
}

TEST(Salle, Fencers_FaceEachOther) {
  const Salle<double> salle;
  const auto left = salle.X_WF(Side::kLeft);
  const auto right = salle.X_WF(Side::kRight);
  EXPECT_NEAR((right.p_W - left.p_W).x(), salle.distance, 1e-15);
  EXPECT_EQ(left.q_WB * Vec3<double>::UnitX(), Vec3<double>::UnitX());
  EXPECT_EQ(right.q_WB * Vec3<double>::UnitX(), -Vec3<double>::UnitX());
  EXPECT_EQ(other(Side::kLeft), Side::kRight);
  EXPECT_EQ(other(Side::kRight), Side::kLeft);
}

}  // namespace
}  // namespace batuta
