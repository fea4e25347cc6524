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

template <class SceneT>
class WorldOf : public ::testing::Test {
 protected:
  using WorldT = World<SceneT>;
  WorldT world;

  Actor<SceneT>& at(typename WorldT::BodyId id) { return *world.get(id); }
};
using Scenes = ::testing::Types<FlightScene<float, Advancement>, FlightScene<double, Advancement>,
                                FlightScene<float, Stepping>, FlightScene<double, Stepping>>;
TYPED_TEST_SUITE(WorldOf, Scenes);

TYPED_TEST(WorldOf, FreeBody_MovesByItsMomentum) {
  using S = typename TypeParam::Scalar;
  const auto id = this->world.add(ball<TypeParam>(1, 0.1, 2)).value;
  ASSERT_EQ(this->world.step(S(0.5)), Status::kOk);
  EXPECT_NEAR(this->at(id).body.X_WB.p_W.x(), 2.0, 1e-6);
  EXPECT_TRUE(this->world.report().complete());
  EXPECT_EQ(this->world.events().size(), 0);
}

// Two equal balls, elastic: they exchange velocities at t = (2 - 0.2) / 3, whatever the step.
TYPED_TEST(WorldOf, HeadOnElastic_ExchangesVelocities) {
  using S = typename TypeParam::Scalar;
  const auto left = this->world.add(ball<TypeParam>(0, 0.1, 2)).value;
  const auto right = this->world.add(ball<TypeParam>(2, 0.1, -1)).value;
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
  EXPECT_NEAR(this->at(left).body.momentum.linear_W.x(), -1.0, 1e-5);
  EXPECT_NEAR(this->at(right).body.momentum.linear_W.x(), 2.0, 1e-5);
  EXPECT_NEAR(this->at(left).body.X_WB.p_W.x(), 2 * 0.6 - 0.4, 1e-4);
  EXPECT_NEAR(this->at(right).body.X_WB.p_W.x(), 2 - 0.6 + 2 * 0.4, 1e-4);
}

TYPED_TEST(WorldOf, ContactEvents_BeginOnceAndEndOnce) {
  using S = typename TypeParam::Scalar;
  (void)this->world.add(ball<TypeParam>(0, 0.1, 1));
  (void)this->world.add(post<TypeParam>(0.5, 0.1));
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
  using S = typename TypeParam::Scalar;
  const auto id = this->world.add(ball<TypeParam>(0, 0.1, 1)).value;
  const auto wall = this->world.add(post<TypeParam>(0.5, 0.1)).value;
  for (int i = 0; i < 60; ++i) ASSERT_EQ(this->world.step(S(0.01)), Status::kOk);
  EXPECT_NEAR(this->at(id).body.momentum.linear_W.x(), -1.0, 1e-6);
  EXPECT_NEAR(this->at(id).body.X_WB.p_W.x(), 0.3 - 0.3, 1e-4);
  EXPECT_EQ(this->at(wall).body.X_WB.p_W, vec<S>(0.5, 0, 0));
  EXPECT_EQ(this->at(wall).body.momentum.linear_W, (Vec3<S>::Zero()));
}

// A bullet that crosses the wall within one step is found (the paper's Fig. 1).
TYPED_TEST(WorldOf, FastBody_DoesNotTunnel) {
  using S = typename TypeParam::Scalar;
  const auto id = this->world.add(ball<TypeParam>(0, 0.01, 1000)).value;
  (void)this->world.add(post<TypeParam>(0.5, 0.01));
  ASSERT_EQ(this->world.step(S(0.001)), Status::kOk);
  EXPECT_EQ(this->world.report().collisions, 1);
  EXPECT_LT(this->at(id).body.X_WB.p_W.x(), 0.5);
  EXPECT_LT(this->at(id).body.momentum.linear_W.x(), 0);
}

// Newton's cradle with gaps: the collisions come one after the other within one step.
TYPED_TEST(WorldOf, ChainOfBalls_PassesTheMomentumOnWithinOneStep) {
  using S = typename TypeParam::Scalar;
  std::array<typename TestFixture::WorldT::BodyId, 4> ids;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    ids[i] =
        this->world.add(ball<TypeParam>(0.25 * static_cast<double>(i), 0.1, i == 0 ? 1 : 0)).value;
  }
  ASSERT_EQ(this->world.step(S(0.5)), Status::kOk);
  EXPECT_TRUE(this->world.report().complete());
  EXPECT_EQ(this->world.report().collisions, 3);
  EXPECT_NEAR(this->at(ids[0]).body.momentum.linear_W.x(), 0, 1e-5);
  EXPECT_NEAR(this->at(ids[3]).body.momentum.linear_W.x(), 1, 1e-5);
  EXPECT_NEAR(this->at(ids[3]).body.X_WB.p_W.x(), 0.75 + 0.5 - 3 * 0.05, 1e-3);
}

