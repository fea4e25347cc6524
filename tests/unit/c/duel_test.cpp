// SPDX-License-Identifier: MIT
// The duel for C against the library's duel with the same sticks, to the bit.

#include "batuta/fencing/duel.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>

#include "batuta/c/duel.h"
#include "batuta/haptics/stepped_bout.hpp"
#include "batuta/record/duel.hpp"
#include "heap_trap.hpp"

namespace batuta {
using namespace fencing;
namespace {

constexpr std::int32_t kStepUs = 1000;

/// A lunge of the left fencer, who then holds it; the right one sways and steps back.
batuta_stick left_at(int k) {
  const float share = clamp(static_cast<float>(k - 100) / 250.0F, 0.0F, 1.0F);
  return {-share, share, 0, k > 300 ? 1.0F : 0.0F};
}
batuta_stick right_at(int k) {
  const float t = static_cast<float>(k);
  return {0.8F * std::sin(6e-3F * t), 0.1F, 0, k < 200 ? -0.5F : 0.0F};
}

class DuelForC : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(batuta_duel_init(duel.get(), sizeof *duel, kStepUs, 2), BATUTA_OK);
    auto settings = duel_settings<>();
    settings.step_us = kStepUs;
    settings.touches = 2;
    ASSERT_EQ(own->configure(settings, first_fencer<float>(), second_fencer<float>()), Status::kOk);
  }
  InputSample sample(const batuta_stick& stick, std::uint32_t sequence, int k) const {
    InputSample made;
    made.time = static_cast<Microseconds>(k) * Microseconds{kStepUs};
    made.x = stick.x;
    made.y = stick.y;
    made.feet_x = stick.feet_x;
    made.feet_y = stick.feet_y;
    made.sequence = sequence;
    return made;
  }
  /// Step k of both: samples of the left stick each 10 steps, of the right one each 7.
  void step(int k) {
    const batuta_stick left = left_at(k % 1500);
    const batuta_stick right = right_at(k % 1500);
    const auto number = static_cast<std::uint32_t>(k);
    const InputSample l = sample(left, number / 10U, k);
    const InputSample r = sample(right, number / 7U, k);
    const bool left_came = k % 10 == 0;
    const bool right_came = k % 7 == 0;
    ASSERT_EQ(
        batuta_duel_step(duel.get(), left_came ? &left : nullptr, right_came ? &right : nullptr),
        BATUTA_OK);
    ASSERT_EQ(own->step(left_came ? &l : nullptr, right_came ? &r : nullptr), Status::kOk);
  }
  std::uint64_t hash() const {
    std::uint64_t told = 0;
    EXPECT_EQ(batuta_duel_hash(duel.get(), &told), BATUTA_OK);
    return told;
  }
  batuta_duel_state state() const {
    batuta_duel_state told;
    EXPECT_EQ(batuta_duel_get_state(duel.get(), &told), BATUTA_OK);
    return told;
  }
  void run_to_the_end() {
    for (int k = 0; k < 20000 && !own->bout().is_over(); ++k) {
      ASSERT_NO_FATAL_FAILURE(step(k));
      ASSERT_EQ(hash(), hash_of(*own)) << "step " << k;
    }
    ASSERT_TRUE(own->bout().is_over());
  }

  std::unique_ptr<batuta_duel> duel = std::make_unique<batuta_duel>();
  std::unique_ptr<Duel<>> own = std::make_unique<Duel<>>();
};

void expect_capsule(const float* told, const Capsule<float>& own) {
  EXPECT_EQ(Vec3<float>(told), own.axis.a);
  EXPECT_EQ(Vec3<float>(told + 3), own.axis.b);
  EXPECT_EQ(told[6], own.radius);
}

