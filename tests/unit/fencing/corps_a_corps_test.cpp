// SPDX-License-Identifier: MIT
// Two who stand body to body for long are sent on guard. When that is due follows from how far
// apart the fencers are seen to stand, step by step.
#include <vector>

#include "batuta/record/duel.hpp"
#include "batuta/record/snapshot.hpp"
#include "configured_duel.hpp"

namespace batuta {
using namespace fencing;
namespace {

constexpr int kSteps = 3000;
constexpr std::int32_t kTime_us = 300000;

/// Where both feet go, by the step.
struct Feet {
  float left = 0;
  float right = 0;
};
Feet both_press(int) {
  return {1, 1};
}
Feet left_presses(int) {
  return {1, 0};
}
/// The right one gives way for 100 ms, some 200 ms after both stand close.
Feet right_gives_way_once(int k) {
  if (k >= 500 && k < 600) return {0, -1};
  return {1, 1};
}

template <class DuelT>
class CorpsACorps : public test::ConfiguredDuel<DuelT> {
 protected:
  using Num = typename test::ConfiguredDuel<DuelT>::ScalarT;
  using test::ConfiguredDuel<DuelT>::duel;

  void SetUp() override {
    this->settings.touches = 2;
    this->settings.target = 0;  // nobody can be touched
    this->settings.halt_us = 50000;
    this->settings.strip.corps_a_corps_us = kTime_us;
    ASSERT_EQ(this->configure(), Status::kOk);
  }
  static void step(DuelT& duel, const Feet& feet) {
    InputSample left;
    left.time = 1000 * duel.steps();
    left.sequence = duel.steps();
    InputSample right = left;
    left.feet_y = feet.left;
    right.feet_y = feet.right;
    ASSERT_EQ(duel.step(&left, &right), Status::kOk);
  }
  static double distance(const DuelT& duel) {
    return static_cast<double>(duel.X_WF(Side::kRight).p_W.x() - duel.X_WF(Side::kLeft).p_W.x());
  }
  bool is_halt() const { return duel->bout().state == BoutState::kHalt; }

