// SPDX-License-Identifier: MIT
#include "batuta/fencing/target.hpp"

#include <gtest/gtest.h>

#include <random>

#include "batuta/fencing/fencer.hpp"

namespace batuta {
using namespace fencing;
namespace {

using V = Vec3<double>;
constexpr double kStep = 0.02;

class Dice {
 public:
  explicit Dice(unsigned seed) : random_(seed) {}
  double unit() { return static_cast<double>(random_() % 20001) / 10000.0 - 1.0; }
  V vec() { return {unit(), unit(), unit()}; }

 private:
  std::mt19937 random_;
};

BodyShape<double> shape_at(double x, double y) {
  static const Fencer<double> fencer = first_fencer<double>();
  return pose_body(fencer.build, Pose<double>{}, hand_at(fencer.map, Vec2<double>(x, y)).X_WH);
}

/// A body on its way between two stick positions, one step of 20 ms.
Target<double> moving_target(Dice& dice) {
  Target<double> target;
  const double x = dice.unit();
  const double y = dice.unit();
  target.place(shape_at(x, y));
  target.move_to(shape_at(x + 0.3 * dice.unit(), y + 0.3 * dice.unit()), kStep);
  return target;
}

MovingCapsule<double> blade_at(const V& hilt, const V& direction, const V& v, const V& w,
                               double duration) {
  MovingCapsule<double> blade;
  blade.capsule_B = {{V(0, 0, 0), V(0.9 * direction.normalized())}, 0.0045};
  blade.motion = {{hilt, Quat<double>::Identity()}, {v, w}, duration};
  return blade;
}

SteppingOptions<double> fine() {
  SteppingOptions<double> options;
  options.epsilon = 0.0005;
  options.unit = EpsilonIn::kMetres;
  return options;
}

/// The first part and time by trying every part at many instants: no hierarchy, no search.
struct Sampled {
  double t = 1e9;
  int part = -1;
  double deepest = -1e9;
};
Sampled by_sampling(const Target<double>& target, const MovingCapsule<double>& blade, double from) {
  Sampled first;
  constexpr int kInstants = 1000;
  for (int i = 0; i <= kInstants; ++i) {
    const double t = blade.motion.duration * i / kInstants;
    const auto blade_W = to_world(pose_at(blade.motion, t), blade.capsule_B);
    for (int p = 0; p < kBodyParts; ++p) {
      const auto& moving = target.part(static_cast<BodyPart>(p));
      const auto part_W = to_world(pose_at(moving.motion, from + t), moving.capsule_B);
      const double gap = capsule_gap(blade_W, part_W).gap;
      first.deepest = std::max(first.deepest, -gap);
      if (gap <= 0 && first.part < 0) first = {from + t, p, first.deepest};
    }
  }
  return first;
}

TEST(Target, MoveTo_CarriesEveryPartFromStartToEnd) {
  Target<double> target;
  const auto start = shape_at(-0.4, 0.2);
  const auto end = shape_at(0.6, 0.9);
  target.place(start);
  target.move_to(end, kStep);
  for (std::size_t i = 0; i < start.size(); ++i) {
    const auto& part = target.part(static_cast<BodyPart>(i));
    const auto at_start = to_world(pose_at(part.motion, 0.0), part.capsule_B);
    const auto at_end = to_world(pose_at(part.motion, kStep), part.capsule_B);
    EXPECT_LE((at_start.axis.a - start[i].axis.a).norm(), 1e-14);
    EXPECT_LE((at_start.axis.b - start[i].axis.b).norm(), 1e-14);
    EXPECT_LE((at_end.axis.a - end[i].axis.a).norm(), 1e-12);
    EXPECT_LE((at_end.axis.b - end[i].axis.b).norm(), 1e-12);
  }
}

// The body's hull, and that of each part, hold its surface at every time of the step.
TEST(Target, Hulls_HoldTheMovingBodyAtEveryTime) {
  Dice dice(4);
  for (int n = 0; n < 50; ++n) {
    auto target = moving_target(dice);
    for (int p = 0; p < kBodyParts; ++p) {
      const auto& moving = target.part(static_cast<BodyPart>(p));
      for (int i = 0; i <= 20; ++i) {
        const auto c = to_world(pose_at(moving.motion, kStep * i / 20), moving.capsule_B);
        const V on_surface =
            c.axis.at(0.5 + 0.5 * dice.unit()) + c.radius * dice.vec().normalized();
        ASSERT_TRUE(contains(target.hull(), on_surface)) << p;
        ASSERT_TRUE(contains(target.hull(static_cast<BodyPart>(p)), on_surface)) << p;
      }
    }
  }
}

// Random blades through a moving body: found touches are real, come first, and none deeper than
// epsilon is missed.
TEST(FindTouch, RandomBlades_AgreeWithSamplingOfAllParts) {
  Dice dice(8);
  int touches = 0;
  int misses = 0;
  for (int n = 0; n < 400; ++n) {
    auto target = moving_target(dice);
    const V hilt(1.25 + 0.3 * dice.unit(), 0.5 * dice.unit(), 1 + 0.8 * dice.unit());
    const V aim = V(0.3 * dice.unit(), 0.3 * dice.unit(), 1 + 0.7 * dice.unit()) - hilt;
    const auto blade =
        blade_at(hilt, aim, V(-15 + 10 * dice.unit(), 5 * dice.unit(), 5 * dice.unit()),
                 10 * dice.vec(), kStep / 2);
    const double from = kStep / 4;
    const auto found = target.find_touch<Stepping<double>>(blade, from, fine());
    const auto truth = by_sampling(target, blade, from);
    ASSERT_TRUE(found.complete);
    ASSERT_TRUE(found.certain());
    if (truth.deepest > 0.0005) {
      ASSERT_TRUE(found.found);
    }
    if (truth.deepest < -1e-9 && !found.found) ++misses;
    if (!found.found) continue;
    ++touches;
    ASSERT_GE(found.t_hit, found.t_free);
    ASSERT_GE(found.t_free, from);
    ASSERT_LE(found.t_free, truth.t + 1e-12);  // sampling never sees it earlier
    if (found.t_hit == from) {
      ASSERT_EQ(truth.t, from);
      continue;
    }
    const auto& moving = target.part(found.part);
    const auto blade_W = to_world(pose_at(blade.motion, found.t_hit - from), blade.capsule_B);
    const auto part_W = to_world(pose_at(moving.motion, found.t_hit), moving.capsule_B);
    const auto gap = capsule_gap(blade_W, part_W);
    ASSERT_LE(std::abs(gap.gap), 1e-3);
    ASSERT_LE((gap.surface_B - found.contact.point_W).norm(), 2e-3);
    ASSERT_LE((found.contact.normal_BA_W + gap.axes.normal_AB).norm(), 1e-2);
    ASSERT_NEAR(found.place, gap.axes.s, 1e-2);
  }
  EXPECT_GT(touches, 100);
  EXPECT_GT(misses, 50);
}

// The part that is hit first wins, not the part that is looked at first.
TEST(FindTouch, HandInFrontOfTheTorso_IsHitFirst) {
  Target<double> target;
  const auto shape = shape_at(0, 0);
  target.place(shape);
  target.move_to(shape, kStep);
  const V hand = shape[static_cast<std::size_t>(BodyPart::kWeaponHand)].axis.at(0.5);
  const V chest = shape[static_cast<std::size_t>(BodyPart::kTorso)].axis.at(0.5);
  const V aim = (chest - hand).normalized();
  const auto blade = blade_at(hand - 1.2 * aim, aim, 60 * aim, V::Zero(), kStep);
  const auto touch = target.find_touch<Stepping<double>>(blade, 0.0, fine());
  ASSERT_TRUE(touch.found);
  EXPECT_EQ(touch.part, BodyPart::kWeaponHand);
  EXPECT_GT(touch.searches, 1);
  const PartMask without_arm =
      kAllParts & ~(PartMask{7} << static_cast<int>(BodyPart::kWeaponUpperArm));
  const auto behind = target.find_touch<Stepping<double>>(blade, 0.0, fine(), without_arm);
  ASSERT_TRUE(behind.found);
  EXPECT_EQ(behind.part, BodyPart::kTorso);
  EXPECT_GT(behind.t_free, touch.t_free);
}

TEST(FindTouch, FarAway_CostsNoSearch) {
  Target<double> target;
  target.place(shape_at(0, 0));
  target.move_to(shape_at(0, 0.1), kStep);
  const auto touch = target.find_touch<Stepping<double>>(
      blade_at({4, 0, 1}, {1, 0, 0}, {1, 0, 0}, {0, 0, 0}, kStep), 0.0, fine());
  EXPECT_FALSE(touch.found);
  EXPECT_TRUE(touch.complete);
  EXPECT_EQ(touch.searches, 0);
  EXPECT_EQ(touch.evaluations, 0U);
  EXPECT_EQ(touch.known_until, kStep);
}

TEST(FindTouch, InsideAtTheStart_IsATouchAtTheStart) {
  Target<double> target;
  const auto shape = shape_at(0, 0);
  target.place(shape);
  target.move_to(shape, kStep);
  const V chest = shape[static_cast<std::size_t>(BodyPart::kTorso)].axis.at(0.5);
  const auto touch = target.find_touch<Stepping<double>>(
      blade_at(chest, {0, 0, 1}, {0, 0, 0}, {0, 0, 0}, kStep), 0.0, fine());
  ASSERT_TRUE(touch.found);
  EXPECT_EQ(touch.t_free, 0.0);
  EXPECT_EQ(touch.part, BodyPart::kTorso);
}

// Out of budget is not "no touch".
TEST(FindTouch, OutOfBudget_IsReportedAsUnknown) {
  Target<double> target;
  target.place(shape_at(0, 0));
  target.move_to(shape_at(0, 0), kStep);
  auto options = fine();
  options.max_steps = 2;
  const auto blade = blade_at({2.2, 0, 1.15}, {-1, 0, 0}, {-60, 0, 0}, {0, 0, 0}, kStep);
  ASSERT_TRUE(target.find_touch<Stepping<double>>(blade, 0.0, fine()).found);
  const auto touch = target.find_touch<Stepping<double>>(blade, 0.0, options);
  EXPECT_FALSE(touch.found);
  EXPECT_FALSE(touch.complete);
  EXPECT_FALSE(touch.certain());
  EXPECT_LT(touch.known_until, kStep / 100);
}

TEST(FindTouch, InvalidSearch_IsReportedAsUnknown) {
  Target<double> target;
  target.place(shape_at(0, 0));
  target.move_to(shape_at(0, 0), kStep);
  auto options = fine();
  options.epsilon = -1;
  const auto blade = blade_at({0.8, 0, 1.15}, {-1, 0, 0}, {0, 0, 0}, {0, 0, 0}, kStep);
  const auto touch = target.find_touch<Stepping<double>>(blade, 0.0, options);
  EXPECT_FALSE(touch.complete);
  EXPECT_EQ(touch.known_until, 0.0);
}

TEST(FindTouch, Float_AgreesWithDouble) {
  const auto fencer_f = first_fencer<float>();
  const auto hand = [&fencer_f](float x, float y) {
    return hand_at(fencer_f.map, Vec2<float>(x, y)).X_WH;
  };
  Target<float> in_float;
  in_float.place(pose_body(fencer_f.build, Pose<float>{}, hand(0, 0)));
  in_float.move_to(pose_body(fencer_f.build, Pose<float>{}, hand(0.1F, 0.2F)), float(kStep));
  Target<double> in_double;
  in_double.place(shape_at(0, 0));
  in_double.move_to(shape_at(0.1F, 0.2F), kStep);
  const auto blade = blade_at({1.6, 0.02, 1.2}, {-1, 0, 0}, {-40, 0, 0}, {0, 1, 0}, kStep);
  MovingCapsule<float> blade_f;
  blade_f.capsule_B = {{blade.capsule_B.axis.a.cast<float>(), blade.capsule_B.axis.b.cast<float>()},
                       0.0045F};
  blade_f.motion = {{blade.motion.X_WB.p_W.cast<float>(), Quat<float>::Identity()},
                    {blade.motion.twist.v_W.cast<float>(), blade.motion.twist.w_W.cast<float>()},
                    float(kStep)};
  SteppingOptions<float> options;
  options.epsilon = 0.0005F;
  options.unit = EpsilonIn::kMetres;
  const auto f = in_float.find_touch<Stepping<float>>(blade_f, 0.0F, options);
  const auto d = in_double.find_touch<Stepping<double>>(blade, 0.0, fine());
  ASSERT_TRUE(f.found && d.found);
  EXPECT_EQ(f.part, d.part);
  EXPECT_NEAR(f.t_hit, d.t_hit, 1e-6);
}

// What a search could not do is told by its reason.
TEST(FindTouch, SearchesWithoutAnAnswer_AreCountedByTheirReason) {
  Target<double> target;
  const auto shape = shape_at(0, 0);
  target.place(shape);
  target.move_to(shape, kStep);
  const V chest = shape[static_cast<std::size_t>(BodyPart::kTorso)].axis.at(0.5);
  const auto blade = blade_at(chest - V(1.5, 0, 0), {1, 0, 0}, {30, 0, 0}, V::Zero(), kStep);
  SteppingOptions<double> tight;
  tight.unit = EpsilonIn::kMetres;
  tight.epsilon = 1e-9;
  tight.max_steps = 1;
  const auto cut = target.find_touch<Stepping<double>>(blade, 0, tight);
  EXPECT_GT(cut.budget_outs, 0);
  EXPECT_EQ(cut.searches_invalid, 0);
  tight.epsilon = 0;
  const auto invalid = target.find_touch<Stepping<double>>(blade, 0, tight);
  EXPECT_FALSE(invalid.complete);
  EXPECT_EQ(invalid.known_until, 0.0);
  EXPECT_EQ(invalid.budget_outs, 0);
  EXPECT_EQ(invalid.searches_invalid, invalid.searches);
  EXPECT_GT(invalid.searches_invalid, 0);
}

}  // namespace
}  // namespace batuta
