// SPDX-License-Identifier: MIT
// Groups of contacts, without the step: balls in a row along z, and what pencil and paper say of
// them. q = M / (m + M) is what one impulse leaves of the speed of M, that meets m at rest with C
// = 0.
#include <cmath>
#include <memory>

#include "row_rig.hpp"

namespace batuta {
namespace {

using namespace test;
using detail::ProxyPair;

class ContactGroups : public ::testing::Test {
 protected:
  RowRig& rig() { return *rig_; }

 private:
  std::unique_ptr<RowRig> rig_ = std::make_unique<RowRig>();
};

TEST_F(ContactGroups, WhoIsWithinD_IsAContact_UntilHeIsNot) {
  rig().add(1, 0);
  rig().add(1, 0, kD / 2);
  rig().add(1, 0, 1.5 * kD);
  rig().begin();
  ASSERT_EQ(rig().groups.contacts.size(), 1);
  const auto& contact = rig().contact(0);
  const auto& point = contact.points[0];
  EXPECT_EQ(contact.count, 1);
  EXPECT_NEAR(contact.rest_gap, kD, kExact);
  EXPECT_NEAR(point.gap, kD / 2, kExact);
  EXPECT_NEAR(point.normal_W.z(), -1, kExact) << "out of the upper one, towards the lower one";
  EXPECT_NEAR(point.arm_A_W.z(), kRadius + kD / 4, kExact) << "in the middle of the gap";
  rig().z(1) += kD;  // 1.5 D from below, 0.5 D from above
  rig().begin();
  ASSERT_EQ(rig().groups.contacts.size(), 1);
  EXPECT_EQ(rig().groups.contacts[0].pair.first, 1);
}

TEST_F(ContactGroups, BesideWhoIsFixed_ThePointLiesOnTheOther) {
  for (const bool lower_is_fixed : {true, false}) {
    RowRig row;
    row.add(lower_is_fixed ? 0 : 1, 0);
    row.add(lower_is_fixed ? 1 : 0, 0, kD / 2);
    row.begin();
    ASSERT_EQ(row.groups.contacts.size(), 1);
    const auto& point = row.contact(0).points[0];
    EXPECT_NEAR(point.gap, kD / 2, kExact);
    EXPECT_NEAR(point.arm_A_W.z(), kRadius + (lower_is_fixed ? kD / 2 : 0), kExact);
  }
}

TEST_F(ContactGroups, WhoPressOnEachOther_AreAGroup_AndWhatIsFixedIsInNone) {
  for (const double v : {1.0, 0.0, -1.0}) rig().add(1, v);  // three that press
  rig().add(1, 1, 1);                                       // one from each side of a fixed one
  rig().add(0, 0);
  rig().add(1, -1);
  rig().add(1, -1, 1);  // two that part
  rig().add(1, 1);
  rig().solve();
  ASSERT_EQ(rig().groups.solved_count, 5);
  rig().groups.group_all(rig().bodies);
  const std::size_t lowest[] = {0, 0, 0, 3, 4, 5, 6, 7};
  for (std::size_t i = 0; i < 8; ++i) {
    EXPECT_EQ(rig().groups.group_of(i), lowest[i]) << i;
    EXPECT_EQ(rig().groups.is_held(lowest[i]), i == 3 || i == 5) << i;
  }
}

TEST_F(ContactGroups, TwoThatPress_GoOnWithTheVelocityOfTheirCentre) {
  rig().add(1, 2);
  rig().add(3, -2);
  rig().add(0, 0, 1);
  rig().add(5, -0.1);
  rig().solve();
  for (const std::size_t i : {0U, 1U}) EXPECT_NEAR(rig().velocity(i), -1, kExact);
  EXPECT_NEAR(rig().impulse(0), 3, kExact) << "3 kg by 1 m/s";
  EXPECT_NEAR(rig().velocity(3), 0, kExact);
  EXPECT_NEAR(rig().impulse(2), 0.5, kExact);
  EXPECT_EQ(rig().momentum(2), 0) << "nothing moves what is fixed";
  for (const std::size_t i : {0U, 2U}) EXPECT_TRUE(rig().groups.presses(RowRig::pair(i)));
}

// A row that lies: without weight, and where it weighs nothing along the row.
TEST_F(ContactGroups, ContactsAtOneHeight_AreSolvedInTheOrderOfTheirPairs) {
  for (const double weight : {0.0, 10.0}) {
    RowRig row;
    row.bodies.settings.gravity_W = {-weight, 0, 0};
    for (int i = 0; i < 6; ++i) row.add(1, 5 - i);  // each presses on the next one
    row.solve();
    ASSERT_EQ(row.groups.solved_count, 5);
    for (int k = 0; k < 5; ++k) EXPECT_EQ(row.groups.solved_at(k).pair.first, k) << weight;
  }
}

// Weight: each contact carries what is above it, and its begin is told once.
TEST_F(ContactGroups, Column_CarriesItsWeight_AndIsToldOnce) {
  constexpr double kG = 10;
  rig().bodies.settings.gravity_W = {0, 0, -kG};
  rig().add(0, 0);
  for (const double mass : {3.0, 2.0, 1.0}) rig().add(mass, 0);
  const double weights[] = {6 * kG * kStep, 3 * kG * kStep, kG * kStep};
  // What counts as nothing: D / 64 in a step, of each contact's approach.
  const double rest = 3 * 6 * kD / 64 / kStep;
  int told = 0;
  for (int step = 0; step < 20; ++step) {
    rig().solve();
    rig().groups.tell_begun(rig().bodies, [&](ProxyPair pair, const auto& contact, double impulse) {
      ++told;
      EXPECT_EQ(pair.second, pair.first + 1);
      EXPECT_NEAR(contact.gap, kNear, kExact);
      EXPECT_NEAR(impulse, weights[pair.first], rest);
    });
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(rig().impulse(i), weights[i], rest) << step;
    rig().groups.end_step();
  }
  EXPECT_EQ(told, 3);
}

// By the velocities before gravity; one that lasted is a blow from four times as fast on.
TEST_F(ContactGroups, FasterThanRest_IsABlow_AndNotSolved) {
  const auto solves = [this](double approach) {
    rig().momentum(0) = approach;
    rig().momentum(1) = 0;
    rig().solve();
    const bool is_solved = rig().contact(0).is_solved;
    EXPECT_EQ(rig().groups.solved_count, is_solved ? 1 : 0);
    EXPECT_NEAR(rig().velocity(0), is_solved ? approach / 2 : approach, kExact);
    EXPECT_NEAR(rig().impulse(0), is_solved ? approach / 2 : 0, kExact);
    rig().groups.end_step();
    return is_solved;
  };
  for (int i = 0; i < 2; ++i) {
    rig().add(1, 0);
    rig().bodies.actor(static_cast<std::size_t>(i)).restitution = 0.5;
  }
  const double rest = rig().bodies.settings.rest_speed;
  EXPECT_FALSE(solves(1.01 * rest));
  EXPECT_TRUE(solves(0.99 * rest));
  EXPECT_TRUE(solves(3.9 * rest));
  EXPECT_FALSE(solves(4.1 * rest));
  EXPECT_FALSE(solves(1.01 * rest)) << "a blow has ended it";
}

// M presses m against what is fixed. A sweep up takes 1 - q of the speed of M, one down stops m: so
// sixty of them leave q^30. The impulses are kept, and the next sixty begin where these ended.
TEST_F(ContactGroups, SixtySweepsAStep_AndTheNextOneGoesOn) {
  constexpr double kHeavy = 50, kSpeed = 1;
  const double left = std::pow(kHeavy / (kHeavy + 1), 30);
  rig().add(0, 0);
  rig().add(1, 0);
  rig().add(kHeavy, -kSpeed);
  double want = -kSpeed;
  for (int step = 0; step < 3; ++step) {
    rig().momentum(1) = 0;
    rig().momentum(2) = -kHeavy * kSpeed;
    rig().solve();
    want *= left;
    EXPECT_NEAR(rig().velocity(2), want, kExact) << step;
    EXPECT_NEAR(rig().velocity(1), 0, kExact) << step;
    EXPECT_NEAR(rig().impulse(1), kHeavy * (kSpeed + want), 100 * kExact) << step;
    EXPECT_NEAR(rig().impulse(0), kHeavy * (kSpeed + want), 100 * kExact) << step;
    rig().groups.end_step();
  }
  rig().groups.remove(2);
  EXPECT_EQ(rig().groups.contacts.size(), 1) << "the other one's is kept";
  rig().groups.remove(1);
  rig().momentum(2) = -kHeavy * kSpeed;
  rig().solve();
  EXPECT_NEAR(rig().velocity(2), -kSpeed * left, kExact) << "all begins anew";
}

// A long group goes on ahead between sweeps, and not after the last one: that ends at what is
// fixed, which the lowest ball then does not approach, however much is left above it.
TEST_F(ContactGroups, SweepsThatEndBeforeTheyAreDone_EndWithAVisit) {
  constexpr double kHeavy = 1e4, kSpeed = 1;
  rig().add(0, 0);
  for (int i = 0; i < 4; ++i) rig().add(1, 0);
  rig().add(kHeavy, -kSpeed);
  rig().momentum(5) = -kHeavy * kSpeed;
  rig().solve();
  EXPECT_LT(rig().velocity(5), -0.01 * kSpeed) << "or all is done";
  EXPECT_GT(rig().impulse(0), 1);
  EXPECT_NEAR(rig().velocity(1), 0, kExact * rig().impulse(0));
}

TEST_F(ContactGroups, NoRoomForAContact_TheTwoGoOnTogether_AndItIsTold) {
  for (std::size_t i = 0; i < kRoom + 2; ++i) rig().add(1, i == 0 ? 1 : 0);
  rig().solve();
  EXPECT_EQ(rig().groups.contacts.size(), kRoom);
  EXPECT_EQ(rig().bodies.report.contacts_dropped, 1U);
  for (std::size_t i = 0; i < kRoom + 2; ++i) {
    const auto alone = detail::Bodies<Row>::kAlone;
    EXPECT_EQ(rig().bodies.states[i].group == alone, i < kRoom) << i;
  }
  EXPECT_FALSE(rig().contact(kRoom - 1).is_solved) << "one of its two goes with a group";
  EXPECT_NEAR(rig().sum(), 1, kExact);
}

TEST_F(ContactGroups, NoRoomForABlow_TheTwoGoOnTogether_AndItIsTold) {
  for (std::size_t i = 0; i < kRoom + 1; ++i) rig().add(1, 0);
  rig().add(1, -1, 2 * kD);
  rig().solve();
  EXPECT_EQ(rig().groups.contacts.size(), kRoom);
  EXPECT_EQ(rig().bodies.report.contacts_dropped, 0U);
  rig().pass_on(kRoom);
  EXPECT_EQ(rig().bodies.report.contacts_dropped, 1U);
  EXPECT_NE(rig().bodies.states[kRoom].group, detail::Bodies<Row>::kAlone);
  EXPECT_EQ(rig().bodies.states[kRoom].group, rig().bodies.states[kRoom + 1].group);
  EXPECT_EQ(rig().bodies.states[kRoom - 1].group, detail::Bodies<Row>::kAlone);
  EXPECT_NEAR(rig().sum(), -1, kExact);
}

/// What is left of each contact's approach when nothing more is passed on: D / 8 in a step.
constexpr double kUnseen = kD / 8 / kStep;

// Two equal balls at rest in a row, struck by a third with 10 m/s. C = 1: the last one takes all of
// it. C = 0: each has a third.
TEST_F(ContactGroups, BlowOnARow_IsPassedOn) {
  for (const double C : {1.0, 0.0}) {
    RowRig row;
    row.restitution = C;
    row.add(1, 10);
    row.add(1, 0, 1);
    row.add(1, 0);
    row.solve();
    row.meet(C == 0 ? 5 : 10);
    row.pass_on(0);
    ASSERT_FALSE(row.blows.empty()) << C;
    for (const ProxyPair pair : row.blows) EXPECT_EQ(pair.first, 1) << C;
    EXPECT_EQ(row.contact(0).is_solved, true) << "it lasts from now on";
    for (std::size_t i = 0; i < 3; ++i) {
      const double want = C == 0 ? 10.0 / 3 : (i == 2 ? 10 : 0);
      EXPECT_NEAR(row.velocity(i), want, 2 * kUnseen) << C << ' ' << i;
    }
    EXPECT_NEAR(row.sum(), 10, kExact);
    EXPECT_EQ(row.bodies.states[2].changed, true) << "it has to be planned anew";
  }
}

// What a contact may close by, D / 8 in the rest of the step, is not passed on, and neither is what
// is left to close: not a bit of the next ball changes.
TEST_F(ContactGroups, ApproachThatDoesNotMatter_IsNotPassedOn) {
  for (const double of_unseen : {0.5, 0.9, 1.1, 2.0}) {
    RowRig row;
    for (int i = 0; i < 3; ++i) row.add(1, 0);
    row.solve();
    row.momentum(0) = 2 * of_unseen * kUnseen;  // shared with the second ball
    row.pass_on(0);
    EXPECT_TRUE(row.contact(1).is_solved);
    if (of_unseen < 1) {
      EXPECT_NEAR(row.velocity(1), of_unseen * kUnseen, kExact);
      EXPECT_EQ(row.momentum(2), 0) << of_unseen;
      EXPECT_EQ(row.impulse(1), 0) << of_unseen;
    } else {
      EXPECT_GT(row.momentum(2), 0.25 * of_unseen * kUnseen) << of_unseen;
    }
    EXPECT_NEAR(row.sum(), 2 * of_unseen * kUnseen, kExact);
  }
}

// The same where the other two sleep: they are woken before they take anything, and share it all
// the same. One that sleeps further on is let sleep.
TEST_F(ContactGroups, BlowOnSleepers_WakesThem) {
  rig().add(1, 10);
  rig().add(1, 0, 1);
  rig().add(1, 0);
  rig().add(1, 0);
  rig().add(1, 0, 1);
  rig().solve();
  rig().groups.end_step();
  for (const std::size_t i : {2U, 3U, 4U}) rig().bodies.states[i].asleep = true;
  rig().solve();
  EXPECT_FALSE(rig().contact(2).is_solved) << "between two that sleep";
  rig().meet(5);
  rig().pass_on(0);
  EXPECT_EQ(rig().woken, (std::vector<std::size_t>{2, 3}));
  EXPECT_TRUE(rig().bodies.states[4].asleep);
  EXPECT_TRUE(rig().contact(2).is_solved);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(rig().velocity(i), 2.5, 6 * kUnseen) << i;
  EXPECT_NEAR(rig().sum(), 10, kExact);
}

TEST_F(ContactGroups, WhoWakes_PressesOnNobodyUntilHeIsSolved) {
  rig().add(0, 0);
  rig().add(1, -1);
  rig().solve();
  rig().groups.end_step();
  EXPECT_NEAR(rig().impulse(0), 1, kExact);
  rig().bodies.states[1].asleep = true;
  rig().solve();
  EXPECT_FALSE(rig().groups.presses(RowRig::pair(0)));
  rig().bodies.states[1].asleep = false;
  rig().groups.wake(1);
  EXPECT_TRUE(rig().contact(0).is_solved);
  EXPECT_EQ(rig().impulse(0), 0);
}

// M strikes m, which lies against what is fixed, with C = 0. The blow leaves q of its speed; each
// sweep stops m, and takes 1 - q again: 48 of them leave q^49.
TEST_F(ContactGroups, WhatABlowPassesOn_TakesFortyEightSweepsAtMost) {
  constexpr double kHeavy = 50, kSpeed = 10;
  rig().add(0, 0);
  rig().add(1, 0);
  rig().add(kHeavy, 0);
  rig().solve();
  rig().momentum(2) = -kHeavy * kSpeed;
  rig().pass_on(1);
  const double left = kSpeed * std::pow(kHeavy / (kHeavy + 1), 49);
  EXPECT_NEAR(rig().velocity(2), -left, 1e-11);
  EXPECT_NEAR(rig().velocity(1), -left, 1e-11);
  EXPECT_EQ(rig().blows.size(), 48U) << "m on what is fixed, once a sweep";
}

// A blow at a quarter of the step that changes nothing: a quarter of the weight's impulse is spent
// and cannot be taken back, the sum is what the next step starts from.
TEST_F(ContactGroups, WhatHasPassedOfAStep_IsSpent) {
  constexpr double kG = 10;
  rig().bodies.settings.gravity_W = {0, 0, -kG};
  rig().add(0, 0);
  rig().add(2, 0);
  rig().solve();
  rig().bodies.now = kStep / 4;
  rig().pass_on(0);
  const double weight = 2 * kG * kStep;
  EXPECT_NEAR(rig().impulse(0), 0.75 * weight, kExact);
  EXPECT_NEAR(rig().contact(0).points[0].spent_normal, 0.25 * weight, kExact);
  EXPECT_NEAR(rig().velocity(1), 0, kExact);
  rig().groups.end_step();
  EXPECT_NEAR(rig().impulse(0), weight, kExact);
  EXPECT_EQ(rig().contact(0).points[0].spent_normal, 0);
}

// The same of a neighbour that the blow is passed on to: it is brought to the time of the blow
// first.
TEST_F(ContactGroups, WhatHasPassedOfAStep_IsSpentOfWhatTakesItNext) {
  constexpr double kG = 10;
  rig().bodies.settings.gravity_W = {0, 0, -kG};
  rig().add(0, 0);
  rig().add(2, 0);
  rig().add(1, 0);
  for (int step = 0; step < 20; ++step) {
    rig().solve();
    rig().groups.end_step();
  }
  rig().solve();
  const double carried = rig().impulse(1);
  EXPECT_NEAR(carried, kG * kStep, 3 * kD / 64 / kStep) << "as in Column_CarriesItsWeight";
  rig().bodies.now = kStep / 4;
  rig().momentum(1) += 0.5;  // upwards, at 0.25 m/s: the upper one takes a third of it
  rig().pass_on(0);
  EXPECT_EQ(rig().contact(1).since, rig().bodies.now);
  EXPECT_NEAR(rig().contact(1).points[0].spent_normal, 0.25 * carried, kExact);
  EXPECT_GT(rig().velocity(2), 0.1);
}

// The least radius of gyration of a ball is sqrt(2/5) r: an eighth of it is 7.9 mm.
TEST_F(ContactGroups, ShiftBeyondAnEighthOfTheGyration_HasItsPointsFoundAnew) {
  rig().add(1, 0);
  rig().add(1, 0);
  rig().solve();
  for (const double shift : {7.8e-3, 8.0e-3}) {
    rig().groups.note_shift(rig().body(1), 1, {0, shift, 0});
    EXPECT_EQ(rig().contact(0).is_moved, shift > 7.9e-3) << shift;
  }
}

}  // namespace
}  // namespace batuta
