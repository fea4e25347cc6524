// SPDX-License-Identifier: MIT
// The host's side of a session against the firmware's application, over a cable in memory.
#include "programs/duel/device/device_partner.hpp"

#include <gmock/gmock.h>

#include "bouts.hpp"
#include "device_rig.hpp"

namespace batuta::host {
using namespace fencing;
namespace {

using test::Damage;
using test::DeviceRig;
using ::testing::HasSubstr;

/// A device in memory, and the host's end of its cable: time passes on the device while the host
/// waits.
struct Bench {
  DeviceRig rig;
  bool powered = true;
  DeviceLink link{{rig.cable.host, rig.clock, [this](int /*timeout_ms*/) { wait(); }},
                  {20, 30, 30}};

  Bench() { rig.start(); }
  void wait() {
    if (powered) {
      rig.run(1);
    } else {
      rig.clock.time += 1000;
    }
  }
  /// What a reset of the device leaves: a new application at the same cable.
  void reset() {
    rig.device = std::make_unique<firmware::Application>(
        firmware::Board{rig.clock, rig.cable.device, &rig.stick, &rig.motor},
        firmware::LastFault{5, {1, 2}});
    rig.start();
  }
};

/// A bout of the runner with a device. @returns whether it came to its end
bool fence(DuelRunner& runner, DevicePartner& partner, std::uint32_t most = 1000000) {
  bool going_on = true;
  while (going_on && runner.duel().steps() < most) {
    if (!partner.before_step(runner)) return false;
    going_on = runner.step();
    if (!partner.after_step(runner)) return false;
  }
  return true;
}

TEST(PacedPartner, AWholeBout_IsTheSameOnBothSides) {
  Bench bench;
  PacedPartner partner(bench.link);
  BoutRig bout("default", "script:parry");
  ASSERT_TRUE(partner.open()) << partner.problem();
  ASSERT_TRUE(fence(*bout.runner, partner)) << partner.problem();
  BoutRig plain("default", "script:parry");
  plain.run();
  EXPECT_EQ(partner.compared(), plain.runner->duel().steps());
  EXPECT_EQ(bout.runner->ending(), Ending::kWon);
  EXPECT_GE(bout.runner->tally().beats, 5U) << "events have been compared";
  EXPECT_GE(partner.forces_not_zero(), bout.runner->tally().beats) << "and forces";
  EXPECT_EQ(bench.rig.device->bout().steps(), plain.runner->duel().steps());
  EXPECT_EQ(bench.link.sums().resends, 0U);
  EXPECT_EQ(bench.link.counters().rejected(), 0U);
}

class OverABadCable : public ::testing::TestWithParam<Damage> {};

TEST_P(OverABadCable, TheBoutIsTheSame_AndTheDamageIsCounted) {
  Bench bench;
  bench.rig.cable.worsen(GetParam(), 11);
  PacedPartner partner(bench.link);
  BoutRig bout("default", "script:parry", 3);
  ASSERT_TRUE(partner.open()) << partner.problem();
  ASSERT_TRUE(fence(*bout.runner, partner)) << partner.problem();
  EXPECT_EQ(partner.compared(), 3000U);
  EXPECT_EQ(bench.rig.device->bout().steps(), 3000U) << "no step was made twice";
  EXPECT_GT(bench.link.sums().resends, 0U);
  EXPECT_GT(bench.link.counters().rejected(), 0U);
  EXPECT_GT(partner.report().rejected, 0U);
}

INSTANTIATE_TEST_SUITE_P(Kinds, OverABadCable,
                         ::testing::Values(Damage{1e-3, 0, 0}, Damage{0, 1e-3, 0},
                                           Damage{0, 0, 1e-3}, Damage{1e-3, 1e-3, 1e-3}));

TEST(PacedPartner, ACutCable_EndsTheBoutInBoundedTime_WithAReason) {
  Bench bench;
  PacedPartner partner(bench.link);
  BoutRig bout("default", "script:parry");
  ASSERT_TRUE(partner.open());
  ASSERT_TRUE(fence(*bout.runner, partner, 300));
  bench.rig.cable.cut(true);
  const Microseconds before = bench.rig.clock.time;
  EXPECT_FALSE(fence(*bout.runner, partner, 1000));
  EXPECT_LE(elapsed_us(before, bench.rig.clock.time), 20 * 30 * 1000 + 30 * 2000);
  EXPECT_EQ(partner.session(), Session::kFailed);
  EXPECT_THAT(partner.problem(), HasSubstr("no whole answer to step 301"));
  EXPECT_EQ(partner.compared(), 300U);
  EXPECT_EQ(bench.rig.device->silences(), 1U) << "the device let go";
  EXPECT_EQ(bench.rig.motor.last.x, 0.0F);
  EXPECT_EQ(bench.rig.motor.last.y, 0.0F);
}

TEST(PacedPartner, AfterACut_ANewSessionIsANewBout) {
  Bench bench;
  PacedPartner partner(bench.link);
  BoutRig bout("default", "script:parry");
  ASSERT_TRUE(partner.open());
  ASSERT_TRUE(fence(*bout.runner, partner, 300));
  bench.rig.cable.cut(true);
  ASSERT_FALSE(fence(*bout.runner, partner, 1000));
  bench.rig.cable.cut(false);
  BoutRig next("default", "script:parry", 2);
  ASSERT_TRUE(partner.open()) << partner.problem();
  ASSERT_TRUE(fence(*next.runner, partner)) << partner.problem();
  EXPECT_EQ(partner.compared(), 300U + 2000U);
  EXPECT_EQ(partner.report().silences, 1U) << "the device tells of the silence before";
}

TEST(PacedPartner, ADeviceThatIsOff_IsNotWaitedForForEver) {
  Bench bench;
  bench.powered = false;
  PacedPartner partner(bench.link);
  EXPECT_FALSE(partner.open());
  EXPECT_THAT(partner.problem(), HasSubstr("no answer to Hello within 600 ms"));
}

TEST(PacedPartner, AResetOfTheDevice_IsNoticed_AndItsFaultToldAfterwards) {
  Bench bench;
  PacedPartner partner(bench.link);
  BoutRig bout("default", "script:parry");
  ASSERT_TRUE(partner.open());
  ASSERT_TRUE(fence(*bout.runner, partner, 100));
  bench.reset();
  EXPECT_FALSE(fence(*bout.runner, partner, 200));
  EXPECT_THAT(partner.problem(), HasSubstr("was it reset?"));
  ASSERT_TRUE(partner.open());
  EXPECT_EQ(bench.link.welcome().fault_code, 5U);
}

TEST(PacedPartner, AnotherForce_IsADifference) {
  Bench bench;
  bench.rig.settings.bout.force.full_scale *= 1.0001F;
  bench.reset();
  PacedPartner partner(bench.link);
  BoutRig bout("default", "script:parry");
  ASSERT_TRUE(partner.open());
  EXPECT_FALSE(fence(*bout.runner, partner));
  EXPECT_EQ(partner.session(), Session::kFailed);
  EXPECT_THAT(partner.problem(), HasSubstr(" force: "));
  EXPECT_THAT(partner.problem(), HasSubstr("differs: 0x"));
}

/// Sources on the host's side, faces for the runner.
struct FreeBench : Bench {
  std::unique_ptr<Source> attack = open_source("script:attack").source;
  ReportedStick left{"left"};
  ReportedStick right{"right"};
  FreePartner partner{link, {&left, &right}, {attack.get(), nullptr}};
  std::unique_ptr<DuelRunner> runner;

