// SPDX-License-Identifier: MIT
// What does not fit is counted, the bodies concerned stay where they are free, and nothing is lost
// silently.

#include <gtest/gtest.h>

#include <limits>
#include <memory>
#include <utility>

#include "scenes.hpp"

namespace batuta {
namespace {

using test::ball;
using test::post;
using test::vec;

constexpr SceneOptions tight_scene_options() {
  SceneOptions scene = test::flight_scene_options();
  scene.max_bodies = 3;
  scene.max_pairs = 1;
  scene.max_contacts = 1;
  scene.max_events = 1;
  return scene;
}
using TightScene = Scene<tight_scene_options, Stepping<double>, test::AnyFlight<double>>;

constexpr SceneOptions one_contact_scene_options() {
  SceneOptions scene = test::flight_scene_options();
  scene.max_contacts = 1;
  return scene;
}
using OneContactScene = Scene<one_contact_scene_options, Stepping<double>, test::AnyFlight<double>>;

constexpr SceneOptions roomy_scene_options() {
  SceneOptions scene = test::flight_scene_options();
  scene.max_contacts = 2;
  scene.max_events = 1;
  return scene;
}
using RoomyScene = Scene<roomy_scene_options, Stepping<double>, test::AnyFlight<double>>;

template <class SceneT>
double gap_between(const World<SceneT>& world, std::uint16_t a, std::uint16_t b) {
  const auto& A = *world.get(world.id_at(a));
  const auto& B = *world.get(world.id_at(b));
  return capsule_gap(to_world(A.body.X_WB, A.capsule_B), to_world(B.body.X_WB, B.capsule_B)).gap;
}

TEST(WorldLimits, BadStep_ChangesNothing) {
  World<TightScene> world;
  const auto id = world.add(ball<TightScene>(0, 0.1, 1)).value;
  for (const double dt : {0.0, -1.0, std::numeric_limits<double>::infinity(), std::nan("")}) {
    EXPECT_EQ(world.step(dt), Status::kInvalidArgument);
  }
  EXPECT_EQ(world.get(id)->body.X_WB.p_W, Vec3<double>::Zero());
}

TEST(WorldLimits, BadActors_AreRefused) {
  World<TightScene> world;
  const auto good = ball<TightScene>(0, 0.1, 1);
  auto bad = good;
  bad.capsule_B.radius = -1;
  EXPECT_EQ(world.add(bad).status, Status::kInvalidArgument);
  bad = good;
  bad.body.X_WB.p_W.x() = std::nan("");
  EXPECT_EQ(world.add(bad).status, Status::kInvalidArgument);
  bad = good;
  bad.body.X_WB.q_WB.w() = std::nan("");
  EXPECT_EQ(world.add(bad).status, Status::kInvalidArgument);
  bad = good;
  bad.body.momentum.angular_W.z() = std::numeric_limits<double>::infinity();
  EXPECT_EQ(world.add(bad).status, Status::kInvalidArgument);
  bad = good;
  bad.body.X_WB.q_WB.coeffs().setZero();
  EXPECT_EQ(world.add(bad).status, Status::kInvalidArgument);
  bad = good;
  bad.body.inverse_mass = std::numeric_limits<double>::denorm_min();  // no mass is its inverse
  EXPECT_EQ(world.add(bad).status, Status::kInvalidArgument);
  bad = good;
  bad.body.inverse_moments.y() = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(world.add(bad).status, Status::kInvalidArgument);
  bad = good;
  bad.body.inverse_mass = -1;
  EXPECT_EQ(world.add(bad).status, Status::kInvalidArgument);
  bad = good;
  bad.body.inverse_moments.x() = -1;
  EXPECT_EQ(world.add(bad).status, Status::kInvalidArgument);
  for (const double restitution : {-0.1, 1.1, std::nan("")}) {
    bad = good;
    bad.restitution = restitution;
    EXPECT_EQ(world.add(bad).status, Status::kInvalidArgument);
  }
  EXPECT_EQ(world.size(), 0);
}

TEST(WorldLimits, FullWorld_SaysSo) {
  World<TightScene> world;
  for (int i = 0; i < TightScene::kMaxBodies; ++i)
    ASSERT_TRUE(world.add(ball<TightScene>(i, 0.1, 0)).ok());
  EXPECT_EQ(world.add(ball<TightScene>(9, 0.1, 0)).status, Status::kPoolFull);
}

TEST(WorldLimits, StaleAndForeignIds_AreDetected) {
  World<TightScene> world(1);
  World<TightScene> other(2);
  const auto id = world.add(ball<TightScene>(0, 0.1, 0)).value;
  EXPECT_EQ(other.get(id), nullptr);
  EXPECT_EQ(other.remove(id), Status::kStaleHandle);
  EXPECT_EQ(world.remove(id), Status::kOk);
  EXPECT_EQ(world.get(id), nullptr);
  EXPECT_EQ(world.remove(id), Status::kStaleHandle);
  EXPECT_EQ(world.remove({}), Status::kStaleHandle);
}

TEST(WorldLimits, TooManyPairs_LetsTheSurplusBodiesGoOnTogether) {
  World<TightScene> world;
  for (int i = 0; i < 3; ++i) (void)world.add(ball<TightScene>(0.25 * i, 0.1, i == 2 ? -1 : 1));
  ASSERT_EQ(world.step(1.0), Status::kOk);
  EXPECT_GT(world.report().pairs_dropped, 0);
  EXPECT_FALSE(world.report().complete());
  EXPECT_GT(world.report().time_held, 0.5);
  for (std::uint16_t a = 0; a < 3; ++a) {
    for (std::uint16_t b = a + 1; b < 3; ++b) EXPECT_GT(gap_between(world, a, b), -1e-12);
  }
}

TEST(WorldLimits, TooManyContacts_LetsTheBodiesGoOnTogetherFromWhereTheyAreFree) {
  World<OneContactScene>
      world;  // the first ball strikes the second one, which then would strike the third
  (void)world.add(ball<OneContactScene>(0, 0.1, 1));
  (void)world.add(ball<OneContactScene>(0.3, 0.1, 0));
  (void)world.add(ball<OneContactScene>(0.6, 0.1, 0));
  ASSERT_EQ(world.step(1.0), Status::kOk);
  EXPECT_EQ(world.report().collisions, 1U);
  EXPECT_EQ(world.report().contacts_dropped, 1U);
  EXPECT_FALSE(world.report().complete());
  EXPECT_GT(gap_between(world, 1, 2), -1e-12);
  EXPECT_LT(gap_between(world, 1, 2), 1e-3) << "what is proven free is used";
  // The first ball gave all it had to the second one at 0.1 s; that met the third one at 0.2 s.
  EXPECT_NEAR(world.get(world.id_at(1))->body.momentum.linear_W.x(), 0.5, 1e-9);
  EXPECT_NEAR(world.get(world.id_at(2))->body.momentum.linear_W.x(), 0.5, 1e-9);
  EXPECT_NEAR(world.get(world.id_at(2))->body.X_WB.p_W.x(), 0.6 + 0.5 * 0.8, 1e-3);
  ASSERT_EQ(world.step(1.0), Status::kOk);
  EXPECT_TRUE(world.report().complete());
  EXPECT_NEAR(world.get(world.id_at(2))->body.X_WB.p_W.x(), 0.6 + 0.5 * 1.8, 1e-3);
}

TEST(WorldLimits, TooManyEvents_AreCountedAndStillAnswered) {
  World<RoomyScene> world;
  (void)world.add(ball<RoomyScene>(0, 0.1, 1));
  (void)world.add(ball<RoomyScene>(0.3, 0.1, 0));
  (void)world.add(ball<RoomyScene>(0.6, 0.1, 0));
  ASSERT_EQ(world.step(1.0), Status::kOk);
  EXPECT_EQ(world.report().collisions, 2);
  EXPECT_EQ(world.events().size(), 1);
  EXPECT_EQ(world.report().events_dropped, 3U) << "the second begin and both ends";
  EXPECT_FALSE(world.report().complete());
}

TEST(WorldLimits, SearchOutOfBudget_StopsThePairBeforeTheContact) {
  World<TightScene> world;
  WorldSettings<TightScene> settings;
  settings.search.max_steps = 3;
  ASSERT_EQ(world.configure(settings), Status::kOk);
  (void)world.add(ball<TightScene>(0, 0.1, 10));
  (void)world.add(post<TightScene>(2, 0.1));
  ASSERT_EQ(world.step(1.0), Status::kOk);
  EXPECT_EQ(world.report().searches_cut, 1);
  EXPECT_FALSE(world.report().complete());
  EXPECT_GT(gap_between(world, 0, 1), 0);
  EXPECT_GT(world.get(world.id_at(0))->body.X_WB.p_W.x(), 0) << "what is proven free is used";
}

TEST(WorldLimits, SpinBeyondTheLimit_GoesOnWithoutATurnAndSaysSo) {
  World<TightScene> world;
  auto spinner = ball<TightScene>(0, 0.1, 1);
  spinner.body.momentum.angular_W = vec<double>(1e9, 0, 0);
  const auto id = world.add(spinner).value;
  ASSERT_EQ(world.step(1.0), Status::kOk);
  EXPECT_EQ(world.report().plans_invalid, 1);
  EXPECT_FALSE(world.report().complete());
  EXPECT_EQ(world.get(id)->body.X_WB.p_W, vec<double>(1, 0, 0));
  EXPECT_EQ(world.get(id)->body.X_WB.q_WB.coeffs(), Quat<double>::Identity().coeffs());
}

TEST(WorldLimits, OverlapAtStart_IsAnsweredReportedAndUndone) {
  World<TightScene> world;
  (void)world.add(ball<TightScene>(0, 0.1, 1));
  (void)world.add(ball<TightScene>(0.15, 0.1, 0));
  ASSERT_EQ(world.step(0.001), Status::kOk);
  EXPECT_EQ(world.report().overlaps_at_start, 1);
  EXPECT_NEAR(world.report().deepest_overlap, 0.05, 1e-12);
  EXPECT_EQ(world.report().collisions, 1);
  EXPECT_GT(gap_between(world, 0, 1), 0);
}

// The push-out of a pair must not push a body into its neighbour.
TEST(WorldLimits, SeparationStopsShortOfTheNeighbour) {
  World<TightScene> world;
  WorldSettings<TightScene> settings;
  settings.separation = 0.05;
  ASSERT_EQ(world.configure(settings), Status::kOk);
  (void)world.add(ball<TightScene>(0, 0.1, 0.005));
  (void)world.add(ball<TightScene>(0.2 + 1e-7, 0.1, 0));
  (void)world.add(post<TightScene>(0.4 + 0.01, 0.1));
  for (int i = 0; i < 20; ++i) {
    ASSERT_EQ(world.step(0.001), Status::kOk);
    EXPECT_GT(gap_between(world, 1, 2), 0) << "step " << i;
  }
}

TEST(WorldLimits, SameOwner_NeverMeets) {
  World<TightScene> world;
  auto A = ball<TightScene>(0, 0.1, 1);
  auto B = ball<TightScene>(0.5, 0.1, -1);
  A.owner = B.owner = 3;
  (void)world.add(A);
  (void)world.add(B);
  ASSERT_EQ(world.step(1.0), Status::kOk);
  EXPECT_EQ(world.report().pairs, 0);
  EXPECT_EQ(world.events().size(), 0);
}

TEST(WorldLimits, RemovedBody_LeavesNoContactBehind) {
  World<TightScene> world;
  const auto id = world.add(ball<TightScene>(0, 0.1, 1)).value;
  (void)world.add(post<TightScene>(0.25, 0.1));
  ASSERT_EQ(world.step(0.06), Status::kOk);
  ASSERT_EQ(world.events().size(), 1);
  ASSERT_EQ(world.remove(id), Status::kOk);
  for (int i = 0; i < 5; ++i) {
    ASSERT_EQ(world.step(0.1), Status::kOk);
    EXPECT_EQ(world.events().size(), 0);
  }
}

TEST(WorldLimits, BodyThatTheCallerSpoils_IsLeftOutAndCounted) {
  World<TightScene> world;
  const auto spoilt = world.add(ball<TightScene>(0, 0.1, 1)).value;
  const auto healthy = world.add(ball<TightScene>(3, 0.1, 1)).value;
  world.get(spoilt)->body.X_WB.p_W.x() = std::nan("");
  ASSERT_EQ(world.step(0.1), Status::kOk);
  EXPECT_GE(world.report().plans_invalid, 1U);
  EXPECT_NEAR(world.get(healthy)->body.X_WB.p_W.x(), 3.1, 1e-12);
  world.get(spoilt)->body.X_WB.p_W.x() = 0;
  ASSERT_EQ(world.step(0.1), Status::kOk);
  EXPECT_TRUE(world.report().complete());
}

TEST(WorldLimits, AnswerThatOverflows_HoldsThePairAndKeepsTheMomenta) {
  World<TightScene> world;
  auto heavy = ball<TightScene>(0, 0.1, 0);
  heavy.body.inverse_mass = 1e-300;
  heavy.body.inverse_moments.setZero();
  heavy.controller = Hand<double>{{vec<double>(1e9, 0, 0), Quat<double>::Identity()}, 1e-3};
  auto other = heavy;
  other.body.X_WB.p_W.x() = 0.3;
  other.controller = Fixed<double>{};
  (void)world.add(heavy);
  const auto id = world.add(other).value;
  WorldSettings<TightScene> settings;
  settings.search.epsilon = 1e9;
  settings.search.unit = EpsilonIn::kMetres;
  ASSERT_EQ(world.configure(settings), Status::kOk);
  ASSERT_EQ(world.step(1e-3), Status::kOk);
  EXPECT_TRUE(is_finite(world.get(id)->body.momentum.linear_W));
}

template <RestingContact kRests>
constexpr SceneOptions row_options() {
  SceneOptions scene;
  scene.max_bodies = 3;
  scene.max_pairs = 3;
  scene.max_contacts = 16;
  scene.resting = kRests;
  return scene;
}
template <RestingContact kRests>
using RowOf = Scene<row_options<kRests>>;

/// A ball flies at one that touches the end of a rod of 20 m, all of the same mass: it strikes the
/// other ball, and that one the rod. @param mass  kg: from 1e36 on, what the rod gets has a moment
/// beyond the largest float, while all momenta are below it
template <class SceneT>
void strike_row(World<SceneT>& world, float mass) {
  constexpr float kSpeed = 100;  // m/s
  constexpr float kHalf = 10;    // of the rod, m
  const auto add = [&](const Vec3<float>& place, float half, float speed) {
    Actor<SceneT> actor;
    const float across = mass * (half * half / 3 + 1e-3F);
    actor.body =
        make_body<float>({place, Quat<float>::Identity()}, mass, {across, mass * 1e-3F, across})
            .value;
    actor.capsule_B = {{{0, -half, 0}, {0, half, 0}}, 0.05F};
    actor.body.momentum.linear_W = {mass * speed, 0, 0};
    actor.restitution = 1;
    ASSERT_TRUE(world.add(actor).ok());
  };
  add({-0.105F, 0, 0}, 0, kSpeed);
  add({0, 0, 0}, 0, 0);
  add({0.1001F, kHalf, 0}, kHalf, 0);
  ASSERT_EQ(world.step(1e-3F), Status::kOk);
  double momentum = 0;
  for (std::uint16_t slot = 0; slot < 3; ++slot) {
    const Body<float>& body = std::as_const(world).get(world.id_at(slot))->body;
    ASSERT_TRUE(is_finite(body.momentum.linear_W) && is_finite(body.momentum.angular_W)) << slot;
    ASSERT_TRUE(is_finite(body.X_WB.p_W)) << slot;
    momentum += static_cast<double>(body.momentum.linear_W.x());
  }
  const double before = static_cast<double>(mass) * static_cast<double>(kSpeed);
  EXPECT_NEAR(momentum, before, 1e-6 * before);
}

TEST(WorldLimits, BlowThatOverflowsInARow_IsCountedAndKeepsMomentum) {
  const auto counts = [](auto world, float mass) {
    strike_row(*world, mass);
    EXPECT_EQ(world->report().complete(), world->report().resolutions_invalid == 0);
    return world->report().resolutions_invalid;
  };
  for (const float mass : {1e36F, 3e36F}) {
    EXPECT_GT(counts(std::make_unique<World<RowOf<RestingContact::kNone>>>(), mass), 0U);
    EXPECT_GT(counts(std::make_unique<World<RowOf<RestingContact::kSeparation>>>(), mass), 0U);
    // The second blow is passed on through the group.
    EXPECT_GT(counts(std::make_unique<World<RowOf<RestingContact::kSettling>>>(), mass), 0U);
  }
  EXPECT_EQ(counts(std::make_unique<World<RowOf<RestingContact::kNone>>>(), 1), 0U);
  EXPECT_EQ(counts(std::make_unique<World<RowOf<RestingContact::kSeparation>>>(), 1), 0U);
  EXPECT_EQ(counts(std::make_unique<World<RowOf<RestingContact::kSettling>>>(), 1), 0U);
}

TEST(WorldLimits, BadSettings_AreRefusedAndTheOldStay) {
  World<TightScene> world;
  WorldSettings<TightScene> settings;
  settings.rest_speed = 0;
  EXPECT_EQ(world.configure(settings), Status::kInvalidArgument);
  (void)world.add(ball<TightScene>(0, 0.1, 1));
  EXPECT_EQ(world.step(0.1), Status::kOk);
}

}  // namespace
}  // namespace batuta
