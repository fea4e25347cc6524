// SPDX-License-Identifier: MIT
// SceneOptions::bent_turns off: bodies whose turn would be bent are refused, and all others move by
// the same bits as with it.
#include <gtest/gtest.h>

#include <memory>

#include "batuta/world/any_controller.hpp"
#include "batuta/world/make_actor.hpp"
#include "batuta/world/scenes.hpp"
#include "batuta/world/world.hpp"
#include "draws.hpp"

namespace batuta {
namespace {

constexpr int kBodies = 12;

constexpr SceneOptions crowd(RestingContact resting, bool bends, bool responds) {
  SceneOptions scene;
  scene.max_bodies = kBodies;
  scene.max_pairs = kBodies * (kBodies - 1) / 2;
  scene.max_contacts = 64;
  scene.max_events = 64;
  scene.resting = resting;
  scene.response = responds;
  scene.restitution = responds;
  scene.bent_turns = bends;
  return scene;
}
template <RestingContact kResting, bool kBends, bool kResponds>
constexpr SceneOptions crowd_of() {
  return crowd(kResting, kBends, kResponds);
}

template <class Scalar>
using Anybody = AnyController<Scalar, FreeFlight<Scalar>, Fixed<Scalar>, Hand<Scalar>>;

/// A scene with bent turns, and the same without; and both where some are led.
template <class Scalar, RestingContact kResting, bool kResponds>
struct Both {
  using Bent = Scene<crowd_of<kResting, true, kResponds>, Advancement<Scalar>>;
  using Steady = Scene<crowd_of<kResting, false, kResponds>, Advancement<Scalar>>;
  using BentLed = Scene<crowd_of<kResting, true, kResponds>, Advancement<Scalar>, Anybody<Scalar>>;
  using SteadyLed =
      Scene<crowd_of<kResting, false, kResponds>, Advancement<Scalar>, Anybody<Scalar>>;
};

template <class BothT>
class BentTurnsOption : public ::testing::Test {};
using Scenes = ::testing::Types<
    Both<float, RestingContact::kNone, false>, Both<float, RestingContact::kNone, true>,
    Both<float, RestingContact::kSeparation, true>, Both<float, RestingContact::kSettling, true>,
    Both<double, RestingContact::kSeparation, true>, Both<double, RestingContact::kSettling, true>>;
TYPED_TEST_SUITE(BentTurnsOption, Scenes);

/// Rods and balls that fly at each other, of any mass, spin and restitution.
template <class SceneT>
void fill(World<SceneT>& world, std::uint64_t seed) {
  using Scalar = typename SceneT::Scalar;
  test::Draws draws(seed, 0, 0);
  for (int i = 0; i < kBodies; ++i) {  // Bound: kBodies
    const Vec3<double> half = draws.between(0, 0.3) * Vec3<double>::UnitX();
    const Capsule<Scalar> shape = {{-half.cast<Scalar>(), half.cast<Scalar>()}, Scalar(0.1)};
    const Vec3<double> place = draws.in_ball(1);
    const Quat<double> q = draws.rotation();
    const auto density = static_cast<Scalar>(draws.between(10, 1000));
    const Vec3<double> speed = -2 * place;
    const Vec3<double> spin = draws.in_ball(40);
    auto actor = make_actor<SceneT>(shape, density, {place.cast<Scalar>(), q.cast<Scalar>()},
                                    {speed.cast<Scalar>(), spin.cast<Scalar>()});
    if constexpr (SceneT::kRestitution) {
      actor.value.restitution = static_cast<Scalar>(draws.unit());
    }
    ASSERT_EQ(world.add(actor.value).status, Status::kOk);
  }
}

TYPED_TEST(BentTurnsOption, BodiesOfOneCapsule_SameBits) {
  using Bent = typename TypeParam::Bent;
  using Steady = typename TypeParam::Steady;
  std::uint32_t blows = 0;
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    auto bent = std::make_unique<World<Bent>>();
    auto steady = std::make_unique<World<Steady>>();
    fill(*bent, seed);
    fill(*steady, seed);
    for (int k = 0; k < 60; ++k) {
      const auto dt = typename Bent::Scalar(1.0 / 60);
      ASSERT_EQ(bent->step(dt), Status::kOk);
      ASSERT_EQ(steady->step(dt), Status::kOk);
      blows += steady->report().collisions;
      for (std::uint16_t slot = 0; slot < kBodies; ++slot) {
        const auto& one = bent->get(bent->id_at(slot))->body;
        const auto& other = steady->get(steady->id_at(slot))->body;
        ASSERT_EQ(one.X_WB.p_W, other.X_WB.p_W) << seed << ", step " << k;
        ASSERT_EQ(one.X_WB.q_WB.coeffs(), other.X_WB.q_WB.coeffs()) << seed << ", step " << k;
        ASSERT_EQ(one.momentum.angular_W, other.momentum.angular_W) << seed << ", step " << k;
      }
    }
  }
  EXPECT_EQ(blows > 0, Bent::kResponse);
}

/// A rod that flies, and one that stays or that a hand leads, near it.
template <class SceneT>
void fill_led(World<SceneT>& world, std::uint64_t seed) {
  using Scalar = typename SceneT::Scalar;
  test::Draws draws(seed, 1, 0);
  for (const bool is_led : {false, true}) {
    const Vec3<double> half = draws.between(0.05, 0.25) * Vec3<double>::UnitZ();
    const Capsule<Scalar> shape = {{-half.cast<Scalar>(), half.cast<Scalar>()}, Scalar(0.02)};
    const Vec3<double> place = draws.in_ball(0.2);
    const Quat<double> q = draws.rotation();
    const Vec3<double> speed = is_led ? Vec3<double>::Zero() : draws.in_ball(3);
    const Vec3<double> spin = is_led ? Vec3<double>::Zero() : draws.in_ball(40);
    auto actor = make_actor<SceneT>(shape, Scalar(1000), {place.cast<Scalar>(), q.cast<Scalar>()},
                                    {speed.cast<Scalar>(), spin.cast<Scalar>()});
    actor.value.restitution = static_cast<Scalar>(draws.unit());
    if (is_led && draws.chance(0.5)) actor.value.controller = Fixed<Scalar>{};
    if (is_led && draws.chance(0.5)) {
      Hand<Scalar> hand;
      hand.target_W = actor.value.body.X_WB;
      hand.target_W.p_W += draws.in_ball(0.05).template cast<Scalar>();
      hand.step = Scalar(0.01);
      actor.value.controller = hand;
    }
    ASSERT_EQ(world.add(actor.value).status, Status::kOk);
  }
}

// Who is led turns as it is led: no course is cut for it.
TYPED_TEST(BentTurnsOption, BesideOneThatIsLed_SameBits) {
  using Scalar = typename TypeParam::Bent::Scalar;
  if constexpr (TypeParam::Bent::kResponse) {
    using Bent = typename TypeParam::BentLed;
    using Steady = typename TypeParam::SteadyLed;
    std::uint32_t blows = 0;
    for (std::uint64_t seed = 0; seed < 400; ++seed) {
      auto bent = std::make_unique<World<Bent>>();
      auto steady = std::make_unique<World<Steady>>();
      fill_led(*bent, seed);
      fill_led(*steady, seed);
      for (int k = 0; k < 20; ++k) {
        ASSERT_EQ(bent->step(Scalar(0.01)), Status::kOk);
        ASSERT_EQ(steady->step(Scalar(0.01)), Status::kOk);
        blows += steady->report().collisions;
        const auto& one = bent->get(bent->id_at(0))->body;
        const auto& other = steady->get(steady->id_at(0))->body;
        ASSERT_EQ(one.X_WB.p_W, other.X_WB.p_W) << seed << ", step " << k;
        ASSERT_EQ(one.momentum.angular_W, other.momentum.angular_W) << seed << ", step " << k;
      }
    }
    EXPECT_GT(blows, 50U);
  }
}

template <class SceneT>
struct Sample {
  using Scalar = typename SceneT::Scalar;
  static constexpr Scalar kHalf = Scalar(0.5);

