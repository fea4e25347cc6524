// SPDX-License-Identifier: MIT
// Events are told and change nothing: with and without them, the same engine gives the same bits.
// Over all ready-made scenes; the duel's are in unit/fencing.
#include <gtest/gtest.h>

#include <cstring>
#include <memory>
#include <random>

#include "batuta/world/make_actor.hpp"
#include "batuta/world/scenes.hpp"
#include "batuta/world/world.hpp"

namespace batuta {
namespace {

/// The scene with so many events, run by the general engine, which alone has any.
template <class SceneT, int kEvents>
constexpr SceneOptions told_options() {
  SceneOptions scene = SceneT::kStated;
  if (scene.engine == Engine::kSmall) {
    scene.max_pairs = scene.max_bodies * (scene.max_bodies - 1) / 2;  // room for all, as it has
  }
  scene.engine = Engine::kGeneral;
  scene.max_events = kEvents;
  return scene;
}
template <class SceneT, int kEvents>
using Told = Scene<told_options<SceneT, kEvents>, typename SceneT::Search>;

/// What sleeps is followed by events, so that a rack with none has no sleepers.
constexpr SceneOptions wakeful_options() {
  SceneOptions scene = rack();
  scene.sleep = false;
  return scene;
}
using WakefulRack = Scene<wakeful_options>;

/// Bodies that meet: in a cube that they are thrown into from all sides.
template <class SceneT>
void fill(World<SceneT>& world, unsigned seed) {
  std::mt19937 random(seed);
  const auto in = [&random](float low, float high) {
    return std::uniform_real_distribution<float>(low, high)(random);
  };
  constexpr bool kIsBall = SceneT::Search::kForSpheres;
  const float half_cube = 0.12F * std::cbrt(static_cast<float>(SceneT::kMaxBodies));
  for (int i = 0; i < SceneT::kMaxBodies; ++i) {
    const Vec3<float> place(in(-half_cube, half_cube), in(-half_cube, half_cube),
                            in(-half_cube, half_cube));
    const float half = kIsBall ? 0.0F : 0.1F;
    const Capsule<float> shape = {{{0, 0, -half}, {0, 0, half}}, 0.05F};
    const Quat<float> turn = renewed(Quat<float>(in(-1, 1), in(-1, 1), in(-1, 1), in(-1, 1)));
    Twist<float> twist;
    twist.v_W = -8 * place;
    if (SceneT::kRotation) twist.w_W = {in(-5, 5), in(-5, 5), in(-5, 5)};
    auto made = make_actor<SceneT>(shape, 100.0F, {place, turn}, twist);
    ASSERT_TRUE(made.ok());
    if constexpr (SceneT::kRestitution) made.value.restitution = in(0, 1);
    if constexpr (SceneT::kFriction) made.value.friction = 0.4F;
    ASSERT_TRUE(world.add(made.value).ok());
  }
}

template <class T>
bool same_bits(const T& a, const T& b) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}

template <class BodyT>
void expect_same_body(const BodyT& a, const BodyT& b) {
  EXPECT_TRUE(same_bits(a.inverse_mass, b.inverse_mass));
  if constexpr (std::is_same_v<BodyT, StraightBody<float>>) {
    EXPECT_TRUE(same_bits(a.p_W, b.p_W) && same_bits(a.momentum_W, b.momentum_W));
  } else {
    EXPECT_TRUE(same_bits(a.X_WB.p_W, b.X_WB.p_W) && same_bits(a.X_WB.q_WB, b.X_WB.q_WB) &&
                same_bits(a.momentum.linear_W, b.momentum.linear_W) &&
                same_bits(a.momentum.angular_W, b.momentum.angular_W));
  }
}

/// All but what counts events.
void expect_same_report(StepReport<float> a, StepReport<float> b) {
  a.events_dropped = b.events_dropped = 0;
  a.contacts_untracked = b.contacts_untracked = 0;
  EXPECT_TRUE(same_bits(a, b));
}

/// @returns blows and separations, so that the caller can ask for some
template <class OneT, class OtherT>
std::uint32_t expect_same_run(unsigned seed, int steps) {
  const auto one = std::make_unique<World<OneT>>();
  const auto other = std::make_unique<World<OtherT>>();
  fill(*one, seed);
  fill(*other, seed);
  std::uint32_t contacts = 0;
  for (int k = 0; k < steps && !::testing::Test::HasFailure(); ++k) {
    EXPECT_EQ(one->step(1e-3F), Status::kOk);
    EXPECT_EQ(other->step(1e-3F), Status::kOk);
    expect_same_report(one->report(), other->report());
    for (std::uint16_t slot = 0; slot < OneT::kMaxBodies; ++slot) {
      const World<OneT>& a = *one;
      const World<OtherT>& b = *other;
      expect_same_body(a.get(a.id_at(slot))->body, b.get(b.id_at(slot))->body);
    }
    contacts += one->report().collisions + one->report().separations;
  }
  return contacts;
}

TEST(Events, TwoBlades_MoveTheSameWithoutThem) {
  std::uint32_t contacts = 0;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    contacts += expect_same_run<TwoBlades, Told<TwoBlades, 0>>(seed, 300);
  }
  EXPECT_GT(contacts, 10U);
}

TEST(Events, StraightSpheres_MoveTheSameWithoutThem) {
  std::uint32_t contacts = 0;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    contacts += expect_same_run<Told<StraightSpheres, 16>, Told<StraightSpheres, 0>>(seed, 300);
  }
  EXPECT_GT(contacts, 50U);
}

TEST(Events, Rack_MovesTheSameWithoutThem) {
  EXPECT_GT((expect_same_run<WakefulRack, Told<WakefulRack, 0>>(1, 300)), 500U);
}

// Without events there would be nothing to see of the one, and no sleep in the other: with one
// event at a time all but the first of a step are dropped.
TEST(Events, WhereThereHaveToBeSome_OneIsAsGoodAsMany) {
  EXPECT_GT((expect_same_run<Rack, Told<Rack, 1>>(2, 300)), 500U);
  for (unsigned seed = 1; seed <= 20; ++seed) {
    (void)expect_same_run<DetectionOnly, Told<DetectionOnly, 1>>(seed, 300);
  }
}

}  // namespace
}  // namespace batuta
