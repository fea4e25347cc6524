// SPDX-License-Identifier: MIT
#include "batuta/control/stick.hpp"

#include <gtest/gtest.h>

#include <random>

namespace batuta {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

InputSample sample(Microseconds time, float x, float y, std::uint32_t sequence) {
  InputSample s;
  s.time = time;
  s.x = x;
  s.y = y;
  s.sequence = sequence;
  return s;
}

template <class S>
class StickOf : public ::testing::Test {
 protected:
  StickTracker<S> stick;
  void SetUp() override { ASSERT_EQ(stick.configure(StickSettings{}), Status::kOk); }
  void run(int steps, double dt = 1e-3) {
    for (int i = 0; i < steps; ++i) stick.advance(static_cast<S>(dt));
  }
  double x() const { return static_cast<double>(stick.position().x()); }
  double vx() const { return static_cast<double>(stick.velocity().x()); }
};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(StickOf, Scalars);

TYPED_TEST(StickOf, NoSample_RestsAtTheCentreAndIsStale) {
  this->run(10);
  EXPECT_EQ(this->x(), 0.0);
  EXPECT_EQ(this->vx(), 0.0);
  EXPECT_TRUE(this->stick.is_stale());
  EXPECT_EQ(this->stick.report().stale_steps, 10U);
}

// A ramp of 3 / s, sampled each 10 ms, stepped each 1 ms: velocity without spikes, position one
// sample late.
TYPED_TEST(StickOf, RampAtTenSteps_VelocityIsTheRamps) {
  (void)this->stick.accept(sample(0, -0.9F, 0, 1));
  this->run(200);
  for (unsigned k = 1; k <= 60; ++k) {
    const double ramp = -0.9 + 3.0 * 0.01 * k;
    const auto use =
        this->stick.accept(sample(1000000U + k * 10000U, static_cast<float>(ramp), 0, 1 + k));
    EXPECT_EQ(use, SampleUse::kUsed);
    for (int i = 1; i <= 10; ++i) {
      this->run(1);
      if (k < 3) continue;  // the first interval was a silence
      EXPECT_NEAR(this->vx(), 3.0, 2e-3);
      EXPECT_NEAR(this->x(), ramp - 0.03 + 0.003 * i, 1e-5);
    }
  }
}

TYPED_TEST(StickOf, RepeatedStamp_CorrectsTheGoalOnly) {
  (void)this->stick.accept(sample(1000, 0, 0, 1));
  this->run(50);
  (void)this->stick.accept(sample(11000, 0.05F, 0, 2));
  EXPECT_EQ(this->stick.accept(sample(11000, 0.1F, 0, 3)), SampleUse::kRepeated);
  this->run(5);
  EXPECT_NEAR(this->x(), 0.05, 1e-6);
  this->run(5);
  EXPECT_NEAR(this->x(), 0.1, 1e-6);
  EXPECT_EQ(this->stick.report().repeated, 1U);
  EXPECT_EQ(this->stick.report().used, 2U);
}

TYPED_TEST(StickOf, BackwardStamp_IsRefused) {
  (void)this->stick.accept(sample(1000, 0, 0, 1));
  (void)this->stick.accept(sample(11000, 0.1F, 0, 2));
  EXPECT_EQ(this->stick.accept(sample(9000, -0.9F, 0, 3)), SampleUse::kBackward);
  this->run(100);
  EXPECT_NEAR(this->x(), 0.1, 1e-6);
  EXPECT_EQ(this->stick.report().backward, 1U);
}

TYPED_TEST(StickOf, ClockSetBackAfterSilence_IsBelievedAgain) {
  (void)this->stick.accept(sample(5000000, 0, 0, 1));
  this->run(300);
  ASSERT_TRUE(this->stick.is_stale());
  EXPECT_EQ(this->stick.accept(sample(5000000, 0, 0, 1)), SampleUse::kRepeated);
  EXPECT_TRUE(this->stick.is_stale());  // an old sample again is no sign of life
  EXPECT_EQ(this->stick.accept(sample(100, 0.3F, 0, 2)), SampleUse::kRestart);
  EXPECT_FALSE(this->stick.is_stale());
  EXPECT_EQ(this->stick.accept(sample(10100, 0.3F, 0, 3)), SampleUse::kUsed);
}

TYPED_TEST(StickOf, StampsAcrossTheWrap_AreInOrder) {
  (void)this->stick.accept(sample(0xFFFFFFFFU - 4999U, 0, 0, 1));
  this->run(50);
  EXPECT_EQ(this->stick.accept(sample(5000, 0.1F, 0, 2)), SampleUse::kUsed);
  this->run(5);
  EXPECT_NEAR(this->x(), 0.05, 1e-5);
}

TYPED_TEST(StickOf, GapInTheSequence_IsCountedAcrossItsWrap) {
  (void)this->stick.accept(sample(0, 0, 0, 0xFFFFFFFEU));
  (void)this->stick.accept(sample(1000, 0, 0, 2));  // ...FF, 0, 1 are missing
  EXPECT_EQ(this->stick.report().lost, 3U);
  (void)this->stick.accept(sample(2000, 0, 0, 1));  // numbering began anew
  (void)this->stick.accept(sample(3000, 0, 0, 1));
  EXPECT_EQ(this->stick.report().lost, 3U);
}

TYPED_TEST(StickOf, RefusedOrRepeatedSamples_AreNotLost) {
  (void)this->stick.accept(sample(1000, 0, 0, 1));
  InputSample again = sample(1000, 0.1F, 0, 2);
  again.buttons = 3;
  EXPECT_EQ(this->stick.accept(again), SampleUse::kRepeated);
  EXPECT_EQ(this->stick.buttons(), 3U);
  EXPECT_EQ(this->stick.accept(sample(2000, 0, 0, 3)), SampleUse::kUsed);
  InputSample late = sample(1500, 0, 0, 4);
  late.buttons = 7;
  EXPECT_EQ(this->stick.accept(late), SampleUse::kBackward);
  EXPECT_EQ(this->stick.buttons(), 0U);
  EXPECT_EQ(this->stick.accept(sample(3000, kNan, 0, 5)), SampleUse::kInvalid);
  EXPECT_EQ(this->stick.accept(sample(4000, 0, 0, 6)), SampleUse::kUsed);
  EXPECT_EQ(this->stick.report().lost, 0U);
  EXPECT_EQ(this->stick.accept(sample(4000, 0, 0, 9)), SampleUse::kRepeated);  // 7 and 8
  EXPECT_EQ(this->stick.accept(sample(3500, 0, 0, 8)), SampleUse::kBackward);  // overtaken
  EXPECT_EQ(this->stick.accept(sample(5000, 0, 0, 10)), SampleUse::kUsed);
  EXPECT_EQ(this->stick.report().lost, 2U);
}

TYPED_TEST(StickOf, SameStampWhileStale_DoesNotMoveTheStick) {
  (void)this->stick.accept(sample(1000, 0, 0, 1));
  this->run(300);
  ASSERT_TRUE(this->stick.is_stale());
  InputSample again = sample(1000, 1, 1, 2);
  again.buttons = 1;
  EXPECT_EQ(this->stick.accept(again), SampleUse::kRepeated);
  EXPECT_EQ(this->stick.buttons(), 0U);
  for (int i = 0; i < 100; ++i) {
    this->run(1);
    ASSERT_TRUE(this->stick.is_stale());
    ASSERT_EQ(this->vx(), 0.0);
    ASSERT_EQ(this->x(), 0.0);
  }
}

TYPED_TEST(StickOf, GoalCorrectedLate_IsGivenUpWithTheSilence) {
  (void)this->stick.accept(sample(1000, 0, 0, 1));
  this->run(245);
  (void)this->stick.accept(sample(1000, 1, 0, 2));
  for (int i = 0; i < 20; ++i) {
    this->run(1);
    if (this->stick.is_stale()) {
      ASSERT_EQ(this->vx(), 0.0);
    }
  }
  EXPECT_TRUE(this->stick.is_stale());
  EXPECT_LT(this->x(), 0.1);
}

TYPED_TEST(StickOf, NotFinite_IsRefused) {
  EXPECT_EQ(this->stick.accept(sample(0, kNan, 0, 1)), SampleUse::kInvalid);
  EXPECT_EQ(this->stick.accept(sample(0, 0, 1 / 0.0F, 2)), SampleUse::kInvalid);
  this->run(10);
  EXPECT_EQ(this->x(), 0.0);
  EXPECT_EQ(this->stick.report().invalid, 2U);
  EXPECT_TRUE(this->stick.is_stale());
}

TYPED_TEST(StickOf, BeyondTheRim_IsClampedAndCounted) {
  (void)this->stick.accept(sample(0, 7, -1.5F, 1));
  this->run(500);
  EXPECT_EQ(this->x(), 1.0);
  EXPECT_EQ(this->stick.position().y(), TypeParam(-1));
  EXPECT_EQ(this->stick.report().clamped, 1U);
}

// A new goal every 10 ms: at 3/s it is as fast as its samples, at 100/s it may not.
TYPED_TEST(StickOf, FasterThanItMay_IsCountedForThatSampleOnly) {
  std::uint32_t number = 0;
  const auto go_to = [this, &number](float x) {
    ++number;
    (void)this->stick.accept(sample(number * 10000U, x, 0, number));
    this->run(10);
    return this->stick.report().slowed;
  };
  float x = 0;
  const std::uint32_t first = go_to(x);
  for (int i = 0; i < 20; ++i) EXPECT_EQ(go_to(x += 0.03F), first) << i;
  EXPECT_EQ(go_to(x -= 1), first + 1);
}

// Whatever the stamps and positions are, the stick stays in its square and below its speed.
TYPED_TEST(StickOf, AnyStream_StaysInTheSquareAndBelowTheSpeed) {
  std::mt19937 random(7);
  const auto below = [&random](unsigned n) { return static_cast<std::uint32_t>(random() % n); };
  const auto unit = [&below] { return static_cast<float>(below(4001)) / 1000.0F - 2.0F; };
  Microseconds time = 0xFFFF0000U;
  for (unsigned k = 0; k < 20000; ++k) {
    time += below(20000);
    time -= below(5) == 0 ? below(40000) : 0U;
    if (below(3) != 0) (void)this->stick.accept(sample(time, unit(), unit(), below(1000)));
    const double before = this->x();
    this->run(1);
    ASSERT_LE(std::abs(this->x()), 1.0);
    ASSERT_LE(std::abs(this->vx()), 16.0 * (1 + 1e-4));
    ASSERT_NEAR(this->x() - before, this->vx() * 1e-3, 1e-6);
  }
  EXPECT_GT(this->stick.report().slowed, 100U);
  EXPECT_GT(this->stick.report().backward, 100U);
}

TYPED_TEST(StickOf, Silence_BecomesStaleAndStill) {
  (void)this->stick.accept(sample(0, 1, 0, 1));
  this->run(249);
  EXPECT_FALSE(this->stick.is_stale());
  this->run(2);
  EXPECT_TRUE(this->stick.is_stale());
  EXPECT_EQ(this->vx(), 0.0);
  EXPECT_EQ(this->x(), 1.0);
}

TYPED_TEST(StickOf, Buttons_AreThoseOfTheLatestSample) {
  InputSample s = sample(5, 0, 0, 1);
  s.buttons = 5;
  (void)this->stick.accept(s);
  EXPECT_EQ(this->stick.buttons(), 5U);
}

// The second pair has no way to go: it is where the sample says, and zero where none comes.
TYPED_TEST(StickOf, Feet_AreThoseOfTheLatestSample_UntilItIsStale) {
  const auto feet = [this] {
    return std::pair{static_cast<double>(this->stick.feet().x()),
                     static_cast<double>(this->stick.feet().y())};
  };
  InputSample s = sample(1000, 0, 0, 1);
  s.feet_x = 0.25F;
  s.feet_y = -0.5F;
  EXPECT_EQ(this->stick.accept(s), SampleUse::kRestart);
  EXPECT_EQ(feet(), (std::pair{0.25, -0.5}));
  s.feet_y = 1;
  EXPECT_EQ(this->stick.accept(s), SampleUse::kRepeated);
  EXPECT_EQ(feet(), (std::pair{0.25, 1.0}));
  s.time = 500;
  s.feet_y = 0;
  EXPECT_EQ(this->stick.accept(s), SampleUse::kBackward);
  s.time = 2000;
  s.feet_x = kNan;
  EXPECT_EQ(this->stick.accept(s), SampleUse::kInvalid);
  EXPECT_EQ(feet(), (std::pair{0.25, 1.0}));
  s.feet_x = 7;
  s.feet_y = -7;
  EXPECT_EQ(this->stick.accept(s), SampleUse::kUsed);
  EXPECT_EQ(feet(), (std::pair{1.0, -1.0})) << "at the rim";
  this->run(300);
  EXPECT_EQ(feet(), (std::pair{0.0, 0.0})) << "a device that is gone orders nothing";
}

TYPED_TEST(StickOf, FromTheCentre_TheStickGoesAsFastAsItMay) {
  (void)this->stick.accept(sample(1000, 1, -0.5F, 1));
  this->run(100);
  EXPECT_EQ(this->x(), 1.0);
  this->stick.start_from_centre();
  EXPECT_EQ(this->x(), 0.0);
  EXPECT_EQ(this->vx(), 0.0);
  for (int i = 1; i <= 62; ++i) {
    this->run(1);
    EXPECT_NEAR(this->x(), 0.016 * i, 1e-5);
    EXPECT_NEAR(this->vx(), 16.0, 1e-2);
  }
  this->run(1);
  EXPECT_EQ(this->x(), 1.0);
  EXPECT_EQ(this->stick.position().y(), TypeParam(-0.5F));
}

TYPED_TEST(StickOf, PutToTheCentreOnItsWay_IsStill) {
  (void)this->stick.accept(sample(1000, 1, 0, 1));
  this->run(5);
  ASSERT_GT(this->vx(), 1.0);
  this->stick.start_from_centre();
  EXPECT_EQ(this->stick.position(), (Vec2<TypeParam>(0, 0)));
  EXPECT_EQ(this->stick.velocity(), (Vec2<TypeParam>(0, 0)));
}

// Whatever comes: x stays, y does not grow, and nothing is faster than it may be.
TYPED_TEST(StickOf, FollowedOnlyBack_GoesBackOrStays) {
  std::mt19937 random(11);
  const auto unit = [&random] { return static_cast<float>(random() % 4001U) / 1000.0F - 2.0F; };
  int moved = 0;
  for (unsigned k = 1; k <= 20000; ++k) {
    if (k % 7 == 0) (void)this->stick.accept(sample(1000 * k, unit(), unit(), k));
    const bool back = k / 50 % 2 == 1;
    const Vec2<TypeParam> before = this->stick.position();
    this->stick.advance(TypeParam(1e-3), back ? StickFollow::kBack : StickFollow::kAll);
    const Vec2<TypeParam> way = this->stick.position() - before;
    ASSERT_LE(way.cwiseAbs().maxCoeff(), TypeParam(0.016 * (1 + 1e-4)));
    ASSERT_LE((way / TypeParam(1e-3) - this->stick.velocity()).norm(), TypeParam(1e-3));
    if (!back) continue;
    ASSERT_EQ(way.x(), TypeParam(0));
    ASSERT_LE(way.y(), TypeParam(0));
    moved += way.y() < TypeParam(0) ? 1 : 0;
  }
  EXPECT_GT(moved, 100);
}

// A goal that was kept from it is reached afterwards, as fast as a stick may be and no faster.
TYPED_TEST(StickOf, AfterItWasFollowedOnlyBack_GoesToItsGoalNoFasterThanItMay) {
  (void)this->stick.accept(sample(1000, 1, 0.5F, 1));
  for (int i = 0; i < 100; ++i) this->stick.advance(TypeParam(1e-3), StickFollow::kBack);
  EXPECT_EQ(this->stick.position(), (Vec2<TypeParam>(0, 0)));
  for (int i = 1; i <= 62; ++i) {
    this->run(1);
    ASSERT_NEAR(this->x(), 0.016 * i, 1e-5);
    ASSERT_NEAR(static_cast<double>(this->stick.position().y()), 0.008 * i, 1e-5);
  }
  this->run(1);
  EXPECT_EQ(this->stick.position(), (Vec2<TypeParam>(1, TypeParam(0.5))));
}

// What draws back is followed at once, as fast as it may: 16 /s.
TYPED_TEST(StickOf, DrawnBack_IsFollowedBack) {
  (void)this->stick.accept(sample(1000, 0, 0, 1));
  this->run(50);
  (void)this->stick.accept(sample(11000, 0, -0.1F, 2));  // 10 ms later
  for (int i = 1; i <= 10; ++i) {
    this->stick.advance(TypeParam(1e-3), StickFollow::kBack);
    ASSERT_EQ(this->x(), 0.0);
    ASSERT_NEAR(static_cast<double>(this->stick.position().y()), std::max(-0.1, -0.016 * i), 1e-6);
  }
}

TEST(StickSettings, OutOfRange_IsRefusedAndChangesNothing) {
  StickTracker<float> stick;
  const auto refused = [&stick](auto change) {
    StickSettings settings;
    change(settings);
    return stick.configure(settings) == Status::kInvalidArgument;
  };
  (void)stick.accept(sample(0, 0.5F, 0, 1));
  EXPECT_TRUE(refused([](StickSettings& s) { s.min_interval_us = 0; }));
  EXPECT_TRUE(refused([](StickSettings& s) { s.max_interval_us = s.min_interval_us - 1; }));
  EXPECT_TRUE(refused([](StickSettings& s) { s.stale_after_us = s.max_interval_us - 1; }));
  EXPECT_TRUE(
      refused([](StickSettings& s) { s.max_speed = 7; }));  // 2 / 7 s is longer than the silence
  EXPECT_TRUE(refused([](StickSettings& s) { s.max_speed = kNan; }));
  EXPECT_EQ(stick.report().used, 1U);
  EXPECT_EQ(stick.configure(StickSettings{}), Status::kOk);
  EXPECT_EQ(stick.report().used, 0U);
  StickSettings slow;
  slow.max_speed = 8.5F;  // 2 / 8.5 s is not
  EXPECT_EQ(stick.configure(slow), Status::kOk);
}

}  // namespace
}  // namespace batuta