  bool open(double limit) {
    runner = std::make_unique<DuelRunner>(left, right, limit);
    return runner->start() == Status::kOk && partner.open();
  }
};

TEST(FreePartner, FollowsTheDevice_ToTheTouch) {
  FreeBench bench;
  ASSERT_TRUE(bench.open(10)) << bench.partner.problem();
  ASSERT_TRUE(fence(*bench.runner, bench.partner)) << bench.partner.problem();
  EXPECT_EQ(bench.runner->ending(), Ending::kWon);
  EXPECT_EQ(bench.partner.compared(), bench.runner->duel().steps());
  EXPECT_GT(bench.runner->duel().stick(Side::kLeft).report().used, 1000U);
}

TEST(FreePartner, WithTheDevicesOwnStick_FollowsThatToo) {
  FreeBench bench;
  for (std::uint32_t i = 0; i < 1000; ++i) {
    InputSample sample;
    sample.time = 77000 + i * 1000;
    sample.sequence = i;
    sample.x = 0.3F * static_cast<float>(i % 7) / 7;
    bench.rig.stick.samples.push_back(sample);
  }
  FreePartner partner(bench.link, {&bench.left, &bench.right}, {nullptr, nullptr});
  ASSERT_TRUE(bench.open(0.5));
  ASSERT_TRUE(fence(*bench.runner, partner)) << partner.problem();
  EXPECT_EQ(partner.compared(), 500U);
  EXPECT_EQ(bench.runner->duel().stick(Side::kLeft).report().used, 499U)
      << "the sample of the tick in which Hello came is of the bout before";
}

TEST(FreePartner, LostTelemetry_LosesTheSession_AndANewOneGoesOn) {
  FreeBench bench;
  ASSERT_TRUE(bench.open(10));
  ASSERT_TRUE(fence(*bench.runner, bench.partner, 100));
  bench.rig.cable.to_host.cut(true);
  bench.rig.run(3);
  bench.rig.cable.to_host.cut(false);
  EXPECT_FALSE(fence(*bench.runner, bench.partner, 200));
  EXPECT_EQ(bench.partner.session(), Session::kLost);
  EXPECT_THAT(bench.partner.problem(), HasSubstr("was lost"));
  EXPECT_EQ(bench.partner.lost_sessions(), 1U);
  const std::uint32_t before = bench.partner.compared();
  ASSERT_TRUE(bench.open(0.5)) << bench.partner.problem();
  ASSERT_TRUE(fence(*bench.runner, bench.partner)) << bench.partner.problem();
  EXPECT_EQ(bench.partner.compared(), before + 500U);
}

TEST(FreePartner, AResetOfTheDevice_LosesTheSession_AndIsToldAsSuch) {
  FreeBench bench;
  ASSERT_TRUE(bench.open(10));
  ASSERT_TRUE(fence(*bench.runner, bench.partner, 100));
  bench.reset();
  EXPECT_FALSE(fence(*bench.runner, bench.partner, 200));
  EXPECT_EQ(bench.partner.session(), Session::kLost);
  EXPECT_THAT(bench.partner.problem(), HasSubstr("was it reset?"));
  EXPECT_EQ(bench.partner.compared(), 100U) << "nothing of the device alone is taken for the bout";
  ASSERT_TRUE(bench.open(0.5)) << bench.partner.problem();
  EXPECT_EQ(bench.link.welcome().fault_code, 5U);
  ASSERT_TRUE(fence(*bench.runner, bench.partner)) << bench.partner.problem();
}

TEST(FreePartner, AResetWhoseFramesAreAllOld_IsToldAsSuch) {
  FreeBench bench;
  ASSERT_TRUE(bench.open(10));
  ASSERT_TRUE(fence(*bench.runner, bench.partner, 900));
  bench.reset();
  EXPECT_FALSE(fence(*bench.runner, bench.partner, 1000));
  EXPECT_EQ(bench.partner.session(), Session::kLost);
  EXPECT_THAT(bench.partner.problem(), HasSubstr("numbers its frames anew; was it reset?"));
}

TEST(FreePartner, ALateHelloOfAnOlderSession_LosesTheSession) {
  FreeBench bench;
  ASSERT_TRUE(bench.open(10));
  ASSERT_TRUE(fence(*bench.runner, bench.partner, 100));
  test::PlainHost late(bench.rig.cable);
  const std::uint32_t other = (bench.link.welcome().session & 0xFFFFU) == 1U ? 2U : 1U;
  late.send(link::Hello{other, link::Mode::kFree});
  EXPECT_FALSE(fence(*bench.runner, bench.partner, 200));
  EXPECT_EQ(bench.partner.session(), Session::kLost);
  EXPECT_THAT(bench.partner.problem(), HasSubstr("in another session"));
}

TEST(FreePartner, ASilentDevice_IsGivenUp) {
  FreeBench bench;
  ASSERT_TRUE(bench.open(10));
  ASSERT_TRUE(fence(*bench.runner, bench.partner, 50));
  bench.powered = false;
  EXPECT_FALSE(fence(*bench.runner, bench.partner, 200));
  EXPECT_EQ(bench.partner.session(), Session::kFailed);
}

}  // namespace
}  // namespace batuta::host
