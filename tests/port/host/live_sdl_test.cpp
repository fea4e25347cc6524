// SPDX-License-Identifier: MIT
// Sticks and pads through SDL, and their rumble.
#include <gmock/gmock.h>

#include <map>
#include <string>

#include "batuta/haptics/output_stage.hpp"
#include "programs/devices/source.hpp"
#include "programs/live/live_force.hpp"
#include "programs/live/sdl_feed.hpp"
#include "programs/live/sdl_force.hpp"
#include "soon.hpp"
#include "virtual_stick.hpp"

namespace batuta::host {
using namespace haptics;
namespace {

using test::Opened;
using test::soon;
using test::VirtualStick;
using testing::HasSubstr;
using testing::Not;

/// What sticks tell of themselves, by SDL's number; the virtual ones have none.
std::map<SDL_JoystickID, std::string> serials;

class LiveSdl : public test::LiveSdl {
 protected:
  LiveSdl() { serials.clear(); }
};

/// Of the stick that it has; -1: none.
SDL_JoystickID instance_of(const Opened& opened) {
  const SdlStick::Handle handle = opened.stick->handle();
  return handle == nullptr ? -1 : SDL_JoystickInstanceID(handle.get());
}

/// As the thread of the device looks. @returns whether it has the stick
bool look(SdlFeed& feed) {
  InputSample sample;
  return feed.look(sample) != News::kGone;
}

TEST_F(LiveSdl, WithoutAStick_TheListSaysNone) {
  const OpenedSource opened = open_source("device:sdl");
  EXPECT_FALSE(opened.source);
  EXPECT_EQ(opened.error, "device:sdl: no such stick; found: none");
}

TEST_F(LiveSdl, ItIsChosenByPlaceOrName_AndTheListSaysWhatThereIs) {
  VirtualStick first("Alpha Stick");
  VirtualStick second("Beta Stick");
  EXPECT_EQ(Opened().stick->name(), "Alpha Stick");
  EXPECT_EQ(Opened("1").stick->name(), "Beta Stick");
  EXPECT_EQ(Opened("beta").stick->name(), "Beta Stick");
  EXPECT_FALSE(Opened("2").there);
  EXPECT_FALSE(Opened("-1").there);
  const OpenedSource opened = open_source("device:sdl:Gamma");
  EXPECT_FALSE(opened.source);
  EXPECT_THAT(opened.error, HasSubstr("found: 0 (Alpha Stick), 1 (Beta Stick)"));
  EXPECT_THAT(opened.error, Not(HasSubstr("\n")));
}

TEST_F(LiveSdl, TwoFencersHaveTwoSticks) {
  VirtualStick first("Twin");
  VirtualStick second("Twin");
  const Opened left;
  const Opened right;
  EXPECT_TRUE(left.there && right.there);
  EXPECT_NE(left.stick->handle(), right.stick->handle());
  const Opened third;
  EXPECT_FALSE(third.there);
  EXPECT_EQ(third.stick->problem(), "Twin is the other fencer's already");
  EXPECT_EQ(Opened("0").stick->problem(), "Twin is the other fencer's already");
}

TEST_F(LiveSdl, AStickWithOneAxis_IsNone) {
  VirtualStick throttle("Throttle", SDL_JOYSTICK_TYPE_THROTTLE, 1);
  const Opened opened;
  EXPECT_FALSE(opened.there);
  EXPECT_EQ(opened.stick->problem(), "Throttle has too few axes");
}

TEST_F(LiveSdl, AxesGoToTheRim_UpIsUp_AndTheCentreIsZero) {
  VirtualStick stick("Stick");
  const Opened opened;
  ASSERT_TRUE(opened.there);
  SdlFeed feed(opened.stick);
  InputSample sample;
  ASSERT_EQ(feed.look(sample), News::kSample) << "where it is";
  EXPECT_EQ(sample.x, 0.0F);
  EXPECT_EQ(sample.y, 0.0F);
  EXPECT_EQ(feed.look(sample), News::kNone);
  stick.move(32767, -32768);
  stick.press(1, true);
  ASSERT_EQ(feed.look(sample), News::kSample);
  EXPECT_EQ(sample.x, 1.0F);
  EXPECT_EQ(sample.y, 1.0F) << "SDL's axes grow downwards";
  EXPECT_EQ(sample.buttons, 2U);
  stick.move(-32768, 16384);
  stick.press(1, false);
  ASSERT_EQ(feed.look(sample), News::kSample);
  EXPECT_EQ(sample.x, -1.0F);
  EXPECT_NEAR(static_cast<double>(sample.y), -0.5, 1e-4);
  EXPECT_EQ(sample.buttons, 0U);
}

TEST_F(LiveSdl, APad_GoesBySdlsMapping) {
  VirtualStick pad("Pad", SDL_JOYSTICK_TYPE_GAMECONTROLLER, 6);
  const Opened opened;
  ASSERT_TRUE(opened.there);
  ASSERT_NE(opened.stick->pad(), nullptr);
  SdlFeed feed(opened.stick);
  InputSample sample;
  pad.move(32767, 32767);
  pad.press(0, true);
  ASSERT_EQ(feed.look(sample), News::kSample);
  EXPECT_EQ(sample.x, 1.0F);
  EXPECT_EQ(sample.y, -1.0F);
  EXPECT_EQ(sample.buttons, 1U << SDL_CONTROLLER_BUTTON_A);
}

TEST_F(LiveSdl, TheHatOfAStick_IsForTheFeet) {
  VirtualStick stick("Stick");
  const Opened opened;
  ASSERT_TRUE(opened.there);
  SdlFeed feed(opened.stick);
  InputSample sample;
  ASSERT_EQ(feed.look(sample), News::kSample);
  EXPECT_EQ(sample.feet_y, 0.0F);
  stick.hat(SDL_HAT_DOWN);
  ASSERT_EQ(feed.look(sample), News::kSample);
  EXPECT_EQ(sample.feet_y, -1.0F);
  EXPECT_EQ(sample.feet_x, 0.0F);
  stick.hat(SDL_HAT_RIGHTUP);
  ASSERT_EQ(feed.look(sample), News::kSample);
  EXPECT_EQ(sample.feet_y, 1.0F);
  EXPECT_EQ(sample.feet_x, 1.0F);
  stick.hat(SDL_HAT_LEFT);
  ASSERT_EQ(feed.look(sample), News::kSample);
  EXPECT_EQ(sample.feet_y, 0.0F);
  EXPECT_EQ(sample.feet_x, -1.0F);
}

TEST_F(LiveSdl, TheRightStickOfAPad_IsForTheFeet) {
  VirtualStick pad("Pad", SDL_JOYSTICK_TYPE_GAMECONTROLLER, 6);
  const Opened opened;
  ASSERT_NE(opened.stick->pad(), nullptr);
  SdlFeed feed(opened.stick);
  InputSample sample;
  ASSERT_EQ(feed.look(sample), News::kSample);
  pad.tilt(SDL_CONTROLLER_AXIS_RIGHTX, 32767);
  pad.tilt(SDL_CONTROLLER_AXIS_RIGHTY, -32768);
  ASSERT_EQ(feed.look(sample), News::kSample);
  EXPECT_EQ(sample.feet_x, 1.0F);
  EXPECT_EQ(sample.feet_y, 1.0F);
  EXPECT_EQ(sample.x, 0.0F);
}

TEST_F(LiveSdl, Unplugged_ItIsGone_AndTheSameOneComesBack) {
  VirtualStick other("Other");
  VirtualStick stick("Wanted");
  const Opened opened("Wanted");
  ASSERT_TRUE(opened.there);
  SdlFeed feed(opened.stick);
  InputSample sample;
  (void)feed.look(sample);
  stick.detach();
  EXPECT_EQ(feed.look(sample), News::kGone);
  EXPECT_EQ(opened.stick->handle(), nullptr);
  EXPECT_FALSE(feed.reopen()) << "the other one is not it";
  stick.attach();
  stick.move(16384, 0);
  ASSERT_TRUE(feed.reopen());
  ASSERT_EQ(feed.look(sample), News::kSample);
  EXPECT_NEAR(static_cast<double>(sample.x), 0.5, 1e-4);
}

TEST_F(LiveSdl, ATwinThatLiesThere_DoesNotTakeItsPlace_WheneverItWasPluggedIn) {
  for (const bool first : {true, false}) {
    VirtualStick early("Twin");
    VirtualStick late("Twin");
    const Opened opened(first ? "0" : "1");
    ASSERT_TRUE(opened.there);
    SdlFeed feed(opened.stick);
    VirtualStick latest("Twin");
    ASSERT_TRUE(look(feed));
    VirtualStick& mine = first ? early : late;
    mine.detach();
    EXPECT_FALSE(look(feed));
    EXPECT_FALSE(feed.reopen()) << "nobody has chosen one of those";
    EXPECT_FALSE(feed.reopen());
    mine.attach();
    ASSERT_TRUE(feed.reopen());
    mine.move(16384, 0);
    InputSample sample;
    ASSERT_EQ(feed.look(sample), News::kSample);
    EXPECT_GT(sample.x, 0.4F) << "and it is the one in the hand";
  }
}

TEST_F(LiveSdl, PulledAndPluggedInBetweenTwoLooks_ItIsBack) {
  VirtualStick stick("Twin");
  VirtualStick twin("Twin");
  const Opened opened("0");
  SdlFeed feed(opened.stick);
  ASSERT_TRUE(look(feed));
  stick.detach();
  stick.attach();
  EXPECT_FALSE(look(feed));
  EXPECT_TRUE(feed.reopen());
}

TEST_F(LiveSdl, ATwinThatComesInstead_IsKnownByItsSerialNumber) {
  VirtualStick stick("Twin");
  serials[SDL_JoystickGetDeviceInstanceID(0)] = "mine";
  const Opened opened;
  ASSERT_TRUE(opened.there);
  const SDL_JoystickID before = instance_of(opened);
  SdlFeed feed(opened.stick);
  stick.detach();
  EXPECT_FALSE(look(feed));
  VirtualStick twin("Twin");
  serials[SDL_JoystickGetDeviceInstanceID(0)] = "another";
  EXPECT_FALSE(feed.reopen());
  EXPECT_EQ(opened.stick->problem(), "Twin is another one");
  stick.attach();
  serials[SDL_JoystickGetDeviceInstanceID(1)] = "mine";
  ASSERT_TRUE(feed.reopen());
  EXPECT_EQ(instance_of(opened), SDL_JoystickGetDeviceInstanceID(1));
  EXPECT_NE(instance_of(opened), before);
}

TEST_F(LiveSdl, FromTheStickToTheBout_AndBackIntoTheHand) {
  VirtualStick stick("Stick");
  {
    const OpenedSource opened = open_source("device:sdl");
    ASSERT_TRUE(opened.source) << opened.error;
    Source& source = *opened.source;
    EXPECT_EQ(source.description(), "SDL (Stick)");
    InputSample sample;
    ASSERT_TRUE(soon([&] { return source.read(0, sample) == Status::kOk; }));
    stick.move(-32768, 0);
    ASSERT_TRUE(soon([&] { return source.read(1000, sample) == Status::kOk && sample.x == -1; }));

    LiveForce* const force = source.force({});
    ASSERT_NE(force, nullptr);
    EXPECT_EQ(force->first_kind(), ForceKind::kRumble) << "no force: it is shaken";
    OutputStage stage(*force);
    ASSERT_EQ(stage.configure({}), Status::kOk);
    ASSERT_EQ(stage.enable(), Status::kOk);
    StageInput hard;
    hard.demanded.x() = 1000;
    hard.fresh_sample = hard.fresh_command = true;
    ASSERT_TRUE(soon([&] { return stage.step(hard) == Status::kOk && stick.hardest > 0x8000; }));
    EXPECT_GT(force->report().sent, 0U);
    EXPECT_TRUE(soon([&] { return stick.strong == 0 && stick.weak == 0; }))
        << "nobody commands any more";
    EXPECT_TRUE(soon([&] { return stage.step(hard) == Status::kOk && stick.strong > 0x8000; }));

    stick.detach();
    EXPECT_TRUE(soon([&] { return source.unplugs() == 1; }));
    EXPECT_TRUE(soon([&] { return stage.step(hard) == Status::kUnavailable; }));
    stick.attach();
    stick.move(32767, 0);
    EXPECT_TRUE(soon([&] { return source.read(5000, sample) == Status::kOk && sample.x == 1; }));
    stick.strong = 0;
    EXPECT_TRUE(soon([&] { return stage.step(hard) == Status::kOk && stick.strong > 0x8000; }));
  }
  EXPECT_EQ(stick.strong, 0U) << "the end of the program takes the force away";
}

TEST_F(LiveSdl, Off_StopsTheRumbleAtOnce) {
  VirtualStick stick("Stick");
  const Opened opened;
  LiveForce force(std::make_unique<SdlForce>(opened.stick), {});
  ASSERT_EQ(force.first_kind(), ForceKind::kRumble);
  OutputStage stage(force);
  ASSERT_EQ(stage.configure({}), Status::kOk);
  ASSERT_EQ(stage.enable(), Status::kOk);
  StageInput hard;
  hard.demanded.x() = 1000;
  hard.fresh_sample = hard.fresh_command = true;
  ASSERT_TRUE(soon([&] { return stage.step(hard) == Status::kOk && stick.strong > 0x8000; }));
  stage.stop(0);
  EXPECT_TRUE(soon([&] { return stick.strong == 0 && stick.weak == 0; }));
  std::this_thread::sleep_for(std::chrono::milliseconds(60));
  EXPECT_EQ(stick.strong + stick.weak, 0U);
}

TEST_F(LiveSdl, WithoutForceAndRumble_ThereIsNone) {
  VirtualStick stick("Stick", SDL_JOYSTICK_TYPE_FLIGHT_STICK, 2, false);
  const Opened opened;
  EXPECT_EQ(SdlForce(opened.stick).open(), ForceKind::kNone);
}

}  // namespace
}  // namespace batuta::host

// The linker takes this instead of SDL's.
extern "C" const char* SDL_JoystickGetSerial(SDL_Joystick* stick) {
  const auto found = batuta::host::serials.find(SDL_JoystickInstanceID(stick));
  return found == batuta::host::serials.end() ? nullptr : found->second.c_str();
}
