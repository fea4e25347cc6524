// SPDX-License-Identifier: MIT
// What random scenes have found (random_checks.hpp), each reduced to the smallest scene that showed
// it.
#include <gtest/gtest.h>

#include <vector>

#include "batuta/record/snapshot.hpp"
#include "batuta/record/world.hpp"
#include "batuta/world/any_controller.hpp"
#include "batuta/world/detail/group_motion.hpp"
#include "choices.hpp"
#include "law_worlds.hpp"

namespace batuta {
namespace {

using test::LawScene;
using test::Vector;

constexpr double kStep = 1e-2;

template <class S>
class FoundAtRandom : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(FoundAtRandom, Scalars);

// The cube of 1e-13 kg m^2 is no number of float's any more: I^-1 L of a group is, and so is the
// torque that resists rolling.
TYPED_TEST(FoundAtRandom, GroupOfGrains_TurnsByItsInertia) {
  const Vec3<TypeParam> moments = Vector(1e-14, 2e-14, 3e-14).template cast<TypeParam>();
  detail::RigidGroup<TypeParam> group;
  group.mass = TypeParam(1e-9);
  for (int i = 0; i < 3; ++i) group.inertia_W[static_cast<std::size_t>(i)][i] = moments[i];
  const Vec3<TypeParam> L = Vector(1e-12, -4e-12, 3e-12).template cast<TypeParam>();
  const Vec3<TypeParam> w = detail::group_twist(group, L).w_W;
  const double rounding = 64 * static_cast<double>(kRoundOff<TypeParam>);
  EXPECT_NEAR(static_cast<double>(w.x()), 100, 100 * rounding);
  EXPECT_NEAR(static_cast<double>(w.y()), -200, 200 * rounding);
  EXPECT_NEAR(static_cast<double>(w.z()), 100, 100 * rounding);
}

TYPED_TEST(FoundAtRandom, GrainThatRolls_IsBrakedAndNotLost) {
  using SceneT = test::Settling<TypeParam, test::kRolling>;
  auto world = std::make_unique<World<SceneT>>();
  const auto add = [&world](Actor<SceneT> ball, bool is_fixed) {
    ball.friction = TypeParam(0.5);
    ball.rolling_resistance = TypeParam(1e-5);
    if (is_fixed) {
      ball.body.inverse_mass = 0;
      ball.body.inverse_moments.setZero();
    } else {
      test::throw_body(ball, Vector::Zero(), {0, 0, 10});
    }
    return world->add(ball).value;
  };
  add(test::solid_ball<SceneT>(0.05, {0, 0, 0}), true);
  const auto id = add(test::solid_ball<SceneT>(3e-4, {0, 0, 0.0503}), false);  // 4e-15 kg m^2
  for (int i = 0; i < 5; ++i) ASSERT_EQ(world->step(TypeParam(1e-3)), Status::kOk);
  const auto& body = std::as_const(*world).get(id)->body;
  EXPECT_NEAR(static_cast<double>(body.X_WB.p_W.z()), 0.0503, 2e-4);
  EXPECT_LE(static_cast<double>(twist_of(body).w_W.norm()), 10.001);
}

template <class S>
constexpr SceneOptions hands_options() {
  SceneOptions scene;
  scene.max_bodies = 3;
  scene.max_pairs = 3;
  scene.max_separations = 1;
  scene.resting = RestingContact::kSettling;
  return scene;
}

// A ball between two hands that close: it goes on with the one, and stands with both.
TYPED_TEST(FoundAtRandom, BallBetweenHands_StandsWithBoth) {
  using S = TypeParam;
  using SceneT = Scene<hands_options<S>, Advancement<S>, AnyController<S, FreeFlight<S>, Hand<S>>>;
  for (const double late : {0.0, 1e-3, 0.02, 0.04}) {
    World<SceneT> world;
    const double from[] = {-0.21, 0, 0.21 + late};
    Handle<Actor<SceneT>> ids[3];
    for (int i = 0; i < 3; ++i) {
      auto ball = test::solid_ball<SceneT>(0.1, {from[i], 0, 0});
      if (i != 1) {
        ball.body.inverse_mass = 0;
        ball.body.inverse_moments.setZero();
        Hand<S> hand;
        hand.step = S(kStep);
        hand.target_W.p_W = {static_cast<S>(from[i] / 2), 0, 0};
        ball.controller = hand;
      }
      ids[i] = world.add(ball).value;
    }
    ASSERT_EQ(world.step(S(kStep)), Status::kOk);
    EXPECT_GT(world.report().time_held, S(0)) << late;
    EXPECT_GT(test::smallest_gap(std::as_const(world)), -1e-4) << late;
  }
}

// A light ball in a hand is struck towards a heavy one that it touches: it leaves the hand within
// that moment, and what its contacts held for as heavy as a wall is light. (They pushed it on as if
// it still were, harder at each visit: impulses of 1e288 N s, then no numbers.)
TYPED_TEST(FoundAtRandom, LightBallStruckOutOfAHand_WinsNoEnergy) {
  using S = TypeParam;
  using SceneT = Scene<hands_options<S>, Advancement<S>, AnyController<S, FreeFlight<S>, Hand<S>>>;
  for (const double speed : {0.3, 3.0, 30.0}) {
    World<SceneT> world;
    Handle<Actor<SceneT>> ids[3];
    for (int i = 0; i < 3; ++i) {
      auto ball = test::solid_ball<SceneT>(0.1, {0.2 * i, 0, 0});
      if (i == 1) {
        ball.body.inverse_mass *= S(1000);
        ball.body.inverse_moments *= S(1000);
        Hand<S> hand;
        hand.step = S(kStep);
        hand.target_W = ball.body.X_WB;
        ball.controller = hand;
      }
      if (i == 2) test::throw_body(ball, {-speed, 0, 0});
      ids[i] = world.add(ball).value;
    }
    const double before = test::sums_of(std::as_const(world)).kinetic;
    ASSERT_EQ(world.step(S(kStep)), Status::kOk);
    const double after = test::sums_of(std::as_const(world)).kinetic;
    EXPECT_LE(after, before * (1 + 64 * static_cast<double>(kRoundOff<S>))) << speed;
  }
}

template <class S>
constexpr SceneOptions cramped_options() {
  SceneOptions scene;
  scene.max_bodies = 5;
  scene.max_pairs = 10;
  scene.max_contacts = 3;
  scene.friction = true;
  scene.resting = RestingContact::kSettling;
  return scene;
}

// A row of balls that press on each other, with room for three of four contacts: what is opened and
// what goes on together keep the common centre where it is.
TYPED_TEST(FoundAtRandom, RowWithTooFewContacts_KeepsItsCentre) {
  using S = TypeParam;
  using SceneT = Scene<cramped_options<S>, Advancement<S>>;
  World<SceneT> world;
  for (int i = 0; i < 5; ++i) {
    auto ball = test::solid_ball<SceneT>(0.1, {0.1999 * i, 0, 0});
    test::throw_body(ball, {-0.001 * i, 0, 0});
    ASSERT_TRUE(world.add(ball).ok());
  }
  const auto before = test::sums_of(std::as_const(world));
  ASSERT_EQ(world.step(S(kStep)), Status::kOk);
  EXPECT_GT(world.report().contacts_dropped, 0U) << "or nothing is seen";
  const Vector way = test::sums_of(std::as_const(world)).place - before.place;
  const Vector wanted = kStep / before.mass * before.momentum;
  EXPECT_LE((way - wanted).norm(), 16 * static_cast<double>(kRoundOff<S>));
}

// Who went on together for want of room parts at the end of the step, and nothing of it is left to
// be saved: who is restored goes on with the same bits. Spinning rods that fly into each other.
TYPED_TEST(FoundAtRandom, CrampedWorld_RestoredGoesOnWithTheSameBits) {
  using S = TypeParam;
  using SceneT = Scene<cramped_options<S>, Advancement<S>>;
  std::vector<std::uint8_t> bytes(kSnapshotRoom<World<SceneT>>);
  int dropped = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    test::Choices draw(seed);
    World<SceneT> world;
    for (int i = 0; i < 5; ++i) {
      const double turn = 2 * std::acos(-1.0) * i / 5;
      const Vector out(std::cos(turn), std::sin(turn), 0.1 * draw.signed_share());
      auto rod = test::solid_rod<SceneT>(0.4, 0.02, 0.4 * out, draw.rotation());
      test::throw_body(rod, -3 * out, 9 * draw.in_cube());
      ASSERT_TRUE(world.add(rod).ok());
    }
    for (int i = 0; i < 100; ++i) {
      const auto size = save(world, bytes.data(), static_cast<int>(bytes.size()));
      ASSERT_TRUE(size.ok());
      World<SceneT> read;
      ASSERT_EQ(restore(read, bytes.data(), size.value), Restored::kOk);
      ASSERT_EQ(world.step(S(4e-3)), Status::kOk);
      ASSERT_EQ(read.step(S(4e-3)), Status::kOk);
      ASSERT_EQ(hash_of(world), hash_of(read)) << seed << ", step " << i;
      dropped += world.report().contacts_dropped > 0 ? 1 : 0;
    }
  }
  EXPECT_GT(dropped, 20) << "or nothing is seen";
}

// Whether it comes nearer or not, an overlap is told, and is as deep as it is told.
template <class SceneT>
void tell_overlap(double speed) {
  using S = typename SceneT::Scalar;
  World<SceneT> world;
  for (int i = 0; i < 2; ++i) {
    auto ball = test::solid_ball<SceneT>(0.1, {0.199 * i, 0, 0});
    test::throw_body(ball, {speed * i, 0.1, 0});
    ASSERT_TRUE(world.add(ball).ok());
  }
  ASSERT_EQ(world.step(S(kStep)), Status::kOk);
  EXPECT_NEAR(static_cast<double>(world.report().deepest_overlap), 1e-3, 1e-6) << speed;
}

TYPED_TEST(FoundAtRandom, OverlapThatParts_IsTold) {
  for (const double speed : {0.0, 0.01, -0.01}) {
    tell_overlap<LawScene<TypeParam, RestingContact::kNone, test::kFloating>>(speed);
    tell_overlap<LawScene<TypeParam, RestingContact::kSeparation, test::kFloating>>(speed);
    tell_overlap<LawScene<TypeParam, RestingContact::kSettling, test::kFloating>>(speed);
  }
}

// A contact is found at a gap of nothing, give or take a rounding: that is no overlap to be shifted
// out of, which would change the angular momentum.
TYPED_TEST(FoundAtRandom, BlowOfSpinningRods_KeepsAngularMomentum) {
  using S = TypeParam;
  using SceneT = LawScene<S, RestingContact::kNone, test::kFloating>;
  for (int i = 0; i < 50; ++i) {
    World<SceneT> world;
    auto one = test::solid_rod<SceneT>(0.4, 0.02, {0.01 * i, 0, 0}, test::along_x());
    test::throw_body(one, {0, 0.3, 0.1}, {1, 0.1 * i, 3});
    auto other = test::solid_rod<SceneT>(0.3, 0.03, {0, 0.001 * i, 0.055}, test::along_y());
    test::throw_body(other, {0.2, 0, -1}, {2, -1, 0.1});
    one.restitution = S(1);
    ASSERT_TRUE(world.add(one).ok() && world.add(other).ok());
    const auto before = test::sums_of(std::as_const(world));
    ASSERT_EQ(world.step(S(kStep)), Status::kOk);
    const auto after = test::sums_of(std::as_const(world));
    const double each = 8 * static_cast<double>(kRoundOff<S>) * (before.spread + after.spread);
    EXPECT_LE((after.spin - before.spin).norm(), each * (2 + world.report().collisions)) << i;
  }
}

}  // namespace
}  // namespace batuta
