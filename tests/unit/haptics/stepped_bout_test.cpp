// SPDX-License-Identifier: MIT
#include "batuta/haptics/stepped_bout.hpp"

#include <gtest/gtest.h>

#include <memory>

namespace batuta::haptics {
using namespace fencing;
namespace {

/// A stick that goes up the middle again and again: blades meet.
InputSample swept(std::uint32_t step) {
  InputSample sample;
  sample.time = step * 1000;
  sample.sequence = step;
  sample.y = 0.5F * static_cast<float>(step % 200) / 200.0F;
  return sample;
}

void make_steps(SteppedBout& bout, std::uint32_t count) {
  for (std::uint32_t i = 0; i < count; ++i) {
    const InputSample left = swept(bout.steps());
    ASSERT_EQ(bout.step(&left, nullptr), Status::kOk);
  }
}

void expect_same(const SteppedBout& a, const SteppedBout& b) {
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const Capsule<float> blade_a = a.duel().blade_W(side);
    const Capsule<float> blade_b = b.duel().blade_W(side);
    ASSERT_EQ(blade_a.axis.a, blade_b.axis.a);
    ASSERT_EQ(blade_a.axis.b, blade_b.axis.b);
    ASSERT_EQ(a.forces().of(side).share, b.forces().of(side).share);
  }
  ASSERT_EQ(a.duel().world().report().evaluations, b.duel().world().report().evaluations);
}

// Whoever is put on guard is elsewhere within a step. No hand feels that.
TEST(SteppedBout, AfterAHalt_NobodyFeelsThatHeIsPutOnGuard) {
  SteppedBout bout;
  BoutSettings settings;
  settings.touches = 2;
  ASSERT_EQ(bout.start(settings), Status::kOk);
  while (!bout.duel().bout().is_halt_over()) {
    ASSERT_LT(bout.steps(), 3000U);
    InputSample lunge = swept(bout.steps());
    lunge.y = std::min(1.0F, 0.01F * static_cast<float>(bout.steps()));
    lunge.x = -lunge.y;
    ASSERT_EQ(bout.step(&lunge, nullptr), Status::kOk);
  }
  InputSample held = swept(bout.steps());
  held.x = -1;
  held.y = 1;
  ASSERT_EQ(bout.step(&held, nullptr), Status::kOk);
  EXPECT_EQ(bout.duel().bout().exchange, 2U);
  for (const Side side : {Side::kLeft, Side::kRight}) {
    EXPECT_EQ(bout.forces().of(side).demanded.norm(), 0.0F);
  }
}

TEST(SteppedBout, AnotherBout_IsLikeTheFirstOne_ToTheLastBit) {
  for (const std::uint32_t before : {1U, 7U, 150U, 400U}) {
    auto again = std::make_unique<SteppedBout>();
    auto first = std::make_unique<SteppedBout>();
    ASSERT_EQ(again->start({}), Status::kOk);
    make_steps(*again, before);
    ASSERT_EQ(again->start({}), Status::kOk);
    ASSERT_EQ(first->start({}), Status::kOk);
    EXPECT_EQ(again->steps(), 0U);
    int blows = 0;
    for (int i = 0; i < 300; ++i) {
      make_steps(*again, 1);
      make_steps(*first, 1);
      expect_same(*again, *first);
      blows += first->duel().world().events().size();
      if (::testing::Test::HasFatalFailure()) return;
    }
    EXPECT_GT(blows, 0);
  }
}

TEST(SteppedBout, RemembersTheSamplesOfItsLastStep) {
  SteppedBout bout;
  ASSERT_EQ(bout.start({}), Status::kOk);
  EXPECT_EQ(bout.used(Side::kLeft), nullptr);
  const InputSample left = swept(50);
  ASSERT_EQ(bout.step(&left, nullptr), Status::kOk);
  ASSERT_NE(bout.used(Side::kLeft), nullptr);
  EXPECT_EQ(bout.used(Side::kLeft)->x, left.x);
  EXPECT_EQ(bout.used(Side::kRight), nullptr);
  ASSERT_EQ(bout.step(nullptr, nullptr), Status::kOk);
  EXPECT_EQ(bout.used(Side::kLeft), nullptr);
}

/// A driver that hangs hands out its last sample for ever; nobody holds the stick that it tells of.
TEST(SteppedBout, SamplesThatTheStickDoesNotBelieve_AreSilence) {
  constexpr std::uint32_t kLonger = 200;  // steps: than silence and its ramp
  for (const std::uint32_t back_us : {0U, 1000U}) {
    SteppedBout bout;
    ASSERT_EQ(bout.start({}), Status::kOk);
    make_steps(bout, kLonger);
    ASSERT_TRUE(bout.is_alive(Side::kLeft));
    ASSERT_EQ(bout.forces().of(Side::kLeft).allowed, 1);
    InputSample stuck = swept(bout.steps() - 1);
    for (std::uint32_t i = 0; i < kLonger; ++i) {
      stuck.time -= back_us;
      ASSERT_EQ(bout.step(&stuck, nullptr), Status::kOk);
      ASSERT_FALSE(bout.is_alive(Side::kLeft));
    }
    EXPECT_NE(bout.used(Side::kLeft), nullptr) << "a host needs it for the same bits";
    EXPECT_TRUE(bout.forces().of(Side::kLeft).silent);
    EXPECT_EQ(bout.forces().of(Side::kLeft).allowed, 0);
  }
}

TEST(SteppedBout, NotStarted_MakesNoStep) {
  SteppedBout bout;
  EXPECT_EQ(bout.step(nullptr, nullptr), Status::kInvalidArgument);
  EXPECT_EQ(bout.steps(), 0U);
}

TEST(SteppedBout, BadForceSettings_LeaveTheBoutAlone) {
  SteppedBout bout;
  ASSERT_EQ(bout.start({}), Status::kOk);
  make_steps(bout, 3);
  BoutSettings bad;
  bad.force.full_scale = 0;
  EXPECT_EQ(bout.start(bad), Status::kInvalidArgument);
  EXPECT_EQ(bout.steps(), 3U);
}

// A range ten times as large takes a tenth of it for the same demand, also after a state was put
// in.
TEST(SteppedBout, Restored_HasTheForcesThatItIsTold) {
  SteppedBout bout;
  BoutSettings settings;
  ASSERT_EQ(bout.start(settings), Status::kOk);
  const auto put = [&settings](Duel<>& duel) {
    auto fresh = duel_settings();
    fresh.touches = settings.touches;
    return duel.configure(fresh, first_fencer<float>(), second_fencer<float>()) == Status::kOk;
  };
  const auto largest = [&bout] {
    float most = 0;
    for (int i = 0; i < 300; ++i) {
      make_steps(bout, 1);
      for (const Side side : {Side::kLeft, Side::kRight}) {
        most = std::max(most, bout.forces().of(side).share.cwiseAbs().maxCoeff());
      }
    }
    return most;
  };
  ForceSettings force;
  ASSERT_EQ(bout.restore(force, put), Status::kOk);
  const float usual = largest();
  force.full_scale *= 10;
  ASSERT_EQ(bout.restore(force, put), Status::kOk);
  const float scaled = largest();
  EXPECT_GT(usual, 0.01F);
  EXPECT_LT(scaled, usual / 5);
  force.full_scale = -1;
  bool is_called = false;
  EXPECT_EQ(bout.restore(force, [&is_called](Duel<>&) { return is_called = true; }),
            Status::kInvalidArgument);
  EXPECT_FALSE(is_called);
}

}  // namespace
}  // namespace batuta::haptics
