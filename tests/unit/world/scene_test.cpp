// SPDX-License-Identifier: MIT
#include "batuta/world/actor.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace batuta {
namespace {

template <class S, template <class> class SearchT>
struct SceneOf : Scene {
  using Scalar = S;
  using Search = SearchT<S>;
  static constexpr std::uint32_t kBudget = Search::kDefaultBudget;
};

TEST(Scene, DefaultSettings_AreValid) {
  EXPECT_EQ(validate(WorldSettings<Scene>{}), Status::kOk);
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
  EXPECT_TRUE(refuses<Paper>([](auto& settings) { settings.search.halvings = kMaxHalvings + 1; }));
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

struct SpinScene : Scene {
  static constexpr std::uint32_t kBudget = 32;
  static constexpr float kTurnPerStep = 3.0F;
};
struct CoarseScene : SpinScene {
  static constexpr float kContactTolerance = 6e-3F;
};

TEST(Scene, TurnAndBudget_GiveTheTolerance) {
  const float contact_tolerance = WorldSettings<SpinScene>{}.search.contact_tolerance;
  EXPECT_EQ(contact_tolerance, contact_tolerance_for(3.0F, 32));
  EXPECT_GT(contact_tolerance, 1e-3F);
  EXPECT_EQ(WorldSettings<CoarseScene>{}.search.contact_tolerance, 6e-3F);
  EXPECT_EQ(WorldSettings<Scene>{}.search.contact_tolerance,
            AdvancementOptions<float>{}.contact_tolerance);
}

TEST(Scene, PairRestitution_IsThatOfTheBouncierBody) {
  EXPECT_EQ(pair_restitution(0.25, 0.5), 0.5);
  EXPECT_EQ(pair_restitution(0.5, 0.25), 0.5);
}

}  // namespace
}  // namespace batuta
