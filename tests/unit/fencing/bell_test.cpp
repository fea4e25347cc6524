// SPDX-License-Identifier: MIT
// A weapon is blade, guard and hand: nothing passes through any of them, unless a scene has the
// blade alone.
#include "batuta/fencing/duel_definitions.hpp"
#include "configured_duel.hpp"

namespace batuta {
using namespace fencing;

constexpr DuelOptions blades_alone() {
  DuelOptions scene = two_fencers();
  scene.capsules_per_body = 1;
  scene.max_pairs = 1;
  return scene;
}
template class fencing::Duel<DuelScene<blades_alone>>;

namespace {

/// What a blade may be in what has stopped it, m.
constexpr float kIntoGuard = 2e-4F;

/// The left hand goes straight forward at the height of the right one's bell; the right blade
/// points up, so that the left one passes in front of its beginning.
template <class DuelT>
class Bell : public ::testing::Test {
 protected:
  static constexpr float kSteep = 1.2F;  ///< of the right blade, rad
  std::array<MapKey<float>, 4> left_keys{};
  std::array<MapKey<float>, 4> right_keys{};
  const Fencer<float> fencer = first_fencer<float>();
  const Weapon<float> weapon = epee<float>();
  DuelT duel;
  float least_gap = 1;  ///< of the left blade to the right guard and hand
  float passed = -1;    ///< so far the left point has been behind the right bell's centre, x

  void begin() {
    const float height = 1.15F + 0.07F * std::sin(kSteep);
    for (std::size_t i = 0; i < 4; ++i) {
      left_keys[i] = {{i < 2 ? -0.4F : 1.24F, 0, height}, {0, 0, 0}, 0};
      right_keys[i] = {{0.42F, 0, 1.15F}, {0, -kSteep, 0}, 0};
    }
    auto settings = duel_settings<typename DuelT::StatedScene>();
    settings.target = 0;
    Fencer<float> left = fencer;
    Fencer<float> right = fencer;
    left.map = {left_keys.data(), 2, 2};
    right.map = {right_keys.data(), 2, 2};
    ASSERT_EQ(duel.configure(settings, left, right), Status::kOk);
  }
  Capsule<float> right_W(const Capsule<float>& capsule_H) const {
    return to_world(duel.held_hand_W(Side::kRight), capsule_H);
  }
  void lunge(int steps) {
    for (int k = 0; k < steps; ++k) {
      InputSample sample;
      sample.sequence = duel.steps();
      sample.time = 1000 * sample.sequence;
      sample.y = clamp(static_cast<float>(sample.sequence) / 250.0F, 0.0F, 1.0F);
      ASSERT_EQ(duel.step(&sample, nullptr), Status::kOk);
      const Capsule<float> blade = duel.blade_W(Side::kLeft);
      for (const auto& capsule_H : {weapon.parts[1].capsule_H, weapon.hand_H}) {
        least_gap = std::min(least_gap, capsule_gap(blade, right_W(capsule_H)).gap);
      }
      const Capsule<float> bell = right_W(weapon.parts[1].capsule_H);
      passed = std::max(passed, blade.axis.b.x() - bell.axis.a.x());
    }
  }
};

using OfThree = Bell<Duel<>>;
using OfOne = Bell<Duel<DuelScene<blades_alone>>>;

// After 150 steps a hand that nothing stops has its point 0.1 m behind where the bell's centre was.
// A weapon that is pushed gives way, and a point that presses on a ball slips off it in the end:
// neither goes through it.
TEST_F(OfThree, LungeOntoTheBell_IsStopped) {
  begin();
  lunge(150);
  EXPECT_GT(duel.report().blows, 0U);
  EXPECT_LT(passed, -0.03F);
  lunge(450);
  EXPECT_GE(least_gap, -kIntoGuard);
}

TEST_F(OfOne, LungeOntoTheBell_PassesThroughIt) {
  begin();
  lunge(150);
  EXPECT_EQ(duel.report().blows, 0U);
  EXPECT_LT(least_gap, -0.06F);
  EXPECT_GT(passed, 0.1F);
}

}  // namespace
}  // namespace batuta
