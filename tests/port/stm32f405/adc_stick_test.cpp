// SPDX-License-Identifier: MIT
// From conversions to samples: ranges, times, counts, and what happens when the stick goes.

#include "platforms/stm32f405/drivers/adc_stick.hpp"

#include <gtest/gtest.h>

#include "adc_rig.hpp"

namespace batuta::stm32f405 {
namespace {

class AdcStickTest : public ::testing::Test {
 protected:
  Status read() { return rig_.stick.read(rig_.now, sample_); }

  test::AdcRig rig_;
  InputSample sample_;
};

TEST_F(AdcStickTest, Started_PacesSixteenConversionsOfEachAxisInAMillisecond) {
  rig_.stick.start(10, 11, 84000000);
  EXPECT_EQ(84000000.0 / (rig_.pace.arr + 1), 16000.0);
  EXPECT_EQ(rig_.dma.stream[0].ndtr, 64U);
  EXPECT_EQ(rig_.adc.sqr1 >> 20, 1U);  // two conversions a turn
  EXPECT_EQ(rig_.adc.sqr3, 10U | (11U << 5));
  EXPECT_EQ(rig_.adc.smpr1, 0x24U);  // 84 cycles each for channels 10 and 11
  EXPECT_NE(rig_.dma.stream[0].cr & DmaStream::kCrEn, 0U);
  EXPECT_NE(rig_.dma.stream[0].cr & DmaStream::kCrCirc, 0U);
  // Both conversions of a turn at 21 MHz fit the pace with room to spare.
  EXPECT_LT(2.0 * Adc::kConversionCycles / 21e6, 0.5 / 16000);
}

TEST_F(AdcStickTest, NothingConverted_IsNoStick) {
  EXPECT_EQ(read(), Status::kUnavailable);
  EXPECT_FALSE(rig_.stick.is_connected());
}

TEST_F(AdcStickTest, Deflection_IsThatOfTheCounts) {
  rig_.connect();
  rig_.convert(4031, 64);
  ASSERT_EQ(read(), Status::kOk);
  EXPECT_EQ(sample_.x, 1.0F);
  EXPECT_EQ(sample_.y, -1.0F);
  rig_.convert(2047, 2060);
  ASSERT_EQ(read(), Status::kOk);
  EXPECT_EQ(sample_.x, 0.0F);  // in the dead zone
  EXPECT_EQ(sample_.y, 0.0F);
  rig_.convert(3039, 1055);
  ASSERT_EQ(read(), Status::kOk);
  EXPECT_EQ(sample_.x, deflection(test::AdcRig::kAxis, 16 * 3039));
  EXPECT_EQ(sample_.y, deflection(test::AdcRig::kAxis, 16 * 1055));
  EXPECT_NEAR(sample_.x, 0.5F, 0.01F);
}

TEST_F(AdcStickTest, Time_IsTheMiddleOfTheWindow) {
  rig_.connect();
  rig_.convert(2048, 2048);
  ASSERT_EQ(read(), Status::kOk);
  EXPECT_EQ(elapsed_us(sample_.time, rig_.now), kWindowUs / 2);
}

TEST_F(AdcStickTest, EarlierNow_DoesNotGetASampleFromTheFuture) {
  rig_.connect();
  InputSample sample;
  EXPECT_EQ(rig_.stick.read(rig_.now - kWindowUs, sample), Status::kUnavailable);
  EXPECT_EQ(rig_.stick.read(rig_.now, sample), Status::kOk);
}

TEST_F(AdcStickTest, UnreadSamples_LeaveAGapInTheSequence) {
  rig_.connect();
  rig_.convert(1000, 1000);
  ASSERT_EQ(read(), Status::kOk);
  const std::uint32_t first = sample_.sequence;
  for (int i = 0; i < 7; ++i) rig_.convert(1000, 1000);
  ASSERT_EQ(read(), Status::kOk);
  EXPECT_EQ(sample_.sequence, first + 7);
  EXPECT_EQ(read(), Status::kUnavailable);
}

TEST_F(AdcStickTest, WireOff_TheDeviceIsGoneAtOnceAndBackWhenItIsSure) {
  rig_.connect();
  rig_.convert(0, 2048);
  EXPECT_FALSE(rig_.stick.is_connected());
  EXPECT_EQ(read(), Status::kUnavailable);
  for (int i = 1; i < Connection::kReturnAfter; ++i) {
    rig_.convert(2048, 2048);
    ASSERT_EQ(read(), Status::kUnavailable);
  }
  rig_.convert(2048, 2048);
  EXPECT_EQ(read(), Status::kOk);
}

TEST_F(AdcStickTest, LateInterrupt_ThrowsTheReadingAway) {
  rig_.connect();
  ASSERT_EQ(read(), Status::kOk);
  rig_.dma.lisr = Dma::kStream0Htif | Dma::kStream0Tcif;
  rig_.stick.on_dma(rig_.now += 2000);
  EXPECT_EQ(rig_.stick.faults(), 1U);
  EXPECT_EQ(read(), Status::kUnavailable);
}

TEST_F(AdcStickTest, ErrorOfDmaOrAdc_StartsTheTurnAnew) {
  rig_.stick.start(10, 11, 84000000);
  rig_.dma.stream[0].cr = 0;
  rig_.dma.stream[0].ndtr = 5;
  rig_.pace.cnt = 5249;  // a trigger is due
  rig_.dma.lisr = Dma::kStream0Teif;
  rig_.stick.on_dma(rig_.now);
  EXPECT_EQ(rig_.stick.faults(), 1U);
  EXPECT_EQ(rig_.pace.cnt, 0U);  // a whole turn for the ADC to settle
  EXPECT_EQ(rig_.dma.stream[0].ndtr, 64U);
  EXPECT_NE(rig_.dma.stream[0].cr & DmaStream::kCrEn, 0U);
  rig_.stick.on_overrun();
  EXPECT_EQ(rig_.stick.faults(), 2U);
  EXPECT_EQ(rig_.adc.sr & Adc::kSrOvr, 0U);
}

TEST_F(AdcStickTest, BadCalibration_IsRefused) {
  EXPECT_EQ(rig_.stick.calibrate({AxisKind::kAbsolute, false, 5, 5, 0}, test::AdcRig::kAxis),
            Status::kInvalidArgument);
}

}  // namespace
}  // namespace batuta::stm32f405
