// SPDX-License-Identifier: MIT
// The instant that a search foresees, from a distance: by the parabola that has the gap, its rate
// and its bend in common with a motion whose distance is known in closed form.
#include <gtest/gtest.h>

#include <cmath>

#include "../../../src/detection/advancement_search.hpp"
#include "advancement_cases.hpp"
#include "batuta/detection/translation.hpp"

namespace batuta {
namespace {

using namespace testing_detection;

/// A distance, and its first two derivatives in time.
struct Course {
  double distance = 0;
  double rate = 0;
  double bend = 0;

  /// The first root of gap + rate h + bend h^2 / 2, by the school's formula.
  double contact(double radii) const {
    const double gap = distance - radii;
    return (-rate - std::sqrt(rate * rate - 2 * bend * gap)) / bend;
  }
};

constexpr double kRadii = 3.8;
constexpr double kFar = 5;  // from the axis to the ball that stands, m
constexpr double kArm = 3;  // from the axis to the ball that turns, m

/// Law of cosines: distance^2 = far^2 + arm^2 - 2 far arm cos(angle), angle' = rate.
Course on_circle(double angle, double turn_rate) {
  const double product = kFar * kArm;
  Course course;
  course.distance = std::sqrt(kFar * kFar + kArm * kArm - 2 * product * std::cos(angle));
  course.rate = product * turn_rate * std::sin(angle) / course.distance;
  course.bend = (product * turn_rate * turn_rate * std::cos(angle) - course.rate * course.rate) /
                course.distance;
  return course;
}

/// A ball on an arm about the origin, and one that stands kFar away on the x axis.
struct Circling {
  Capsule64 stands;
  Capsule64 turns;

  Circling(double angle, double turn_rate) {
    const Vec3<double> arm = kArm * Vec3<double>(std::cos(angle), std::sin(angle), 0);
    stands = {{kFar, 0, 0}, kO, kO, kRadii / 2};
    turns = {kO, arm, arm, kRadii / 2};
    turns.w = {0, 0, turn_rate};
  }

  MovingPair<double> pair(bool A_turns, double duration) const {
    const auto made = make_moving_pair(moving<double>(A_turns ? turns : stands, duration),
                                       moving<double>(A_turns ? stands : turns, duration));
    EXPECT_TRUE(made.ok());
    return made.value;
  }
};

constexpr double kU = kRoundOff<double>;

TEST(WalkForesees, BallOnACircle_MeetsWhereTheParabolaDoes) {
  for (const double angle : {-1.0, -0.9}) {
    const double turn = 0.5;
    const Course course = on_circle(angle, turn);
    const double truth = course.contact(kRadii);
    ASSERT_GT(truth, 0.02);
    ASSERT_LT(truth, 1);
    for (const bool A_turns : {false, true}) {
      const MovingPair<double> pair = Circling(angle, turn).pair(A_turns, 1);
      const AdvancementSearch<double> advancement(pair, kContactTolerance,
                                                  detail::kInflation<double>);
      // a gap of 0.05 m and more, from lengths of less than 16 m
      EXPECT_NEAR(advancement.foreseen_contact(advancement.closest()), truth, 64 * kU * (16 / 0.05))
          << angle << A_turns;
    }
  }
}

/// In seconds and metres, though the advancement has units of its own.
TEST(WalkForesees, BallOnACircle_PartsAsFastAsItDoes) {
  const double angle = -1;
  const double turn = 0.7;
  const double duration = 0.25;
  const double scale = 4;
  for (const bool A_turns : {false, true}) {
    const MovingPair<double> pair = Circling(angle, turn).pair(A_turns, duration);
    const MovingPair<double> unit = in_units(pair, scale);
    const AdvancementSearch<double> advancement(unit, kContactTolerance * scale,
                                                detail::kInflation<double>);
    EXPECT_NEAR(advancement.rate(advancement.closest(), pair, scale), on_circle(angle, turn).rate,
                64 * kU * 16)
        << A_turns;
  }
}

/// With a contact tolerance so wide that the parabola shows: a ball passes another at a distance of
/// 1 m.
TEST(TranslationForesees, BallThatPasses_MeetsWhereTheParabolaDoes) {
  const double speed = 3;
  const double duration = 2;
  const Capsule64 stands{kO, kO, kO, 0.75};
  Capsule64 passes{{-4, 1, 0}, kO, kO, 0.75};
  passes.v = {speed, 0, 0};
  const auto asked = ask(moving<double>(stands, duration), moving<double>(passes, duration), 0.4);
  const auto found = search_translation(asked.pair, asked.options);
  ASSERT_EQ(found.outcome, Outcome::kContact);
  ASSERT_GT(found.witness.gap, 0.1);
  Course course;
  course.distance = 1.5 + found.witness.gap;
  const double before = std::sqrt(course.distance * course.distance - 1);  // the foot of the pass
  course.rate = -speed * before / course.distance;
  course.bend = (speed * speed - course.rate * course.rate) / course.distance;
  const double seen = (4 - before) / speed;
  EXPECT_NEAR(found.t_hit, seen + course.contact(1.5), 1024 * kU);
}

}  // namespace
}  // namespace batuta
