// SPDX-License-Identifier: MIT
#include "batuta/world/world.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "scenes.hpp"

namespace batuta {
namespace {

using test::ball;
using test::FlightScene;
using test::post;
using test::vec;

template <class S>
class WorldOf : public ::testing::Test {
 protected:
  using SceneT = FlightScene<S>;
  using WorldT = World<SceneT>;
  WorldT world;

  Actor<SceneT>& at(typename WorldT::BodyId id) { return *world.get(id); }
};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(WorldOf, Scalars);

TYPED_TEST(WorldOf, FreeBody_MovesByItsMomentum) {
  const auto id = this->world.add(ball<FlightScene<TypeParam>>(1, 0.1, 2)).value;
  ASSERT_EQ(this->world.step(TypeParam(0.5)), Status::kOk);
  EXPECT_NEAR(this->at(id).body.X_WB.p_W.x(), 2.0, 1e-6);
  EXPECT_TRUE(this->world.report().complete());
  EXPECT_EQ(this->world.events().size(), 0);
}

// Two equal balls, elastic: they exchange velocities at t = (2 - 0.2) / 3, whatever the step.
TYPED_TEST(WorldOf, HeadOnElastic_ExchangesVelocities) {
  using S = TypeParam;
  const auto left = this->world.add(ball<FlightScene<S>>(0, 0.1, 2)).value;
  const auto right = this->world.add(ball<FlightScene<S>>(2, 0.1, -1)).value;
  int begins = 0;
  double t_hit = 0;
  for (int i = 0; i < 100; ++i) {
    ASSERT_EQ(this->world.step(S(0.01)), Status::kOk);
    ASSERT_TRUE(this->world.report().complete());
    for (const auto& event : this->world.events()) {
      if (event.kind != EventKind::kBegin) continue;
      ++begins;
      t_hit = 0.01 * i + static_cast<double>(event.time);
      EXPECT_EQ(event.contact_kind, ContactKind::kColliding);
      EXPECT_NEAR(event.impulse, 3.0, 1e-5);
      EXPECT_NEAR(event.v_rel, -3.0, 1e-5);
      EXPECT_NEAR(event.contact.point_W.x(), 1.3, 1e-4);
      EXPECT_NEAR(event.contact.normal_BA_W.x(), -1.0, 1e-6);
    }
  }
  EXPECT_EQ(begins, 1);
  EXPECT_NEAR(t_hit, 0.6, 1e-5);
  EXPECT_NEAR(this->at(left).body.momentum.p_W.x(), -1.0, 1e-5);
  EXPECT_NEAR(this->at(right).body.momentum.p_W.x(), 2.0, 1e-5);
  EXPECT_NEAR(this->at(left).body.X_WB.p_W.x(), 2 * 0.6 - 0.4, 1e-4);
  EXPECT_NEAR(this->at(right).body.X_WB.p_W.x(), 2 - 0.6 + 2 * 0.4, 1e-4);
}

TYPED_TEST(WorldOf, ContactEvents_BeginOnceAndEndOnce) {
  using S = TypeParam;
  (void)this->world.add(ball<FlightScene<S>>(0, 0.1, 1));
  (void)this->world.add(post<FlightScene<S>>(0.5, 0.1));
  int begins = 0;
  int ends = 0;
  for (int i = 0; i < 100; ++i) {
    ASSERT_EQ(this->world.step(S(0.01)), Status::kOk);
    for (const auto& event : this->world.events()) {
      begins += event.kind == EventKind::kBegin ? 1 : 0;
      ends += event.kind == EventKind::kEnd ? 1 : 0;
      EXPECT_LE(begins - ends, 1);
      EXPECT_LT(event.body_A, event.body_B);
    }
  }
  EXPECT_EQ(begins, 1);
  EXPECT_EQ(ends, 1);
}

TYPED_TEST(WorldOf, FixedBody_StaysAndReflectsElastically) {
  using S = TypeParam;
  const auto id = this->world.add(ball<FlightScene<S>>(0, 0.1, 1)).value;
  const auto wall = this->world.add(post<FlightScene<S>>(0.5, 0.1)).value;
  for (int i = 0; i < 60; ++i) ASSERT_EQ(this->world.step(S(0.01)), Status::kOk);
  EXPECT_NEAR(this->at(id).body.momentum.p_W.x(), -1.0, 1e-6);
  EXPECT_NEAR(this->at(id).body.X_WB.p_W.x(), 0.3 - 0.3, 1e-4);
  EXPECT_EQ(this->at(wall).body.X_WB.p_W, vec<S>(0.5, 0, 0));
  EXPECT_EQ(this->at(wall).body.momentum.p_W, (Vec3<S>::Zero()));
}

// A bullet that crosses the wall within one step is found (the paper's Fig. 1).
TYPED_TEST(WorldOf, FastBody_DoesNotTunnel) {
  using S = TypeParam;
  const auto id = this->world.add(ball<FlightScene<S>>(0, 0.01, 1000)).value;
  (void)this->world.add(post<FlightScene<S>>(0.5, 0.01));
  ASSERT_EQ(this->world.step(S(0.001)), Status::kOk);
  EXPECT_EQ(this->world.report().collisions, 1);
  EXPECT_LT(this->at(id).body.X_WB.p_W.x(), 0.5);
  EXPECT_LT(this->at(id).body.momentum.p_W.x(), 0);
}

// Newton's cradle with gaps: the collisions come one after the other within one step.
TYPED_TEST(WorldOf, ChainOfBalls_PassesTheMomentumOnWithinOneStep) {
  using S = TypeParam;
  std::array<typename TestFixture::WorldT::BodyId, 4> ids;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    ids[i] =
        this->world.add(ball<FlightScene<S>>(0.25 * static_cast<double>(i), 0.1, i == 0 ? 1 : 0))
            .value;
  }
  ASSERT_EQ(this->world.step(S(0.5)), Status::kOk);
  EXPECT_TRUE(this->world.report().complete());
  EXPECT_EQ(this->world.report().collisions, 3);
  EXPECT_NEAR(this->at(ids[0]).body.momentum.p_W.x(), 0, 1e-5);
  EXPECT_NEAR(this->at(ids[3]).body.momentum.p_W.x(), 1, 1e-5);
  EXPECT_NEAR(this->at(ids[3]).body.X_WB.p_W.x(), 0.75 + 0.5 - 3 * 0.05, 1e-3);
}

// Random elastic gas between posts: momentum and energy of the gas alone, no overlap ever.
TYPED_TEST(WorldOf, RandomBalls_ConserveMomentumAndEnergyAndNeverOverlap) {
  using S = TypeParam;
  const std::array<double, 5> x = {-2, -1, 0.2, 1.1, 2.3};
  const std::array<double, 5> v = {1.7, -0.4, 0.9, -2.1, -0.6};
  double momentum = 0;
  double energy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    (void)this->world.add(ball<FlightScene<S>>(x[i], 0.1, v[i]));
    momentum += v[i];
    energy += v[i] * v[i] / 2;
  }
  int collisions = 0;
  for (int i = 0; i < 300; ++i) {
    ASSERT_EQ(this->world.step(S(0.01)), Status::kOk);
    ASSERT_TRUE(this->world.report().complete());
    collisions += this->world.report().collisions;
    for (std::uint16_t a = 0; a + 1 < 5; ++a) {
      const S gap = this->at(this->world.id_at(a + 1)).body.X_WB.p_W.x() -
                    this->at(this->world.id_at(a)).body.X_WB.p_W.x() - S(0.2);
      ASSERT_GT(gap, S(-1e-6)) << "step " << i << " pair " << a;
    }
  }
  EXPECT_GE(collisions, 5);
  double momentum_after = 0;
  for (std::uint16_t a = 0; a < 5; ++a) {
    momentum_after += static_cast<double>(this->at(this->world.id_at(a)).body.momentum.p_W.x());
  }
  EXPECT_NEAR(momentum_after, momentum, 1e-5);
  EXPECT_NEAR(test::total_energy(this->world), energy, 1e-5);
}

