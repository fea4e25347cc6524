// SPDX-License-Identifier: MIT
// What a duel does not take: settings and fencers out of range, steps before it is configured.
#include <vector>

#include "batuta/record/duel.hpp"
#include "configured_duel.hpp"

namespace batuta {
using namespace fencing;
namespace {

template <class DuelT>
class DuelRefusals : public test::ConfiguredDuel<DuelT> {};
TYPED_TEST_SUITE(DuelRefusals, test::Duels);
template <class DuelT>
class PaperDuelRefusals : public test::ConfiguredDuel<DuelT> {};
TYPED_TEST_SUITE(PaperDuelRefusals, test::PaperDuels);
template <class DuelT>
class CertifiedDuelRefusals : public test::ConfiguredDuel<DuelT> {};
TYPED_TEST_SUITE(CertifiedDuelRefusals, test::CertifiedDuels);

TYPED_TEST(DuelRefusals, NotConfigured_StepIsRefused) {
  this->duel = std::make_unique<TypeParam>();
  EXPECT_EQ(this->duel->step(nullptr, nullptr), Status::kInvalidArgument);
  this->settings.step_us = 0;
  EXPECT_EQ(this->configure(), Status::kInvalidArgument);
  EXPECT_EQ(this->duel->step(nullptr, nullptr), Status::kInvalidArgument);
  EXPECT_DEATH((void)this->duel->blade_W(Side::kLeft), "");
  EXPECT_DEATH((void)this->duel->grip(Side::kRight), "");
}

// What a bout leaves behind must not show in the next one, not in what its searches cost either.
TYPED_TEST(DuelRefusals, ConfiguredAgain_GoesOnWithTheBitsOfAFirstBout) {
  const auto fresh = std::make_unique<TypeParam>();
  ASSERT_EQ(this->configure(), Status::kOk);
  InputSample sample;
  for (int bout = 0; bout < 2; ++bout) {
    ASSERT_EQ(fresh->configure(this->settings, first_fencer<typename TestFixture::ScalarT>(),
                               second_fencer<typename TestFixture::ScalarT>()),
              Status::kOk);
    if (bout == 1) break;
    for (std::uint32_t i = 0; i < 40; ++i) {
      sample.time = i * 1000;
      sample.x = i % 2 == 0 ? 0.5F : -0.5F;
      ASSERT_EQ(fresh->step(&sample, &sample), Status::kOk);
    }
  }
  for (int i = 0; i < 20; ++i) {
    ASSERT_EQ(this->duel->step(nullptr, nullptr), Status::kOk);
    ASSERT_EQ(fresh->step(nullptr, nullptr), Status::kOk);
    ASSERT_EQ(fresh->report().evaluations, this->duel->report().evaluations) << i;
    ASSERT_EQ(fresh->blade_W(Side::kLeft).axis.b, this->duel->blade_W(Side::kLeft).axis.b) << i;
  }
}

// A fencer that is made when it is needed is the one that is given.
TYPED_TEST(DuelRefusals, ConfiguredByMakers_IsTheSameBout) {
  using S = typename TestFixture::ScalarT;
  const auto made = std::make_unique<TypeParam>();  // configured once, as the fixture's duel is
  ASSERT_EQ(made->configure(this->settings, first_fencer<S>, second_fencer<S>), Status::kOk);
  EXPECT_EQ(hash_of(*made), hash_of(*this->duel));
  const FencerMaker<S> unarmed = []() { return Fencer<S>{}; };
  EXPECT_EQ(made->configure(this->settings, first_fencer<S>, unarmed), Status::kInvalidArgument);
  EXPECT_EQ(made->configure(this->settings, unarmed, first_fencer<S>), Status::kInvalidArgument);
  EXPECT_EQ(made->configure(this->settings, nullptr, first_fencer<S>), Status::kInvalidArgument);
  EXPECT_EQ(made->configure(this->settings, first_fencer<S>, nullptr), Status::kInvalidArgument);
  EXPECT_EQ(hash_of(*made), hash_of(*this->duel));
}

TYPED_TEST(DuelRefusals, SettingsOutOfRange_AreRefused) {
  using S = typename TestFixture::ScalarT;
  EXPECT_TRUE(this->refuses([](auto& s) { s.salle.distance = S(1e30); }));
  EXPECT_TRUE(
      this->refuses([](auto& s) { s.salle.distance = std::numeric_limits<S>::quiet_NaN(); }));
  EXPECT_TRUE(this->refuses([](auto& s) { s.step_us = 99; }));
  EXPECT_TRUE(this->refuses([](auto& s) { s.step_us = 20001; }));
  EXPECT_TRUE(this->refuses([](auto& s) { s.double_window_us = -1; }));
  EXPECT_TRUE(this->refuses([](auto& s) { s.double_window_us = 10000001; }));
  EXPECT_TRUE(this->refuses([](auto& s) { s.salle.distance = 0; }));
  EXPECT_TRUE(this->refuses([](auto& s) { s.stick.min_interval_us = 0; }));
  EXPECT_TRUE(this->refuses([](auto& s) { s.world.separation = 0; }));
}

TYPED_TEST(PaperDuelRefusals, SearchOptionsOutOfRange_AreRefused) {
  using S = typename TestFixture::ScalarT;
  EXPECT_TRUE(
      this->refuses([](auto& s) { s.touch.epsilon = std::numeric_limits<S>::quiet_NaN(); }));
  EXPECT_TRUE(this->refuses([](auto& s) { s.touch.max_steps = 0; }));
  EXPECT_TRUE(this->refuses([](auto& s) { s.touch.halvings = -1; }));
}

TYPED_TEST(CertifiedDuelRefusals, SearchOptionsOutOfRange_AreRefused) {
  EXPECT_TRUE(this->refuses([](auto& s) { s.touch.budget = kMaxBudget + 1; }));
  EXPECT_TRUE(this->refuses([](auto& s) { s.touch.contact_tolerance = -1; }));
  EXPECT_TRUE(
      this->refuses([](auto& s) { s.world.search.budget = TypeParam::SceneType::kBudget + 1; }));
}

TYPED_TEST(DuelRefusals, FencerOutOfRange_IsRefused) {
  using S = typename TestFixture::ScalarT;
  const auto refused = [this](auto change) {
    Fencer<S> bad = first_fencer<S>();
    change(bad);
    const auto good = second_fencer<S>();
    return this->duel->configure(this->settings, bad, good) == Status::kInvalidArgument &&
           this->duel->configure(this->settings, good, bad) == Status::kInvalidArgument;
  };
  const S nan = std::numeric_limits<S>::quiet_NaN();
  MapKey<S> key = first_fencer<S>().map.keys[0];
  std::vector<MapKey<S>> keys(6, key);
  const FencerMap<S> small{keys.data(), 3, 2};
  EXPECT_FALSE(refused([small](auto& f) { f.map = small; }));
  EXPECT_TRUE(refused([](auto& f) { f.map.keys = nullptr; }));
  EXPECT_TRUE(refused([](auto& f) { f.map.columns = 1; }));
  keys[5].hand_F[2] = nan;
  EXPECT_TRUE(refused([small](auto& f) { f.map = small; }));
  EXPECT_TRUE(refused([](auto& f) { f.weapon = {}; }));
  EXPECT_TRUE(refused([](auto& f) { f.weapon.mass = 0; }));
  EXPECT_TRUE(refused([](auto& f) { f.weapon.moments.y() = S(-0.1); }));
  EXPECT_TRUE(refused([](auto& f) { f.weapon.X_HB.q_WB.w() = S(1.1); }));
  EXPECT_TRUE(refused([nan](auto& f) { f.weapon.X_HB.p_W.z() = nan; }));
  EXPECT_TRUE(refused([](auto& f) { f.weapon.guard_B.radius = -1; }));
  // A bell beside the axis of the blade: its turn would be bent (DuelOptions, bent_turns).
  Weapon<S> crooked = epee<S>();
  crooked.parts[1].capsule_H.axis.a.y() = S(0.02);
  EXPECT_TRUE(refused([&crooked](auto& f) { f.weapon = weapon_body(crooked).value; }));
  EXPECT_TRUE(refused([](auto& f) { f.weapon.restitution = 2; }));
  EXPECT_TRUE(refused([](auto& f) { f.weapon.restitution = S(-0.1); }));
  EXPECT_TRUE(refused([nan](auto& f) { f.weapon.hand_B.radius = nan; }));
  EXPECT_TRUE(refused([](auto& f) { f.grip.torque = 0; }));
  EXPECT_TRUE(refused([nan](auto& f) { f.build.bones[3].start_P.x() = nan; }));
  EXPECT_TRUE(refused([](auto& f) { f.build.bones[4].capsule_J.axis.b.setZero(); }));
  EXPECT_TRUE(refused([](auto& f) { f.build.front_leg.bend_F.setZero(); }));
  EXPECT_TRUE(refused([](auto& f) { f.build.lunge_hand_x = f.build.guard_hand_x; }));
  EXPECT_TRUE(refused([](auto& f) { f.build.shoulder_give = S(-0.01); }));
  ASSERT_EQ(this->configure(), Status::kOk);
  EXPECT_EQ(this->duel->world().size(), 2);
}

}  // namespace
}  // namespace batuta
