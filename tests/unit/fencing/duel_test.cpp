// SPDX-License-Identifier: MIT
#include "configured_duel.hpp"

#include <cstring>
#include <vector>

namespace batuta {
using namespace fencing;
namespace {

/// Where a stick is, by the number of the step.
using Script = Vec2<double> (*)(int);

Vec2<double> guard(int) {
  return {0, 0};
}
Vec2<double> lunge(int k) {
  const double share = clamp((k - 100) / 250.0, 0.0, 1.0);
  return {-share, share};
}
Vec2<double> late_lunge(int k) {
  return lunge(k - 20);
}
Vec2<double> very_late_lunge(int k) {
  return lunge(k - 240);
}
/// The arm goes out into the high inside line.
Vec2<double> extend(int k) {
  const double share = clamp(k / 100.0, 0.0, 1.0);
  return {-0.5 * share, 0.5 * share};
}
Vec2<double> quarte(int k) {
  return {-clamp((k - 100) / 100.0, 0.0, 1.0), 0};
}
Vec2<double> sway(int k) {
  return {0.8 * std::sin(6e-3 * k), 0.1 + 0.1 * std::sin(3.1e-3 * k)};
}
Vec2<double> counter_sway(int k) {
  return {0.9 * std::sin(7.7e-3 * k + 1), 0.1 + 0.1 * std::sin(4.1e-3 * k)};
}
Vec2<double> hacking(int k) {
  return {std::sin(37e-3 * k) > 0 ? 1.0 : -1.0, 0.0};
}

InputSample sample_of(Script script, int k) {
  InputSample s;
  s.time = static_cast<Microseconds>(k) * 1000U;
  s.sequence = static_cast<std::uint32_t>(k) / 10U;
  s.x = static_cast<float>(script(k).x());
  s.y = static_cast<float>(script(k).y());
  return s;
}

template <class DuelT>
class DuelOf : public test::ConfiguredDuel<DuelT> {
 protected:
  using ScalarT = typename DuelT::SceneType::Scalar;
  using test::ConfiguredDuel<DuelT>::duel;
  double least_gap = 1e9;

