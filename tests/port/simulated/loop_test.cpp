// SPDX-License-Identifier: MIT
// The whole way at 1 kHz, as a program with a real stick would go it: sample, spring, output stage,
// actuator. What the gain advisor allows calms down; what it does not, shakes.
#include <gtest/gtest.h>

#include <memory>

#include "batuta/haptics/gain_advisor.hpp"
#include "batuta/haptics/output_stage.hpp"
#include "shared/simulated/stick.hpp"

namespace batuta {
using namespace haptics;
namespace {

constexpr float kForceLimit = 40;  // N m per unit of the stick
constexpr double kHandStiffness = 20;

DeviceProfile<float> profile(int delay) {
  DeviceProfile<float> device;
  device.period = 1e-3F;
  device.delay = delay;
  device.damping = 0.2F;
  device.force_limit = kForceLimit;
  device.travel = 1;
  return device;
}

class Loop {
 public:
  Loop(float stiffness, int delay) : stage_(stick_.force()), stiffness_(stiffness) {
    port_simulated::StickSettings settings;
    settings.x.damping = 0.2;
    settings.x.hand_stiffness = kHandStiffness;
    settings.y = settings.x;
    settings.force_limit = static_cast<double>(kForceLimit);
    settings.delay = delay;
    EXPECT_EQ(stick_.configure(settings), Status::kOk);
    StageSettings stage;
    stage.gain = {1 / kForceLimit, 1 / kForceLimit};
    EXPECT_EQ(stage_.configure(stage), Status::kOk);
    EXPECT_EQ(stage_.enable(), Status::kOk);
  }

  /// A period, with the hand wanting the stick at (x, 0).
  void step(double x) {
    stick_.advance({x, 0});
    InputSample sample;
    StageInput input;
    input.time = stick_.now();
    input.fresh_sample = stick_.input().read(stick_.now(), sample) == Status::kOk;
    input.fresh_command = true;
    if (input.fresh_sample) seen_ = {sample.x, sample.y};
    input.position = seen_;
    input.demanded = -stiffness_ * seen_;
    (void)stage_.step(input);
  }

  port_simulated::SimulatedStick& stick() { return stick_; }

 private:
  port_simulated::SimulatedStick stick_;
  OutputStage stage_;
  float stiffness_;
  Vec2<float> seen_ = Vec2<float>::Zero();
};

/// How far the stick still swings, five seconds after the hand let go of it.
double swing(float share, int delay) {
  constexpr int kDrawn = 600;  // the stage fades in meanwhile
  constexpr int kLooked = 5600;
  constexpr int kEnd = 5800;
  Loop loop(share * largest_stiffness(profile(delay), 0.0F).value.largest, delay);
  double most = 0;
  for (int i = 0; i < kEnd; ++i) {
    loop.step(i < kDrawn ? 0.5 : 0.0);
    if (i >= kLooked) most = std::max(most, std::abs(loop.stick().x().position()));
    EXPECT_EQ(loop.stick().y().position(), 0);
  }
  return most;
}

TEST(SimulatedLoop, WithinTheAdvice_CalmsDown) {
  for (const int delay : {0, 1, 2}) EXPECT_LT(swing(0.5F, delay), 0.01) << delay;
}

TEST(SimulatedLoop, BeyondTheAdvice_ShakesAsFarAsTheActuatorGoes) {
  for (const int delay : {0, 1, 2}) EXPECT_GT(swing(1.5F, delay), 0.05) << delay;
}

TEST(SimulatedLoop, Unplugged_NoForceIsHeldAndItComesBackByAndBy) {
  Loop loop(200, 0);
  for (int i = 0; i < 6000; ++i) loop.step(0.5);
  const double held = loop.stick().held().x();
  EXPECT_LT(held, -1);
  loop.stick().plug(false);
  for (int i = 0; i < 100; ++i) {
    loop.step(0.5);
    EXPECT_EQ(loop.stick().held().x(), 0);
  }
  loop.stick().plug(true);
  double before = 0;
  for (int i = 0; i < 50; ++i) {
    loop.step(0.5);
    EXPECT_LT(std::abs(loop.stick().held().x() - before), 1);  // no jump
    before = loop.stick().held().x();
  }
  for (int i = 0; i < 6000; ++i) loop.step(0.5);
  EXPECT_NEAR(loop.stick().held().x(), held, 0.1);
}

}  // namespace
}  // namespace batuta
