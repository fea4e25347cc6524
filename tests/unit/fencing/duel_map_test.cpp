// SPDX-License-Identifier: MIT
// A duel whose fencers have maps of their own: hands and feet go by them, and what was saved under
// one map is not restored under another.
#include <vector>

#include "batuta/fencing/duel_definitions.hpp"
#include "batuta/record/duel.hpp"
#include "batuta/record/snapshot.hpp"
#include "configured_duel.hpp"

namespace batuta {
using namespace fencing;

constexpr DuelOptions standing_fencers() {
  DuelOptions scene = two_fencers();
  scene.feet = false;
  return scene;
}
template class fencing::Duel<DuelScene<standing_fencers>>;

namespace {

/// Three columns and two rows: the library's outermost keys, and feet that go back on the left.
template <class S>
std::vector<MapKey<S>> six_keys() {
  const FencerMap<S>& all = library_map<S>();
  std::vector<MapKey<S>> keys;
  for (const int i : {0, 4, 8, 18, 22, 26}) {
    MapKey<S> key = all.keys[i];
    key.feet = S(0);
    keys.push_back(key);
  }
  keys[0].feet = keys[3].feet = S(-4);
  return keys;
}

template <class DuelT>
class DuelMap : public test::ConfiguredDuel<DuelT> {
 protected:
  using Num = typename test::ConfiguredDuel<DuelT>::ScalarT;
  using test::ConfiguredDuel<DuelT>::duel;
  std::vector<MapKey<Num>> keys = six_keys<Num>();
  FencerMap<Num> own{keys.data(), 3, 2};

