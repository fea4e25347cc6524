// SPDX-License-Identifier: MIT
// What a world makes of its scene's search: budget, contact tolerance, seed, and what the search
// refuses.

#include <gtest/gtest.h>

#include <cstring>
#include <memory>

#include "scenes.hpp"

namespace batuta {
namespace {

using test::ball;
using test::FlightScene;
using test::post;
using test::vec;

template <class SceneT>
class SearchOfWorld : public ::testing::Test {};
using Scenes = ::testing::Types<FlightScene<float, Advancement>, FlightScene<double, Advancement>,
                                FlightScene<float, Translation>, FlightScene<double, Translation>,
                                FlightScene<float, Stepping>, FlightScene<double, Stepping>>;
TYPED_TEST_SUITE(SearchOfWorld, Scenes);

template <class SceneT>
double gap_between(const World<SceneT>& world, std::uint16_t a, std::uint16_t b) {
  const auto& A = *world.get(world.id_at(a));
  const auto& B = *world.get(world.id_at(b));
  return static_cast<double>(
      capsule_gap(to_world(A.body.X_WB, A.capsule_B), to_world(B.body.X_WB, B.capsule_B)).gap);
}

// After a blow the two are apart by more than the next search takes for contact: one answer, and
// nobody is held.
TYPED_TEST(SearchOfWorld, PartingBodies_AreNotHeld) {
  using S = typename TypeParam::Scalar;
  for (const double scale : {1e-3, 1.0, 1e3}) {
    World<TypeParam> world;
    auto settings = WorldSettings<TypeParam>{};
    settings.separation *= S(scale);
    settings.rest_speed *= S(scale);
    if constexpr (TypeParam::Search::kHasContactTolerance)
      settings.search.contact_tolerance = S(1e-3);
    ASSERT_EQ(world.configure(settings), Status::kOk);
    (void)world.add(ball<TypeParam>(0, 0.1 * scale, scale));
    auto wall = post<TypeParam>(3 * scale, 0.1 * scale);
    wall.capsule_B.axis = {vec<S>(0, -scale, 0), vec<S>(0, scale, 0)};
    (void)world.add(wall);
    std::uint32_t collisions = 0;
    for (int i = 0; i < 60; ++i) {
      ASSERT_EQ(world.step(S(0.1)), Status::kOk);
      EXPECT_EQ(world.report().time_held, S(0)) << "step " << i << ", scale " << scale;
      EXPECT_EQ(world.report().overlaps_at_start, 0U);
      EXPECT_TRUE(world.report().complete());
      collisions += world.report().collisions;
    }
    EXPECT_EQ(collisions, 1U);
    EXPECT_NEAR(gap_between(world, 0, 1) / scale, 6 - 2.8, 2e-2) << scale;
  }
}

TYPED_TEST(SearchOfWorld, TouchingAndParting_Leaves) {
  using S = typename TypeParam::Scalar;
  World<TypeParam> world;
  (void)world.add(ball<TypeParam>(0, 0.1, -1));
  (void)world.add(post<TypeParam>(0.2, 0.1));
  ASSERT_EQ(world.step(S(0.01)), Status::kOk);
  EXPECT_EQ(world.report().time_held, S(0));
  EXPECT_NEAR(gap_between(world, 0, 1), 0.01, 1e-4);
}

/// A hand of infinite mass.
template <class SceneT>
Actor<SceneT> unyielding_hand(double x) {
  using S = typename SceneT::Scalar;
  auto hand = post<SceneT>(x, 0.1);
  hand.controller = Hand<S>{{vec<S>(x, 0, 0), Quat<S>::Identity()}, S(0.1)};
  return hand;
}

template <class SceneT>
void lead_to(World<SceneT>& world, double x) {
  using S = typename SceneT::Scalar;
  world.get(world.id_at(0))->controller.template as<Hand<S>>()->target_W.p_W = vec<S>(x, 0, 0);
}

// Neither the hand nor the wall can be pushed: pressed together they stop, and leave when led away.
TYPED_TEST(SearchOfWorld, UnyieldingHandLedAwayFromTheWall_Leaves) {
  using S = typename TypeParam::Scalar;
  World<TypeParam> world;
  (void)world.add(unyielding_hand<TypeParam>(0));
  (void)world.add(post<TypeParam>(0.5, 0.1));
  for (int round = 0; round < 5; ++round) {
    lead_to(world, 0.6);
    for (int i = 0; i < 3; ++i) {
      ASSERT_EQ(world.step(S(0.1)), Status::kOk);
      EXPECT_EQ(world.report().blocked, 1U) << round;
      EXPECT_EQ(world.report().overlaps_at_start, 0U)
          << "within the contact_tolerance is not overlapping";
      EXPECT_GT(gap_between(world, 0, 1), -1e-6);
      EXPECT_LT(gap_between(world, 0, 1), 1e-4);
    }
    lead_to(world, 0.1);
    ASSERT_EQ(world.step(S(0.1)), Status::kOk);
    EXPECT_EQ(world.report().blocked, 0U);
    EXPECT_EQ(world.report().time_held, S(0));
    EXPECT_NEAR(gap_between(world, 0, 1), 0.2, 1e-5);
  }
}

// Walls of infinite mass that overlap from the start may part, and come no deeper.
TYPED_TEST(SearchOfWorld, UnyieldingHandInsideTheWall_MayLeaveAndComesNoDeeper) {
  using S = typename TypeParam::Scalar;
  World<TypeParam> world;
  (void)world.add(unyielding_hand<TypeParam>(0.4));
  (void)world.add(post<TypeParam>(0.5, 0.1));
  lead_to(world, 0.5);
  ASSERT_EQ(world.step(S(0.1)), Status::kOk);
  EXPECT_EQ(world.report().overlaps_at_start, 1U);
  EXPECT_NEAR(gap_between(world, 0, 1), -0.1, 1e-6);
  lead_to(world, 0.35);
  ASSERT_EQ(world.step(S(0.1)), Status::kOk);
  EXPECT_NEAR(gap_between(world, 0, 1), -0.05, 1e-5);
  lead_to(world, 0.1);
  ASSERT_EQ(world.step(S(0.1)), Status::kOk);
  EXPECT_NEAR(gap_between(world, 0, 1), 0.2, 1e-5);
}

// Thinner than what is missing, the pair cannot be made thinner: it stays, and the report says so.
TYPED_TEST(SearchOfWorld, WiresWithoutRadius_StayHeldAndCounted) {
  using S = typename TypeParam::Scalar;
  World<TypeParam> world;
  auto settings = WorldSettings<TypeParam>{};
  if constexpr (!TypeParam::Search::kHasContactTolerance) settings.search.unit = EpsilonIn::kMetres;
  ASSERT_EQ(world.configure(settings), Status::kOk);
  auto hand = unyielding_hand<TypeParam>(0.5);
  auto wall = post<TypeParam>(0.5, 0);
  hand.capsule_B.radius = 0;
  (void)world.add(hand);
  (void)world.add(wall);
  lead_to(world, 0.1);
  ASSERT_EQ(world.step(S(0.1)), Status::kOk);
  EXPECT_EQ(world.report().blocked, 1U);
  EXPECT_EQ(world.get(world.id_at(0))->body.X_WB.p_W.x(), S(0.5));
}

using SlidingScene = FlightScene<double, Translation>;

TEST(WorldSearch, TurningBodyInASceneWithoutRotation_IsHeldAndCounted) {
  World<SlidingScene> world;
  auto rod = test::rod<SlidingScene>(0, 0.3, 0.03);
  rod.body.momentum.linear_W = vec<double>(1, 0, 0);
  rod.body.momentum.angular_W = vec<double>(0, 0.01, 0);
  (void)world.add(rod);
  (void)world.add(post<SlidingScene>(0.2, 0.1));
  ASSERT_EQ(world.step(0.1), Status::kOk);
  EXPECT_EQ(world.report().searches_invalid, 1U);
  EXPECT_FALSE(world.report().complete());
  EXPECT_EQ(world.get(world.id_at(0))->body.X_WB.p_W, (Vec3<double>::Zero()));
}

TEST(WorldSearch, AdvancementOutOfBudget_StopsThePairBeforeTheContact) {
  using SceneT = FlightScene<double, Advancement>;
  World<SceneT> world;
  WorldSettings<SceneT> settings;
  settings.search.budget = 1;
  ASSERT_EQ(world.configure(settings), Status::kOk);
  auto rod = test::rod<SceneT>(0, 0.4, 0.02);
  rod.body.momentum.linear_W = vec<double>(1, 0, 0);
  rod.body.momentum.angular_W = vec<double>(0, 0.4, 0);
  (void)world.add(rod);
  (void)world.add(post<SceneT>(0.6, 0.1));
  ASSERT_EQ(world.step(1.0), Status::kOk);
  EXPECT_EQ(world.report().searches_cut, 1U);
  EXPECT_FALSE(world.report().complete());
  EXPECT_GT(gap_between(world, 0, 1), 0);
  EXPECT_GT(world.report().time_held, 0);
}

/// Rods that fly and turn at each other.
template <class SceneT>
void fill(World<SceneT>& world) {
  for (int i = 0; i < 5; ++i) {
    auto rod = test::rod<SceneT>(0.45 * i - 0.9, 0.3, 0.03);
    rod.body.momentum.linear_W = vec<typename SceneT::Scalar>(-0.8 * (i - 2), 0.03 * i, -0.02 * i);
    rod.body.momentum.angular_W = vec<typename SceneT::Scalar>(0.02 * i, -0.04, 0);
    rod.restitution = static_cast<typename SceneT::Scalar>(0.8);
    (void)world.add(rod);
  }
}

template <class SceneT>
bool same_bits(const World<SceneT>& P, const World<SceneT>& Q) {
  bool same = P.size() == Q.size() && P.report().evaluations == Q.report().evaluations &&
              P.events().size() == Q.events().size();
  for (std::uint16_t slot = 0; slot < P.size(); ++slot) {
    const Body<typename SceneT::Scalar>& a = P.get(P.id_at(slot))->body;
    const Body<typename SceneT::Scalar>& b = Q.get(P.id_at(slot))->body;
    same = same && std::memcmp(&a.X_WB, &b.X_WB, sizeof a.X_WB) == 0 &&
           std::memcmp(&a.momentum, &b.momentum, sizeof a.momentum) == 0;
  }
  return same;
}

// A saved world goes on with the same bits and at the same cost: nothing that matters is outside.
TEST(WorldSearch, RestoredWorld_GoesOnWithTheSameBits) {
  using SceneT = FlightScene<float, Advancement>;
  const auto world = std::make_unique<World<SceneT>>(7);
  const auto saved = std::make_unique<World<SceneT>>();
  (void)saved->add(ball<SceneT>(0, 0.1, 1));  // what was in it is gone
  fill(*world);
  std::uint32_t collisions = 0;
  for (int save = 0; save < 5; ++save) {
    for (int i = 0; i < 60; ++i) ASSERT_EQ(world->step(1e-3F), Status::kOk);
    saved->restore(*world);
    ASSERT_TRUE(same_bits(*world, *saved));
    for (int i = 0; i < 60; ++i) {
      ASSERT_EQ(world->step(1e-3F), Status::kOk);
      ASSERT_EQ(saved->step(1e-3F), Status::kOk);
      ASSERT_TRUE(same_bits(*world, *saved)) << "save " << save << ", step " << i;
      collisions += saved->report().collisions;
    }
  }
  EXPECT_GT(collisions, 2U);
}

// A contact that began before the save persists after it.
TEST(WorldSearch, RestoredWorld_KnowsWhatIsInContact) {
  using SceneT = FlightScene<float, Advancement>;
  World<SceneT> world;
  World<SceneT> saved;
  (void)world.add(unyielding_hand<SceneT>(0));
  (void)world.add(post<SceneT>(0.5, 0.1));
  lead_to(world, 0.6);
  ASSERT_EQ(world.step(0.1F), Status::kOk);
  saved.restore(world);
  ASSERT_EQ(saved.events().size(), 1);
  EXPECT_EQ(saved.events()[0].kind, EventKind::kBegin);
  ASSERT_EQ(saved.step(0.1F), Status::kOk);
  ASSERT_EQ(saved.events().size(), 1);
  EXPECT_EQ(saved.events()[0].kind, EventKind::kPersist);
}

TEST(WorldSearch, RestoredFromItself_IsAsItWas) {
  using SceneT = FlightScene<float, Advancement>;
  World<SceneT> world;
  World<SceneT> twin;
  fill(world);
  fill(twin);
  world.restore(world);
  EXPECT_TRUE(same_bits(world, twin));
}

// Two slanting blades that stay apart: the normal of the last step is all that the next one needs.
TEST(WorldSearch, NormalOfTheLastStep_SavesTheSearch) {
  using SceneT = FlightScene<float, Advancement>;
  World<SceneT> world;
  auto first = test::rod<SceneT>(0, 0.3, 0.01);
  auto second = test::rod<SceneT>(0.05, 0.3, 0.01);
  first.body.X_WB.q_WB = second.body.X_WB.q_WB = Quat<float>(0.92388F, 0, 0.38268F, 0);
  second.body.momentum.angular_W = vec<float>(1e-4, 0, 0);
  (void)world.add(first);
  (void)world.add(second);
  ASSERT_EQ(world.step(0.05F), Status::kOk);
  EXPECT_EQ(world.report().pairs, 1U);
  EXPECT_GE(world.report().evaluations, 1U);
  ASSERT_EQ(world.step(0.05F), Status::kOk);
  EXPECT_EQ(world.report().pairs, 0U);
  EXPECT_EQ(world.report().evaluations, 0U);
}

}  // namespace
}  // namespace batuta
