// SPDX-License-Identifier: MIT
// Forces through SDL. Its virtual joystick knows none: a fake takes the place of its functions.
#include <iterator>
#include <limits>
#include <map>
#include <memory>

#include "held_force.hpp"
#include "programs/live/sdl_force.hpp"
#include "virtual_stick.hpp"

namespace batuta::host {
namespace {

using test::Opened;
using test::VirtualStick;

/// What the functions below are asked for.
struct FakeHaptic {
  bool there = false;
  unsigned features = SDL_HAPTIC_CONSTANT | SDL_HAPTIC_GAIN | SDL_HAPTIC_AUTOCENTER;
  int room = 16;
  int axes = 2;
  bool fails = false;
  bool refuses_reruns = false;
  unsigned refused = 0;  ///< types of effects
  std::map<int, SDL_HapticEffect> effects;
  std::map<int, std::int64_t> ends;  ///< of those that play, by its time
  std::map<int, int> runs_of;        ///< each, since it was made
  std::int64_t time_us = 0;
  int runs = 0;
  int made = 0;
  int updates = 0;
  int gain = -1;
  int autocentre = -1;
  bool open = false;
  const char* path = nullptr;  ///< of the stick's file
  void pass(std::int32_t microseconds) {
    time_us += microseconds;
    for (auto end = ends.begin(); end != ends.end();) {
      end = end->second <= time_us ? ends.erase(end) : std::next(end);
    }
  }
  bool plays(int effect) const { return ends.count(effect) == 1; }
};
FakeHaptic haptic;

class LiveSdlForce : public test::LiveSdl {
 protected:
  LiveSdlForce() { haptic = {}; }
};

TEST_F(LiveSdlForce, AForce_IsTwoEffects_OfWhichOnlyTheLevelsChange) {
  haptic.there = true;
  VirtualStick stick("Stick");
  const Opened opened;
  {
    SdlForce force(opened.stick);
    ASSERT_EQ(force.open(), ForceKind::kForce);
    EXPECT_EQ(haptic.gain, 100);
    EXPECT_EQ(haptic.autocentre, 0);
    Feel feel;
    feel.x = 0.5F;
    feel.y = 0.25F;
    ASSERT_EQ(force.render(feel), Rendered::kDone);
    ASSERT_EQ(haptic.effects.size(), 2U);
    const SDL_HapticConstant& right = haptic.effects[0].constant;
    EXPECT_EQ(right.type, SDL_HAPTIC_CONSTANT);
    EXPECT_EQ(right.length, kEffectLength_ms);
    EXPECT_EQ(right.direction.type, SDL_HAPTIC_CARTESIAN);
    EXPECT_EQ(right.direction.dir[0], -1) << "from the west";
    EXPECT_EQ(right.direction.dir[1], 0);
    EXPECT_EQ(right.level, 16384);
    const SDL_HapticConstant& up = haptic.effects[1].constant;
    EXPECT_EQ(up.direction.dir[0], 0);
    EXPECT_EQ(up.direction.dir[1], 1) << "from the south, the user's side";
    EXPECT_EQ(up.level, 8192);
    EXPECT_TRUE(haptic.plays(0) && haptic.plays(1));
    feel.x = -1;
    ASSERT_EQ(force.render(feel), Rendered::kDone);
    EXPECT_EQ(haptic.effects[0].constant.level, -32767);
    EXPECT_EQ(haptic.made, 2);
    haptic.fails = true;
    EXPECT_EQ(force.render(feel), Rendered::kLater) << "it may pass";
    EXPECT_TRUE(haptic.effects.empty()) << "and nothing stays as it was";
    haptic.fails = false;
    EXPECT_EQ(force.render(feel), Rendered::kDone);
    EXPECT_EQ(haptic.effects[0].constant.level, -32767);
    EXPECT_TRUE(haptic.plays(0));
    stick.detach();
    SDL_JoystickUpdate();
    haptic.fails = true;
    EXPECT_EQ(force.render(feel), Rendered::kGone) << "it is not attached any more";
  }
  EXPECT_TRUE(haptic.effects.empty());
  EXPECT_FALSE(haptic.open);
}

TEST_F(LiveSdlForce, TheDirectionOfOneEffect_IsWhereTheForceComesFrom) {
  haptic.there = true;
  haptic.room = 1;
  VirtualStick stick("Stick");
  const Opened opened;
  SdlForce force(opened.stick);
  ASSERT_EQ(force.open(), ForceKind::kForce);
  const struct {
    float x, y;
    int from_x, from_y;
  } golden[] = {{1, 0, -32767, 0},
                {-1, 0, 32767, 0},
                {0, 1, 0, 32767},
                {0, -1, 0, -32767},
                {1, 1, -32767, 32767}};
  for (const auto& push : golden) {
    Feel feel;
    feel.x = push.x;
    feel.y = push.y;
    ASSERT_EQ(force.render(feel), Rendered::kDone);
    EXPECT_EQ(haptic.effects[0].constant.direction.dir[0], push.from_x) << push.x << push.y;
    EXPECT_EQ(haptic.effects[0].constant.direction.dir[1], push.from_y) << push.x << push.y;
    EXPECT_EQ(haptic.effects[0].constant.level, 32767);
  }
}

TEST_F(LiveSdlForce, AWheel_IsPushedToTheRight) {
  haptic.there = true;
  haptic.axes = 1;
  VirtualStick stick("Wheel");
  const Opened opened;
  SdlForce force(opened.stick);
  ASSERT_EQ(force.open(), ForceKind::kForce);
  Feel feel;
  feel.x = 1;
  feel.y = 1;
  ASSERT_EQ(force.render(feel), Rendered::kDone);
  ASSERT_EQ(haptic.effects.size(), 1U);
  EXPECT_EQ(haptic.effects[0].constant.direction.dir[0], -1);
}

TEST_F(LiveSdlForce, SpringAndDamper_AreConditions) {
  haptic.there = true;
  haptic.features |= SDL_HAPTIC_SPRING | SDL_HAPTIC_DAMPER;
  VirtualStick stick("Stick");
  const Opened opened;
  SdlForce force(opened.stick);
  ASSERT_EQ(force.open(), ForceKind::kForce);
  Feel feel;
  feel.spring.coefficient = 0.5F;
  feel.spring.centre_y = 1;
  feel.damper.coefficient = 1;
  ASSERT_EQ(force.render(feel), Rendered::kDone);
  ASSERT_EQ(haptic.effects.size(), 4U);
  const SDL_HapticCondition& spring = haptic.effects[2].condition;
  EXPECT_EQ(spring.type, SDL_HAPTIC_SPRING);
  EXPECT_EQ(spring.right_coeff[0], 16384);
  EXPECT_EQ(spring.left_coeff[1], 16384);
  EXPECT_EQ(spring.center[1], -32767) << "the counts of an axis grow downwards";
  EXPECT_EQ(spring.right_sat[0], 65535);
  EXPECT_EQ(haptic.effects[3].condition.type, SDL_HAPTIC_DAMPER);
  EXPECT_EQ(haptic.effects[3].condition.right_coeff[1], 32767);
}

TEST_F(LiveSdlForce, AStickThatIsReadThroughItsEventDevice_IsTaken) {
  haptic.path = "/dev/null";  // the kernel's number is what counts
  VirtualStick stick("Stick");
  Claim other;
  ASSERT_TRUE(other.take(number_at("/dev/null")));
  const Opened refused;
  EXPECT_FALSE(refused.there);
  EXPECT_EQ(refused.stick->problem(), "Stick is the other fencer's already");
  other.release();
  const Opened opened;
  EXPECT_TRUE(opened.there);
  EXPECT_FALSE(other.take(number_at("/dev/null")));
}

constexpr int kSeconds = 1000;  // turns of the pump

/// A pump on the stick, and haptics whose time goes on.
test::HeldForce held_by(const std::shared_ptr<SdlStick>& stick, const ForceOptions& options = {}) {
  return {std::make_unique<SdlForce>(stick), options,
          [](std::int32_t time_us) { haptic.pass(time_us); }};
}

TEST_F(LiveSdlForce, AHeldForce_NeverDropsOut_AndEndsWhereTheProgramIsStopped) {
  haptic.there = true;
  haptic.features |= SDL_HAPTIC_SPRING | SDL_HAPTIC_DAMPER;
  VirtualStick stick("Stick");
  const Opened opened;
  ForceOptions options;
  options.spring.coefficient = options.damper.coefficient = 0.5F;
  test::HeldForce force = held_by(opened.stick, options);
  EXPECT_EQ(hold(force, 0.5F, -0.25F, 5 * kSeconds, [] { return haptic.ends.size() == 4; }), 0);
  EXPECT_EQ(haptic.effects[0].constant.level, 16384);
  EXPECT_EQ(haptic.made, 4) << "none of them anew";
  haptic.pass(kEffectLength_ms * 1000);
  EXPECT_TRUE(haptic.ends.empty()) << "nobody is there to take it away";
}

TEST_F(LiveSdlForce, AfterAPauseInWhichAllHasEnded_ABlowIsFelt) {
  haptic.there = true;
  VirtualStick stick("Stick");
  const Opened opened;
  test::HeldForce force = held_by(opened.stick);
  for (int blow = 0; blow < 5; ++blow) {
    force.command(0, 0.5F);
    force.pass(ForcePump::kTurn_us);
    force.turn();
    EXPECT_TRUE(haptic.plays(1)) << blow;
    EXPECT_EQ(haptic.effects[1].constant.level, 16384) << blow;
    (void)hold(force, 0, 0, kSeconds, [] { return true; });
    EXPECT_TRUE(haptic.ends.empty()) << "what is zero need not play";
  }
}

TEST_F(LiveSdlForce, EffectsAreRun_OnceMoreEachFiftyMilliseconds_AndNoOftener) {
  haptic.there = true;
  VirtualStick stick("Stick");
  const Opened opened;
  test::HeldForce force = held_by(opened.stick);
  for (int i = 0; i < kSeconds; ++i) {
    force.command(0.001F * static_cast<float>(i), 0);
    force.pass(ForcePump::kTurn_us);
    force.turn();
  }
  EXPECT_LE(haptic.runs, 2 + 2 * 20) << "two effects, twenty times a second";
}

TEST_F(LiveSdlForce, AnEffectThatCannotBeRunAgain_IsMadeAnew) {
  haptic.there = true;
  VirtualStick stick("Stick");
  const Opened opened;
  SdlForce force(opened.stick);
  ASSERT_EQ(force.open(), ForceKind::kForce);
  Feel feel;
  feel.x = 0.5F;
  ASSERT_EQ(force.render(feel), Rendered::kDone);
  haptic.refuses_reruns = true;
  haptic.pass(kEffectLength_ms * 1000);
  force.renew();
  ASSERT_EQ(force.render(feel), Rendered::kDone);
  EXPECT_TRUE(haptic.plays(0) && haptic.plays(1));
  EXPECT_EQ(haptic.effects.size(), 2U);
  EXPECT_EQ(haptic.made, 4);
}

/// Renders until the device has taken it, or has not.
Rendered render(SdlForce& force, const Feel& feel) {
  Rendered rendered = Rendered::kLater;
  for (int i = 0; i < 2 * SdlForce::kMostFailures && rendered == Rendered::kLater; ++i) {
    rendered = force.render(feel);
  }
  return rendered;
}

TEST_F(LiveSdlForce, ASpringThatIsRefused_IsLeftOut_TheForceGoesOn) {
  haptic.there = true;
  haptic.features |= SDL_HAPTIC_SPRING | SDL_HAPTIC_DAMPER;
  haptic.refused = SDL_HAPTIC_SPRING;
  VirtualStick stick("Stick");
  const Opened opened;
  SdlForce force(opened.stick);
  ASSERT_EQ(force.open(), ForceKind::kForce);
  Feel feel;
  feel.x = 0.5F;
  feel.spring.coefficient = 0.5F;
  feel.damper.coefficient = 0.5F;
  ASSERT_EQ(render(force, feel), Rendered::kDone);
  EXPECT_EQ(force.kind(), ForceKind::kForce);
  EXPECT_EQ(names_of(force.left_out()), "spring");
  EXPECT_EQ(haptic.effects.size(), 3U);
  EXPECT_EQ(haptic.effects[0].constant.level, 16384);
  EXPECT_TRUE(haptic.open);
}

TEST_F(LiveSdlForce, FailuresNowAndThen_AreNoRefusal) {
  haptic.there = true;
  VirtualStick stick("Stick");
  const Opened opened;
  SdlForce force(opened.stick);
  ASSERT_EQ(force.open(), ForceKind::kForce);
  Feel feel;
  for (int i = 0; i < 3 * SdlForce::kMostFailures; ++i) {
    haptic.fails = i % 2 == 0;
    feel.x = 0.01F * static_cast<float>(i);
    ASSERT_EQ(force.render(feel), haptic.fails ? Rendered::kLater : Rendered::kDone);
  }
  EXPECT_EQ(force.kind(), ForceKind::kForce);
  EXPECT_EQ(haptic.effects.size(), 2U);
}

TEST_F(LiveSdlForce, AConstantThatIsRefused_BecomesRumble_OrNothing) {
  haptic.there = true;
  haptic.refused = SDL_HAPTIC_CONSTANT;
  Feel feel;
  feel.x = 1;
  {
    VirtualStick stick("Stick");
    const Opened opened;
    SdlForce force(opened.stick);
    ASSERT_EQ(force.open(), ForceKind::kForce);
    ASSERT_EQ(render(force, feel), Rendered::kDone);
    EXPECT_EQ(force.kind(), ForceKind::kRumble);
    EXPECT_EQ(names_of(force.left_out()), "constant");
    EXPECT_EQ(stick.strong, 65535U);
  }
  VirtualStick stick("Stick", SDL_JOYSTICK_TYPE_FLIGHT_STICK, 2, false);
  const Opened opened;
  SdlForce force(opened.stick);
  ASSERT_EQ(force.open(), ForceKind::kForce);
  EXPECT_EQ(render(force, feel), Rendered::kRefused);
  EXPECT_EQ(force.problem(), "it takes none of its effects (constant)");
  EXPECT_TRUE(force.is_there()) << "and is not opened anew for it";
}

}  // namespace
}  // namespace batuta::host

