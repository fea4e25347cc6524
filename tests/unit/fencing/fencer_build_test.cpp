// SPDX-License-Identifier: MIT
// The ready-made bodies and weapons: what their figures must keep whoever chooses them.
#include <gtest/gtest.h>

#include "batuta/fencing/fencer.hpp"

namespace batuta {
using namespace fencing;
namespace {

constexpr double kRounding = 1e-6;  // the figures are single precision numbers of metres

class ReadyMade : public ::testing::TestWithParam<int> {
 protected:
  const Fencer<double> fencer = GetParam() == 0 ? first_fencer<double>() : second_fencer<double>();
  const Weapon<double> weapon = epee<double>();

  const Bone<double>& bone(BodyPart part) const {
    return fencer.build.bones[static_cast<std::size_t>(part)];
  }
  /// A bone of a limb lies along x from where it begins.
  void expect_joined(BodyPart parent, BodyPart child) const {
    EXPECT_EQ(bone(parent).capsule_J.axis.a, Vec3<double>::Zero());
    EXPECT_EQ(bone(child).start_P, bone(parent).capsule_J.axis.b);
  }
  void expect_alike(BodyPart one, BodyPart other) const {
    EXPECT_EQ(bone(one).capsule_J.axis.b, bone(other).capsule_J.axis.b);
    EXPECT_EQ(bone(one).capsule_J.radius, bone(other).capsule_J.radius);
  }
};

TEST_P(ReadyMade, Limbs_AreJoinedAndAlikeOnBothSides) {
  expect_joined(BodyPart::kWeaponUpperArm, BodyPart::kWeaponForearm);
  expect_joined(BodyPart::kWeaponForearm, BodyPart::kWeaponHand);
  expect_joined(BodyPart::kOtherUpperArm, BodyPart::kOtherForearm);
  expect_joined(BodyPart::kFrontThigh, BodyPart::kFrontShin);
  expect_joined(BodyPart::kRearThigh, BodyPart::kRearShin);
  expect_alike(BodyPart::kWeaponUpperArm, BodyPart::kOtherUpperArm);
  expect_alike(BodyPart::kWeaponForearm, BodyPart::kOtherForearm);
  expect_alike(BodyPart::kFrontThigh, BodyPart::kRearThigh);
  expect_alike(BodyPart::kFrontShin, BodyPart::kRearShin);
}

/// The hips lie opposite each other, a half turn about the trunk apart, and at one height.
TEST_P(ReadyMade, Hips_LieOppositeEachOther) {
  const Vec3<double> front = bone(BodyPart::kFrontThigh).start_P;
  const Vec3<double> rear = bone(BodyPart::kRearThigh).start_P;
  EXPECT_EQ(front, Vec3<double>(-rear.x(), -rear.y(), rear.z()));
}

/// In its mask, which is 0.35 m high at most, and on the trunk without a gap between them.
TEST_P(ReadyMade, Head_IsOnTheTrunkAndNoLargerThanAMask) {
  const Bone<double>& head = bone(BodyPart::kHead);
  const Capsule<double>& trunk = bone(BodyPart::kTorso).capsule_J;
  const double low = head.start_P.z() +
                     min_of(head.capsule_J.axis.a.z(), head.capsule_J.axis.b.z()) -
                     head.capsule_J.radius;
  const double high = head.start_P.z() +
                      max_of(head.capsule_J.axis.a.z(), head.capsule_J.axis.b.z()) +
                      head.capsule_J.radius;
  EXPECT_LE(high - low, 0.35);
  EXPECT_GE(high - low, 0.2) << "a head alone";
  EXPECT_LE(low, trunk.axis.b.z() + trunk.radius);
  EXPECT_GT(low, trunk.axis.a.z());
}

/// The rules of the sport for an epee: a straight blade of 0.90 m at most, 0.77 kg in all.
TEST_P(ReadyMade, Epee_KeepsTheRules) {
  double mass = 0;
  for (const auto& part : weapon.parts) {
    mass += part.mass;
    EXPECT_EQ(part.capsule_H.axis.a.tail<2>(), Vec2<double>::Zero());
    EXPECT_EQ(part.capsule_H.axis.b.tail<2>(), Vec2<double>::Zero());
  }
  const Segment<double>& blade = weapon.parts[0].capsule_H.axis;
  EXPECT_NEAR((blade.b - blade.a).norm(), 0.90, kRounding);
  EXPECT_NEAR(mass, 0.77, kRounding);
}

/// Each part touches the next one: the weapon is one piece.
TEST_P(ReadyMade, Epee_IsOnePiece) {
  const auto& parts = weapon.parts;  // blade, guard, grip, pommel
  for (std::size_t i = 1; i < parts.size(); ++i) {
    EXPECT_EQ(capsule_gap(parts[i - 1].capsule_H, parts[i].capsule_H).proximity,
              Proximity::kOverlapping)
        << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Both, ReadyMade, ::testing::Values(0, 1));

}  // namespace
}  // namespace batuta
