// SPDX-License-Identifier: MIT
// What a duel's scene leaves out is absent, and what is left does the same as before.
#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "batuta/fencing/duel_definitions.hpp"
#include "batuta/record/duel.hpp"
#include "batuta/record/snapshot.hpp"

namespace batuta {
using namespace fencing;

constexpr DuelOptions drill_options() {
  DuelOptions scene = two_fencers();
  scene.targets = false;
  return scene;
}
constexpr DuelOptions stiff_options() {
  DuelOptions scene = two_fencers();
  scene.grip = false;
  return scene;
}
constexpr DuelOptions bare_options() {
  DuelOptions scene = drill_options();
  scene.grip = false;
  return scene;
}
constexpr DuelOptions standing_options() {
  DuelOptions scene = two_fencers();
  scene.feet = false;
  return scene;
}
/// Fewer contacts, no restitution, nothing to read after a step.
constexpr DuelOptions quiet_options() {
  DuelOptions scene = two_fencers();
  scene.restitution = false;
  scene.max_contacts = 3;
  scene.max_events = 0;
  scene.haptics = false;
  scene.resting = RestingContact::kNone;
  return scene;
}

/// Nothing is felt, so that events may be left out.
constexpr DuelOptions numb_options() {
  DuelOptions scene = two_fencers();
  scene.haptics = false;
  return scene;
}
constexpr DuelOptions deaf_options() {
  DuelOptions scene = numb_options();
  scene.max_events = 0;
  return scene;
}

template <class SearchT>
using FullOf = Duel<DuelScene<two_fencers, SearchT>>;
template <class SearchT>
using DrillOf = Duel<DuelScene<drill_options, SearchT>>;
using Full = Duel<>;
using Drill = Duel<DuelScene<drill_options>>;
using Stiff = Duel<DuelScene<stiff_options>>;
using Bare = Duel<DuelScene<bare_options>>;
using Standing = Duel<DuelScene<standing_options>>;

// As a whole, as a user's own source may: no member relies on what is absent.
template class fencing::Duel<DuelScene<drill_options>>;
template class fencing::Duel<DuelScene<bare_options>>;
template class fencing::Duel<DuelScene<standing_options>>;

namespace {

template <class DuelT>
std::unique_ptr<DuelT> configured() {
  using S = typename DuelT::Scalar;
  auto duel = std::make_unique<DuelT>();
  const auto settings = duel_settings<typename DuelT::StatedScene>();
  EXPECT_EQ(duel->configure(settings, first_fencer<S>(), second_fencer<S>()), Status::kOk);
  return duel;
}

struct Stick {
  float x;
  float y;
};
using Script = Stick (*)(float);

Stick guard(float) {
  return {0, 0};
}
Stick lunge(float k) {
  const float share = clamp((k - 100) / 250, 0.0F, 1.0F);
  return {-share, share};
}
Stick sway(float k) {
  return {0.8F * std::sin(6e-3F * k), 0.1F + 0.1F * std::sin(3.1e-3F * k)};
}
Stick counter_sway(float k) {
  return {0.9F * std::sin(7.7e-3F * k + 1), 0.1F + 0.1F * std::sin(4.1e-3F * k)};
}
Stick hacking(float k) {
  return {std::sin(37e-3F * k) > 0 ? 1.0F : -1.0F, 0.0F};
}

template <class DuelT>
void advance(DuelT& duel, Script left, Script right) {
  const auto sample = [&duel](Script script) {
    const Stick stick = script(static_cast<float>(duel.steps()));
    InputSample s;
    s.time = duel.steps() * 1000U;
    s.sequence = duel.steps();
    s.x = stick.x;
    s.y = stick.y;
    return s;
  };
  const InputSample l = sample(left);
  const InputSample r = sample(right);
  ASSERT_EQ(duel.step(&l, &r), Status::kOk);
}

/// Where the blades are, and what their world says.
template <class DuelT>
std::vector<double> blades(const DuelT& duel) {
  const auto& world = duel.world().report();
  std::vector<double> all = {static_cast<double>(duel.report().blows),
                             static_cast<double>(duel.report().rests),
                             static_cast<double>(world.evaluations)};
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const auto blade = duel.blade_W(side);
    for (const auto* point : {&blade.axis.a, &blade.axis.b}) {
      for (int i = 0; i < 3; ++i) all.push_back(static_cast<double>((*point)[i]));
    }
  }
  return all;
}

template <class DuelT>
double blade_gap(const DuelT& duel) {
  return static_cast<double>(
      capsule_gap(duel.blade_W(Side::kLeft), duel.blade_W(Side::kRight)).gap);
}

template <class A, class B>
void expect_same_blades(Script left, Script right, int steps) {
  const auto a = configured<A>();
  const auto b = configured<B>();
  for (int k = 0; k < steps; ++k) {
    advance(*a, left, right);
    advance(*b, left, right);
    ASSERT_EQ(blades(*a), blades(*b)) << k;
  }
  EXPECT_EQ(a->bout().state, BoutState::kFencing) << "or the other one has nothing to compare with";
  EXPECT_GT(a->report().blows, 0U);
}

TEST(DuelFeatures, Drill_MovesItsBladesAsTheDuelDoes) {
  expect_same_blades<Full, Drill>(sway, counter_sway, 5000);
  expect_same_blades<Full, Drill>(hacking, counter_sway, 2000);
  expect_same_blades<FullOf<Advancement<double>>, DrillOf<Advancement<double>>>(sway, counter_sway,
                                                                                2000);
  expect_same_blades<FullOf<Stepping<float>>, DrillOf<Stepping<float>>>(sway, counter_sway, 2000);
  expect_same_blades<Stiff, Bare>(sway, counter_sway, 2000);
}

// Feet that nobody orders make no difference, to the bit.
TEST(DuelFeatures, WithoutFeet_ABoutIsThatOfFeetThatStand) {
  expect_same_blades<Full, Standing>(sway, counter_sway, 3000);
  expect_same_blades<Full, Standing>(hacking, counter_sway, 2000);
}

TEST(DuelFeatures, BladesWithoutEvents_MoveAsThoseWithThem) {
  expect_same_blades<Duel<DuelScene<numb_options>>, Duel<DuelScene<deaf_options>>>(
      sway, counter_sway, 2000);
}

// From the step of the touch on, the body stops the blade, in a duel that has bodies.
TEST(DuelFeatures, Drill_GoesOnWhereTheDuelEndsByATouch) {
  const auto full = configured<Full>();
  const auto drill = configured<Drill>();
  while (!full->bout().is_over()) {
    ASSERT_LT(full->steps(), 1000U);
    advance(*full, lunge, guard);
    advance(*drill, lunge, guard);
    if (full->bout().state == BoutState::kFencing) {
      ASSERT_EQ(blades(*full), blades(*drill));
    }
  }
  EXPECT_EQ(full->bout().state, BoutState::kTouched);
  for (int k = 0; k < 500; ++k) advance(*drill, lunge, guard);
  EXPECT_EQ(drill->bout().state, BoutState::kFencing);
  EXPECT_FALSE(drill->bout().is_over());
  EXPECT_EQ(drill->report().touch_searches, 0U);
}

TEST(DuelFeatures, WithoutGrip_BladesMeetAndStayApart) {
  const auto stiff = configured<Stiff>();
  double least = 1;
  for (int k = 0; k < 20000; ++k) {
    advance(*stiff, k < 10000 ? sway : hacking, counter_sway);
    least = std::min(least, blade_gap(*stiff));
  }
  EXPECT_EQ(stiff->bout().state, BoutState::kFencing);
  EXPECT_GT(least, -1e-5);  // as of a duel with grips: a few units in the last place of a metre
  EXPECT_GT(stiff->report().blows, 20U);
  EXPECT_EQ(stiff->report().budget_outs, 0U);
}

// A hand brings its blade where the keyframes want it, whatever the blade weighs.
TEST(DuelFeatures, WithoutGrip_ABladeThatNobodyStrikesFollowsTheHand) {
  const auto stiff = configured<Stiff>();
  const WeaponBody<float> weapon = first_fencer<float>().weapon;
  for (int k = 0; k < 400 && !stiff->bout().is_over(); ++k) {
    advance(*stiff, lunge, guard);
    const auto X_WB = chained(stiff->hand(Side::kLeft).X_WH, weapon.X_HB);
    const Vec3<float> point = to_world(X_WB, weapon.blade_B).axis.b;
    const bool is_touch = stiff->bout().state != BoutState::kFencing;
    if (stiff->report().blows + stiff->report().rests > 0 || is_touch) break;
    ASSERT_LT((stiff->blade_W(Side::kLeft).axis.b - point).norm(), 1e-5F) << k;
  }
  EXPECT_GT(stiff->steps(), 100U);
}

constexpr DuelOptions curved_options() {
  DuelOptions scene;
  scene.bent_turns = true;
  return scene;
}

/// The point beside the axis of the grip, m.
WeaponBody<float> sabre(float beside) {
  Weapon<float> weapon = epee<float>();
  weapon.parts[0].capsule_H.axis.b.y() = beside;
  return weapon_body(weapon).value;
}

// A sabre: the blade leaves the axis of its grip, and three moments are unlike.
TEST(DuelFeatures, CurvedWeapon_FencesWhereTheSceneHasBentTurns) {
  using Sabres = Duel<DuelScene<curved_options>>;
  const auto duel = std::make_unique<Sabres>();
  Fencer<float> left = first_fencer<float>();
  Fencer<float> right = second_fencer<float>();
  left.weapon = sabre(0.1F);
  right.weapon = sabre(-0.1F);
  ASSERT_EQ(duel->configure({}, left, right), Status::kOk);
  double least = 1;
  for (int k = 0; k < 10000 && !duel->bout().is_over(); ++k) {
    advance(*duel, hacking, counter_sway);
    least = std::min(least, blade_gap(*duel));
  }
  EXPECT_GT(duel->report().blows, 20U);
  // The margin of the search, as tests/laws has it: centres less than a metre apart, and what
  // reaches 0.9 m from each.
  constexpr double kLength = 1 + 2 * (0.9 + 0.9);
  EXPECT_GT(least, -2 * (96 + 72) * static_cast<double>(kRoundOff<float>) * kLength);
}

TEST(DuelFeatures, WithoutGrip_ALungeStillTouches) {
  const auto stiff = configured<Stiff>();
  while (!stiff->bout().is_over() && stiff->steps() < 1000U) advance(*stiff, lunge, guard);
  ASSERT_EQ(stiff->bout().state, BoutState::kTouched);
  EXPECT_EQ(stiff->bout().touches[0].by, Side::kLeft);
  EXPECT_EQ(stiff->bout().touches[0].part, BodyPart::kTorso);
}

TEST(DuelFeatures, OtherScenes_KeepTheirCapacities) {
  using QuietDuel = Duel<DuelScene<quiet_options>>;
  static_assert(decltype(QuietDuel::SceneType::Controller::corners)::kCapacity == 3);
  const auto quiet = configured<QuietDuel>();
  double least = 1;
  for (int k = 0; k < 3000; ++k) {
    advance(*quiet, sway, counter_sway);
    least = std::min(least, blade_gap(*quiet));
  }
  EXPECT_GT(quiet->report().blows, 0U);
  // Lengths of 3 m: so far what parts may turn back (src/world/detail/margin.md).
  EXPECT_GT(least, -7e-5);
}

TEST(DuelFeatures, WhatIsOff_TakesNoRoom) {
  using Way = Corners<float, kMostCorners>;
  constexpr std::size_t kTargetsOf =
      2 * (sizeof(Target<float>) + sizeof(FencerBuild<float>) + sizeof(Way)) + sizeof(Bout<float>) +
      sizeof(TouchSettings<DuelScene<>>);
  EXPECT_GE(sizeof(Full), sizeof(Drill) + kTargetsOf);
  EXPECT_GE(sizeof(Stiff), sizeof(Bare) + kTargetsOf);
  constexpr std::size_t kGrips = 2 * (sizeof(Grip<float>) - sizeof(Hand<float>));
  EXPECT_EQ(sizeof(Full), sizeof(Stiff) + kGrips);
  EXPECT_EQ(sizeof(Drill), sizeof(Bare) + kGrips);
  EXPECT_EQ(sizeof(Full),
            sizeof(Standing) + sizeof(Footwork<float>) + sizeof(FootworkSettings<DuelScene<>>));
  EXPECT_EQ(sizeof(Bare::SceneType::Controller), sizeof(Hand<float>));
  EXPECT_EQ(sizeof(Drill::SceneType::Controller), sizeof(Grip<float>));
}

template <class T, class = void>
struct HasTarget : std::false_type {};
template <class T>
struct HasTarget<T, std::void_t<decltype(T::target)>> : std::true_type {};
template <class T, class = void>
struct HasCorners : std::false_type {};
template <class T>
struct HasCorners<T, std::void_t<decltype(T::corners)>> : std::true_type {};

TEST(DuelFeatures, WhatIsOff_HasNoMember) {
  EXPECT_TRUE(HasTarget<Full::Settings>::value);
  EXPECT_FALSE(HasTarget<Drill::Settings>::value);
  EXPECT_TRUE(HasCorners<Stiff::SceneType::Controller>::value);
  EXPECT_FALSE(HasCorners<Drill::SceneType::Controller>::value);
  EXPECT_TRUE((std::is_same_v<decltype(Stiff::SceneType::Controller::carrier), Hand<float>>));
  EXPECT_TRUE((std::is_same_v<decltype(Drill::SceneType::Controller::carrier), Grip<float>>));
  EXPECT_TRUE((std::is_same_v<decltype(std::declval<Drill>().bout()), OpenBout>));
}

// What is not there cannot be out of range.
TEST(DuelFeatures, DataOfWhatIsOff_IsNotLookedAt) {
  Fencer<float> odd = first_fencer<float>();
  odd.grip.torque = -1;
  const auto settings = duel_settings<Stiff::StatedScene>();
  EXPECT_EQ(configured<Stiff>()->configure(settings, odd, odd), Status::kOk);
  EXPECT_EQ(configured<Full>()->configure(duel_settings(), odd, odd), Status::kInvalidArgument);
  odd.build.front_leg.bend_F.setZero();
  EXPECT_EQ(configured<Stiff>()->configure(settings, odd, odd), Status::kInvalidArgument);
  EXPECT_EQ(configured<Bare>()->configure(duel_settings<Bare::StatedScene>(), odd, odd),
            Status::kOk);
}

template <class DuelT>
class DuelFeatureArchive : public ::testing::Test {};
using Others = ::testing::Types<Drill, Stiff, Bare, Standing>;
TYPED_TEST_SUITE(DuelFeatureArchive, Others);

TYPED_TEST(DuelFeatureArchive, Saved_GoesOnWithTheSameBits) {
  const auto duel = configured<TypeParam>();
  for (int k = 0; k < 700; ++k) advance(*duel, sway, counter_sway);
  std::vector<std::uint8_t> bytes(kSnapshotRoom<TypeParam>);
  const auto size = save(*duel, bytes.data(), static_cast<int>(bytes.size()));
  ASSERT_EQ(size.status, Status::kOk);
  TypeParam other;
  ASSERT_EQ(restore(other, bytes.data(), size.value), Restored::kOk);
  Full full;
  EXPECT_EQ(restore(full, bytes.data(), size.value), Restored::kOtherScene);
  for (int k = 0; k < 700; ++k) {
    advance(*duel, sway, counter_sway);
    advance(other, sway, counter_sway);
    ASSERT_EQ(blades(*duel), blades(other)) << k;
    ASSERT_EQ(hash_of(*duel), hash_of(other)) << k;
  }
  EXPECT_GT(duel->report().blows, 0U);
}

}  // namespace
}  // namespace batuta
