// SPDX-License-Identifier: MIT
// A live stick from the kernel to the bout, and the bout back into the hand; the kernel is a fake.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>

#include "fake_stick.hpp"
#include "programs/devices/script_device.hpp"
#include "programs/duel/bout_log.hpp"
#include "programs/duel/json_log.hpp"
#include "programs/duel/stick_feedback.hpp"
#include "soon.hpp"

namespace batuta::host {
using namespace haptics;
using namespace fencing;
namespace {

using test::kPath;
using test::soon;
using test::strength;
using testing::HasSubstr;
using testing::Not;
using Stick = test::FakeStick;

TEST(LiveEvdev, FromTheKernelToTheBout_AndBackIntoTheHand) {
  Stick stick;
  stick.has(EV_FF, FF_CONSTANT).room_for_effects(16);
  const OpenedSource opened = open_source(std::string("device:") + kPath);
  ASSERT_TRUE(opened.source) << opened.error;
  Source& source = *opened.source;
  EXPECT_TRUE(source.is_live());
  EXPECT_EQ(source.description(), "/dev/input/fake0 (Test Stick)");
  InputSample sample;
  ASSERT_TRUE(soon([&] { return source.read(0, sample) == Status::kOk; }));
  EXPECT_EQ(sample.x, 0.0F);
  stick.event(EV_ABS, ABS_X, 255);
  stick.sync();
  ASSERT_TRUE(soon([&] { return source.read(1000, sample) == Status::kOk && sample.x == 1; }));
  EXPECT_FALSE(is_later(sample.time, 1000)) << "never of the bout's future";

  LiveForce* const force = source.force({});
  ASSERT_NE(force, nullptr);
  EXPECT_EQ(force->first_kind(), ForceKind::kForce);
  EXPECT_EQ(force->off(0), Status::kOk);
  EXPECT_TRUE(soon([&] { return stick.is_playing(0) && stick.is_playing(1); }));

  stick.unplug();
  EXPECT_TRUE(soon([&] { return source.unplugs() == 1; }));
  while (source.read(2000, sample) == Status::kOk) {  // what was on its way
  }
  EXPECT_EQ(source.read(3000, sample), Status::kUnavailable);
  stick.change(EV_ABS, ABS_X, 0);
  stick.plug_in();
  ASSERT_TRUE(soon([&] { return source.read(4000, sample) == Status::kOk; }));
  EXPECT_EQ(sample.x, -1.0F);
  EXPECT_EQ(source.unplugs(), 1U);
}

/// A bout in real time, with a live stick on the left.
class LiveBout {
 public:
  explicit LiveBout(Source& left, const ForceOptions& options = {})
      : runner_(left, right_, 100), feedback_({left.force(options), nullptr}) {
    EXPECT_EQ(runner_.start(), Status::kOk);
    feedback_.on_start(runner_);
  }