  Status configure_with(DuelT& one, const FencerMap<Num>& right_map) const {
    Fencer<Num> right = second_fencer<Num>();
    right.map = right_map;
    return one.configure(this->settings, first_fencer<Num>(), right);
  }
  static Status step(DuelT& one, const Vec2<float>& stick, float feet_y = 0) {
    InputSample s;
    s.time = 1000 * one.steps();
    s.sequence = one.steps();
    s.x = stick.x();
    s.y = stick.y();
    s.feet_y = feet_y;
    return one.step(nullptr, &s);
  }
  void run(int steps, const Vec2<float>& stick, float feet_y = 0) {
    for (int k = 0; k < steps; ++k) ASSERT_EQ(step(*duel, stick, feet_y), Status::kOk);
  }
  double speed() const { return static_cast<double>(duel->feet(Side::kRight).velocity()); }
};
TYPED_TEST_SUITE(DuelMap, test::Duels);

TYPED_TEST(DuelMap, OfOtherSize_SaysWhereTheHandIs) {
  using S = typename TestFixture::Num;
  ASSERT_EQ(this->configure_with(*this->duel, this->own), Status::kOk);
  for (int k = 0; k < 300; ++k) {
    const auto t = static_cast<float>(k);
    ASSERT_EQ(this->step(*this->duel, {std::sin(t / 40), -std::abs(std::sin(t / 70))}),
              Status::kOk);
    const auto& stick = this->duel->stick(Side::kRight).position();
    const auto wanted = hand_at(this->own, stick, this->duel->X_WF(Side::kRight));
    const KeyedPose<S>& hand = this->duel->hand(Side::kRight);
    ASSERT_EQ(hand.X_WH.p_W, wanted.X_WH.p_W);
    ASSERT_EQ(hand.X_WH.q_WB.coeffs(), wanted.X_WH.q_WB.coeffs());
    ASSERT_EQ(hand.jacobian, wanted.jacobian);
  }
  EXPECT_NE(this->duel->feet(Side::kRight).way(), S(0)) << "F moved as well";
}

// What the stick says by its place, and what the second pair of axes says, are added up.
TYPED_TEST(DuelMap, Feet_GoByTheMapAndTheSecondAxis) {
  ASSERT_EQ(this->configure_with(*this->duel, this->own), Status::kOk);
  this->run(500, {-1, 0});
  EXPECT_NEAR(this->speed(), -1.8, 1e-3) << "back as fast as feet are";
  this->run(500, {-1, 0}, -1);
  EXPECT_NEAR(this->speed(), -1.8, 1e-3) << "and no faster";
  this->run(500, {-1, 0}, 1);
  EXPECT_NEAR(this->speed(), 0, 1e-6) << "one against the other";
  this->run(500, {0, 0}, 0.5F);
  EXPECT_NEAR(this->speed(), 0.75, 1e-3) << "the second axis alone";
}

TYPED_TEST(DuelMap, OfTheLibrary_RetreatsWhereTheStickIsBack) {
  this->run(600, {0, -1});
  EXPECT_NEAR(this->speed(), -1.8, 1e-3);
  this->run(600, {1, -1});
  EXPECT_EQ(this->speed(), 0) << "octave stands";
}

TEST(DuelMap, SceneWithoutFeet_DoesNotWalk) {
  using Standing = Duel<DuelScene<standing_fencers>>;
  const auto duel = std::make_unique<Standing>();
  ASSERT_EQ(duel->configure(duel_settings<DuelScene<standing_fencers>>(), first_fencer<float>(),
                            second_fencer<float>()),
            Status::kOk);
  const auto before = duel->X_WF(Side::kRight).p_W;
  InputSample back;
  back.y = -1;
  for (int k = 0; k < 300; ++k) {
    back.time = 1000U * static_cast<std::uint32_t>(k);
    back.sequence = static_cast<std::uint32_t>(k);
    ASSERT_EQ(duel->step(nullptr, &back), Status::kOk);
  }
  EXPECT_EQ(duel->X_WF(Side::kRight).p_W, before);
}

template <class DuelT>
std::vector<std::uint8_t> saved(const DuelT& duel) {
  std::vector<std::uint8_t> bytes(kSnapshotRoom<DuelT>);
  const Result<int> size = save(duel, bytes.data(), static_cast<int>(bytes.size()));
  EXPECT_EQ(size.status, Status::kOk);
  bytes.resize(static_cast<std::size_t>(size.value));
  return bytes;
}

template <class DuelT>
Restored restored(DuelT& duel, const std::vector<std::uint8_t>& bytes) {
  return restore(duel, bytes.data(), static_cast<int>(bytes.size()));
}

TYPED_TEST(DuelMap, RestoredUnderTheSameKeys_GoesOn) {
  ASSERT_EQ(this->configure_with(*this->duel, this->own), Status::kOk);
  this->run(200, {-1, -0.5F});
  const auto bytes = saved(*this->duel);
  const auto copy = this->keys;  // the same numbers elsewhere
  const auto other = std::make_unique<TypeParam>();
  ASSERT_EQ(this->configure_with(*other, {copy.data(), 3, 2}), Status::kOk);
  ASSERT_EQ(restored(*other, bytes), Restored::kOk);
  EXPECT_EQ(hash_of(*other), hash_of(*this->duel));
  for (int k = 0; k < 100; ++k) {
    ASSERT_EQ(this->step(*this->duel, {0.4F, -0.1F}), Status::kOk);
    ASSERT_EQ(this->step(*other, {0.4F, -0.1F}), Status::kOk);
    ASSERT_EQ(hash_of(*other), hash_of(*this->duel)) << k;
  }
}

TYPED_TEST(DuelMap, RestoredUnderAnotherMap_IsRefused) {
  ASSERT_EQ(this->configure_with(*this->duel, this->own), Status::kOk);
  this->run(50, {0.3F, -0.5F});
  const auto bytes = saved(*this->duel);
  const auto other = std::make_unique<TypeParam>();
  EXPECT_EQ(restored(*other, bytes), Restored::kOutOfRange) << "never configured";
  EXPECT_EQ(this->step(*other, {0, 0}), Status::kInvalidArgument);
  ASSERT_EQ(this->configure_with(*other, library_map<typename TestFixture::Num>()), Status::kOk);
  EXPECT_EQ(restored(*other, bytes), Restored::kOutOfRange) << "that of the library";
  EXPECT_EQ(this->step(*other, {0, 0}), Status::kInvalidArgument);
  auto near = this->keys;
  near[3].turn_F[1] = -near[3].turn_F[1];
  ASSERT_EQ(this->configure_with(*other, {near.data(), 3, 2}), Status::kOk);
  EXPECT_EQ(restored(*other, bytes), Restored::kOutOfRange) << "one sign is another";
  EXPECT_EQ(this->step(*other, {0, 0}), Status::kInvalidArgument);
  ASSERT_EQ(this->configure_with(*other, this->own), Status::kOk);
  EXPECT_EQ(restored(*other, bytes), Restored::kOk);
}

TYPED_TEST(DuelMap, NeverConfigured_HasTheMapOfTheLibrary) {
  this->run(100, {0.5F, -0.2F});
  const auto other = std::make_unique<TypeParam>();
  ASSERT_EQ(restored(*other, saved(*this->duel)), Restored::kOk);
  EXPECT_EQ(hash_of(*other), hash_of(*this->duel));
  ASSERT_EQ(this->step(*other, {0.5F, -0.2F}), Status::kOk);
  ASSERT_EQ(this->step(*this->duel, {0.5F, -0.2F}), Status::kOk);
  EXPECT_EQ(hash_of(*other), hash_of(*this->duel));
}

}  // namespace
}  // namespace batuta
