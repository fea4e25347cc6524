// SPDX-License-Identifier: MIT
// What stops a blade at a body, against pencil and paper and what holds of any blow.

#include <gtest/gtest.h>

#include "batuta/fencing/fencer.hpp"
#include "batuta/fencing/target.hpp"
#include "draws.hpp"

namespace batuta {
using namespace fencing;
namespace {

using V = Vec3<double>;
constexpr double kStep = 0.001;
constexpr PartMask kBody = kAllParts & ~mask_of(BodyPart::kWeaponHand);
/// Of a standing trunk.
constexpr double kRadius = double{0.13F};
constexpr double kBladeRadius = 0.0045;

BodyShape<double> standing_at(double x) {
  static const Fencer<double> fencer = first_fencer<double>();
  const Pose<double> X_WF{V(x, 0, 0), Quat<double>::Identity()};
  return pose_body(fencer.build, X_WF, hand_at(fencer.map, Vec2<double>(0, 0), X_WF).X_WH);
}

/// A blade of 0.9 m along x whose centre of mass is in its middle.
constexpr double kHalf = 0.45;
Capsule<double> blade_B() {
  return {{V(-kHalf, 0, 0), V(kHalf, 0, 0)}, kBladeRadius};
}
Body<double> blade_at(const Pose<double>& X_WB) {
  return make_body<double>(X_WB, 0.5, V(1e-4, 0.03, 0.03)).value;
}

double deepest_of(const BodyShape<double>& shape, const Pose<double>& X_WB) {
  double deepest = -1e9;
  for (std::size_t i = 0; i < shape.size(); ++i) {
    if ((kBody >> i & 1U) == 0) continue;
    deepest = std::max(deepest, -capsule_gap(to_world(X_WB, blade_B()), shape[i]).gap);
  }
  return deepest;
}

/// From behind, along x, at the middle of the trunk, the tip at this distance from it.
Pose<double> behind_trunk(const BodyShape<double>& shape, double gap) {
  const V middle = shape[static_cast<std::size_t>(BodyPart::kTorso)].axis.at(0.5);
  return {middle - V(kRadius + gap + kBladeRadius + kHalf, 0, 0), Quat<double>::Identity()};
}

// 1 mm and what the jacket gives is the way that is left in a millisecond.
TEST(TargetStop, ThrustAlongTheNormal_EndsWhereTheJacketDoes) {
  Target<double> target;
  const auto shape = standing_at(0);
  target.place(shape);
  const Pose<double> X_WB = behind_trunk(shape, 0.001);
  Motion<double> motion{X_WB, {V(5, 0, 0), V(0, 0, 0)}, kStep};
  EXPECT_TRUE(target.stop(blade_at(X_WB), blade_B(), 0, kBody, motion));
  EXPECT_NEAR(motion.twist.v_W.x(), (0.001 + kGive<double>) / kStep, 1e-6);
  EXPECT_NEAR(motion.twist.v_W.tail<2>().norm(), 0, 1e-6);
  EXPECT_NEAR(motion.twist.w_W.norm(), 0, 1e-6);
}

// A body that goes 5 mm leaves behind it a blade that was 1 mm away and may be pressed by 2 mm: it
// goes 2 mm along.
TEST(TargetStop, BodyThatComes_TakesTheBladeAlong) {
  Target<double> target;
  target.place(standing_at(0));
  target.move_to(standing_at(-0.005), kStep);
  const Pose<double> X_WB = behind_trunk(standing_at(0), 0.001);
  Motion<double> motion = still(X_WB, kStep);
  EXPECT_TRUE(target.stop(blade_at(X_WB), blade_B(), 0, kBody, motion));
  EXPECT_NEAR(motion.twist.v_W.x(), -(0.005 - 0.001 - kGive<double>) / kStep, 1e-6);
}

// A blade in a body is not thrown out, but comes out at 1 m/s.
TEST(TargetStop, BladeInABody_ComesOutSlowly) {
  Target<double> target;
  const auto shape = standing_at(0);
  target.place(shape);
  const Pose<double> X_WB = behind_trunk(shape, -0.05);
  Motion<double> motion{X_WB, {V(2, 0, 0), V(0, 0, 0)}, kStep};
  EXPECT_TRUE(target.stop(blade_at(X_WB), blade_B(), 0, kBody, motion));
  EXPECT_NEAR(motion.twist.v_W.x(), -1, 1e-6);
}

// Two impulses make what a blow did: J from the change of v is at the place that the change of w
// says.
TEST(TargetStop, BladeAcrossABody_IsTurnedByTheSameImpulse) {
  Target<double> target;
  const auto shape = standing_at(0);
  target.place(shape);
  const V middle = shape[static_cast<std::size_t>(BodyPart::kTorso)].axis.at(0.5);
  // Along y, its tip at the trunk's back: only the tip meets it.
  const Quat<double> along_y(std::sqrt(0.5), 0, 0, std::sqrt(0.5));
  const Pose<double> X_WB{middle - V(kRadius + kBladeRadius + 0.001, kHalf, 0), along_y};
  const Body<double> blade = blade_at(X_WB);
  const Twist<double> before{V(4, 0, 0), V(0, 0, 0)};
  Motion<double> motion{X_WB, before, kStep};
  EXPECT_TRUE(target.stop(blade, blade_B(), 0, mask_of(BodyPart::kTorso), motion));
  const V J = 0.5 * (motion.twist.v_W - before.v_W);
  const V turn = 0.03 * motion.twist.w_W;  // its axis is z
  EXPECT_LT(J.x(), 0);
  EXPECT_NEAR(turn.z(), -kHalf * J.x(), 0.02 * std::abs(turn.z()));
  EXPECT_NEAR(deepest_of(shape, pose_at(motion, kStep)), kGive<double>, 1e-4);
}

// Whatever a blade does that begins outside: it ends outside, and no blow gave it energy. What ends
// outside by itself is left as it is, to the last bit.
TEST(TargetStop, RandomMotions_EndOutsideWithoutEnergy) {
  constexpr int kMotions = 100000;
  constexpr double kLeft = 1e-4;  // what may be left to a later step
  Target<double> target;
  const auto shape = standing_at(0);
  target.place(shape);
  const V middle = shape[static_cast<std::size_t>(BodyPart::kTorso)].axis.at(0.5);
  int stopped = 0;
  for (std::uint64_t i = 0; i < kMotions; ++i) {
    test::Draws draws(1, 2, i);
    const V place = middle + draws.in_ball(0.9);
    const Pose<double> X_WB{place, draws.rotation()};
    if (deepest_of(shape, X_WB) > 0) continue;
    Twist<double> twist;
    twist.v_W = draws.in_ball(15);
    twist.w_W = draws.in_ball(20);
    Motion<double> motion{X_WB, twist, kStep};
    const double alone = deepest_of(shape, pose_at(motion, kStep));
    Body<double> blade = blade_at(X_WB);
    const bool is_stopped = target.stop(blade, blade_B(), 0, kBody, motion);
    if (alone <= kGive<double>) {
      EXPECT_FALSE(is_stopped) << i;
      EXPECT_EQ(motion.twist.v_W, twist.v_W) << i;
      EXPECT_EQ(motion.twist.w_W, twist.w_W) << i;
      continue;
    }
    ++stopped;
    EXPECT_LE(deepest_of(shape, pose_at(motion, kStep)), kGive<double> + kLeft) << i;
    blade.momentum = momentum_of(blade, twist);
    const double energy = kinetic_energy(blade);
    blade.momentum = momentum_of(blade, motion.twist);
    EXPECT_LE(kinetic_energy(blade), energy) << i;
  }
  EXPECT_GT(stopped, 200);
}

/// In the norm of energy.
double norm_of(Body<double> blade, const Twist<double>& twist) {
  blade.momentum = momentum_of(blade, twist);
  return std::sqrt(kinetic_energy(blade));
}

// Wherever it begins, deep in several parts too, fast, in long steps and in what rounding leaves of
// one: no more energy than it had, and its mass at a metre a second beside it.
TEST(TargetStop, BladesThatBeginDeep_AreNotThrownOut) {
  constexpr int kMotions = 40000;
  const double comes_out = std::sqrt(0.5 / 2);  // 0.5 kg at 1 m/s
  Target<double> target;
  const auto shape = standing_at(0);
  target.place(shape);
  const V middle = shape[static_cast<std::size_t>(BodyPart::kTorso)].axis.at(0.5);
  int stopped = 0;
  for (std::uint64_t i = 0; i < kMotions; ++i) {
    test::Draws draws(1, 3, i);
    const Pose<double> X_WB{middle + draws.in_ball(0.5), draws.rotation()};
    const double fast = i % 2 == 0 ? 1 : 20;
    const Twist<double> twist{draws.in_ball(fast), draws.in_ball(fast)};
    const double step = 1e-4 * std::pow(2, i % 6);
    const double left = i % 4 == 3 ? step * std::pow(2, -draws.between(20, 52)) : step;
    target.place(shape);
    target.move_to(shape, step);
    Motion<double> motion{X_WB, twist, left};
    const Body<double> blade = blade_at(X_WB);
    if (!target.stop(blade, blade_B(), step - left, kBody, motion)) continue;
    ++stopped;
    EXPECT_LE(norm_of(blade, motion.twist), (norm_of(blade, twist) + comes_out) * (1 + 1e-12)) << i;
  }
  EXPECT_GT(stopped, 5000);
}

// From outside a body that stands gives nothing, however long the step is.
TEST(TargetStop, BladesFromOutside_GainNothingInLongSteps) {
  constexpr int kMotions = 100000;
  constexpr double kLong = 0.004;
  Target<double> target;
  const auto shape = standing_at(0);
  target.place(shape);
  const V middle = shape[static_cast<std::size_t>(BodyPart::kTorso)].axis.at(0.5);
  int stopped = 0;
  for (std::uint64_t i = 0; i < kMotions; ++i) {
    test::Draws draws(1, 4, i);
    const Pose<double> X_WB{middle + draws.in_ball(0.9), draws.rotation()};
    if (deepest_of(shape, X_WB) > 0) continue;
    const Twist<double> twist{draws.in_ball(20), draws.in_ball(40)};
    Motion<double> motion{X_WB, twist, kLong};
    const Body<double> blade = blade_at(X_WB);
    if (!target.stop(blade, blade_B(), 0, kBody, motion)) continue;
    ++stopped;
    EXPECT_LE(norm_of(blade, motion.twist), norm_of(blade, twist) * (1 + 1e-12)) << i;
  }
  EXPECT_GT(stopped, 500);
}

// Of a way that was made otherwise than planned: out by the nearest way, no faster than at 1 m/s.
TEST(TargetWayOut, BladeThatABodyWalkedInto_IsCarriedAlong) {
  Target<double> target;
  target.place(standing_at(0));
  target.move_to(standing_at(-0.005), kStep);
  const Pose<double> X_WB = behind_trunk(standing_at(0), 0.001);
  const V way = target.way_out(blade_B(), X_WB, X_WB, kBody);
  EXPECT_NEAR(way.x(), -(0.005 - 0.001 - kGive<double>), 1e-9);
  EXPECT_NEAR(way.tail<2>().norm(), 0, 1e-9);
  const Pose<double> away = behind_trunk(standing_at(0), 0.5);
  EXPECT_EQ(target.way_out(blade_B(), away, away, kBody), V(0, 0, 0));
}

}  // namespace
}  // namespace batuta