  /// A rod along x, `beside` the axis of its body.
  static Actor<SceneT> rod(const Vec3<double>& moments, double beside) {
    Actor<SceneT> actor;
    actor.body = make_body<Scalar>({}, Scalar(1), moments.cast<Scalar>()).value;
    const Vec3<Scalar> axis(kHalf, 0, 0);
    const Vec3<Scalar> off(0, static_cast<Scalar>(beside), 0);
    actor.capsule_B = {{off - axis, off + axis}, Scalar(0.05)};
    return actor;
  }
  /// The same, and it turns only about the axes that `turns` names with 1.
  static Actor<SceneT> hinge(const Vec3<double>& turns) {
    Actor<SceneT> actor = rod({0.1, 0.2, 0.3}, 0.1);
    actor.body.inverse_moments =
        actor.body.inverse_moments.cwiseProduct(turns.cast<Scalar>()).eval();
    return actor;
  }
};

TYPED_TEST(BentTurnsOption, WhoseTurnIsBent_IsRefused) {
  using Steady = typename TypeParam::Steady;
  using Of = Sample<Steady>;
  auto world = std::make_unique<World<Steady>>();
  const auto status_of = [&](const Actor<Steady>& actor) { return world->add(actor).status; };
  EXPECT_EQ(status_of(Of::rod({0.1, 0.2, 0.25}, 0)), Status::kInvalidArgument);   // three moments
  EXPECT_EQ(status_of(Of::rod({0.1, 0.2, 0.2}, 0.1)), Status::kInvalidArgument);  // off the axis
  EXPECT_EQ(status_of(Of::rod({0.2, 0.2, 0.1}, 0)), Status::kInvalidArgument);    // across it
  EXPECT_EQ(status_of(Of::hinge({1, 1, 0})), Status::kInvalidArgument);           // two axes
  EXPECT_EQ(world->id_at(0), decltype(world->id_at(0)){});
  EXPECT_EQ(status_of(Of::rod({0.1, 0.2, 0.2}, 0)), Status::kOk);
  EXPECT_EQ(status_of(Of::rod({0.2, 0.2, 0.2}, 0.1)), Status::kOk);  // equal moments: never bent
  EXPECT_EQ(status_of(Of::hinge({0, 0, 1})), Status::kOk);
  EXPECT_EQ(status_of(Of::hinge({0, 0, 0})), Status::kOk);
}

// Three equal moments and a capsule off the axis: the twist is that of the angular momentum, where
// with bent turns it is the one that joins both ends of the flight.
TYPED_TEST(BentTurnsOption, EqualMomentsOffTheAxis_SameFlight) {
  using Bent = typename TypeParam::Bent;
  using Steady = typename TypeParam::Steady;
  using Scalar = typename Steady::Scalar;
  const auto flown = [](auto world, const auto& actor) {
    auto turning = actor;
    turning.body.momentum.angular_W = {Scalar(1), Scalar(-2), Scalar(0.5)};
    const auto id = world->add(turning).value;
    for (int k = 0; k < 10; ++k) EXPECT_EQ(world->step(Scalar(0.01)), Status::kOk);
    return world->get(id)->body.X_WB.q_WB;
  };
  const Vec3<double> moments(0.2, 0.2, 0.2);
  const auto bent = flown(std::make_unique<World<Bent>>(), Sample<Bent>::rod(moments, 0.1));
  const auto steady = flown(std::make_unique<World<Steady>>(), Sample<Steady>::rod(moments, 0.1));
  // Ten steps of a few roundings each.
  EXPECT_LE((bent.coeffs() - steady.coeffs()).norm(), 100 * kRoundOff<Scalar>);
}

// What a caller makes of a body later takes no part, and is told.
TYPED_TEST(BentTurnsOption, WhoseMomentsAreChangedLater_IsLeftOutAndTold) {
  using Steady = typename TypeParam::Steady;
  using Of = Sample<Steady>;
  auto world = std::make_unique<World<Steady>>();
  const auto id = world->add(Of::rod({0.1, 0.2, 0.2}, 0)).value;
  world->get(id)->body.momentum.angular_W = {1, 2, 3};
  world->get(id)->body.inverse_moments = {10, 5, 4};
  ASSERT_EQ(world->step(typename Steady::Scalar(0.01)), Status::kOk);
  EXPECT_EQ(world->report().plans_invalid, 1U);
  EXPECT_FALSE(world->report().complete());
  EXPECT_EQ(world->get(id)->body.X_WB.q_WB.w(), 1);
}

}  // namespace
}  // namespace batuta