// Five elastic balls on a line: momentum and energy are kept, no overlap ever.
TYPED_TEST(WorldOf, BallsOnALine_ConserveMomentumAndEnergyAndNeverOverlap) {
  using S = typename TypeParam::Scalar;
  const std::array<double, 5> x = {-2, -1, 0.2, 1.1, 2.3};
  const std::array<double, 5> v = {1.7, -0.4, 0.9, -2.1, -0.6};
  double momentum = 0;
  double energy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    (void)this->world.add(ball<TypeParam>(x[i], 0.1, v[i]));
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
    momentum_after +=
        static_cast<double>(this->at(this->world.id_at(a)).body.momentum.linear_W.x());
  }
  EXPECT_NEAR(momentum_after, momentum, 1e-5);
  EXPECT_NEAR(test::total_energy(this->world), energy, 1e-5);
}

// C = 0 against a wall that is pressed on by a velocity below eps_r: separation, not a thousand
// impulses.
TYPED_TEST(WorldOf, SlowApproach_IsSeparatedToD) {
  using S = typename TypeParam::Scalar;
  WorldSettings<TypeParam> settings;
  settings.rest_speed = S(0.01);
  settings.separation = S(1e-3);
  ASSERT_EQ(this->world.configure(settings), Status::kOk);
  const auto id = this->world.add(ball<TypeParam>(0, 0.1, 0.005)).value;
  (void)this->world.add(post<TypeParam>(0.2 + 1e-5, 0.1));
  ASSERT_EQ(this->world.step(S(0.01)), Status::kOk);
  EXPECT_EQ(this->world.report().separations, 1);
  EXPECT_EQ(this->world.report().collisions, 0);
  const double gap = 0.2 + 1e-5 - 0.2 - static_cast<double>(this->at(id).body.X_WB.p_W.x());
  EXPECT_GT(gap, 0.9e-3);
  EXPECT_LE(gap, 1e-3 + 1e-6);
}

// Two hands that want their bodies in the same place: one blow a step each, no overlap, nothing
// left out.
TYPED_TEST(WorldOf, PressedTogetherByHands_NeverOverlaps) {
  using S = typename TypeParam::Scalar;
  auto left = ball<TypeParam>(-0.2, 0.1, 0);
  auto right = ball<TypeParam>(0.2, 0.1, 0);
  left.controller = Hand<S>{{vec<S>(0.05, 0, 0), Quat<S>::Identity()}, S(0.001)};
  right.controller = Hand<S>{{vec<S>(-0.05, 0, 0), Quat<S>::Identity()}, S(0.001)};
  const auto a = this->world.add(left).value;
  const auto b = this->world.add(right).value;
  for (int i = 0; i < 50; ++i) {
    ASSERT_EQ(this->world.step(S(0.001)), Status::kOk);
    ASSERT_TRUE(this->world.report().complete());
    EXPECT_LE(this->world.report().collisions, 1U);
    const S gap = this->at(b).body.X_WB.p_W.x() - this->at(a).body.X_WB.p_W.x() - S(0.2);
    ASSERT_GT(gap, S(-1e-6)) << "step " << i;
  }
}

// A disc whose only capsule is a spoke: the spin about the disc's axis shows, and must not be left
// out.
TYPED_TEST(WorldOf, SpinOfACapsuleOffTheAxis_IsShown) {
  using S = typename TypeParam::Scalar;
  auto disc = ball<TypeParam>(0, 0.1, 0);
  disc.body = make_body<S>({}, S(1), Vec3<S>(1, 1, 2)).value;
  disc.body.momentum.angular_W = vec<S>(0, 0, 2);  // one radian a second
  disc.capsule_B = {{vec<S>(0, 0, 0), vec<S>(1, 0, 0)}, S(0.01)};
  const auto id = this->world.add(disc).value;
  ASSERT_EQ(this->world.step(S(1)), Status::kOk);
  const Vec3<S> tip_W = to_world(this->at(id).body.X_WB, vec<S>(1, 0, 0));
  EXPECT_NEAR(tip_W.x(), std::cos(1.0), 1e-6);
  EXPECT_NEAR(tip_W.y(), std::sin(1.0), 1e-6);
}

