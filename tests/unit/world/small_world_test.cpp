// SPDX-License-Identifier: MIT
// The world of a few bodies that fly straight: against the general one, and against what must hold.

#include "small_scenes.hpp"

namespace batuta {
namespace {

using namespace test;

TYPED_TEST_SUITE(Small, SmallScenes);

// A blow amplifies rounding by no more than a few times, and few follow each other in a step.
TYPED_TEST(Small, ThousandScenes_SameBlowsAsInTheGeneralWorld) {
  using S = typename TypeParam::Scalar;
  std::uint32_t blows = 0;
  for (unsigned seed = 0; seed < 1000; ++seed) {
    Draw draw(seed);
    World<TypeParam> small;
    World<Told<TypeParam>> general;
    for (const auto& actor : draw.actors<TypeParam>(2 + static_cast<int>(seed % 7))) {
      ASSERT_TRUE(small.add(actor).ok());
      ASSERT_TRUE(general.add(told(actor)).ok());
    }
    ASSERT_EQ(small.step(S(0.1)), Status::kOk);
    ASSERT_EQ(general.step(S(0.1)), Status::kOk);
    ASSERT_TRUE(small.report().complete());
    ASSERT_EQ(small.report().collisions, general.report().collisions) << "seed " << seed;
    blows += small.report().collisions;
    for (std::uint16_t slot = 0; slot < small.size(); ++slot) {
      const auto& mine = small.get(small.id_at(slot))->body;
      const auto& theirs = general.get(general.id_at(slot))->body;
      ASSERT_NEAR((mine.p_W - theirs.p_W).norm(), 0, TestFixture::kSame) << "seed " << seed;
      ASSERT_NEAR((mine.momentum_W - theirs.momentum_W).norm(), 0, 10 * TestFixture::kSame)
          << "seed " << seed;
    }
  }
  EXPECT_GT(blows, 200U);
}

// The gap at a contact is at least what a search resolves; then every pose is rounded.
TYPED_TEST(Small, CrowdOfEight_NeverOverlaps) {
  using S = typename TypeParam::Scalar;
  for (unsigned seed = 0; seed < 50; ++seed) {
    Draw draw(seed);
    World<TypeParam> world;
    for (const auto& actor : draw.actors<TypeParam>(8)) ASSERT_TRUE(world.add(actor).ok());
    for (int step = 0; step < 100; ++step) {
      ASSERT_EQ(world.step(S(0.01)), Status::kOk);
      ASSERT_GT(least_gap(world), -TestFixture::kRounding) << "seed " << seed << " step " << step;
    }
  }
}

TYPED_TEST(Small, ElasticCrowdWithoutGravity_KeepsMomentumAndEnergy) {
  using S = typename TypeParam::Scalar;
  for (unsigned seed = 0; seed < 50; ++seed) {
    World<TypeParam> world;
    WorldSettings<TypeParam> settings;
    settings.gravity_W.setZero();
    ASSERT_EQ(world.configure(settings), Status::kOk);
    for (auto actor : Draw(seed).actors<TypeParam>(8, true)) {
      if (actor.body.inverse_mass == S(0)) actor.body.inverse_mass = 1;
      ASSERT_TRUE(world.add(actor).ok());
    }
    const auto sums = [&world] {
      std::pair<Vec3<double>, double> all = {Vec3<double>::Zero(), 0};
      for (std::uint16_t slot = 0; slot < world.size(); ++slot) {
        const auto& body = world.get(world.id_at(slot))->body;
        const Vec3<double> p = body.momentum_W.template cast<double>();
        all.first += p;
        all.second += p.squaredNorm() * static_cast<double>(body.inverse_mass) / 2;
      }
      return all;
    };
    const auto before = sums();
    for (int step = 0; step < 20; ++step) ASSERT_EQ(world.step(S(0.02)), Status::kOk);
    EXPECT_NEAR((sums().first - before.first).norm(), 0, 100 * TestFixture::kRounding);
    EXPECT_NEAR(sums().second / before.second, 1, 100 * TestFixture::kRounding);
  }
}

// Elastic, 1 kg against 3 kg: v1' = -v / 2, v3' = v / 2.
TYPED_TEST(Small, ElasticBlow_FollowsTheTextbook) {
  World<TypeParam> world;
  WorldSettings<TypeParam> settings;
  settings.gravity_W.setZero();
  ASSERT_EQ(world.configure(settings), Status::kOk);
  const auto light = world.add(ball<TypeParam>(0, 2)).value;
  const auto heavy = world.add(ball<TypeParam>(1, 0, 3)).value;
  ASSERT_EQ(world.step(1), Status::kOk);
  EXPECT_EQ(world.report().collisions, 1U);
  EXPECT_NEAR(world.get(light)->body.momentum_W.x(), -1, 1e-5);
  EXPECT_NEAR(world.get(heavy)->body.momentum_W.x(), 3, 1e-5);
  EXPECT_NEAR(world.get(light)->body.p_W.x(), 0.8 - 0.6, 1e-4) << "touch at 0.4 s";
  EXPECT_NEAR(world.get(heavy)->body.p_W.x(), 1 + 0.6, 1e-4);
}

// Falls by g t^2 / 2, whatever the step; what is fixed does not.
TYPED_TEST(Small, FreeFall_IsTheParabola) {
  using S = typename TypeParam::Scalar;
  World<TypeParam> world;
  const auto falling = world.add(ball<TypeParam>(0, 0, 2)).value;
  const auto fixed = world.add(ball<TypeParam>(5, 0, INFINITY)).value;
  for (int i = 0; i < 100; ++i) ASSERT_EQ(world.step(S(1e-2)), Status::kOk);
  EXPECT_NEAR(world.get(falling)->body.p_W.z(), -9.81 / 2, 1e-5 * 9.81 / 2);
  EXPECT_NEAR(world.get(falling)->body.momentum_W.z(), -2 * 9.81, 1e-4);
  EXPECT_EQ(world.get(fixed)->body.p_W.z(), 0);
}

// Who lies on another is struck from the side: two of one mass, C = 1, change velocities.
TYPED_TEST(Small, WhoIsCarriedAndStruck_AnswersWithItsRestitution) {
  using S = typename TypeParam::Scalar;
  World<TypeParam> world;
  const auto add = [&world](double x, double z, double vx, double mass) {
    auto actor = ball<TypeParam>(x, vx, mass);
    put_shape(actor, {0, 0, 0}, 0.1);
    actor.body.p_W.z() = static_cast<S>(z);
    return world.add(actor).value;
  };
  add(0, -0.2 - 1e-6, 0, INFINITY);
  const auto carried = add(0, 0, 0, 1);
  const auto striker = add(-0.21, 0, 2, 1);
  ASSERT_EQ(world.step(S(0.01)), Status::kOk);
  EXPECT_TRUE(world.report().complete());
  // Until they meet, after 5 ms, the striker falls by 0.12 mm: the normal tilts by 0.6 mrad.
  EXPECT_NEAR(world.get(carried)->body.momentum_W.x(), 2, 4e-3);
  EXPECT_NEAR(world.get(striker)->body.momentum_W.x(), 0, 4e-3);
  // Upwards there is nothing but what the tilt gives it: its weight is carried once.
  EXPECT_LE(world.get(carried)->body.momentum_W.z(), 2 * 6.2e-4);
  EXPECT_GE(world.get(carried)->body.momentum_W.z(), -9.81 * 0.005 - 1e-4)
      << "it falls from then on";
}

// The middle one is hit from both sides at once: the lower pair first, whatever the last bits say.
// 1 kg at 1 m/s, 1 kg, 3 kg at -1 m/s: 0 gives all to 1; 1 takes all from 2, and gives it to 0.
TYPED_TEST(Small, ContactsAtTheSameTime_AreAnsweredByTheirNames) {
  using S = typename TypeParam::Scalar;
  for (const int ulps : {-1, 0, 1}) {
    World<TypeParam> world;
    for (int i = 0; i < 3; ++i) {
      auto actor = ball<TypeParam>(i - 1, 1 - i, i == 2 ? 3 : 1);
      S& x = actor.body.p_W.x();
      if (i == 2 && ulps != 0) x = std::nextafter(x, ulps > 0 ? S(2) : S(0));
      ASSERT_TRUE(world.add(actor).ok());
    }
    ASSERT_EQ(world.step(1), Status::kOk);
    EXPECT_TRUE(world.report().complete());
    EXPECT_EQ(world.report().collisions, 3U);
    EXPECT_NEAR(world.get(world.id_at(0))->body.momentum_W.x(), -2, 1e-4) << ulps;
    EXPECT_NEAR(world.get(world.id_at(1))->body.momentum_W.x(), 0, 1e-4) << ulps;
    EXPECT_NEAR(world.get(world.id_at(2))->body.momentum_W.x(), 0, 1e-4) << ulps;
  }
}

TYPED_TEST(Small, TouchingAndParting_IsLeftAlone) {
  World<TypeParam> world;
  ASSERT_TRUE(world.add(ball<TypeParam>(0, -1)).ok());
  ASSERT_TRUE(world.add(ball<TypeParam>(0.2, 1)).ok());
  ASSERT_EQ(world.step(1), Status::kOk);
  EXPECT_EQ(world.report().collisions, 0U);
  EXPECT_TRUE(world.report().complete());
}

}  // namespace
}  // namespace batuta