// C = 0 against a wall that is pressed on by a velocity below eps_r: separation, not a thousand
// impulses.
TYPED_TEST(WorldOf, SlowApproach_IsSeparatedToD) {
  using S = TypeParam;
  WorldSettings<S> settings;
  settings.rest_speed = S(0.01);
  settings.separation = S(1e-3);
  ASSERT_EQ(this->world.configure(settings), Status::kOk);
  const auto id = this->world.add(ball<FlightScene<S>>(0, 0.1, 0.005)).value;
  (void)this->world.add(post<FlightScene<S>>(0.2 + 1e-5, 0.1));
  ASSERT_EQ(this->world.step(S(0.01)), Status::kOk);
  EXPECT_EQ(this->world.report().separations, 1);
  EXPECT_EQ(this->world.report().collisions, 0);
  const double gap = 0.2 + 1e-5 - 0.2 - static_cast<double>(this->at(id).body.X_WB.p_W.x());
  EXPECT_GT(gap, 0.9e-3);
  EXPECT_LE(gap, 1e-3 + 1e-6);
}

// A body pushed into another for many steps: bounded contacts, no overlap, all of it reported.
TYPED_TEST(WorldOf, PressedTogetherByHands_NeverOverlaps) {
  using S = TypeParam;
  auto left = ball<FlightScene<S>>(-0.2, 0.1, 0);
  auto right = ball<FlightScene<S>>(0.2, 0.1, 0);
  left.driver = Hand<S>{{vec<S>(0.05, 0, 0), Quat<S>::Identity()}, S(0.001)};
  right.driver = Hand<S>{{vec<S>(-0.05, 0, 0), Quat<S>::Identity()}, S(0.001)};
  const auto a = this->world.add(left).value;
  const auto b = this->world.add(right).value;
  bool dropped = false;
  for (int i = 0; i < 50; ++i) {
    ASSERT_EQ(this->world.step(S(0.001)), Status::kOk);
    dropped = dropped || this->world.report().contacts_dropped > 0;
    const S gap = this->at(b).body.X_WB.p_W.x() - this->at(a).body.X_WB.p_W.x() - S(0.2);
    ASSERT_GT(gap, S(-1e-6)) << "step " << i;
  }
  EXPECT_TRUE(dropped)
      << "hands that do not give way use up the contacts of a step, and the report says so";
}