// What a hand carries has the momentum of its motion when it strikes: equal balls, elastic,
// exchange velocities.
TYPED_TEST(WorldOf, BallInAHand_StrikesWithTheMomentumOfItsMotion) {
  using S = typename TypeParam::Scalar;
  auto carried = ball<TypeParam>(0, 0.1, 0);
  carried.controller = Hand<S>{{vec<S>(0.2, 0, 0), Quat<S>::Identity()}, S(0.1)};  // 2 m/s
  const auto hand = this->world.add(carried).value;
  const auto free = this->world.add(ball<TypeParam>(0.3, 0.1, 0)).value;
  ASSERT_EQ(this->world.step(S(0.1)), Status::kOk);
  EXPECT_NEAR(this->at(free).body.momentum.linear_W.x(), 2, 1e-5);
  EXPECT_NEAR(this->at(hand).body.momentum.linear_W.x(), 0, 1e-5);
}

// A contact ends in the step in which the gap has opened beyond twice the separation distance, not
// later.
TYPED_TEST(WorldOf, EndOfAContact_ComesWhenTheGapIsBeyondTwiceD) {
  using S = typename TypeParam::Scalar;
  const auto id = this->world.add(ball<TypeParam>(0.2, 0.1, 0.05)).value;
  (void)this->world.add(post<TypeParam>(0.4 + 1e-4, 0.1));
  const S beyond = S(2) * WorldSettings<TypeParam>{}.separation;
  int ends = 0;
  for (int i = 0; i < 20; ++i) {
    ASSERT_EQ(this->world.step(S(0.001)), Status::kOk);
    const S gap = S(0.4 + 1e-4) - S(0.2) - this->at(id).body.X_WB.p_W.x();
    for (const auto& event : this->world.events()) {
      if (event.kind != EventKind::kEnd) continue;
      ++ends;
      EXPECT_GT(event.contact.gap, beyond);
      EXPECT_LT(gap, beyond + S(0.051e-3)) << "within a step's way of the limit";
    }
  }
  EXPECT_EQ(ends, 1);
}

// A hand of infinite mass cannot be pushed, and neither can the wall it is led into: it stops
// there, and an event says so.
TYPED_TEST(WorldOf, UnyieldingHandAgainstAWall_IsBlocked) {
  using S = typename TypeParam::Scalar;
  auto hand = post<TypeParam>(0, 0.1);
  const auto wall = this->world.add(post<TypeParam>(0.5, 0.1)).value;
  hand.controller = Hand<S>{{vec<S>(1, 0, 0), Quat<S>::Identity()}, S(0.1)};
  const auto id = this->world.add(hand).value;
  for (int i = 0; i < 3; ++i) {
    ASSERT_EQ(this->world.step(S(0.1)), Status::kOk);
    EXPECT_EQ(this->world.report().blocked, 1U);
    ASSERT_EQ(this->world.events().size(), 1);
    EXPECT_EQ(this->world.events()[0].kind, i == 0 ? EventKind::kBegin : EventKind::kPersist);
    EXPECT_EQ(this->world.events()[0].impulse, 0);
    EXPECT_LT(this->at(id).body.X_WB.p_W.x(), S(0.3));
    EXPECT_GT(this->at(id).body.X_WB.p_W.x(), S(0.29));
  }
  EXPECT_EQ(this->at(wall).body.X_WB.p_W.x(), S(0.5));
}

// A beat is a new beat when the bodies have parted in between, also within a few steps.
TYPED_TEST(WorldOf, EveryBeatOfABounceBetweenTwoWalls_BeginsAndEnds) {
  using S = typename TypeParam::Scalar;
  (void)this->world.add(post<TypeParam>(-0.2, 0.1));
  const auto id = this->world.add(ball<TypeParam>(0, 0.05, 20)).value;
  (void)this->world.add(post<TypeParam>(0.2, 0.1));
  std::uint32_t collisions = 0;
  int begins = 0;
  int ends = 0;
  for (int i = 0; i < 100; ++i) {  // 0.2 m there and back: a bounce in 5 ms
    ASSERT_EQ(this->world.step(S(0.001)), Status::kOk);
    ASSERT_TRUE(this->world.report().complete());
    collisions += this->world.report().collisions;
    for (const auto& event : this->world.events()) {
      begins += event.kind == EventKind::kBegin ? 1 : 0;
      ends += event.kind == EventKind::kEnd ? 1 : 0;
    }
  }
  EXPECT_GE(collisions, 18U);
  EXPECT_EQ(static_cast<std::uint32_t>(begins), collisions);
  EXPECT_LE(begins - ends, 1);
  EXPECT_NEAR(std::abs(this->at(id).body.momentum.linear_W.x()), 20, 1e-4);
}

