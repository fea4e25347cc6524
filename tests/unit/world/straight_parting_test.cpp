// SPDX-License-Identifier: MIT
// Bodies that do not turn, touch or are in each other, and part: both engines.

#include <gtest/gtest.h>

#include "draws.hpp"
#include "small_scenes.hpp"

namespace batuta {
namespace {

using namespace test;

/// Where a body's momentum says nothing that its velocity does not.
constexpr SceneOptions weightless_options() {
  SceneOptions scene = lean_scene_options();
  scene.gravity = false;
  return scene;
}
template <class S>
using Weightless = Scene<weightless_options, Spheres<S>>;

template <class SceneT>
class StraightParting : public ::testing::Test {};
using StraightScenes =
    ::testing::Types<LeanScene<Spheres, float>, LeanScene<Spheres, double>,
                     LeanScene<Translation, float>, LeanScene<Translation, double>,
                     Told<LeanScene<Spheres, float>>, Told<LeanScene<Spheres, double>>,
                     Told<LeanScene<Translation, float>>, Told<LeanScene<Translation, double>>,
                     Weightless<float>, Weightless<double>>;
TYPED_TEST_SUITE(StraightParting, StraightScenes);

/// Two in each other by 0.05 m. @returns the world after a step of 1 s
template <class SceneT>
std::unique_ptr<World<SceneT>> overlapping(double v_A, double v_B) {
  auto world = std::make_unique<World<SceneT>>();
  EXPECT_TRUE(world->add(ball<SceneT>(0, v_A)).ok());
  EXPECT_TRUE(world->add(ball<SceneT>(0.15, v_B)).ok());
  EXPECT_EQ(world->step(1), Status::kOk);
  return world;
}

TYPED_TEST(StraightParting, OverlapThatParts_IsToldAndFliesFreely) {
  const auto world = overlapping<TypeParam>(-1, 1);
  EXPECT_EQ(world->report().overlaps_at_start, 1U);
  EXPECT_NEAR(world->report().deepest_overlap, 0.05, 1e-6);
  EXPECT_EQ(world->report().collisions, 0U);
  EXPECT_NEAR(world->get(world->id_at(0))->body.p_W.x(), -1, 1e-6);
  EXPECT_NEAR(world->get(world->id_at(1))->body.p_W.x(), 1.15, 1e-6);
}

// Nothing opens it, so each step in which one of the two may move tells it again.
TYPED_TEST(StraightParting, OverlapThatStays_IsToldInEachStep) {
  const auto world = overlapping<TypeParam>(0.5, 0.5);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(world->report().overlaps_at_start, 1U) << i;
    EXPECT_NEAR(world->report().deepest_overlap, 0.05, 1e-6) << i;
    EXPECT_TRUE(world->report().complete()) << i;
    ASSERT_EQ(world->step(1), Status::kOk);
  }
}

TYPED_TEST(StraightParting, OverlapThatApproaches_IsToldOnceAndBouncesOff) {
  const auto world = overlapping<TypeParam>(1, -1);
  EXPECT_EQ(world->report().overlaps_at_start, 1U);
  EXPECT_NEAR(world->report().deepest_overlap, 0.05, 1e-6);
  EXPECT_EQ(world->report().collisions, 1U);
}

TYPED_TEST(StraightParting, DeepestOfSeveral_IsTheOneThatIsTold) {
  World<TypeParam> world;
  ASSERT_TRUE(world.add(ball<TypeParam>(0, -2)).ok());
  ASSERT_TRUE(world.add(ball<TypeParam>(0.18, 0)).ok());
  ASSERT_TRUE(world.add(ball<TypeParam>(0.29, 2)).ok());
  ASSERT_TRUE(world.add(ball<TypeParam>(2, 0)).ok());
  ASSERT_EQ(world.step(typename TypeParam::Scalar(0.125)), Status::kOk);
  EXPECT_EQ(world.report().overlaps_at_start, 2U);
  EXPECT_NEAR(world.report().deepest_overlap, 0.09, 1e-6);
}

/// Two balls without restitution that touch: they come together along n with 2 m/s, and slide past
/// each other with 2 slip.
template <class SceneT>
void put_sliding(World<SceneT>& world, Draws& draws, const Vec3<double>& n,
                 const Vec3<double>& slip) {
  using S = typename SceneT::Scalar;
  const double apart = 0.2 + 32 * static_cast<double>(kRoundOff<S>);  // touching, for any search
  for (const double side : {1.0, -1.0}) {
    auto actor = ball<SceneT>(0, 0, draws.power_of_two(-8, 2));
    put_shape(actor, {0, 0, 0}, 0.1);
    actor.restitution = 0;
    actor.body.p_W = (side * apart / 2 * n).template cast<S>();
    actor.body.momentum_W = (side * (slip - n)).template cast<S>() / actor.body.inverse_mass;
    ASSERT_TRUE(world.add(actor).ok());
  }
}

// A blow leaves a relative velocity along the normal of about u |v|. Where the search still saw an
// approach in it, and the next blow saw none, the pair was answered until no contact was left, and
// then went on as one: what it had along the tangent was lost.
TYPED_TEST(StraightParting, InelasticBlow_IsOneContactAndKeepsWhatIsAlongTheTangent) {
  using S = typename TypeParam::Scalar;
  for (std::uint64_t seed = 0; seed < 256; ++seed) {
    Draws draws(seed, 0, 0);
    const Vec3<double> n = draws.direction();
    const Vec3<double> across = draws.direction();
    const Vec3<double> slip = draws.between(0.1, 3) * n.cross(across).normalized();
    World<TypeParam> world;
    if constexpr (TypeParam::kGravity) {
      WorldSettings<TypeParam> settings;
      settings.gravity_W = vec<S>(0, 0, seed % 2 == 0 ? 0 : -9.81);
      ASSERT_EQ(world.configure(settings), Status::kOk);
    }
    put_sliding(world, draws, n, slip);
    ASSERT_EQ(world.step(S(0.02)), Status::kOk);
    EXPECT_EQ(world.report().collisions, 1U) << seed;
    EXPECT_TRUE(world.report().complete()) << seed;
    EXPECT_LE(world.report().evaluations, 32U) << seed;
    const auto velocity = [&world](std::uint16_t i) {
      return Vec3<double>(velocity_of(world.get(world.id_at(i))->body).template cast<double>());
    };
    const double off = (velocity(0) - velocity(1) - 2 * slip).norm();
    EXPECT_LE(off, 64 * static_cast<double>(kRoundOff<S>) * (1 + slip.norm())) << seed;
  }
}

}  // namespace
}  // namespace batuta