  /// @returns whether no step took more of the force's share away than the ramp does
  bool steps(int count) {
    bool smooth = true;
    for (int i = 0; i < count; ++i) {
      const float before = runner_.bout().forces().of(Side::kLeft).allowed;
      (void)runner_.step();
      feedback_.on_step(runner_);
      EXPECT_EQ(runner_.status(), Status::kOk);
      const float after = runner_.bout().forces().of(Side::kLeft).allowed;
      const float most = 1.001F / static_cast<float>(RampSettings{}.length);
      smooth = smooth && before - after <= most;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return smooth;
  }

  /// Goes on until the condition has held after so many steps in a row: the threads that read and
  /// push may get no processor for many steps. @returns whether it did, and all of it was smooth
  template <class Condition>
  bool steps_until(const Condition& condition, int in_a_row = 1) {
    constexpr int kMost = 30000;
    bool smooth = true;
    int held = 0;
    for (int i = 0; i < kMost && held < in_a_row; ++i) {
      smooth = steps(1) && smooth;
      held = condition() ? held + 1 : 0;
    }
    return smooth && held == in_a_row;
  }

  std::string end(bool json) {
    feedback_.on_end(runner_);
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> out(std::tmpfile(), &std::fclose);
    ForceLog forces(out.get(), json, feedback_);
    forces.on_end(runner_);
    if (json) JsonLog(out.get()).on_end(runner_);
    if (!json) BoutLog(out.get()).on_end(runner_);
    std::rewind(out.get());
    std::string text(10000, '\0');
    text.resize(std::fread(text.data(), 1, text.size(), out.get()));
    return text;
  }

  const DuelRunner& runner() const { return runner_; }

 private:
  ScriptDevice right_{*script_named("guard")};
  DuelRunner runner_;
  StickFeedback feedback_;
};

TEST(LiveDuel, UnpluggedAmidTheBout_TheForceGoesSmoothly_TheDuelGoesOn_AndItIsCounted) {
  Stick stick;
  stick.has(EV_FF, FF_CONSTANT).room_for_effects(16);
  const OpenedSource opened = open_source(std::string("device:") + kPath);
  ASSERT_TRUE(opened.source) << opened.error;
  LiveBout bout(*opened.source);
  const auto allowed = [&] { return bout.runner().bout().forces().of(Side::kLeft).allowed; };
  const auto place = [&] { return bout.runner().duel().stick(Side::kLeft).position().x(); };
  stick.event(EV_ABS, ABS_X, 200);
  stick.sync();
  EXPECT_TRUE(bout.steps_until([&] { return allowed() == 1.0F && place() > 0.4F; }, 150))
      << "a stick that is held still is not silent";
  const float x = place();
  stick.unplug();
  EXPECT_TRUE(bout.steps_until([&] { return allowed() == 0.0F; }, 50));
  EXPECT_EQ(place(), x) << "it stays where it was";
  stick.change(EV_ABS, ABS_X, 0);
  stick.plug_in();
  EXPECT_TRUE(bout.steps_until([&] { return allowed() == 1.0F && place() == -1.0F; }, 50));
  EXPECT_EQ(bout.runner().tally().devices[0].refused, 0U);
  const std::string json = bout.end(true);
  EXPECT_THAT(json, HasSubstr("\"left_unplugs\":1,"));
  EXPECT_THAT(json, HasSubstr("{\"type\":\"force\",\"side\":\"left\",\"kind\":\"force\""));
  const std::string words = bout.end(false);
  EXPECT_THAT(words, HasSubstr(", unplugged 1 times"));
  EXPECT_THAT(words, HasSubstr("left   force: force; effects sent"));
  EXPECT_TRUE(soon([&] {
    const std::vector<ff_effect> effects = stick.effects();
    return effects.size() == 2 && effects[0].u.constant.level == 0;
  })) << "the end of the bout leaves no force";
}

TEST(LiveDuel, AStickThatRefusesItsSpring_IsReadOn_AndItIsToldOnce) {
  Stick stick;
  stick.has(EV_FF, FF_CONSTANT).has(EV_FF, FF_SPRING).room_for_effects(16);
  stick.refuse_effects(EINVAL, FF_SPRING);
  const OpenedSource opened = open_source(std::string("device:") + kPath);
  ASSERT_TRUE(opened.source) << opened.error;
  ForceOptions options;
  options.spring.coefficient = 0.5F;
  LiveBout bout(*opened.source, options);
  EXPECT_TRUE(bout.steps(700)) << "a device that flaps would have been opened twice by now";
  stick.event(EV_ABS, ABS_X, 255);
  stick.sync();
  const auto place = [&] { return bout.runner().duel().stick(Side::kLeft).position().x(); };
  EXPECT_TRUE(bout.steps_until([&] { return place() == 1.0F; })) << "it is read";
  EXPECT_EQ(stick.openings(), 2) << "by who reads, and by who pushes";
  const std::string words = bout.end(false);
  EXPECT_THAT(words, HasSubstr("left   force: force; effects sent"));
  EXPECT_THAT(words, HasSubstr("; not taken by the device: spring\n"));
  EXPECT_THAT(words, Not(HasSubstr("unplugged")));
  EXPECT_THAT(bout.end(true), HasSubstr("\"left_out\":\"spring\""));
}

TEST(LiveDuel, ABoutThatIsGivenUp_LeavesNoForce_WithoutWaitingForTheSilence) {
  Stick stick;
  stick.has(EV_FF, FF_CONSTANT).has(EV_FF, FF_SPRING).room_for_effects(16);
  const OpenedSource opened = open_source(std::string("device:") + kPath);
  ASSERT_TRUE(opened.source) << opened.error;
  ForceOptions options;
  options.spring.coefficient = 1;
  const auto spring = [&] { return stick.effects().size() < 3 ? 0 : strength(stick.effects()[2]); };
  constexpr auto kSooner = std::chrono::microseconds(ForcePump::kSilence_us / 2);
  constexpr int kTries = 100;  // a busy machine may be slow, not always; a silence is never sooner
  auto fastest = 100 * kSooner;
  for (int i = 0; i < kTries && fastest >= kSooner; ++i) {
    auto bout = std::make_unique<LiveBout>(*opened.source, options);
    EXPECT_TRUE(bout->steps(50));
    EXPECT_TRUE(soon([&] { return spring() > 0; }));
    const auto before = std::chrono::steady_clock::now();
    bout.reset();
    EXPECT_TRUE(soon([&] { return spring() == 0; }));
    const auto taken = std::chrono::steady_clock::now() - before;
    fastest = std::min(fastest, std::chrono::duration_cast<std::chrono::microseconds>(taken));
  }
  EXPECT_LT(fastest, kSooner);
}

TEST(LiveDuel, WhatTakesNothing_HasNoForce_AndIsReadOn) {
  Stick stick;
  stick.has(EV_FF, FF_CONSTANT).has(EV_FF, FF_RUMBLE).room_for_effects(16);
  stick.refuse_effects(EINVAL);
  const OpenedSource opened = open_source(std::string("device:") + kPath);
  ASSERT_TRUE(opened.source) << opened.error;
  LiveForce* const force = opened.source->force({});
  ASSERT_NE(force, nullptr);
  EXPECT_EQ(force->first_kind(), ForceKind::kNone);
  EXPECT_EQ(force->problem(), "it takes none of its effects (constant, rumble)");
  EXPECT_EQ(force->off(0), Status::kUnavailable);
  InputSample sample;
  EXPECT_TRUE(soon([&] { return opened.source->read(0, sample) == Status::kOk; }));
  std::this_thread::sleep_for(std::chrono::milliseconds(600));
  EXPECT_EQ(stick.openings(), 2);
  EXPECT_EQ(stick.open_files(), 1) << "and is left alone";
}

}  // namespace
}  // namespace batuta::host
