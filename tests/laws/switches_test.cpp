// SPDX-License-Identifier: MIT
// What is told of a step, and what may sleep in it, changes nothing in it; and who sleeps wakes
// when gravity turns.
#include <gtest/gtest.h>

#include "law_worlds.hpp"

namespace batuta {
namespace {

using test::Vector;

template <bool kSleeps, bool kTells>
constexpr SceneOptions switched() {
  SceneOptions scene = rack();
  scene.max_bodies = 16;
  scene.max_pairs = 120;
  scene.max_contacts = 128;
  scene.max_events = kTells ? 256 : 0;
  scene.sleep = kSleeps;
  return scene;
}
template <bool kSleeps, bool kTells, class S = float>
using Switched = Scene<switched<kSleeps, kTells>, Advancement<S>>;

constexpr SceneOptions few_events() {
  SceneOptions scene = switched<true, true>();
  scene.max_events = 2;
  return scene;
}
template <class S>
using FewEvents = Scene<few_events, Advancement<S>>;

template <class S>
class SwitchesOf : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(SwitchesOf, Scalars);

/// Two rails and bars that fall on them and on each other.
template <class SceneT>
std::unique_ptr<World<SceneT>> heap() {
  using S = typename SceneT::Scalar;
  auto world = std::make_unique<World<SceneT>>();
  for (const double x : {-0.1, 0.1}) {
    auto rail = test::fixed_rod<SceneT>(1, 0.03, {x, 0, -0.03}, test::along_y());
    rail.friction = S(0.5);
    EXPECT_TRUE(world->add(rail).ok());
  }
  for (int i = 0; i < 10; ++i) {
    auto bar = test::solid_rod<SceneT>(0.4, 0.02, {0.01 * i, 0.013 * (i % 3), 0.05 + 0.06 * i},
                                       i % 2 == 0 ? test::along_x() : test::along_y(), 700);
    bar.friction = S(0.5);
    bar.restitution = S(0.3);
    EXPECT_TRUE(world->add(bar).ok());
  }
  return world;
}

template <class P, class Q>
void expect_same_bits(const World<P>& world, const World<Q>& other, int step) {
  for (std::uint16_t i = 0; i < 12; ++i) {
    const auto& p = world.get(world.id_at(i))->body;
    const auto& q = other.get(other.id_at(i))->body;
    ASSERT_EQ(p.X_WB.p_W, q.X_WB.p_W) << i << ", step " << step;
    ASSERT_EQ(p.X_WB.q_WB.coeffs(), q.X_WB.q_WB.coeffs()) << i << ", step " << step;
    ASSERT_EQ(p.momentum.linear_W, q.momentum.linear_W) << i << ", step " << step;
    ASSERT_EQ(p.momentum.angular_W, q.momentum.angular_W) << i << ", step " << step;
  }
}

TYPED_TEST(SwitchesOf, EventsOnOrOff_SameBits) {
  for (const double dt : {1e-3, 1.0 / 60}) {
    const auto told = heap<Switched<false, true, TypeParam>>();
    const auto silent = heap<Switched<false, false, TypeParam>>();
    std::uint32_t blows = 0;
    for (int i = 0; i * dt < 1; ++i) {
      ASSERT_EQ(told->step(static_cast<TypeParam>(dt)), Status::kOk);
      ASSERT_EQ(silent->step(static_cast<TypeParam>(dt)), Status::kOk);
      blows += told->report().collisions;
      expect_same_bits(*told, *silent, i);
      if (this->HasFatalFailure()) return;
    }
    EXPECT_GT(blows, 10U) << dt;
  }
}

TYPED_TEST(SwitchesOf, SleepBeforeAnybodySleeps_SameBits) {
  for (const double dt : {1e-3, 1.0 / 60}) {
    const auto sleepy = heap<Switched<true, true, TypeParam>>();
    const auto awake = heap<Switched<false, true, TypeParam>>();
    int steps = 0;
    for (; steps * dt < 3; ++steps) {
      ASSERT_EQ(sleepy->step(static_cast<TypeParam>(dt)), Status::kOk);
      ASSERT_EQ(awake->step(static_cast<TypeParam>(dt)), Status::kOk);
      if (sleepy->report().asleep > 0) break;
      expect_same_bits(*sleepy, *awake, steps);
      if (this->HasFatalFailure()) return;
    }
    EXPECT_GT(steps * dt, 0.2) << dt;
  }
}

constexpr std::uint16_t kRails = 2;
constexpr std::uint16_t kBars = 8;

/// Bars side by side on two rails, asleep.
template <class SceneT>
std::unique_ptr<World<SceneT>> asleep() {
  using S = typename SceneT::Scalar;
  auto world = std::make_unique<World<SceneT>>();
  for (const double x : {-0.1, 0.1}) {
    auto rail = test::fixed_rod<SceneT>(6, 0.03, {x, 0, -0.03}, test::along_y());
    rail.friction = S(0.5);
    EXPECT_TRUE(world->add(rail).ok());
  }
  for (int i = 0; i < kBars; ++i) {
    auto bar = test::solid_rod<SceneT>(0.4, 0.02, {0, 0.2 * (i - 4), 0.02 + 1e-4}, test::along_x());
    bar.friction = S(0.5);
    EXPECT_TRUE(world->add(bar).ok());
  }
  for (int i = 0; i < 1000; ++i) EXPECT_EQ(world->step(S(1e-3)), Status::kOk);
  return world;
}
template <class SceneT>
int sleepers(const World<SceneT>& world) {
  int count = 0;
  for (std::uint16_t i = 0; i < 16; ++i) count += world.is_asleep(world.id_at(i)) ? 1 : 0;
  return count;
}

TEST(Switches, Asleep_IsToldAsItIsAndCostsNothing) {
  const auto world = asleep<Switched<true, true>>();
  ASSERT_EQ(sleepers(*world), 8);
  EXPECT_EQ(world->report().asleep, 8U);
  for (int i = 0; i < 10; ++i) {
    ASSERT_EQ(world->step(1e-3F), Status::kOk);
    EXPECT_EQ(world->report().asleep, 8U);
    EXPECT_EQ(world->report().pairs, 0U);
    EXPECT_EQ(world->report().evaluations, 0U);
    EXPECT_EQ(world->events().size(), 0);
  }
}

/// The caller takes the rails away, or puts them 1 m lower: all bars fall as if nothing had been.
template <class SceneT>
void take_floor(bool is_moved) {
  using S = typename SceneT::Scalar;
  const auto world = asleep<SceneT>();
  ASSERT_EQ(sleepers(*world), kBars);
  for (std::uint16_t i = 0; i < kRails; ++i) {
    const auto id = world->id_at(i);
    if (is_moved) {
      world->get(id)->body.X_WB.p_W.z() -= S(1);
    } else {
      ASSERT_EQ(world->remove(id), Status::kOk);
    }
  }
  const auto height = [&world](std::uint16_t slot) {
    return static_cast<double>(std::as_const(*world).get(world->id_at(slot))->body.X_WB.p_W.z());
  };
  double start[kBars];
  for (std::uint16_t i = 0; i < kBars; ++i) start[i] = height(i + kRails);
  for (int i = 0; i < 400; ++i) ASSERT_EQ(world->step(S(1e-3)), Status::kOk);
  EXPECT_EQ(sleepers(*world), 0);
  for (std::uint16_t i = 0; i < kBars; ++i) {
    EXPECT_NEAR(height(i + kRails) - start[i], -9.81 * 0.4 * 0.4 / 2, 1e-5) << i;
  }
  for (int i = 0; i < 1000; ++i) ASSERT_EQ(world->step(S(1e-3)), Status::kOk);
  EXPECT_EQ(sleepers(*world), is_moved ? kBars : 0);
  for (std::uint16_t i = 0; i < kBars && is_moved; ++i) {
    EXPECT_NEAR(height(i + kRails) - start[i], -1, 1e-4) << i;
  }
}

TYPED_TEST(SwitchesOf, FloorThatIsTakenFromSleepers_LetsAllFall) {
  for (const bool is_moved : {false, true}) {
    take_floor<Switched<true, true, TypeParam>>(is_moved);
    take_floor<FewEvents<TypeParam>>(is_moved);  // of sixteen contacts two are told
  }
}

TEST(Switches, GravityThatTurns_WakesAll) {
  const auto world = asleep<Switched<true, true>>();
  ASSERT_EQ(sleepers(*world), 8);
  auto settings = world->settings();
  ASSERT_EQ(world->configure(settings), Status::kOk);
  EXPECT_EQ(sleepers(*world), 8) << "the same gravity wakes nobody";
  settings.gravity_W = {0, 9, -1};
  ASSERT_EQ(world->configure(settings), Status::kOk);
  EXPECT_EQ(sleepers(*world), 0);
  for (int i = 0; i < 200; ++i) ASSERT_EQ(world->step(1e-3F), Status::kOk);
  for (std::uint16_t i = kRails; i < kRails + kBars; ++i) {
    const auto& bar = std::as_const(*world).get(world->id_at(i))->body;
    // All of a bar's acceleration but friction, mu g_z = 0.5 m/s^2: and it may roll.
    EXPECT_GT(bar.inverse_mass * bar.momentum.linear_W.y(), 1.0F) << i;
  }
}

}  // namespace
}  // namespace batuta
