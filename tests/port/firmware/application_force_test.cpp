// SPDX-License-Identifier: MIT
// What the motor is told: when blades meet, when samples stop, when the host stops.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "device_rig.hpp"
#include "heap_trap.hpp"

namespace batuta::test {
using namespace fencing;
namespace {

using link::Mode;

/// A device whose left stick leads the blade into the other one.
class SweepingStick : public ::testing::Test {
 protected:
  DeviceRig rig;
  PlainHost host{rig.cable};
  std::uint32_t step = 0;

  static InputSample sweep(std::uint32_t step) {
    InputSample sample;
    sample.time = step * 1000;
    sample.sequence = step;
    sample.y = 0.5F * std::fmin(static_cast<float>(step) / 150.0F, 1.0F);
    return sample;
  }
  bool is_forced() const { return rig.motor.last.x != 0 || rig.motor.last.y != 0; }

  /// One step of a paced session, with a sample of the left stick.
  void order() {
    link::Step message;
    message.step = ++step;
    message.has_left = true;
    message.left = sweep(step);
    host.send(message);
    rig.run(1);
    ASSERT_EQ(rig.device->bout().steps(), step);
  }
  /// One step with a sample of the right stick alone, which sweeps to and fro.
  void order_of_the_right(int i) {
    link::Step message;
    message.step = ++step;
    message.has_right = true;
    message.right.time = step * 1000;
    message.right.sequence = step;
    message.right.x = 0.5F + 0.5F * std::sin(0.05F * static_cast<float>(i));
    host.send(message);
    rig.run(1);
    ASSERT_EQ(rig.device->bout().steps(), step);
  }
  void order_until_forced() {
    host.send(link::Hello{1, Mode::kPaced});
    rig.run(1);
    while (!is_forced() && step < 300) order();
    ASSERT_TRUE(is_forced());
  }
};

TEST_F(SweepingStick, ABlow_ReachesTheMotor_AsItIsTold) {
  rig.start();
  order_until_forced();
  const auto forces = host.received<link::Force>();
  ASSERT_FALSE(forces.empty());
  const link::Force& told = forces[forces.size() - 2];  // left, then right
  ASSERT_EQ(told.side, link::LinkSide::kLeft);
  EXPECT_EQ(rig.motor.last.x, told.x);
  EXPECT_EQ(rig.motor.last.y, told.y);
  EXPECT_LT(told.y, 0) << "the stick went up";
}

TEST_F(SweepingStick,
       WhenTheHostStops_TheForceEndsWithItsTick_AndTheSilenceIsCountedAfterTheLimit) {
  rig.settings.bout.force.ramp = {30, 20};
  rig.start();
  order_until_forced();
  for (int i = 0; i < 30; ++i) {
    rig.run(1);
    ASSERT_FALSE(is_forced()) << i;
  }
  EXPECT_EQ(rig.device->silences(), 0U);
  rig.run(1);
  EXPECT_EQ(rig.device->silences(), 1U);
  for (int i = 0; i < 1000; ++i) {
    rig.run(1);
    ASSERT_FALSE(is_forced()) << i;
  }
  EXPECT_EQ(rig.device->silences(), 1U);
}

TEST_F(SweepingStick, AnOrderOnceMore_IsNoSecondBlow) {
  rig.start();
  order_until_forced();
  --step;
  order();
  EXPECT_FALSE(is_forced());
}

/// However slow the host is, the motor gets each step's force for one tick.
TEST_F(SweepingStick, TheImpulse_DoesNotDependOnTheHostsPace) {
  std::array<double, 2> impulse{};
  for (const int idle : {0, 7}) {
    SCOPED_TRACE(idle);
    rig.start();
    step = 0;
    host.send(link::Hello{static_cast<std::uint32_t>(idle) + 1, Mode::kPaced});
    rig.run(1);
    while (step < 200) {
      order();
      for (int i = 0; i <= idle; ++i) {
        impulse[idle == 0 ? 0 : 1] += std::fabs(rig.motor.last.y);
        if (i < idle) rig.run(1);
      }
    }
  }
  EXPECT_GT(impulse[0], 0);
  EXPECT_EQ(impulse[0], impulse[1]);
}

TEST_F(SweepingStick, WhenTheHostComesBack_TheForceComesBackSlowly_AndTheSilenceIsTold) {
  rig.settings.bout.force.ramp = {10, 50};
  rig.start();
  order_until_forced();
  rig.run(200);
  host.received<link::StepReport>();
  order();
  const auto reports = host.received<link::StepReport>();
  ASSERT_EQ(reports.size(), 1U);
  EXPECT_EQ(reports[0].silences, 1U);
  int back = 1;  // steps since the silence
  for (; !is_forced() && back < 49; ++back) order();
  ASSERT_TRUE(is_forced()) << "else nothing was seen";
  const Vec2<float> demanded = rig.device->bout().forces().of(Side::kLeft).demanded;
  const float whole = demanded.y() * rig.settings.bout.force.gain().y();
  EXPECT_EQ(rig.motor.last.y, static_cast<float>(back) / 50.0F * whole);
}

TEST_F(SweepingStick, WhenTheOwnStickStops_ItsForceFades_ThoughStepsGoOn) {
  rig.settings.bout.force.ramp = {25, 10};
  for (std::uint32_t i = 0; i < 40; ++i) rig.stick.samples.push_back(sweep(i));
  rig.start();
  rig.run(40);
  host.received<link::Force>();
  std::vector<bool> ramped;
  std::vector<bool> stale;
  rig.run(60);
  for (const auto& force : host.received<link::Force>()) {
    if (force.side != link::LinkSide::kLeft) continue;
    ramped.push_back(force.ramped);
    stale.push_back(force.stale);
  }
  ASSERT_EQ(stale.size(), 60U);
  EXPECT_EQ(std::find(stale.begin(), stale.end(), true) - stale.begin(), 25);
  EXPECT_EQ(std::find(ramped.begin(), ramped.end(), true) - ramped.begin(), 25);
  EXPECT_EQ(rig.device->silences(), 1U);
  EXPECT_EQ(rig.device->bout().steps(), 100U);
}

/// A beat, and the stick's cable comes out in the middle of it; the opponent goes on beating.
TEST_F(SweepingStick, UnpluggedMidBeat_TheMotorsForceGoesSmoothly_TheDuelGoesOn_AndItIsCounted) {
  rig.settings.bout.force.full_scale = 0.01F;  // any blow takes all that there is
  rig.settings.bout.force.ramp = {10, 1000};
  rig.start();
  order_until_forced();
  while (step < 1100) order();  // until the whole force is there
  int blows_while_fading = 0;
  int blows_after = 0;
  for (int i = 1; i <= 2000; ++i) {
    order_of_the_right(i);
    const float left = std::fmax(0.0F, static_cast<float>(1010 - i) / 1000);
    ASSERT_LE(std::fabs(rig.motor.last.y), left) << i;
    ASSERT_LE(std::fabs(rig.motor.last.y), left) << i;
    const bool blow = rig.device->bout().forces().of(Side::kLeft).demanded.norm() > 0;
    ASSERT_TRUE(i <= 10 || i >= 1010 || is_forced() == blow) << i;
    if (i > 10 && is_forced()) ++blows_while_fading;
    if (i > 1010 && blow) ++blows_after;
  }
  EXPECT_GT(blows_while_fading, 3);
  EXPECT_GT(blows_after, 3);
  EXPECT_EQ(rig.device->silences(), 1U);
  EXPECT_EQ(rig.device->stage().report().sample_silences, 1U);
}

TEST_F(SweepingStick, EmergencyStop_IsZeroAtOnce_NoSessionEndsIt_AndTheDuelGoesOn) {
  rig.start();
  order_until_forced();
  rig.device->stop_force(rig.clock.time);
  EXPECT_FALSE(is_forced()) << "at once";
  const std::uint32_t failures = rig.device->report().force_failures;
  host.send(link::Hello{2, Mode::kPaced});
  rig.run(1);
  step = 0;
  while (step < 200) {
    order();
    ASSERT_FALSE(is_forced());
  }
  EXPECT_EQ(rig.device->report().force_failures, failures + 201);
  ASSERT_EQ(rig.device->release_force(), Status::kOk);
  while (!is_forced() && step < 300) order();
  EXPECT_TRUE(is_forced());
}

TEST_F(SweepingStick, AMotorThatIsGone_IsCounted_AndTheDuelGoesOn) {
  rig.start();
  order_until_forced();
  rig.motor.broken = true;
  for (int i = 0; i < 5; ++i) order();
  EXPECT_EQ(rig.device->report().force_failures, 5U);
}

TEST_F(SweepingStick, ANewSession_StartsWithoutForce_AndRemembersTheSilences) {
  rig.settings.bout.force.ramp = {10, 5};
  rig.start();
  order_until_forced();
  rig.run(50);
  host.send(link::Hello{2, Mode::kPaced});
  rig.run(1);
  EXPECT_FALSE(is_forced());
  EXPECT_EQ(rig.device->silences(), 1U);
}

TEST_F(SweepingStick, NoTickAllocates) {
  rig.stick.samples.resize(300);
  for (std::uint32_t i = 0; i < 300; ++i) rig.stick.samples[i] = sweep(i);
  rig.cable.to_host.cut(true);  // the cable is the test's, and may allocate
  rig.start();
  HeapTrap trap;
  for (std::uint32_t i = 1; i <= 300; ++i) {
    rig.clock.time += 1000;
    rig.device->tick(i);
  }
  EXPECT_EQ(trap.allocations(), 0);
  EXPECT_EQ(rig.device->bout().steps(), 300U);
}

}  // namespace
}  // namespace batuta::test
