// SPDX-License-Identifier: MIT
#include "batuta/world/actor.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>

#include "batuta/world/scenes.hpp"

namespace batuta {
namespace {

template <class S, template <class> class SearchT>
using SceneOf = Scene<two_blades, SearchT<S>>;

TEST(Scene, DefaultSettings_AreValid) {
  EXPECT_EQ(validate(WorldSettings<TwoBlades>{}), Status::kOk);
  EXPECT_EQ(validate(WorldSettings<SceneOf<double, Advancement>>{}), Status::kOk);
  EXPECT_EQ(validate(WorldSettings<SceneOf<float, Translation>>{}), Status::kOk);
  EXPECT_EQ(validate(WorldSettings<SceneOf<float, Stepping>>{}), Status::kOk);
  EXPECT_EQ(validate(WorldSettings<SceneOf<double, Stepping>>{}), Status::kOk);
}

/// Whether a world refuses its settings after a change.
template <class SceneT, class Change>
bool refuses(const Change& change) {
  WorldSettings<SceneT> settings;
  change(settings);
  return validate(settings) == Status::kInvalidArgument;
}

TEST(Scene, EachOptionOutOfRange_IsRefused) {
  const double infinity = std::numeric_limits<double>::infinity();
  using Plain = SceneOf<double, Advancement>;
  using Paper = SceneOf<double, Stepping>;
  for (const double bad : {0.0, -1.0, infinity, std::nan("")}) {
    EXPECT_TRUE(refuses<Paper>([bad](auto& settings) { settings.search.epsilon = bad; }));
    EXPECT_TRUE(refuses<Plain>([bad](auto& settings) { settings.rest_speed = bad; }));
    EXPECT_TRUE(refuses<Plain>([bad](auto& settings) { settings.separation = bad; }));
    EXPECT_TRUE(refuses<Plain>([bad](auto& settings) { settings.min_separation_time = bad; }));
  }
  for (const double bad : {-1.0, 1.1, infinity, std::nan("")}) {
    EXPECT_TRUE(refuses<Plain>([bad](auto& settings) { settings.search.contact_tolerance = bad; }));
  }
  EXPECT_TRUE(refuses<Paper>([](auto& settings) { settings.search.max_steps = 0; }));
  EXPECT_TRUE(refuses<Paper>([](auto& settings) { settings.search.halvings = -1; }));
  EXPECT_TRUE(
      refuses<Paper>([](auto& settings) { settings.search.halvings = detail::kMaxHalvings + 1; }));
}

// The longest step is a constant of the scene, whatever the settings.
TEST(Scene, SearchBeyondTheScenesBudget_IsRefused) {
  using Plain = SceneOf<float, Advancement>;
  using Paper = SceneOf<float, Stepping>;
  EXPECT_EQ(WorldSettings<Plain>{}.search.budget, Plain::kBudget);
  EXPECT_FALSE(refuses<Plain>([](auto& settings) { --settings.search.budget; }));
  EXPECT_TRUE(refuses<Plain>([](auto& settings) { ++settings.search.budget; }));
  EXPECT_EQ(Paper::Search::most_evaluations(WorldSettings<Paper>{}.search), Paper::kBudget);
  EXPECT_FALSE(refuses<Paper>([](auto& settings) { --settings.search.max_steps; }));
  EXPECT_TRUE(refuses<Paper>([](auto& settings) { ++settings.search.max_steps; }));
  EXPECT_TRUE(refuses<Paper>([](auto& settings) { ++settings.search.halvings; }));
}

constexpr SceneOptions spin_scene_options() {
  SceneOptions scene;
  scene.budget = 32;
  scene.turn_per_step = 3.0F;
  return scene;
}
using SpinScene = Scene<spin_scene_options>;
constexpr SceneOptions coarse_scene_options() {
  SceneOptions scene = spin_scene_options();
  scene.contact_tolerance = 6e-3F;
  return scene;
}
using CoarseScene = Scene<coarse_scene_options>;

TEST(Scene, TurnAndBudget_GiveTheTolerance) {
  const float contact_tolerance = WorldSettings<SpinScene>{}.search.contact_tolerance;
  EXPECT_EQ(contact_tolerance, contact_tolerance_for(3.0F, 32));
  EXPECT_GT(contact_tolerance, 1e-3F);
  EXPECT_EQ(WorldSettings<CoarseScene>{}.search.contact_tolerance, 6e-3F);
  EXPECT_EQ(WorldSettings<TwoBlades>{}.search.contact_tolerance,
            AdvancementOptions<float>{}.contact_tolerance);
}

TEST(Scene, PairRestitution_IsThatOfTheBouncierBody) {
  EXPECT_EQ(pair_restitution(0.25, 0.5), 0.5);
  EXPECT_EQ(pair_restitution(0.5, 0.25), 0.5);
}

/// What a scene lists for the fingerprint of what is saved of its world.
struct Listed {
  std::uint32_t last = 0;
  void constant(std::uint32_t value) { last = value; }
};
template <class SceneT>
std::uint32_t listed_features() {
  Listed listed;
  detail::archive_scene<SceneT>(listed);
  return listed.last;
}

// A bit each: rotation 1, response 2, line contact 4, gravity 8, sleep 16.
TEST(Scene, FeaturesForTheFingerprint_AreABitEach) {
  EXPECT_EQ(listed_features<StraightSpheres>(), 2U);
  EXPECT_EQ(listed_features<DetectionOnly>(), 1U);
  EXPECT_EQ(listed_features<TwoBlades>(), 3U);
  EXPECT_EQ(listed_features<Rack>(), 31U);
}

}  // namespace
}  // namespace batuta
