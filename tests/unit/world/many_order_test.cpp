// SPDX-License-Identifier: MIT
// What the order of things decides in a scene of many bodies, and what costs nothing.

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "crowd.hpp"

namespace batuta {
namespace {

using test::Crowd;
using test::CrowdRun;

constexpr int kMany = 64;
using ManyRun = CrowdRun<float, kMany>;
using ManyScene = ManyRun::SceneT;

/// All bodies, bit by bit as numbers.
template <class SceneT>
bool are_same(const World<SceneT>& P, const World<SceneT>& Q) {
  bool same = true;
  for (std::uint16_t i = 0; i < SceneT::kMaxBodies; ++i) {
    const auto& p = P.get(P.id_at(i))->body;
    const auto& q = Q.get(Q.id_at(i))->body;
    same = same && p.X_WB.p_W == q.X_WB.p_W && p.X_WB.q_WB.coeffs() == q.X_WB.q_WB.coeffs() &&
           p.momentum.linear_W == q.momentum.linear_W &&
           p.momentum.angular_W == q.momentum.angular_W;
  }
  return same;
}

/// Another history: every slot was taken by a body elsewhere, and gets its own in an order that has
/// nothing to do with its number.
void refill(World<ManyScene>& world, const std::vector<Actor<ManyScene>>& wanted) {
  for (int i = kMany - 1; i >= 0; --i) {
    ASSERT_TRUE(world.add(wanted[static_cast<std::size_t>(i)]).ok());
  }
  for (int i = 0; i < 5; ++i) ASSERT_EQ(world.step(0.001F), Status::kOk);
  for (int i = 0; i < kMany; ++i) {
    const auto slot = static_cast<std::uint16_t>(i * 37 % kMany);
    ASSERT_EQ(world.remove(world.id_at(slot)), Status::kOk);
    const auto id = world.add(wanted[slot]);
    ASSERT_TRUE(id.ok());
    ASSERT_TRUE(world.id_at(slot) == id.value);
  }
}

TEST(ManyOrder, BodiesAddedInAnotherOrderUnderTheSameNumbers_GoTheSameWay) {
  auto run = std::make_unique<ManyRun>();
  run->begin(Crowd::kDense, 7);
  std::vector<Actor<ManyScene>> wanted;
  auto world = std::make_unique<World<ManyScene>>();
  for (std::uint16_t i = 0; i < kMany; ++i) {
    wanted.push_back(*run->world().get(run->world().id_at(i)));
    ASSERT_TRUE(world->add(wanted.back()).ok());
  }
  auto other = std::make_unique<World<ManyScene>>();
  refill(*other, wanted);
  ASSERT_TRUE(are_same(*world, *other));
  std::uint32_t contacts = 0;
  for (int i = 0; i < 300; ++i) {
    ASSERT_EQ(world->step(0.001F), Status::kOk);
    ASSERT_EQ(other->step(0.001F), Status::kOk);
    ASSERT_TRUE(are_same(*world, *other)) << "step " << i;
    contacts += world->report().collisions;
  }
  EXPECT_GT(contacts, 20U);
}

/// Balls that fly straight, in a row.
constexpr SceneOptions row_options() {
  SceneOptions scene;
  scene.max_bodies = 4;
  scene.max_pairs = 6;
  return scene;
}
using Row = Scene<row_options, Advancement<double>>;

Actor<Row> in_row(double x, double v) {
  Actor<Row> actor;
  actor.body = make_body<double>({{x, 0, 0}, Quat<double>::Identity()}, 1, {1, 1, 1}).value;
  actor.body.momentum.linear_W.x() = v;
  actor.capsule_B = Capsule<double>::sphere(Vec3<double>::Zero(), 0.1);
  actor.restitution = 0.5;
  return actor;
}

/// One ball between two that reach it at the same time, but for `late` of a metre of the first.
std::unique_ptr<World<Row>> squeezed(double late, double early) {
  auto world = std::make_unique<World<Row>>();
  (void)world->add(in_row(-1 - late, 1));
  (void)world->add(in_row(0, 0));
  (void)world->add(in_row(1 - early, -1));
  EXPECT_EQ(world->step(1), Status::kOk);
  EXPECT_TRUE(world->report().complete());
  return world;
}

/// The pairs that were hit, in order.
std::vector<std::pair<int, int>> blows_of(const World<Row>& world) {
  std::vector<std::pair<int, int>> blows;
  for (const auto& event : world.events()) {
    if (event.impulse > 0) blows.emplace_back(event.body_A, event.body_B);
  }
  return blows;
}

TEST(ManyOrder, ContactsWhoseBracketsOverlap_AreTakenByTheirNumbers) {
  constexpr double kUlp = std::numeric_limits<double>::epsilon();
  const auto even = squeezed(0, 0);
  const double v = even->get(even->id_at(0))->body.momentum.linear_W.x();
  for (const double ulp : {0.0, kUlp, -kUlp / 2, 2 * kUlp}) {
    const auto world = squeezed(ulp, ulp);
    const auto blows = blows_of(*world);
    ASSERT_GE(blows.size(), 2U);
    EXPECT_EQ(blows[0], (std::pair<int, int>{0, 1}));
    EXPECT_EQ(blows[1], (std::pair<int, int>{1, 2}));
    EXPECT_NEAR(world->get(world->id_at(0))->body.momentum.linear_W.x(), v, 1e-9);
  }
  // Anti-vacuity: where the second is really the earlier one, it goes first, and all ends
  // otherwise.
  const auto apart = squeezed(0.01, 0.01);
  EXPECT_EQ(blows_of(*apart)[0], (std::pair<int, int>{1, 2}));
  EXPECT_GT(std::abs(apart->get(apart->id_at(0))->body.momentum.linear_W.x() - v), 0.01);
}

/// Tells how often a bound was computed.
struct CountedBound {
  static int& count() {
    static int count = 0;
    return count;
  }
  template <class S>
  static Aabb<S> of(const MovingCapsule<S>& moving) {
    ++count();
    return SweptBox::of(moving);
  }
};

constexpr SceneOptions room_options() {
  SceneOptions scene;
  scene.max_bodies = 32;
  scene.max_pairs = 64;
  scene.filters = true;
  return scene;
}
using Room = Scene<room_options, Advancement<float>, FreeFlight<float>, CountedBound>;

Actor<Room> at(float x, float v, bool fixed = false) {
  Actor<Room> actor;
  if (!fixed) {
    actor.body = make_body<float>({}, 1, {1, 1, 1}).value;
    actor.body.momentum.linear_W.x() = v;
  }
  actor.body.X_WB.p_W.x() = x;
  actor.capsule_B = {{{0, 0, -0.2F}, {0, 0, 0.2F}}, 0.1F};
  return actor;
}

/// Pairs searched in a few steps of two bodies that stand in each other's way.
std::uint32_t pairs_of(const Actor<Room>& A, const Actor<Room>& B) {
  auto world = std::make_unique<World<Room>>();
  EXPECT_TRUE(world->add(A).ok() && world->add(B).ok());
  std::uint32_t pairs = 0;
  for (int i = 0; i < 20; ++i) {
    EXPECT_EQ(world->step(0.01F), Status::kOk);
    pairs += world->report().pairs;
  }
  return pairs;
}

TEST(ManyOrder, PairsThatCanNeverMeet_AreNotSearched) {
  const auto A = at(0, 1);
  const auto B = at(0.25F, -1);
  ASSERT_GT(pairs_of(A, B), 0U);
  auto owned_A = A;
  auto owned_B = B;
  owned_A.owner = owned_B.owner = 3;
  EXPECT_EQ(pairs_of(owned_A, owned_B), 0U);
  owned_B.owner = 4;
  EXPECT_GT(pairs_of(owned_A, owned_B), 0U);
  auto filtered = B;
  filtered.filter.groups = 2;
  auto picky = A;
  picky.filter.meets = 1;
  EXPECT_EQ(pairs_of(picky, filtered), 0U);
  EXPECT_EQ(pairs_of(filtered, picky), 0U);
  EXPECT_EQ(pairs_of(at(0, 0, true), at(0.1F, 0, true)), 0U);
  EXPECT_GT(pairs_of(at(0, 0, true), at(0.21F, -1)), 0U);
}

TEST(ManyOrder, BodiesAtRest_CostNoSearchAndNoBound) {
  auto world = std::make_unique<World<Room>>();
  for (int i = 0; i < 31; ++i) (void)world->add(at(0.2001F * static_cast<float>(i), 0));
  const auto mover = world->add(at(100, 1)).value;
  for (int i = 0; i < 3; ++i) ASSERT_EQ(world->step(0.01F), Status::kOk);
  for (int i = 0; i < 100; ++i) {
    const int before = CountedBound::count();
    ASSERT_EQ(world->step(0.01F), Status::kOk);
    EXPECT_EQ(world->report().pairs, 0U);
    EXPECT_EQ(world->report().evaluations, 0U);
    EXPECT_EQ(CountedBound::count() - before, 1) << "the one that moves";
  }
  // Who is pushed is searched and bounded again.
  world->get(world->id_at(5))->body.momentum.linear_W.x() = 1;
  const int before = CountedBound::count();
  ASSERT_EQ(world->step(0.01F), Status::kOk);
  EXPECT_GT(world->report().pairs, 0U);
  EXPECT_GT(CountedBound::count() - before, 2);
  (void)mover;
}

}  // namespace
}  // namespace batuta
