// SPDX-License-Identifier: MIT
#include "batuta/port/sample_builder.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace batuta {
namespace {

constexpr std::int32_t kLowest = std::numeric_limits<std::int32_t>::min();
constexpr std::int32_t kHighest = std::numeric_limits<std::int32_t>::max();

AxisCalibration absolute(std::int32_t min, std::int32_t max, std::int32_t flat = 0) {
  return {AxisKind::kAbsolute, false, min, max, flat};
}

AxisCalibration relative(std::int32_t reach) {
  return {AxisKind::kRelative, false, -reach, reach, 0};
}

SampleBuilder builder_with(const AxisCalibration& x, const AxisCalibration& y) {
  SampleBuilder builder;
  EXPECT_EQ(builder.configure(x, y), Status::kOk);
  return builder;
}

/// The definition of a deflection, in long double.
long double truth(const AxisCalibration& axis, std::int32_t counts) {
  const long double centre = (static_cast<long double>(axis.min) + axis.max) / 2;
  const long double half = (static_cast<long double>(axis.max) - axis.min) / 2;
  const long double held = std::fmin(std::fmax(counts, axis.min), axis.max);
  const long double off = std::fabs(held - centre) - axis.flat;
  const long double share = off <= 0 ? 0 : off / (half - axis.flat);
  return (held < centre) != axis.reversed ? -share : share;
}

TEST(AxisCalibration, Valid_NeedsAnAxisAndSomethingBesideTheDeadZone) {
  EXPECT_TRUE(is_valid(absolute(-1, 1)));
  EXPECT_TRUE(is_valid(absolute(kLowest, kHighest, kHighest)));
  EXPECT_FALSE(is_valid(absolute(5, 5)));
  EXPECT_FALSE(is_valid(absolute(5, 4)));
  EXPECT_FALSE(is_valid(absolute(-10, 10, -1)));
  EXPECT_FALSE(is_valid(absolute(-10, 10, 10)));
  EXPECT_TRUE(is_valid(absolute(-10, 10, 9)));
}

TEST(Deflection, AgreesWithItsDefinition_OverTheTable) {
  const AxisCalibration table[] = {absolute(-32768, 32767),
                                   absolute(-32768, 32767, 128),
                                   absolute(0, 255, 15),
                                   absolute(0, 1),
                                   absolute(-1100, 1258),
                                   absolute(kLowest, kHighest),
                                   absolute(kLowest, kHighest, 1 << 30),
                                   absolute(kHighest - 2, kHighest),
                                   relative(400)};
  for (AxisCalibration axis : table) {
    for (const bool reversed : {false, true}) {
      axis.reversed = reversed;
      for (int i = -4; i <= 1004; ++i) {
        const long double wish =
            axis.min + (static_cast<long double>(axis.max) - axis.min) * i / 1000;
        const auto counts =
            static_cast<std::int32_t>(std::fmin(std::fmax(wish, kLowest), kHighest));
        const long double expected = truth(axis, counts);
        const float got = deflection(axis, counts);
        EXPECT_LE(std::fabs(got - expected), 2e-7L * std::fabs(expected))
            << axis.min << ' ' << counts;
        EXPECT_LE(std::fabs(got), 1.0F);
      }
    }
  }
}

TEST(Deflection, RimsAreExact_BeyondThemToo) {
  const AxisCalibration axis = absolute(-1000, 3000, 50);
  EXPECT_EQ(deflection(axis, -1000), -1.0F);
  EXPECT_EQ(deflection(axis, 3000), 1.0F);
  EXPECT_EQ(deflection(axis, kLowest), -1.0F);
  EXPECT_EQ(deflection(axis, kHighest), 1.0F);
}

TEST(Deflection, DeadZone_IsZero_AndContinuousAtItsEdge) {
  const AxisCalibration axis = absolute(-1000, 1000, 100);
  for (int counts = -100; counts <= 100; ++counts) EXPECT_EQ(deflection(axis, counts), 0.0F);
  EXPECT_NEAR(deflection(axis, 101), 1.0 / 900, 1e-9);
  EXPECT_NEAR(deflection(axis, -101), -1.0 / 900, 1e-9);
}

TEST(Deflection, IsMonotone) {
  const AxisCalibration axis = absolute(-517, 30211, 33);
  float last = -1.0F;
  for (std::int32_t counts = -600; counts < 30300; ++counts) {
    const float now = deflection(axis, counts);
    ASSERT_GE(now, last) << counts;
    last = now;
  }
}

TEST(SampleBuilder, Configure_RefusesABadAxis_AndChangesNothing) {
  SampleBuilder builder = builder_with(absolute(-10, 10), absolute(-10, 10));
  builder.axis(Axis::kX, 5);
  EXPECT_EQ(builder.configure(absolute(1, 1), absolute(-1, 1)), Status::kInvalidArgument);
  EXPECT_EQ(builder.configure(absolute(-1, 1), absolute(1, 1)), Status::kInvalidArgument);
  EXPECT_EQ(builder.sync(1).value.x, 0.5F);
}

TEST(SampleBuilder, Absolute_HoldsWhatWasNotReported) {
  SampleBuilder builder = builder_with(absolute(-10, 10), absolute(0, 20));
  builder.axis(Axis::kX, 5);
  const Result<InputSample> first = builder.sync(100);
  ASSERT_TRUE(first.ok());
  EXPECT_EQ(first.value.time, 100U);
  EXPECT_EQ(first.value.x, 0.5F);
  EXPECT_EQ(first.value.y, 0.0F) << "not reported yet: the centre";
  builder.axis(Axis::kY, 0);
  const Result<InputSample> second = builder.sync(200);
  EXPECT_EQ(second.value.x, 0.5F);
  EXPECT_EQ(second.value.y, -1.0F);
}

TEST(SampleBuilder, SecondPair_IsZeroUnlessThereIsOne) {
  SampleBuilder builder = builder_with(absolute(-10, 10), absolute(-10, 10));
  builder.axis(Axis::kFeetX, 10);
  builder.axis(Axis::kFeetY, 10);
  const Result<InputSample> alone = builder.sync(1);
  EXPECT_EQ(alone.value.feet_x, 0.0F);
  EXPECT_EQ(alone.value.feet_y, 0.0F);

  EXPECT_EQ(builder.configure_feet(absolute(1, 1), absolute(-1, 1)), Status::kInvalidArgument);
  EXPECT_EQ(builder.configure_feet(absolute(-1, 1), absolute(1, 1)), Status::kInvalidArgument);
  builder.axis(Axis::kX, 5);
  ASSERT_EQ(builder.configure_feet(absolute(0, 20), absolute(-4, 4)), Status::kOk);
  builder.axis(Axis::kFeetY, -2);
  const Result<InputSample> both = builder.sync(2);
  EXPECT_EQ(both.value.x, 0.5F) << "the first pair stays as it was";
  EXPECT_EQ(both.value.feet_x, 0.0F) << "not reported yet: the centre";
  EXPECT_EQ(both.value.feet_y, -0.5F);
  builder.axis(Axis::kFeetX, 20);
  builder.lost();
  EXPECT_FALSE(builder.sync(3).ok());
  EXPECT_EQ(builder.sync(4).value.feet_x, 0.0F) << "discarded with the rest";
  ASSERT_EQ(builder.configure(absolute(-1, 1), absolute(-1, 1)), Status::kOk);
  builder.axis(Axis::kFeetY, 4);
  EXPECT_EQ(builder.sync(5).value.feet_y, 0.0F) << "begun anew without it";
}

TEST(SampleBuilder, Sequence_CountsSamples) {
  SampleBuilder builder = builder_with(absolute(-10, 10), absolute(-10, 10));
  for (std::uint32_t i = 0; i < 5; ++i) EXPECT_EQ(builder.sync(i).value.sequence, i);
}

TEST(SampleBuilder, Relative_SumsUp_AndForgetsWhatGoesBeyondTheRim) {
  SampleBuilder builder = builder_with(relative(100), relative(100));
  builder.axis(Axis::kX, 30);
  builder.axis(Axis::kX, 20);
  EXPECT_EQ(builder.sync(0).value.x, 0.5F);
  builder.axis(Axis::kX, kHighest);
  builder.axis(Axis::kX, kHighest);
  EXPECT_EQ(builder.sync(1).value.x, 1.0F);
  builder.axis(Axis::kX, -100);
  EXPECT_EQ(builder.sync(2).value.x, 0.0F);
  builder.axis(Axis::kX, kLowest);
  EXPECT_EQ(builder.sync(3).value.x, -1.0F);
}

TEST(SampleBuilder, Relative_ReturnsToTheSameBits) {
  SampleBuilder builder = builder_with(relative(777), relative(777));
  builder.axis(Axis::kX, 123);
  const float there = builder.sync(0).value.x;
  for (int i = 0; i < 100; ++i) {
    builder.axis(Axis::kX, 7 + i);
    static_cast<void>(builder.sync(0));
    builder.axis(Axis::kX, -7 - i);
  }
  EXPECT_EQ(builder.sync(1).value.x, there);
}

TEST(SampleBuilder, Buttons_KeepTheirBits) {
  SampleBuilder builder = builder_with(relative(1), relative(1));
  EXPECT_EQ(builder.button(0, true), Status::kOk);
  EXPECT_EQ(builder.button(31, true), Status::kOk);
  EXPECT_EQ(builder.button(32, true), Status::kInvalidArgument);
  EXPECT_EQ(builder.button(-1, true), Status::kInvalidArgument);
  EXPECT_EQ(builder.sync(0).value.buttons, 0x80000001U);
  EXPECT_EQ(builder.button(0, false), Status::kOk);
  EXPECT_EQ(builder.sync(0).value.buttons, 0x80000000U);
}

TEST(SampleBuilder, Lost_DiscardsBothSidesUpToTheNextMark_AndCounts) {
  SampleBuilder builder = builder_with(relative(10), relative(10));
  builder.axis(Axis::kX, 1);
  EXPECT_EQ(builder.sync(0).value.x, 0.1F);
  builder.axis(Axis::kX, 3);
  EXPECT_EQ(builder.button(1, true), Status::kOk);
  builder.lost();
  builder.axis(Axis::kX, 3);
  EXPECT_EQ(builder.button(2, true), Status::kOk);
  EXPECT_EQ(builder.sync(1).status, Status::kUnavailable);
  EXPECT_EQ(builder.losses(), 1U);
  builder.axis(Axis::kY, 5);
  const Result<InputSample> sample = builder.sync(2);
  ASSERT_TRUE(sample.ok());
  EXPECT_EQ(sample.value.x, 0.1F);
  EXPECT_EQ(sample.value.y, 0.5F);
  EXPECT_EQ(sample.value.buttons, 0U);
  EXPECT_EQ(sample.value.sequence, 1U);
}

}  // namespace
}  // namespace batuta
