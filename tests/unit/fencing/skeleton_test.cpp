// SPDX-License-Identifier: MIT
#include "batuta/fencing/skeleton.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>

#include "batuta/fencing/fencer.hpp"

namespace batuta {
using namespace fencing;
namespace {

using V = Vec3<double>;

TEST(TwoBoneReach, InReach_KeepsLengthsAndArrives) {
  std::mt19937 random(3);
  const auto unit = [&random] { return static_cast<double>(random() % 20001) / 10000.0 - 1.0; };
  int reached = 0;
  for (int n = 0; n < 5000; ++n) {
    const V start(unit(), unit(), unit());
    const V goal(unit(), unit(), unit());
    const V bend(unit(), unit(), unit() + 2);
    const Vec2<double> lengths(0.7 + 0.3 * unit(), 0.7 + 0.3 * unit());
    const auto limb = two_bone_reach(start, goal, lengths, bend);
    ASSERT_NEAR((limb.middle - start).norm(), lengths.x(), 1e-7);
    ASSERT_NEAR((limb.end - limb.middle).norm(), lengths.y(), 1e-7);
    const V way = goal - start;
    ASSERT_LE((limb.end - start).cross(way).norm(), 1e-12 * way.norm());  // in the goal's direction
    const bool can =
        way.norm() <= lengths.sum() && way.norm() >= std::abs(lengths.x() - lengths.y());
    ASSERT_EQ(limb.in_reach, can);
    if (!can) continue;
    ++reached;
    ASSERT_LE((limb.end - goal).norm(), 1e-12);
    const V across = bend - bend.dot(way) / way.squaredNorm() * way;
    ASSERT_GE((limb.middle - start).dot(across), -1e-12);  // gives way towards `bend`
  }
  EXPECT_GT(reached, 1000);
}

TEST(TwoBoneReach, BeyondReach_IsStraight) {
  const auto limb = two_bone_reach<double>({0, 0, 0}, {5, 0, 0}, {0.3, 0.2}, {0, 0, 1});
  EXPECT_LE((limb.middle - V(0.3, 0, 0)).norm(), 1e-15);
  EXPECT_LE((limb.end - V(0.5, 0, 0)).norm(), 1e-15);
  EXPECT_FALSE(limb.in_reach);
}

TEST(TwoBoneReach, DegenerateGoals_GiveFiniteLimbs) {
  const Vec2<double> lengths(0.3, 0.3);
  const auto folded = two_bone_reach<double>({1, 1, 1}, {1, 1, 1}, lengths, {0, 0, 1});
  EXPECT_LE((folded.end - V(1, 1, 1)).norm(), 1e-15);
  EXPECT_NEAR((folded.middle - V(1, 1, 1)).norm(), 0.3, 1e-15);
  const auto along_bend = two_bone_reach<double>({0, 0, 0}, {0, 0, 0.4}, lengths, {0, 0, 2});
  EXPECT_NEAR((along_bend.middle - V(0, 0, 0)).norm(), 0.3, 1e-15);
  EXPECT_NEAR((along_bend.end - V(0, 0, 0.4)).norm(), 0, 1e-15);
  const auto unequal = two_bone_reach<double>({0, 0, 0}, {0, 0, 0}, {0.3, 0.1}, {1, 0, 0});
  EXPECT_NEAR((unequal.end - unequal.middle).norm(), 0.1, 1e-15);
}

TEST(LungeShare, RunsFromGuardToLunge) {
  FencerBuild<double> build;
  build.guard_hand_x = 0.4;
  build.lunge_hand_x = 1.2;
  EXPECT_EQ(lunge_share(build, 0.1), 0.0);
  EXPECT_NEAR(lunge_share(build, 0.8), 0.5, 1e-15);
  EXPECT_EQ(lunge_share(build, 3.0), 1.0);
}

const Capsule<double>& part(const BodyShape<double>& shape, BodyPart p) {
  return shape[static_cast<std::size_t>(p)];
}

class Body : public ::testing::TestWithParam<int> {
 protected:
  Fencer<double> fencer = GetParam() == 0 ? first_fencer<double>() : second_fencer<double>();
  Pose<double> X_WF = Salle<double>{}.X_WF(GetParam() == 0 ? Side::kLeft : Side::kRight);
  Pose<double> hand(double x, double y) const {
    return hand_at(fencer.map, Vec2<double>(x, y), X_WF).X_WH;
  }
  BodyShape<double> at(double x, double y) const {
    return pose_body(fencer.build, X_WF, hand(x, y));
  }
};

// Bones keep their lengths and stay joined, and the weapon hand is where the stick wants it.
TEST_P(Body, WholeStickSquare_IsOneConnectedBody) {
  double farthest = 0;
  for (double y = -1; y <= 1; y += 0.1) {
    for (double x = -1; x <= 1; x += 0.1) {
      const auto shape = at(x, y);
      const auto joined = [&shape](BodyPart a, BodyPart b) {
        return (part(shape, a).axis.b - part(shape, b).axis.a).norm();
      };
      EXPECT_LE(joined(BodyPart::kWeaponUpperArm, BodyPart::kWeaponForearm), 1e-12);
      EXPECT_LE(joined(BodyPart::kWeaponForearm, BodyPart::kWeaponHand), 1e-12);
      EXPECT_LE(joined(BodyPart::kOtherUpperArm, BodyPart::kOtherForearm), 1e-12);
      EXPECT_LE(joined(BodyPart::kFrontThigh, BodyPart::kFrontShin), 1e-12);
      EXPECT_LE(joined(BodyPart::kRearThigh, BodyPart::kRearShin), 1e-12);
      for (std::size_t i = 0; i < shape.size(); ++i) {
        EXPECT_NEAR(shape[i].axis.direction().norm(),
                    fencer.build.bones[i].capsule_J.axis.direction().norm(), 1e-12);
        EXPECT_GT(std::min(shape[i].axis.a.z(), shape[i].axis.b.z()), 0.0);  // above the floor
      }
      const V hand_W = hand(x, y).p_W;
      farthest = std::max(farthest, (part(shape, BodyPart::kWeaponHand).axis.a - hand_W).norm());
    }
  }
  EXPECT_LE(farthest, 0.04);  // an arm may be stretched by this much, not more
}

TEST_P(Body, RearFoot_StaysWhereItIs) {
  const V guard = part(at(0, 0), BodyPart::kRearShin).axis.b;
  EXPECT_LE((part(at(0, 1), BodyPart::kRearShin).axis.b - guard).norm(), 0.05);
  EXPECT_LE((part(at(-1, -1), BodyPart::kRearShin).axis.b - guard).norm(), 1e-12);
}

TEST_P(Body, Lunge_GoesTowardsTheOpponentAndDown) {
  const auto guard = at(0, 0);
  const auto lunge = at(0, 1);
  const double forward =
      (GetParam() == 0 ? 1.0 : -1.0) *
      (part(lunge, BodyPart::kTorso).axis.b - part(guard, BodyPart::kTorso).axis.b).x();
  EXPECT_GT(forward, 0.4);
  EXPECT_LT(part(lunge, BodyPart::kPelvis).axis.a.z(),
            part(guard, BodyPart::kPelvis).axis.a.z() - 0.2);
}

// The shoulder of the weapon comes along straight towards the hand by what is missing to 0.98 of
// the arm, but no further than it gives; nothing else of the body knows of it.
TEST_P(Body, Shoulder_ComesAlongBeforeTheArmIsStraight) {
  FencerBuild<double> stiff = fencer.build;
  stiff.shoulder_give = 0;
  const auto length = [&stiff](BodyPart p) {
    return stiff.bones[static_cast<std::size_t>(p)].capsule_J.axis.direction().norm();
  };
  const double arm = length(BodyPart::kWeaponUpperArm) + length(BodyPart::kWeaponForearm);
  const double give = fencer.build.shoulder_give;
  ASSERT_NEAR(give, GetParam() == 0 ? 0.14 : 0.14 * 1.04, 1e-7);
  std::array<int, 3> seen{};
  for (double x = 0.2; x < 1.6; x += 0.02) {
    const Pose<double> X_WH{to_world(X_WF, V(x, 0.3 - 0.4 * x, 1.1 + 0.2 * x)), X_WF.q_WB};
    const auto still = pose_body(stiff, X_WF, X_WH);
    const auto moved = pose_body(fencer.build, X_WF, X_WH);
    const V root = part(still, BodyPart::kWeaponUpperArm).axis.a;
    const double missing = (X_WH.p_W - root).norm() - 0.98 * arm;
    const double way = std::min(std::max(missing, 0.0), give);
    const V expected = root + way * (X_WH.p_W - root).normalized();
    EXPECT_LE((part(moved, BodyPart::kWeaponUpperArm).axis.a - expected).norm(), 1e-7) << x;
    ++seen[missing <= 0 ? 0U : missing < give ? 1U : 2U];
    for (const BodyPart p : {BodyPart::kPelvis, BodyPart::kTorso, BodyPart::kHead,
                             BodyPart::kOtherForearm, BodyPart::kFrontShin, BodyPart::kRearShin}) {
      EXPECT_EQ(part(moved, p).axis.b, part(still, p).axis.b) << name_of(p);
    }
  }
  EXPECT_GT(*std::min_element(seen.begin(), seen.end()), 3) << "bent, coming along, straight";
}

// Without give the arm begins where the torso has its shoulder, wherever the hand is.
TEST_P(Body, ShoulderThatGivesNothing_IsOnTheTorso) {
  FencerBuild<double> stiff = fencer.build;
  stiff.shoulder_give = 0;
  const V start_P = stiff.bones[static_cast<std::size_t>(BodyPart::kWeaponUpperArm)].start_P;
  for (const double x : {0.1, 0.42, 0.9, 1.24, 3.0}) {
    const Pose<double> X_WH{to_world(X_WF, V(x, -0.1, 1.2)), X_WF.q_WB};
    const auto shape = pose_body(stiff, X_WF, X_WH);
    const Segment<double>& spine = part(shape, BodyPart::kTorso).axis;  // from 0.04 to 0.34, z in J
    const V up = spine.direction().normalized();
    const V left = X_WF.q_WB * V::UnitY();
    const double size = spine.direction().norm() / 0.30;
    const V base = spine.a - 0.04 * size * up;
    const V shoulder = base + start_P.x() * left.cross(up) + start_P.y() * left + start_P.z() * up;
    EXPECT_LE((part(shape, BodyPart::kWeaponUpperArm).axis.a - shoulder).norm(), 1e-6) << x;
  }
}

// No jumps: a small movement of the stick moves every joint a little.
TEST_P(Body, SmallMovements_AreSmallEverywhere) {
  const double h = 1e-4;
  for (double y = -0.95; y <= 0.95; y += 0.05) {
    for (double x = -0.95; x <= 0.95; x += 0.05) {
      const auto before = at(x, y);
      const auto after = at(x + h, y + h);
      for (std::size_t i = 0; i < before.size(); ++i) {
        ASSERT_LE((before[i].axis.a - after[i].axis.a).norm(), 10 * h);
        ASSERT_LE((before[i].axis.b - after[i].axis.b).norm(), 10 * h);
      }
    }
  }
}
INSTANTIATE_TEST_SUITE_P(Both, Body, ::testing::Values(0, 1));

TEST(PoseBody, HandBehindTheBack_IsStillFinite) {
  const auto fencer = first_fencer<float>();
  for (const auto& p :
       {Vec3<float>(-3, 0, 1), Vec3<float>(0.12F, -0.12F, 1.37F), Vec3<float>(0, 0, -2)}) {
    const auto shape = pose_body(fencer.build, Pose<float>{}, {p, Quat<float>(0, 0, 0, 1)});
    for (const auto& capsule : shape) EXPECT_TRUE(is_valid(capsule));
  }
}

TEST(BodyPart, Names_AreAllDifferent) {
  for (int i = 0; i < kBodyParts; ++i) {
    for (int k = 0; k < i; ++k) {
      EXPECT_NE(std::string(name_of(static_cast<BodyPart>(i))), name_of(static_cast<BodyPart>(k)));
    }
  }
  EXPECT_EQ(std::string(name_of(static_cast<BodyPart>(200))), "unknown");
}

TEST(FencerBuild, OutOfRange_IsRefused) {
  ASSERT_EQ(validate(first_fencer<float>().build), Status::kOk);
  ASSERT_EQ(validate(second_fencer<double>().build), Status::kOk);
  const auto refused = [](auto change) {
    FencerBuild<float> build = first_fencer<float>().build;
    change(build);
    return validate(build) == Status::kInvalidArgument;
  };
  using Build = FencerBuild<float>;
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  for (std::size_t i = 0; i < kBodyParts; ++i) {
    EXPECT_TRUE(refused([i](Build& b) { b.bones[i].start_P.y() = kNan; })) << i;
    EXPECT_TRUE(refused([i](Build& b) { b.bones[i].start_P.x() = 1e30F; })) << i;
    EXPECT_TRUE(refused([i](Build& b) { b.bones[i].capsule_J.radius = -0.1F; })) << i;
    EXPECT_TRUE(refused([i](Build& b) { b.bones[i].capsule_J.radius = 1e30F; })) << i;
    EXPECT_TRUE(refused([i](Build& b) { b.bones[i].capsule_J.axis.a.z() = -1e30F; })) << i;
    EXPECT_TRUE(refused([i](Build& b) { b.bones[i].capsule_J.axis.b.z() = kNan; })) << i;
  }
  for (const BodyPart part :
       {BodyPart::kWeaponUpperArm, BodyPart::kWeaponForearm, BodyPart::kOtherUpperArm,
        BodyPart::kOtherForearm, BodyPart::kFrontThigh, BodyPart::kFrontShin, BodyPart::kRearThigh,
        BodyPart::kRearShin}) {
    const auto i = static_cast<std::size_t>(part);
    EXPECT_TRUE(refused([i](Build& b) {
      b.bones[i].capsule_J.axis.b = b.bones[i].capsule_J.axis.a;
    })) << name_of(part);
  }
  using LimbOf = Limb<float> Build::*;
  for (const LimbOf limb :
       {&Build::weapon_arm, &Build::other_arm, &Build::front_leg, &Build::rear_leg}) {
    EXPECT_TRUE(refused([limb](Build& b) { (b.*limb).bend_F.setZero(); }));
    EXPECT_TRUE(refused([limb](Build& b) { (b.*limb).bend_F.x() = kNan; }));
    EXPECT_TRUE(refused([limb](Build& b) { (b.*limb).goal_F.x() = 1e30F; }));
  }
  EXPECT_TRUE(refused([](Build& b) { b.lunge_hand_x = b.guard_hand_x; }));
  EXPECT_TRUE(refused([](Build& b) { b.guard_hand_x = kNan; }));
  EXPECT_TRUE(refused([](Build& b) { b.lunge_hand_x = 1e30F; }));
  EXPECT_TRUE(refused([](Build& b) { b.lunge_lean = 1.1F; }));
  EXPECT_TRUE(refused([](Build& b) { b.lunge_lean = -1.1F; }));
  EXPECT_TRUE(refused([](Build& b) { b.lunge_lean = kNan; }));
  EXPECT_TRUE(refused([](Build& b) { b.lunge_shift_F.z() = kNan; }));
  EXPECT_TRUE(refused([](Build& b) { b.stride_F.x() = 1e30F; }));
}

TEST(FencerBuild, ShoulderGiveOutOfRange_IsRefused) {
  FencerBuild<float> build = first_fencer<float>().build;
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (const float bad : {-1e-6F, nan, 1e30F, std::numeric_limits<float>::infinity()}) {
    build.shoulder_give = bad;
    EXPECT_EQ(validate(build), Status::kInvalidArgument) << bad;
  }
  build.shoulder_give = 0;
  EXPECT_EQ(validate(build), Status::kOk);
}

}  // namespace
}  // namespace batuta