// The linker takes these instead of SDL's.
using batuta::host::haptic;
static SDL_Haptic* const kHandle = reinterpret_cast<SDL_Haptic*>(&haptic);

extern "C" {

const char* SDL_JoystickPath(SDL_Joystick* /*stick*/) {
  return haptic.path;
}
int SDL_JoystickIsHaptic(SDL_Joystick* /*stick*/) {
  return haptic.there ? SDL_TRUE : SDL_FALSE;
}
SDL_Haptic* SDL_HapticOpenFromJoystick(SDL_Joystick* /*stick*/) {
  haptic.open = true;
  return kHandle;
}
void SDL_HapticClose(SDL_Haptic* /*device*/) {
  haptic.open = false;
}
unsigned SDL_HapticQuery(SDL_Haptic* /*device*/) {
  return haptic.features;
}
int SDL_HapticNumEffects(SDL_Haptic* /*device*/) {
  return haptic.room;
}
int SDL_HapticNumAxes(SDL_Haptic* /*device*/) {
  return haptic.axes;
}
int SDL_HapticSetGain(SDL_Haptic* /*device*/, int gain) {
  haptic.gain = gain;
  return 0;
}
int SDL_HapticSetAutocenter(SDL_Haptic* /*device*/, int autocentre) {
  haptic.autocentre = autocentre;
  return 0;
}
int SDL_HapticNewEffect(SDL_Haptic* /*device*/, SDL_HapticEffect* effect) {
  if (haptic.fails || (haptic.refused & effect->type) != 0) return -1;
  if (static_cast<int>(haptic.effects.size()) >= haptic.room) return -1;
  int id = 0;
  while (haptic.effects.count(id) != 0) ++id;
  haptic.effects[id] = *effect;
  ++haptic.made;
  return id;
}
int SDL_HapticUpdateEffect(SDL_Haptic* /*device*/, int id, SDL_HapticEffect* effect) {
  if (haptic.fails || haptic.effects.count(id) == 0) return -1;
  haptic.effects[id] = *effect;
  ++haptic.updates;
  return 0;
}
int SDL_HapticRunEffect(SDL_Haptic* /*device*/, int id, Uint32 iterations) {
  const auto found = haptic.effects.find(id);
  if (haptic.fails || found == haptic.effects.end()) return -1;
  if (haptic.refuses_reruns && haptic.runs_of[id] > 0) return -1;
  ++haptic.runs_of[id];
  constexpr std::int64_t kNever = std::numeric_limits<std::int64_t>::max();
  const bool constant = found->second.type == SDL_HAPTIC_CONSTANT;
  const Uint32 length_ms =
      constant ? found->second.constant.length : found->second.condition.length;
  const std::int64_t once_us = std::int64_t{length_ms} * 1000;
  haptic.ends[id] =
      length_ms == SDL_HAPTIC_INFINITY ? kNever : haptic.time_us + iterations * once_us;
  ++haptic.runs;
  return 0;
}
void SDL_HapticDestroyEffect(SDL_Haptic* /*device*/, int id) {
  haptic.effects.erase(id);
  haptic.ends.erase(id);
  haptic.runs_of.erase(id);
}
}
