// SPDX-License-Identifier: MIT
// A bout to several touches: exchanges, halts, on guard again, and touches at the same time.
#include <vector>

#include "configured_duel.hpp"

namespace batuta {
using namespace fencing;
namespace {

/// Where a stick is, by the steps since both were on guard.
using Script = Vec2<float> (*)(int);

Vec2<float> guard(int) {
  return {0, 0};
}
/// A lunge of a quarter of a second, after a tenth; then back.
Vec2<float> lunge(int k) {
  if (k > 500) return {0, 0};
  const float share = clamp(static_cast<float>(k - 100) / 250.0F, 0.0F, 1.0F);
  return {-share, share};
}
Vec2<float> late_lunge(int k) {
  return lunge(k - 20);
}

template <class DuelT>
class BoutTo : public test::ConfiguredDuel<DuelT> {
 protected:
  using S = typename test::ConfiguredDuel<DuelT>::ScalarT;
  using test::ConfiguredDuel<DuelT>::duel;

  void to(int touches) {
    this->settings.touches = touches;
    ASSERT_EQ(this->configure(), Status::kOk);
  }
  /// In which two lunges at once touch both: their lines do not cross.
  void of_thrusters_to(int touches) {
    this->settings.touches = touches;
    ASSERT_EQ(this->configure_thrusters(), Status::kOk);
  }
  const Bout<S>& bout() const { return duel->bout(); }