TYPED_TEST(WorldOf, QuaternionThatIsNotUnit_IsRenewed) {
  using S = typename TypeParam::Scalar;
  auto actor = ball<TypeParam>(0, 0.1, 0);
  actor.body.X_WB.q_WB = Quat<S>(1, 1, 0, 0);
  const auto id = this->world.add(actor).value;
  EXPECT_NEAR(this->at(id).body.X_WB.q_WB.norm(), 1, 1e-6);
}

/// Five rods of different kinds, turning and flying at each other, by a generator with the same
/// numbers everywhere.
template <class SceneT>
void fill_with_rods(World<SceneT>& world, double restitution) {
  using S = typename SceneT::Scalar;
  std::uint32_t state = 12345;
  const auto random = [&state] {  // in [-1, 1]
    state = state * 1664525U + 1013904223U;
    return static_cast<double>(state >> 8U) / double(1U << 23U) - 1;
  };
  for (int i = 0; i < 5; ++i) {
    auto rod = test::rod<SceneT>(0.45 * i - 0.9, 0.3, 0.03);
    const double y = 0.05 * random();
    rod.body.X_WB.p_W.y() = static_cast<S>(y);
    if (i % 2 == 1)
      rod.body.inverse_moments.y() *= S(0.7);  // three unlike moments: not a body of revolution
    for (int k = 0; k < 3; ++k)
      rod.body.momentum.linear_W(k) =
          static_cast<S>((k == 0 ? -0.8 * (i - 2) : 0) + 0.3 * random());
    for (int k = 0; k < 3; ++k)
      rod.body.momentum.angular_W(k) = static_cast<S>((k == 2 ? 1e-4 : 0.05) * random());
    rod.restitution = static_cast<S>(restitution);
    (void)world.add(rod);
  }
}

template <class SceneT>
Vec3<double> total_momentum(World<SceneT>& world) {
  Vec3<double> sum = Vec3<double>::Zero();
  for (std::uint16_t slot = 0; slot < SceneT::kMaxBodies; ++slot) {
    if (auto* actor = world.get(world.id_at(slot))) {
      sum += actor->body.momentum.linear_W.template cast<double>();
    }
  }
  return sum;
}

TYPED_TEST(WorldOf, TurningRods_NeitherGainEnergyNorLoseMomentumNorOverlap) {
  using S = typename TypeParam::Scalar;
  for (const double restitution : {0.0, 0.6, 1.0}) {
    World<TypeParam> gas;
    fill_with_rods(gas, restitution);
    const Vec3<double> momentum = total_momentum(gas);
    const double energy = test::total_energy(gas);
    std::uint32_t collisions = 0;
    for (int i = 0; i < 2000; ++i) {
      ASSERT_EQ(gas.step(S(0.001)), Status::kOk);
      collisions += gas.report().collisions;
      EXPECT_LT(gas.report().deepest_overlap, S(1e-4)) << "step " << i;
      // In free flight with three unlike moments energy sways by a term of second order and does
      // not drift.
      ASSERT_LT(test::total_energy(gas), energy * (1 + 1e-3))
          << "step " << i << ", restitution " << restitution;
    }
    EXPECT_GE(collisions, 3U) << "the rods have to meet";
    EXPECT_LT((total_momentum(gas) - momentum).norm(), 1e-5);
    if (restitution == 1.0) {
      EXPECT_GT(test::total_energy(gas), energy * (1 - 1e-3));
    }
  }
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
    A.body.momentum.linear_W = vec<S>(3, 0.02, 0);
    A.body.momentum.angular_W = vec<S>(0, 0.05, 0);
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
    // Each takes a gap within its own contact tolerance for contact, 6e-6 S in float: seen from the
    // axes the normal differs by the contact tolerance over the radii, and the impulse of 2.7 N s
    // with it.
    EXPECT_LT((f.momentum.linear_W.cast<double>() - d.momentum.linear_W).norm(), 1e-3);
    EXPECT_LT((f.momentum.angular_W.cast<double>() - d.momentum.angular_W).norm(), 1e-4);
  }
}

}  // namespace
}  // namespace batuta
