// SPDX-License-Identifier: MIT
// Sticks and mice of the Linux input stack, through libevdev's own code; the kernel below it is a
// fake.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cerrno>

#include "fake_stick.hpp"
#include "platforms/host/clock.hpp"
#include "programs/devices/source.hpp"
#include "programs/live/evdev_feed.hpp"

namespace batuta::host {
namespace {

using test::FakeEventDevice;
using test::kPath;
using testing::HasSubstr;
using testing::Not;
using Stick = test::FakeStick;

TEST(EvdevFeed, OnOpening_TheSample_IsWhereTheStickIs) {
  Stick stick;
  stick.change(EV_ABS, ABS_X, 255);
  stick.change(EV_KEY, BTN_THUMB, 1);
  EvdevFeed feed(kPath);
  ASSERT_EQ(feed.open(), "");
  EXPECT_EQ(feed.name(), "Test Stick");
  InputSample sample;
  ASSERT_EQ(feed.look(sample), News::kSample);
  EXPECT_EQ(sample.x, 1.0F);
  EXPECT_EQ(sample.y, 0.0F) << "in the dead zone";
  EXPECT_EQ(sample.buttons, 2U);
  EXPECT_EQ(feed.look(sample), News::kNone) << "and it is said once";
}

TEST(EvdevFeed, AxesHaveTheDevicesRangeAndDeadZone_AndUpIsUp) {
  Stick stick;
  EvdevFeed feed(kPath);
  ASSERT_EQ(feed.open(), "");
  InputSample sample;
  (void)feed.look(sample);
  stick.event(EV_ABS, ABS_X, 0);
  stick.event(EV_ABS, ABS_Y, 0);
  stick.event(EV_KEY, BTN_TRIGGER, 1);
  EXPECT_EQ(feed.look(sample), News::kNone) << "no mark yet: the set is not complete";
  stick.sync(12345678);
  ASSERT_EQ(feed.look(sample), News::kSample);
  EXPECT_EQ(sample.x, -1.0F);
  EXPECT_EQ(sample.y, 1.0F) << "fewer counts are up";
  EXPECT_EQ(sample.buttons, 1U);
  EXPECT_EQ(sample.time, 12345678U) << "the kernel's stamp";
  stick.event(EV_ABS, ABS_X, 142);
  stick.sync();
  ASSERT_EQ(feed.look(sample), News::kSample);
  EXPECT_EQ(sample.x, 0.0F) << "14.5 counts off the centre";
  stick.event(EV_ABS, ABS_X, 143);
  stick.sync();
  ASSERT_EQ(feed.look(sample), News::kSample);
  EXPECT_FLOAT_EQ(sample.x, 0.5F / 112.5F) << "half a count beyond the dead zone";
}

TEST(EvdevFeed, StampsOfAnotherClock_AreNotTaken_TheTimeIsThatOfTheLook) {
  Stick stick;
  stick.refuse_clock();
  EvdevFeed feed(kPath);
  ASSERT_EQ(feed.open(), "");
  HostClock clock;
  for (const std::int64_t off_s : {-1000, 1000, 2000, 3000}) {  // modulo 2^32 us: 4295 s
    InputSample sample;
    (void)feed.look(sample);
    const Microseconds before = clock.now();
    stick.event(EV_ABS, ABS_X, off_s < 0 ? 0 : static_cast<int>(off_s / 100));
    stick.sync(static_cast<std::uint64_t>((std::int64_t{1} << 40) + before + off_s * 1000000));
    ASSERT_EQ(feed.look(sample), News::kSample);
    EXPECT_FALSE(is_later(before, sample.time)) << off_s;
    EXPECT_FALSE(is_later(sample.time, clock.now())) << off_s;
  }
}

TEST(EvdevFeed, SecondStick_IsForTheFeet_FromItsOpeningOn) {
  Stick stick;
  stick.axis(ABS_RX, {100, 0, 100, 0, 0, 0});
  stick.axis(ABS_RY, {50, 0, 100, 0, 0, 0});
  EvdevFeed feed(kPath);
  ASSERT_EQ(feed.open(), "");
  InputSample sample;
  ASSERT_EQ(feed.look(sample), News::kSample);
  EXPECT_EQ(sample.feet_x, 1.0F) << "where it is";
  EXPECT_EQ(sample.feet_y, 0.0F);
  stick.event(EV_ABS, ABS_RY, 0);
  stick.sync();
  ASSERT_EQ(feed.look(sample), News::kSample);
  EXPECT_EQ(sample.feet_y, 1.0F) << "fewer counts are up";
}

TEST(EvdevFeed, AHat_IsForTheFeet_WhereThereIsNoSecondStick) {
  Stick stick;
  stick.axis(ABS_HAT0X, {0, -1, 1, 0, 0, 0});
  stick.axis(ABS_HAT0Y, {0, -1, 1, 0, 0, 0});
  EvdevFeed feed(kPath);
  ASSERT_EQ(feed.open(), "");
  InputSample sample;
  (void)feed.look(sample);
  stick.event(EV_ABS, ABS_HAT0Y, 1);
  stick.sync();
  ASSERT_EQ(feed.look(sample), News::kSample);
  EXPECT_EQ(sample.feet_y, -1.0F);
}

TEST(EvdevFeed, OfManySamples_TheLatestWins) {
  Stick stick;
  EvdevFeed feed(kPath);
  ASSERT_EQ(feed.open(), "");
  for (int counts = 0; counts <= 255; counts += 5) {
    stick.event(EV_ABS, ABS_X, counts);
    stick.sync();
  }
  InputSample sample;
  ASSERT_EQ(feed.look(sample), News::kSample);
  EXPECT_EQ(sample.x, 1.0F);
  EXPECT_EQ(feed.look(sample), News::kNone);
}

TEST(EvdevFeed, AMouse_IsSummedUp_AndHeldAtTheRim) {
  FakeEventDevice mouse(kPath);
  mouse.has(EV_REL, REL_X).has(EV_REL, REL_Y).has(EV_KEY, BTN_LEFT);
  EvdevFeed feed(kPath);
  ASSERT_EQ(feed.open(), "");
  InputSample sample;
  ASSERT_EQ(feed.look(sample), News::kSample);
  EXPECT_EQ(sample.x, 0.0F) << "wherever it lies is the centre";
  for (int i = 0; i < 2; ++i) {
    mouse.event(EV_REL, REL_X, 100);
    mouse.event(EV_REL, REL_Y, -50);
    mouse.sync();
  }
  ASSERT_EQ(feed.look(sample), News::kSample);
  EXPECT_EQ(sample.x, 0.5F) << "of the 400 counts to the rim";
  EXPECT_EQ(sample.y, 0.25F) << "away from the user is up";
  mouse.event(EV_REL, REL_X, 10000);
  mouse.sync();
  mouse.event(EV_REL, REL_X, -400);
  mouse.sync();
  ASSERT_EQ(feed.look(sample), News::kSample);
  EXPECT_EQ(sample.x, 0.0F) << "what went beyond the rim is forgotten";
}

TEST(EvdevFeed, LostEvents_AreCounted_AndTheStateIsAskedFor) {
  Stick stick;
  EvdevFeed feed(kPath);
  ASSERT_EQ(feed.open(), "");
  InputSample sample;
  (void)feed.look(sample);
  stick.event(EV_ABS, ABS_X, 0);  // of a set that is never completed
  stick.change(EV_ABS, ABS_X, 255);
  stick.change(EV_ABS, ABS_Y, 255);
  stick.change(EV_KEY, BTN_THUMB, 1);
  stick.event(EV_SYN, SYN_DROPPED, 0);
  stick.event(EV_ABS, ABS_X, 3);  // the rest of the lost set, to be ignored
  stick.change(EV_ABS, ABS_X, 255);
  stick.sync();
  ASSERT_EQ(feed.look(sample), News::kSample);
  EXPECT_EQ(sample.x, 1.0F);
  EXPECT_EQ(sample.y, -1.0F);
  EXPECT_EQ(sample.buttons, 2U);
  EXPECT_EQ(feed.losses(), 1U);
  stick.event(EV_ABS, ABS_X, 0);
  stick.sync();
  ASSERT_EQ(feed.look(sample), News::kSample) << "and it goes on";
  EXPECT_EQ(sample.x, -1.0F);
  EXPECT_EQ(feed.losses(), 1U);
}

TEST(EvdevFeed, Unplugged_ItIsGone_AndBackAtTheSamePath) {
  Stick stick;
  EvdevFeed feed(kPath);
  ASSERT_EQ(feed.open(), "");
  InputSample sample;
  (void)feed.look(sample);
  stick.event(EV_ABS, ABS_X, 0);
  stick.unplug();
  EXPECT_EQ(feed.look(sample), News::kGone);
  EXPECT_FALSE(feed.reopen());
  stick.plug_in();
  stick.change(EV_ABS, ABS_X, 255);
  ASSERT_TRUE(feed.reopen());
  ASSERT_EQ(feed.look(sample), News::kSample);
  EXPECT_EQ(sample.x, 1.0F) << "where it is now, not where it was";
}

TEST(EvdevFeed, HalfAnEvent_IsNotUnderstood_AndTheDeviceIsOpenedAnew) {
  Stick stick;
  EvdevFeed feed(kPath);
  ASSERT_EQ(feed.open(), "");
  InputSample sample;
  (void)feed.look(sample);
  stick.bytes("rubbish", 7);
  EXPECT_EQ(feed.look(sample), News::kGone);
  EXPECT_TRUE(feed.reopen());
  EXPECT_EQ(feed.look(sample), News::kSample);
}

TEST(EvdevFeed, AFlood_DoesNotHoldTheThread) {
  Stick stick;
  EvdevFeed feed(kPath);
  ASSERT_EQ(feed.open(), "");
  InputSample sample;
  (void)feed.look(sample);
  input_event moved{};
  moved.type = EV_ABS;
  moved.code = ABS_Y;
  const std::vector<input_event> flood(3000, moved);
  stick.bytes(flood.data(), flood.size() * sizeof moved);
  stick.sync();
  int looks = 1;
  while (feed.look(sample) != News::kSample && looks < 10) ++looks;
  EXPECT_EQ(looks, 3) << "1024 events each";
}

TEST(OpenEvdev, TwoFencersDoNotShareADevice_WhateverTheyCallIt) {
  Stick stick;
  stick.also_at("/dev/input/by-id/fake0");
  FakeEventDevice other("/dev/input/fake1");
  other.axis(ABS_X, {127, 0, 255, 0, 15, 0}).axis(ABS_Y, {127, 0, 255, 0, 15, 0});
  {
    const OpenedSource left = open_source(std::string("device:") + kPath);
    ASSERT_TRUE(left.source) << left.error;
    for (const std::string path : {kPath, "/dev/input/by-id/fake0"}) {
      const OpenedSource right = open_source("device:" + path);
      EXPECT_FALSE(right.source);
      EXPECT_THAT(right.error, HasSubstr("device:" + path +
                                         ": Test Stick is the other fencer's already; found"));
    }
    EXPECT_TRUE(open_source("device:/dev/input/fake1").source);
    EXPECT_EQ(stick.open_files(), 1);
  }
  EXPECT_TRUE(open_source("device:/dev/input/by-id/fake0").source) << "it is free again";
}

TEST(EvdevFeed, PluggedInUnderTheNameOfTheOtherFencers_ItWaits) {
  Stick stick;
  FakeEventDevice other("/dev/input/fake1");
  other.axis(ABS_X, {127, 0, 255, 0, 15, 0}).axis(ABS_Y, {127, 0, 255, 0, 15, 0});
  EvdevFeed left(kPath);
  EvdevFeed right("/dev/input/fake1");
  ASSERT_EQ(left.open(), "");
  ASSERT_EQ(right.open(), "");
  InputSample sample;
  stick.unplug();
  EXPECT_EQ(left.look(sample), News::kGone);
  stick.give_name_to(other);
  EXPECT_FALSE(left.reopen());
  other.unplug();
  EXPECT_EQ(right.look(sample), News::kGone);
  other.plug_in();
  EXPECT_TRUE(left.reopen()) << "first come, first served";
  EXPECT_FALSE(right.reopen());
}

TEST(OpenEvdev, Refusals_AreOneLine_AndSayWhy) {
  FakeEventDevice keyboard("/dev/input/fake1");
  keyboard.name("Keys").has(EV_KEY, KEY_A);
  FakeEventDevice broken("/dev/input/fake2");
  broken.axis(ABS_X, {0, 0, 0, 0, 0, 0}).axis(ABS_Y, {0, 0, 0, 0, 0, 0});
  FakeEventDevice locked("/dev/input/fake3");
  locked.refuse(EACCES);
  const std::pair<const char*, const char*> refusals[] = {
      {"device:/dev/input/fake1", "Keys is no stick, pad or mouse"},
      {"device:/dev/input/fake2", "is no stick, pad or mouse"},
      {"device:/dev/input/fake3", "no permission"},
      {"device:/dev/input/fake4", "no such device"},
      {"device:/dev/null", "not an event device"},
      {"device:/", "not an event device"},
      {"device:", "a live device is device:/dev/input/eventN or device:sdl"},
      {"device:mouse", "a live device is"},
      {"device:sdlx", "a live device is"}};
  for (const auto& [words, reason] : refusals) {
    const OpenedSource opened = open_source(words);
    EXPECT_FALSE(opened.source);
    EXPECT_THAT(opened.error, HasSubstr(words));
    EXPECT_THAT(opened.error, HasSubstr(reason));
    EXPECT_THAT(opened.error, Not(HasSubstr("\n")));
  }
}

}  // namespace
}  // namespace batuta::host