  InputSample sample(Vec2<float> at) const {
    InputSample s;
    s.time = 1000 * duel->steps();
    s.sequence = duel->steps();
    s.x = at.x();
    s.y = at.y();
    return s;
  }
  void step(Vec2<float> left, Vec2<float> right) {
    const InputSample l = sample(left);
    const InputSample r = sample(right);
    ASSERT_EQ(duel->step(&l, &r), Status::kOk);
  }
  /// Until a halt is called or the bout is over; at most 900 steps.
  void exchange(Script left, Script right) {
    step(left(0), right(0));
    ASSERT_FALSE(stands_still());
    for (int k = 1; k < 900 && !stands_still(); ++k) step(left(k), right(k));
    ASSERT_TRUE(stands_still());
  }
  /// With both sticks at the centre, until the next step puts both on guard.
  void halt() {
    while (bout().state == BoutState::kHalt && !bout().is_halt_over()) step({0, 0}, {0, 0});
  }
  bool stands_still() const { return bout().state == BoutState::kHalt || bout().is_over(); }
  std::array<int, 2> score() const { return {bout().score[0], bout().score[1]}; }
};
TYPED_TEST_SUITE(BoutTo, test::Duels);

using Score = std::array<int, 2>;

TYPED_TEST(BoutTo, FiveTouches_AreFiveExchangesOfTheSameBits) {
  this->to(5);
  std::vector<double> first;
  for (std::uint32_t number = 1; number <= 5; ++number) {
    const std::uint32_t start = this->duel->steps();
    this->exchange(lunge, guard);
    EXPECT_EQ(this->bout().exchange, number);
    EXPECT_EQ(this->score(), (Score{static_cast<int>(number), 0}));
    ASSERT_EQ(this->bout().touches.size(), 1);
    const auto& touch = this->bout().touches[0];
    const auto tip = this->duel->blade_W(Side::kRight).axis.b;
    const std::vector<double> seen = {static_cast<double>(touch.when.step - start),
                                      static_cast<double>(touch.when.in_step),
                                      static_cast<double>(touch.contact.point_W.x()),
                                      static_cast<double>(touch.contact.point_W.z()),
                                      static_cast<double>(touch.place),
                                      static_cast<double>(tip.x()),
                                      static_cast<double>(tip.z())};
    if (number == 1) first = seen;
    EXPECT_EQ(seen, first) << "nothing of the exchange before is left";
    this->halt();
  }
  EXPECT_EQ(this->bout().state, BoutState::kTouched);
  EXPECT_EQ(this->duel->step(nullptr, nullptr), Status::kUnavailable);
}

TYPED_TEST(BoutTo, Halt_LastsASecondInWhichNobodyScores) {
  this->to(2);
  this->exchange(guard, lunge);
  ASSERT_EQ(this->bout().state, BoutState::kHalt);
  int steps = 0;
  bool reached = false;
  const float chest = 1.125F - 0.5F;
  while (!this->bout().is_halt_over()) {
    this->step({0, steps > 200 ? 1.0F : 0.0F}, {0, 0});  // too late
    reached = reached || this->duel->blade_W(Side::kLeft).axis.b.x() > chest;
    ++steps;
    ASSERT_EQ(this->bout().state, BoutState::kHalt);
    ASSERT_EQ(this->bout().touches.size(), 1);
  }
  EXPECT_EQ(steps, 1000);
  EXPECT_TRUE(reached) << "or there was nothing to score";
  EXPECT_EQ(this->score(), (Score{0, 1}));
}

TYPED_TEST(BoutTo, AfterTheHalt_BothAreOnGuardAsInTheirFirstStep) {
  this->of_thrusters_to(3);
  this->step({0, 0}, {0, 0});
  std::vector<double> start;
  const auto seen = [this] {
    std::vector<double> all;
    const auto add = [&all](const auto& v) {
      for (int i = 0; i < v.size(); ++i) all.push_back(static_cast<double>(v.data()[i]));
    };
    for (const Side side : {Side::kLeft, Side::kRight}) {
      add(this->duel->blade_W(side).axis.a);
      add(this->duel->blade_W(side).axis.b);
      add(this->duel->hand(side).X_WH.p_W);
      for (const auto& part : this->duel->body_W(side)) add(part.axis.b);
      all.push_back(static_cast<double>(this->duel->grip(side).control()));
    }
    return all;
  };
  const std::vector<double> first = seen();
  this->exchange(lunge, late_lunge);
  this->halt();
  EXPECT_EQ(this->bout().touches.size(), 2) << "they can be seen to the end of the halt";
  this->step({0, 0}, {0, 0});
  EXPECT_EQ(seen(), first);
  EXPECT_EQ(this->bout().state, BoutState::kFencing);
  EXPECT_EQ(this->bout().touches.size(), 0);
  EXPECT_EQ(this->bout().exchange, 2U);
}

// Somebody who goes on lunging through the halt begins at the centre, and no faster than a hand.
TYPED_TEST(BoutTo, HeldStick_ComesFromTheGuard) {
  this->to(2);
  this->exchange(lunge, guard);
  while (!this->bout().is_halt_over()) this->step({0, 1}, {0, 0});
  double last = 0;
  int steps = 0;
  while (last < 1 && steps < 100) {
    this->step({0, 1}, {0, 0});
    const auto at = static_cast<double>(this->duel->stick(Side::kLeft).position().y());
    EXPECT_LE(at - last, 16e-3 + 1e-6);
    EXPECT_GT(at, last);
    last = at;
    ++steps;
  }
  EXPECT_EQ(last, 1);
  EXPECT_GE(steps, 62);
}

// A device that is gone does not carry its lunge into the next exchange.
TYPED_TEST(BoutTo, SilentStick_StaysOnGuard) {
  this->to(2);
  this->exchange(lunge, guard);
  this->step({0, 1}, {0, 0});
  while (!this->bout().is_halt_over()) ASSERT_EQ(this->duel->step(nullptr, nullptr), Status::kOk);
  for (int k = 0; k < 200; ++k) ASSERT_EQ(this->duel->step(nullptr, nullptr), Status::kOk);
  EXPECT_EQ(this->duel->stick(Side::kLeft).position().norm(), 0);
  EXPECT_EQ(this->bout().state, BoutState::kFencing);
}

TYPED_TEST(BoutTo, TwoAtOnce_CountForBoth_UnlessBothWouldWin) {
  this->of_thrusters_to(3);
  const auto both = [this] {
    this->exchange(lunge, late_lunge);
    ASSERT_EQ(this->bout().touches.size(), 2);
  };
  both();
  EXPECT_EQ(this->score(), (Score{1, 1}));
  EXPECT_FALSE(this->bout().annulled);
  this->halt();
  both();
  EXPECT_EQ(this->score(), (Score{2, 2}));
  this->halt();
  both();
  EXPECT_EQ(this->score(), (Score{2, 2})) << "one was missing to either";
  EXPECT_TRUE(this->bout().annulled);
  EXPECT_EQ(this->bout().state, BoutState::kHalt);
  this->halt();
  this->exchange(guard, lunge);
  EXPECT_EQ(this->score(), (Score{2, 3}));
  EXPECT_FALSE(this->bout().annulled);
  EXPECT_EQ(this->bout().exchange, 4U);
  EXPECT_EQ(this->bout().state, BoutState::kTouched);
}

TYPED_TEST(BoutTo, TwoAtOnce_WinForWhoIsAhead) {
  this->of_thrusters_to(2);
  this->exchange(lunge, guard);
  this->halt();
  this->exchange(lunge, late_lunge);
  EXPECT_EQ(this->score(), (Score{2, 1}));
  EXPECT_EQ(this->bout().state, BoutState::kDouble);
  EXPECT_FALSE(this->bout().annulled);
}

TYPED_TEST(BoutTo, NoHalt_GoesOnWithTheNextStep) {
  this->settings.halt_us = 0;
  this->to(2);
  this->exchange(lunge, guard);
  EXPECT_TRUE(this->bout().is_halt_over());
  this->step({0, 0}, {0, 0});
  EXPECT_EQ(this->bout().state, BoutState::kFencing);
  EXPECT_EQ(this->bout().exchange, 2U);
}

/// Two fencers alike who lunge past each other's blades, the right one `delay` steps later.
/// @returns the bout when it is over
template <class DuelT>
std::unique_ptr<DuelT> lunges_apart(int delay, std::int32_t window_us) {
  using S = typename DuelT::SceneType::Scalar;
  auto duel = std::make_unique<DuelT>();
  auto settings = duel_settings<typename DuelT::StatedScene>();
  settings.double_window_us = window_us;
  const Fencer<S> fencer = test::thruster(first_fencer<S>());
  EXPECT_EQ(duel->configure(settings, fencer, fencer), Status::kOk);
  const auto at = [](int now, int k) {
    InputSample s;
    s.time = static_cast<Microseconds>(1000 * now);
    const Vec2<float> stick = lunge(k);
    s.x = stick.x();
    s.y = stick.y();
    return s;
  };
  for (int k = 0; k < 900 && !duel->bout().is_over(); ++k) {
    const InputSample left = at(k, k);
    const InputSample right = at(k, k - delay);
    EXPECT_EQ(duel->step(&left, &right), Status::kOk);
  }
  return duel;
}

// What comes later than the window does not count, to the microsecond. When the second touch comes
// is learnt from a bout with a window of ten seconds.
TYPED_TEST(BoutTo, Window_IsFortyMilliseconds) {
  std::array<bool, 3> seen{};
  for (int delay = 40; delay <= 240; ++delay) {
    const auto patient = lunges_apart<TypeParam>(delay, 10000000);
    ASSERT_EQ(patient->bout().touches.size(), 2) << delay;
    const auto time = [&](int i) { return patient->time_us(patient->bout().touches[i].when); };
    const std::uint64_t apart_us = time(1) - time(0);
    if (apart_us < 38500 || apart_us > 41500) continue;
    const auto strict = lunges_apart<TypeParam>(delay, 40000);
    EXPECT_EQ(strict->bout().state, apart_us <= 40000 ? BoutState::kDouble : BoutState::kTouched)
        << apart_us << " us";
    seen[(apart_us - 38500) / 1000 % 3] = true;
    const auto exact = lunges_apart<TypeParam>(delay, static_cast<std::int32_t>(apart_us));
    EXPECT_EQ(exact->bout().state, BoutState::kDouble);
    const auto short_by_one =
        lunges_apart<TypeParam>(delay, static_cast<std::int32_t>(apart_us) - 1);
    EXPECT_EQ(short_by_one->bout().state, BoutState::kTouched);
  }
  EXPECT_EQ(seen, (std::array<bool, 3>{true, true, true})) << "39, 40 and 41 ms";
}

TYPED_TEST(BoutTo, SettingsOutOfRange_AreRefused) {
  EXPECT_TRUE(this->refuses([](auto& s) { s.touches = 0; }));
  EXPECT_TRUE(this->refuses([](auto& s) { s.touches = kMostTouches + 1; }));
  EXPECT_TRUE(this->refuses([](auto& s) { s.halt_us = -1; }));
  EXPECT_TRUE(this->refuses([](auto& s) { s.halt_us = 10000001; }));
  EXPECT_FALSE(this->refuses([](auto& s) { s.touches = kMostTouches; }));
}

}  // namespace
}  // namespace batuta