  /// A sample each 10 ms, a step each 1 ms.
  void run(Script left, Script right, int steps) {
    for (int k = 0; k < steps && !duel->bout().is_over(); ++k) {
      const InputSample l = sample(left, k);
      const InputSample r = sample(right, k);
      const bool fresh = k % 10 == 0;
      ASSERT_EQ(duel->step(fresh ? &l : nullptr, fresh ? &r : nullptr), Status::kOk);
      const double gap = static_cast<double>(
          capsule_gap(duel->blade_W(Side::kLeft), duel->blade_W(Side::kRight)).gap);
      least_gap = std::min(least_gap, gap);
    }
  }
  static InputSample sample(Script script, int k) { return sample_of(script, k); }
  const Bout<ScalarT>& bout() const { return duel->bout(); }
  double touch_time(int i) const {
    return static_cast<double>(duel->time_us(bout().touches[i].when)) * 1e-6;
  }
};
TYPED_TEST_SUITE(DuelOf, test::Duels);

/// How far a blade may be in the other one where it has been turned back, m: the margin of lengths
/// of 3 m (src/world/detail/margin.md).
template <class S>
constexpr double kTurnedBack = std::is_same_v<S, float> ? 7e-5 : 1e-5;

/// What only the paper's search has.
template <class DuelT>
class PaperDuelOf : public DuelOf<DuelT> {};
TYPED_TEST_SUITE(PaperDuelOf, test::PaperDuels);

TYPED_TEST(DuelOf, BothOnGuard_NothingHappens) {
  this->run(guard, guard, 2000);
  EXPECT_EQ(this->bout().state, BoutState::kFencing);
  EXPECT_EQ(this->duel->steps(), 2000U);
  EXPECT_EQ(this->duel->report().blows, 0U);
  EXPECT_EQ(this->duel->report().incomplete_steps, 0U);
}

TYPED_TEST(DuelOf, LungeAgainstGuard_TouchesTheTorso) {
  using S = typename TestFixture::ScalarT;
  this->run(lunge, guard, 1000);
  ASSERT_EQ(this->bout().state, BoutState::kTouched);
  ASSERT_EQ(this->bout().touches.size(), 1);
  const auto& touch = this->bout().touches[0];
  EXPECT_EQ(touch.by, Side::kLeft);
  EXPECT_EQ(touch.part, BodyPart::kTorso);
  EXPECT_TRUE(touch.certain);
  EXPECT_GT(touch.place, S(0.99));
  EXPECT_LT(touch.contact.normal_BA_W.x(),
            S(-0.8));  // out of the right fencer, towards the left one
  EXPECT_GT(this->touch_time(0), 0.25);
  EXPECT_LT(this->touch_time(0), 0.37);
  // The point lies on the torso, up to what the search may miss and a step's movement.
  const auto& torso = this->duel->body_W(Side::kRight)[static_cast<std::size_t>(BodyPart::kTorso)];
  const auto on_axis = closest_point(torso.axis, touch.contact.point_W);
  EXPECT_NEAR(static_cast<double>(on_axis.distance), 0.13 * 1.04, 2e-3);
}

TYPED_TEST(DuelOf, AfterTheBout_NothingChanges) {
  this->run(guard, lunge, 1000);
  ASSERT_EQ(this->bout().state, BoutState::kTouched);
  EXPECT_EQ(this->bout().touches[0].by, Side::kRight);
  const auto steps = this->duel->steps();
  EXPECT_EQ(this->duel->step(nullptr, nullptr), Status::kUnavailable);
  EXPECT_EQ(this->duel->steps(), steps);
  ASSERT_EQ(this->configure(), Status::kOk);  // and the next bout
  EXPECT_EQ(this->bout().state, BoutState::kFencing);
  EXPECT_EQ(this->duel->world().size(), 2);
  this->run(guard, lunge, 1000);
  EXPECT_EQ(this->duel->steps(), steps);
}

// Lines that do not cross: no blade parries the other.
TYPED_TEST(DuelOf, LungesAtTheSameTime_AreADouble) {
  ASSERT_EQ(this->configure_thrusters(), Status::kOk);
  this->run(lunge, late_lunge, 1000);
  ASSERT_EQ(this->bout().state, BoutState::kDouble);
  ASSERT_EQ(this->bout().touches.size(), 2);
  EXPECT_NE(this->bout().touches[0].by, this->bout().touches[1].by);
  EXPECT_GE(this->touch_time(1), this->touch_time(0));
  EXPECT_LE(this->touch_time(1), this->touch_time(0) + 0.04);
}

TYPED_TEST(DuelOf, LungeAfterTheWindow_IsNoDouble) {
  this->run(lunge, very_late_lunge, 1000);
  ASSERT_EQ(this->bout().state, BoutState::kTouched);
  EXPECT_EQ(this->bout().touches[0].by, Side::kLeft);
  EXPECT_EQ(this->bout().touches.size(), 1);
}

TYPED_TEST(DuelOf, NoWindow_EndsWithTheStepOfTheTouch) {
  this->settings.double_window_us = 0;
  ASSERT_EQ(this->configure(), Status::kOk);
  this->run(lunge, guard, 1000);
  EXPECT_EQ(this->bout().state, BoutState::kTouched);
  EXPECT_EQ(this->duel->steps(), this->bout().touches[0].when.step + 1);
}

TYPED_TEST(DuelOf, Parry_BeatsTheBladeOutOfTheHandThatExtends) {
  bool lost = false;
  for (int k = 0; k < 300; ++k) {
    const auto l = this->sample(quarte, k);
    const auto r = this->sample(extend, k);
    ASSERT_EQ(this->duel->step(k % 10 == 0 ? &l : nullptr, k % 10 == 0 ? &r : nullptr),
              Status::kOk);
    lost = lost || this->duel->grip(Side::kRight).phase() == GripPhase::kRegaining;
  }
  EXPECT_GT(this->duel->report().blows, 0U);
  EXPECT_TRUE(lost);
  EXPECT_EQ(this->duel->report().incomplete_steps, 0U);
}

// A minute of blades beating and leaning on each other: they never pass into each other, and the
// world answers all.
TYPED_TEST(DuelOf, LongPhrase_BladesStayApart) {
  this->run(sway, counter_sway, 60000);
  EXPECT_EQ(this->duel->steps(), 60000U);
  EXPECT_GT(this->least_gap, -kTurnedBack<typename TestFixture::ScalarT>);
  EXPECT_GT(this->duel->report().blows, 50U);
  // 1 in 1000: blades that lean bounce ever faster to rest, and a step has max_contacts for that.
  EXPECT_LE(this->duel->report().incomplete_steps, 60U);
  EXPECT_EQ(this->duel->report().budget_outs, 0U);
}

TYPED_TEST(DuelOf, SticksThrownFromRimToRim_BladesStayApart) {
  this->run(hacking, counter_sway, 20000);
  EXPECT_GT(this->least_gap, -kTurnedBack<typename TestFixture::ScalarT>);
  EXPECT_GT(this->duel->report().blows, 20U);
  EXPECT_EQ(this->duel->report().budget_outs, 0U);
}

TYPED_TEST(DuelOf, NoSamplesAtAll_IsStaleAndStill) {
  for (int k = 0; k < 500; ++k) ASSERT_EQ(this->duel->step(nullptr, nullptr), Status::kOk);
  EXPECT_TRUE(this->duel->stick(Side::kLeft).is_stale());
  EXPECT_EQ(this->duel->stick(Side::kLeft).report().stale_steps, 500U);
  EXPECT_EQ(this->bout().state, BoutState::kFencing);
}

// Budget that does not suffice is told: the bout does not run on as if nobody had been touched.
TYPED_TEST(PaperDuelOf, TouchSearchesWithoutBudget_AreReported) {
  using S = typename TestFixture::ScalarT;
  this->settings.touch.epsilon = S(1e-6);
  this->settings.touch.max_steps = 2;
  ASSERT_EQ(this->configure(), Status::kOk);
  this->run(lunge, guard, 1000);
  EXPECT_GT(this->duel->report().budget_outs, 0U);
  EXPECT_EQ(this->duel->report().searches_invalid, 0U);
}

template <class DuelT>
class CertifiedDuelOf : public DuelOf<DuelT> {};
TYPED_TEST_SUITE(CertifiedDuelOf, test::CertifiedDuels);

TYPED_TEST(CertifiedDuelOf, TouchSearchesWithoutBudget_AreReported) {
  this->settings.touch.budget = 0;
  ASSERT_EQ(this->configure(), Status::kOk);
  this->run(lunge, guard, 1000);
  EXPECT_GT(this->duel->report().budget_outs, 0U);
  EXPECT_EQ(this->duel->report().searches_invalid, 0U);
}

// Both searches tell the same bout: who touches, where and when.
TEST(Duel, BothSearches_TellTheSameBout) {
  const auto play = [](auto duel, Script left, Script right) {
    using DuelT = std::decay_t<decltype(*duel)>;
    using S = typename DuelT::SceneType::Scalar;
    const auto settings = duel_settings<typename DuelT::StatedScene>();
    EXPECT_EQ(duel->configure(settings, first_fencer<S>(), second_fencer<S>()), Status::kOk);
    for (int k = 0; k < 1000 && !duel->bout().is_over(); ++k) {
      const InputSample l = sample_of(left, k);
      const InputSample r = sample_of(right, k);
      EXPECT_EQ(duel->step(&l, &r), Status::kOk);
    }
    std::vector<double> told = {static_cast<double>(duel->bout().state)};
    for (const auto& touch : duel->bout().touches) {
      told.push_back(static_cast<double>(touch.by));
      told.push_back(static_cast<double>(touch.part));
      told.push_back(static_cast<double>(duel->time_us(touch.when)) * 1e-6);
    }
    return told;
  };
  for (const auto& [left, right] : {std::pair{lunge, guard}, {lunge, late_lunge}, {guard, lunge}}) {
    const auto paper = play(std::make_unique<test::DuelWith<Stepping<double>>>(), left, right);
    const auto ours = play(std::make_unique<test::DuelWith<Advancement<double>>>(), left, right);
    ASSERT_EQ(paper.size(), ours.size());
    for (std::size_t i = 0; i < paper.size(); ++i) EXPECT_NEAR(paper[i], ours[i], 1e-4) << i;
  }
}

// Relative to a blade without thickness no epsilon is small enough: the searches are invalid, not
// short of budget, and the report says so.
TYPED_TEST(PaperDuelOf, TouchSearchesThatMakeNoSense_AreReported) {
  using S = typename TestFixture::ScalarT;
  this->settings.touch.unit = EpsilonIn::kThinnerRadius;
  Fencer<S> wire = first_fencer<S>();
  wire.weapon.blade_B.radius = 0;
  ASSERT_EQ(this->duel->configure(this->settings, wire, second_fencer<S>()), Status::kOk);
  this->run(lunge, guard, 400);
  EXPECT_GT(this->duel->report().searches_invalid, 0U);
  EXPECT_EQ(this->bout().state, BoutState::kFencing);
}

TYPED_TEST(DuelOf, PartsThatDoNotCount_AreNotTouched) {
  this->settings.target = PartMask{1} << static_cast<int>(BodyPart::kHead);
  ASSERT_EQ(this->configure(), Status::kOk);
  this->run(lunge, guard, 600);
  EXPECT_EQ(this->bout().state, BoutState::kFencing);
}

// A refused configure() leaves the running bout as it is, to the bit.
TYPED_TEST(DuelOf, RefusedConfigure_ChangesNothing) {
  using S = typename TestFixture::ScalarT;
  auto twin = std::make_unique<TypeParam>();
  ASSERT_EQ(twin->configure(this->settings, first_fencer<S>(), second_fencer<S>()), Status::kOk);
  const auto step_both = [&](int from, int to) {
    for (int k = from; k < to; ++k) {
      const InputSample left = this->sample(sway, k);
      const InputSample right = this->sample(counter_sway, k);
      ASSERT_EQ(this->duel->step(&left, &right), Status::kOk);
      ASSERT_EQ(twin->step(&left, &right), Status::kOk);
    }
  };
  step_both(0, 500);
  Fencer<S> bad = second_fencer<S>();
  bad.weapon.restitution = 2;
  auto other = this->settings;
  other.step_us = 2000;
  other.world.separation *= 2;
  EXPECT_EQ(this->duel->configure(other, second_fencer<S>(), bad), Status::kInvalidArgument);
  other.salle.distance = 0;
  EXPECT_EQ(this->duel->configure(other, second_fencer<S>(), first_fencer<S>()),
            Status::kInvalidArgument);
  EXPECT_EQ(this->duel->steps(), 500U);
  step_both(500, 1500);
  for (const Side side : {Side::kLeft, Side::kRight}) {
    EXPECT_EQ(this->duel->blade_W(side).axis.b, twin->blade_W(side).axis.b);
  }
  EXPECT_EQ(this->duel->report().blows, twin->report().blows);
  EXPECT_EQ(this->duel->report().evaluations, twin->report().evaluations);
}

TYPED_TEST(DuelOf, TimeOfAMoment_IsExactAfterHours) {
  using S = typename TestFixture::ScalarT;
  const Moment<S> moment{4000000000U, S(0.00025)};
  EXPECT_EQ(this->duel->time_us(moment), 4000000000000ULL + 250ULL);
}

// The same inputs give the same bits.
TEST(Duel, SameInputs_SameBits) {
  const auto trace = [] {
    auto duel = std::make_unique<Duel<>>();
    EXPECT_EQ(duel->configure(duel_settings(), first_fencer<float>(), second_fencer<float>()),
              Status::kOk);
    std::uint32_t hash = 2166136261U;
    for (int k = 0; k < 3000; ++k) {
      InputSample l, r;
      l.time = r.time = static_cast<Microseconds>(k) * 1000U;
      l.x = static_cast<float>(sway(k).x());
      r.x = static_cast<float>(counter_sway(k).x());
      EXPECT_EQ(duel->step(&l, &r), Status::kOk);
      std::uint32_t bits = 0;
      const float x = duel->blade_W(Side::kLeft).axis.b.x();
      std::memcpy(&bits, &x, sizeof bits);
      hash = (hash ^ bits) * 16777619U;
    }
    return hash;
  };
  EXPECT_EQ(trace(), trace());
}

}  // namespace
}  // namespace batuta