// A disc whose only capsule is a spoke: the spin about the disc's axis shows, and must not be left
// out.
TYPED_TEST(WorldOf, SpinOfACapsuleOffTheAxis_IsShown) {
  using S = TypeParam;
  auto disc = ball<FlightScene<S>>(0, 0.1, 0);
  disc.body = make_body<S>({}, S(1), Vec3<S>(1, 1, 2)).value;
  disc.body.momentum.b_W = vec<S>(0, 0, 2);  // one radian a second
  disc.capsule_B = {{vec<S>(0, 0, 0), vec<S>(1, 0, 0)}, S(0.01)};
  const auto id = this->world.add(disc).value;
  ASSERT_EQ(this->world.step(S(1)), Status::kOk);
  const Vec3<S> tip_W = to_world(this->at(id).body.X_WB, vec<S>(1, 0, 0));
  EXPECT_NEAR(tip_W.x(), std::cos(1.0), 1e-6);
  EXPECT_NEAR(tip_W.y(), std::sin(1.0), 1e-6);
}

// Two rods, a hit near an end: float follows the double oracle through the contact and after it.
TEST(World, FloatAgreesWithDouble) {
  World<FlightScene<float>> single;
  World<FlightScene<double>> oracle;
  const auto place = [](auto& world) {
    using SceneT = FlightScene<typename std::decay_t<decltype(world)>::Scalar>;
    using S = typename SceneT::Scalar;
    auto A = test::rod<SceneT>(0, 0.5, 0.01);
    auto B = test::rod<SceneT>(0.3, 0.5, 0.01);
    A.restitution = S(0.5);
    A.body.momentum.p_W = vec<S>(3, 0.02, 0);
    A.body.momentum.b_W = vec<S>(0, 0.05, 0);
    (void)world.add(A);
    (void)world.add(B);
  };
  place(single);
  place(oracle);
  for (int i = 0; i < 200; ++i) {
    ASSERT_EQ(single.step(1e-3F), Status::kOk);
    ASSERT_EQ(oracle.step(1e-3), Status::kOk);
    ASSERT_EQ(single.report().collisions, oracle.report().collisions) << "step " << i;
  }
  for (std::uint16_t slot = 0; slot < 2; ++slot) {
    const auto& f = single.get(single.id_at(slot))->body;
    const auto& d = oracle.get(oracle.id_at(slot))->body;
    EXPECT_LT((f.X_WB.p_W.cast<double>() - d.X_WB.p_W).norm(), 1e-4);
    EXPECT_LT((f.momentum.p_W.cast<double>() - d.momentum.p_W).norm(), 1e-4);
    EXPECT_LT((f.momentum.b_W.cast<double>() - d.momentum.b_W).norm(), 1e-4);
  }
}

}  // namespace
}  // namespace batuta