  /// Steps to the first halt, kSteps where there is none, and in `due` those after which both had
  /// stood within 5 cm of the least distance for `for_steps` on end.
  int steps_to_halt(Feet (*feet)(int), int for_steps, int& due) {
    int close = 0;
    due = kSteps;
    for (int k = 0; k < kSteps; ++k) {
      step(*duel, feet(k));
      const double beyond = distance(*duel) - static_cast<double>(Strip<Num>().least_distance);
      close = beyond <= 0.05 ? close + 1 : 0;
      if (close == for_steps && due == kSteps) due = k + 1;
      if (is_halt()) return k + 1;
    }
    return kSteps;
  }
};
TYPED_TEST_SUITE(CorpsACorps, test::Duels);

TYPED_TEST(CorpsACorps, WhoStandBodyToBody_AreHalted) {
  for (const auto feet : {both_press, left_presses, right_gives_way_once}) {
    ASSERT_EQ(this->configure(), Status::kOk);
    int due = 0;
    const int halted = this->steps_to_halt(feet, kTime_us / 1000, due);
    ASSERT_LT(due, kSteps);
    EXPECT_EQ(halted, due);
    EXPECT_TRUE(this->duel->bout().is_corps_a_corps());
    EXPECT_EQ(this->duel->bout().touches.size(), 0);
  }
}

TYPED_TEST(CorpsACorps, WhoGivesWay_BeginsAnew) {
  int due = 0;
  const int pressed = this->steps_to_halt(both_press, kTime_us / 1000, due);
  ASSERT_EQ(this->configure(), Status::kOk);
  const int given_way = this->steps_to_halt(right_gives_way_once, kTime_us / 1000, due);
  EXPECT_LT(pressed, 600 + kTime_us / 1000);
  EXPECT_GT(given_way, 600 + kTime_us / 1000) << "300 ms from the time when they are close again";
}

TYPED_TEST(CorpsACorps, AfterIt_BothAreOnGuardAgain_AndNoScoreHasChanged) {
  int due = 0;
  (void)this->steps_to_halt(both_press, kTime_us / 1000, due);
  ASSERT_TRUE(this->is_halt());
  for (int k = 0; k < 51; ++k) this->step(*this->duel, {});
  const auto& bout = this->duel->bout();
  EXPECT_EQ(bout.state, BoutState::kFencing);
  EXPECT_EQ(bout.exchange, 2U);
  EXPECT_EQ(bout.score, (std::array<std::uint8_t, 2>{0, 0}));
  EXPECT_FALSE(bout.is_corps_a_corps());
  EXPECT_EQ(this->distance(*this->duel), 2.25);
  const int second = this->steps_to_halt(both_press, kTime_us / 1000, due);
  EXPECT_EQ(second, due) << "counted from nothing";
}

/// On guard they stand as near as they may: each exchange has all of the time.
TYPED_TEST(CorpsACorps, OnGuardBodyToBody_EachExchangeHasAllOfTheTime) {
  this->settings.salle.distance = typename TestFixture::Num(1.52F);
  ASSERT_EQ(this->configure(), Status::kOk);
  for (int exchange = 0; exchange < 2; ++exchange) {
    int due = 0;
    EXPECT_EQ(this->steps_to_halt(both_press, kTime_us / 1000, due), kTime_us / 1000);
    while (!this->duel->bout().is_halt_over()) this->step(*this->duel, {});  // Bound: 50
  }
}

TYPED_TEST(CorpsACorps, Never_IsNever) {
  this->settings.strip.corps_a_corps_us = 0;
  ASSERT_EQ(this->configure(), Status::kOk);
  int due = 0;
  EXPECT_EQ(this->steps_to_halt(both_press, 1, due), kSteps);
  EXPECT_LT(due, kSteps);
}

/// Also after more steps than a test can make.
TYPED_TEST(CorpsACorps, Never_IsNever_WhateverWasCounted) {
  this->settings.strip.corps_a_corps_us = 0;
  this->settings.salle.distance = 1;
  Footwork<typename TestFixture::Num> feet;
  for (const std::uint32_t counted : {0U, 1U, 0x7FFFFFFFU, 0xFFFFFFFEU, 0xFFFFFFFFU}) {
    feet.close_steps = counted;
    EXPECT_EQ(feet.is_footing_sound(this->settings), counted == 0) << counted;
    for (int k = 0; k < 3; ++k) EXPECT_FALSE(feet.count_body_to_body(this->settings)) << counted;
  }
}

/// The step of a touch is not that of a corps a corps: the touch counts.
TYPED_TEST(CorpsACorps, ATouch_IsATouch) {
  this->settings.target = kAllParts;
  this->settings.strip.corps_a_corps_us = 10000000;
  ASSERT_EQ(this->configure_thrusters(), Status::kOk);
  for (int k = 0; k < kSteps && !this->is_halt(); ++k) {
    InputSample left;
    left.time = 1000 * this->duel->steps();
    left.sequence = this->duel->steps();
    left.y = clamp(static_cast<float>(k - 100) / 250, 0.0F, 1.0F);
    left.feet_y = 1;
    ASSERT_EQ(this->duel->step(&left, nullptr), Status::kOk);
  }
  ASSERT_TRUE(this->is_halt());
  EXPECT_FALSE(this->duel->bout().is_corps_a_corps());
  EXPECT_EQ(this->duel->bout().score[0], 1);
}

TYPED_TEST(CorpsACorps, SavedOnTheWay_IsHaltedInTheSameStep) {
  int due = 0;
  const int halted = this->steps_to_halt(both_press, kTime_us / 1000, due);
  ASSERT_EQ(this->configure(), Status::kOk);
  for (int k = 0; k < halted - 100; ++k) this->step(*this->duel, both_press(k));
  std::vector<std::uint8_t> bytes(kSnapshotRoom<TypeParam>);
  const Result<int> size = save(*this->duel, bytes.data(), static_cast<int>(bytes.size()));
  ASSERT_TRUE(size.ok());
  auto other = std::make_unique<TypeParam>();
  ASSERT_EQ(restore(*other, bytes.data(), size.value), Restored::kOk);
  for (int k = 0; k < 100; ++k) {
    EXPECT_EQ(other->bout().state, BoutState::kFencing) << k;
    this->step(*other, both_press(k));
  }
  EXPECT_TRUE(other->bout().is_corps_a_corps());
}

TYPED_TEST(CorpsACorps, SettingsOutOfRange_AreRefused) {
  EXPECT_TRUE(this->refuses([](auto& s) { s.strip.corps_a_corps_us = -1; }));
  EXPECT_TRUE(this->refuses([](auto& s) { s.strip.corps_a_corps_us = 10000001; }));
  EXPECT_FALSE(this->refuses([](auto& s) { s.strip.corps_a_corps_us = 10000000; }));
}

}  // namespace
}  // namespace batuta
