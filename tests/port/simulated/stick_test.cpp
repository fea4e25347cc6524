// SPDX-License-Identifier: MIT
#include "shared/simulated/stick.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "plain_force.hpp"

namespace batuta::port_simulated {
namespace {

std::unique_ptr<SimulatedStick> stick_with(const StickSettings& settings) {
  auto stick = std::make_unique<SimulatedStick>();
  EXPECT_EQ(stick->configure(settings), Status::kOk);
  return stick;
}

const Vec2<double> kStill(0, 0);

TEST(SimulatedStick, Command_IsHeldAfterTheDelay) {
  for (const int delay : {0, 1, 3, kMostDelay}) {
    StickSettings settings;
    settings.delay = delay;
    settings.force_limit = 4;
    const auto stick = stick_with(settings);
    test::PlainForce force(stick->force());
    ASSERT_EQ(force.write({0, 0.5F, -0.25F}), Status::kOk);
    for (int i = 0; i < delay; ++i) {
      stick->advance(kStill);
      EXPECT_EQ(stick->held(), kStill) << delay;
      ASSERT_EQ(force.write({0, 0.5F, -0.25F}), Status::kOk);
    }
    stick->advance(kStill);
    EXPECT_EQ(stick->held(), Vec2<double>(2, -1)) << delay;
  }
}

TEST(SimulatedStick, Silence_EndsTheForce) {
  StickSettings settings;
  settings.silence = 5000;
  const auto stick = stick_with(settings);
  test::PlainForce force(stick->force());
  ASSERT_EQ(force.write({0, 0.5F, 0}), Status::kOk);
  int held = 0;
  for (int i = 0; i < 20; ++i) {
    stick->advance(kStill);
    held += stick->held() != kStill ? 1 : 0;
  }
  EXPECT_EQ(held, 5);
}

TEST(SimulatedStick, Unplugged_NeitherMovesByForceNorTells) {
  const auto stick = stick_with({});
  test::PlainForce force(stick->force());
  ASSERT_EQ(force.write({0, 0.5F, 0}), Status::kOk);
  stick->plug(false);
  EXPECT_EQ(force.write({0, 0.5F, 0}), Status::kUnavailable);
  stick->advance(kStill);
  EXPECT_EQ(stick->held(), kStill);
  InputSample sample;
  EXPECT_EQ(stick->input().read(stick->now(), sample), Status::kUnavailable);
  stick->plug(true);
  stick->advance(kStill);
  EXPECT_EQ(stick->held(), kStill);  // what was commanded before is forgotten
  EXPECT_EQ(stick->input().read(stick->now(), sample), Status::kOk);
}

TEST(SimulatedStick, Sample_IsOnTheEncodersSteps) {
  StickSettings settings;
  settings.encoder_step = 0.125;
  settings.x.hand_stiffness = 10;
  const auto stick = stick_with(settings);
  int away = 0;
  for (int i = 0; i < 1000; ++i) {
    stick->advance({0.9, 0});
    InputSample sample;
    ASSERT_EQ(stick->input().read(stick->now(), sample), Status::kOk);
    EXPECT_EQ(sample.x * 8, std::floor(sample.x * 8));
    EXPECT_NEAR(static_cast<double>(sample.x), clamp(stick->x().position(), -1.0, 1.0), 0.0626);
    away += sample.x > 0.5F ? 1 : 0;
  }
  EXPECT_GT(away, 100);
}

TEST(SimulatedStick, OutOfRange_IsRefused) {
  SimulatedStick stick;
  StickSettings settings;
  settings.y.period = 2e-3;
  EXPECT_EQ(stick.configure(settings), Status::kInvalidArgument);
  settings = {};
  settings.x.period = settings.y.period = 0.5e-6;
  EXPECT_EQ(stick.configure(settings), Status::kInvalidArgument);
  for (const int delay : {-1, kMostDelay + 1}) {
    settings = {};
    settings.delay = delay;
    EXPECT_EQ(stick.configure(settings), Status::kInvalidArgument);
  }
  settings = {};
  settings.force_limit = 0;
  EXPECT_EQ(stick.configure(settings), Status::kInvalidArgument);
  settings = {};
  settings.encoder_step = -1;
  EXPECT_EQ(stick.configure(settings), Status::kInvalidArgument);
  settings = {};
  settings.silence = 0;
  EXPECT_EQ(stick.configure(settings), Status::kInvalidArgument);
}

}  // namespace
}  // namespace batuta::port_simulated