void expect_same(const batuta_duel_state& told, const Duel<>& own) {
  EXPECT_EQ(told.steps, own.steps());
  EXPECT_EQ(told.bout, static_cast<int>(own.bout().state));
  EXPECT_EQ(told.exchange, static_cast<int>(own.bout().exchange));
  EXPECT_EQ(told.annulled == 1, own.bout().annulled);
  EXPECT_EQ(told.gap, capsule_gap(own.blade_W(Side::kLeft), own.blade_W(Side::kRight)).gap);
  ASSERT_EQ(told.touches, own.bout().touches.size());
  for (int i = 0; i < told.touches; ++i) {
    const auto& touch = own.bout().touches[i];
    EXPECT_EQ(told.touch[i].by, touch.by == Side::kLeft ? 0 : 1);
    EXPECT_EQ(told.touch[i].part, static_cast<int>(touch.part));
    EXPECT_EQ(told.touch[i].time_us, own.time_us(touch.when));
    EXPECT_EQ(Vec3<float>(told.touch[i].point_W), touch.contact.point_W);
  }
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const int i = side == Side::kLeft ? 0 : 1;
    EXPECT_EQ(told.score[i], own.bout().score[index_of(side)]);
    EXPECT_EQ(told.stick[i][0], own.stick(side).position().x());
    EXPECT_EQ(told.stick[i][1], own.stick(side).position().y());
    EXPECT_EQ(told.control[i], own.grip(side).control());
    expect_capsule(told.blade_W[i], own.blade_W(side));
    const auto& body = own.body_W(side);
    for (std::size_t part = 0; part < body.size(); ++part) {
      expect_capsule(told.body_W[i][part], body[part]);
    }
  }
}

TEST_F(DuelForC, ABoutToTwoTouches_HasTheBitsOfTheLibrarysDuel) {
  expect_same(state(), *own);
  for (int k = 0; k < 200; ++k) ASSERT_NO_FATAL_FAILURE(step(k));
  expect_same(state(), *own);
}

TEST_F(DuelForC, ABoutToItsEnd_ThenItIsUnavailableAndChangesNothing) {
  ASSERT_NO_FATAL_FAILURE(run_to_the_end());
  expect_same(state(), *own);
  EXPECT_GE(state().touches, 1);
  const auto before = hash();
  const batuta_stick stick = {1, 1, 0, 0};
  EXPECT_EQ(batuta_duel_step(duel.get(), &stick, &stick), BATUTA_UNAVAILABLE);
  EXPECT_EQ(hash(), before);
}

TEST_F(DuelForC, InitOfAnEndedBout_BeginsAsTheFirstOneDid) {
  const auto first = hash();
  ASSERT_NO_FATAL_FAILURE(run_to_the_end());
  ASSERT_EQ(batuta_duel_init(duel.get(), sizeof *duel, kStepUs, 2), BATUTA_OK);
  EXPECT_EQ(hash(), first);
}

/// As a device sends them: its own clock, buttons, and now and then a sample that got lost.
batuta_sample sampled(const batuta_stick& stick, int k) {
  const auto number = static_cast<std::uint32_t>(k);
  return {stick, 7 + number * 1000U + number % 3U * 200U, number % 4U, number + number / 50U};
}
InputSample own_sample(const batuta_sample& sample) {
  return {sample.time_us,      sample.stick.x, sample.stick.y, sample.stick.feet_x,
          sample.stick.feet_y, sample.buttons, sample.sequence};
}

TEST_F(DuelForC, SamplesOfADevice_HaveTheBitsAndTheForcesOfTheLibrarysBout) {
  const auto bout = std::make_unique<haptics::SteppedBout>();
  haptics::BoutSettings settings;
  settings.touches = 2;
  ASSERT_EQ(bout->start(settings), Status::kOk);
  float most = 0;
  for (int k = 0; k < 1200 && !bout->is_over(); ++k) {
    const batuta_sample left = sampled(left_at(k), k);
    const batuta_sample right = sampled(right_at(k), k);
    const InputSample l = own_sample(left);
    const InputSample r = own_sample(right);
    ASSERT_EQ(batuta_duel_step_sampled(duel.get(), &left, k % 2 == 0 ? &right : nullptr),
              BATUTA_OK);
    ASSERT_EQ(bout->step(&l, k % 2 == 0 ? &r : nullptr), Status::kOk);
    ASSERT_EQ(hash(), hash_of(bout->duel())) << "step " << k;
    const batuta_duel_state told = state();
    for (const Side side : {Side::kLeft, Side::kRight}) {
      const Vec2<float>& share = bout->forces().of(side).share;
      ASSERT_EQ(Vec2<float>(told.force[index_of(side)]), share);
      most = std::max(most, share.cwiseAbs().maxCoeff());
    }
  }
  EXPECT_GT(most, 0) << "nothing was felt";
}

/// A stick that goes up the middle again and again: the blades meet.
batuta_stick swept(int k) {
  return {0, 0.5F * static_cast<float>(k % 200) / 200.0F, 0, k < 100 ? 0.25F : 0.0F};
}

TEST_F(DuelForC, FeetAndBlows_AreThoseOfTheLibrary) {
  int blows = 0;
  for (int k = 0; k < 600; ++k) {
    const batuta_stick left = swept(k);
    const InputSample l = sample(left, static_cast<std::uint32_t>(k), k);
    ASSERT_EQ(batuta_duel_step(duel.get(), &left, nullptr), BATUTA_OK);
    ASSERT_EQ(own->step(&l, nullptr), Status::kOk);
    const batuta_duel_state told = state();
    int count = 0;
    float impulse = 0;
    for (const auto& event : own->world().events()) {
      if (event.kind == EventKind::kEnd) continue;
      ++count;
      impulse += event.impulse;
      EXPECT_EQ(Vec3<float>(told.blow_W), event.contact.point_W);
    }
    EXPECT_EQ(told.blows, count);
    EXPECT_EQ(told.impulse, impulse);
    if (impulse > 0) ++blows;
    for (const Side side : {Side::kLeft, Side::kRight}) {
      EXPECT_EQ(told.place[index_of(side)], own->X_WF(side).p_W.x());
      EXPECT_EQ(told.feet[index_of(side)], own->stick(side).feet().y());
    }
  }
  EXPECT_GT(blows, 0) << "the blades never met";
}

TEST_F(DuelForC, AnotherDistance_IsThatOfTheLibrary_AndOnlyBeforeTheFirstStep) {
  auto settings = duel_settings<>();
  settings.touches = 2;
  settings.salle.distance = 4;
  const auto apart = std::make_unique<Duel<>>();
  ASSERT_EQ(apart->configure(settings, first_fencer<float>(), second_fencer<float>()), Status::kOk);
  ASSERT_EQ(batuta_duel_set_distance(duel.get(), 4), BATUTA_OK);
  EXPECT_EQ(hash(), hash_of(*apart));
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  for (const float bad : {0.0F, -1.0F, 1e30F, kInfinity, std::numeric_limits<float>::quiet_NaN()}) {
    EXPECT_EQ(batuta_duel_set_distance(duel.get(), bad), BATUTA_INVALID_ARGUMENT);
    EXPECT_EQ(hash(), hash_of(*apart));
  }
  ASSERT_EQ(batuta_duel_step(duel.get(), nullptr, nullptr), BATUTA_OK);
  EXPECT_EQ(batuta_duel_set_distance(duel.get(), 4), BATUTA_UNAVAILABLE);
}

TEST_F(DuelForC, LengthsOfAStep_AreThoseOfTheLibrary) {
  for (const std::int32_t step_us : {BATUTA_SHORTEST_STEP_US, BATUTA_LONGEST_STEP_US}) {
    EXPECT_EQ(batuta_duel_init(duel.get(), sizeof *duel, step_us, BATUTA_MOST_TOUCHES), BATUTA_OK);
  }
  auto settings = duel_settings<>();
  for (const std::int32_t step_us : {BATUTA_SHORTEST_STEP_US - 1, BATUTA_LONGEST_STEP_US + 1}) {
    settings.step_us = step_us;
    EXPECT_EQ(own->configure(settings, first_fencer<float>(), second_fencer<float>()),
              Status::kInvalidArgument);
  }
}

TEST_F(DuelForC, Storage_IsFilledAndAllocatesNothing) {
  EXPECT_LE(batuta_duel_size(), std::size_t{BATUTA_DUEL_BYTES});
  EXPECT_EQ(alignof(batuta_duel) % batuta_duel_align(), 0U);
  const test::HeapTrap trap;
  ASSERT_EQ(batuta_duel_init(duel.get(), batuta_duel_size(), kStepUs, 5), BATUTA_OK);
  const batuta_stick stick = {0.5F, 0.5F, 0, 0};
  ASSERT_EQ(batuta_duel_step(duel.get(), &stick, nullptr), BATUTA_OK);
  EXPECT_EQ(trap.allocations(), 0);
}

}  // namespace
}  // namespace batuta
