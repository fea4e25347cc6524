// SPDX-License-Identifier: MIT
// Scenes of many bodies beyond what they have room for, and many small scenes at random: nobody
// ever overlaps.

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "batuta/world/scenes.hpp"
#include "crowd.hpp"

namespace batuta {
namespace {

using test::Crowd;
using test::CrowdRun;
using test::Draws;

template <class SceneT>
float deepest_overlap(const World<SceneT>& world) {
  float least = std::numeric_limits<float>::max();
  for (std::uint16_t i = 0; i < SceneT::kMaxBodies; ++i) {
    const auto* A = world.get(world.id_at(i));
    for (std::uint16_t k = 0; A != nullptr && k < i; ++k) {
      const auto* B = world.get(world.id_at(k));
      if (B == nullptr || (is_fixed(A->body) && is_fixed(B->body))) continue;
      for (int p = 0; p < parts_of(*A); ++p) {
        for (int q = 0; q < parts_of(*B); ++q) {
          const auto gap = capsule_gap(to_world(A->body.X_WB, part_of(*A, p)),
                                       to_world(B->body.X_WB, part_of(*B, q)));
          least = std::min(least, gap.gap);
        }
      }
    }
  }
  return std::max(0.0F, -least);
}

/// What rounding is worth, of coordinates up to `size`.
constexpr float rounding(float size) {
  constexpr float kUlps = 32;  // a pose, two ends, a distance: each a few
  return kUlps * std::numeric_limits<float>::epsilon() * size;
}

/// What a search cannot tell from contact, twice, and rounding, of a pair whose distance, sizes and
/// ways add up to `size` (src/world/detail/margin.md): so far a pair that parts and turns back
/// within the step may overlap.
constexpr float margin(float size) {
  constexpr float kUlps = 96 + 72;  // contact tolerance; evaluation and stored poses
  return 2 * kUlps * kRoundOff<float> * size;
}

TEST(ManyLimits, MorePairsThanRoom_HoldsTheirBodiesAndNeverOverlaps) {
  using Run = CrowdRun<float, 64>;
  static_assert(Run::SceneT::kMaxPairs < 64 * 63 / 2);
  auto run = std::make_unique<Run>();
  run->begin(Crowd::kWorst, 1);
  ASSERT_EQ(run->world().size(), 64);
  // All but those that fit in are held for the whole step; the others go on.
  for (int i = 0; i < 50; ++i) {
    ASSERT_EQ(run->step(), Status::kOk);
    const auto& report = run->world().report();
    EXPECT_GT(report.pairs_dropped, 0U);
    EXPECT_FALSE(report.complete());
    EXPECT_FLOAT_EQ(report.time_held, static_cast<float>(test::kStep));
    ASSERT_LE(deepest_overlap(run->world()), rounding(2)) << "step " << i;
  }
}

// The same bodies come together fast, with room for far too few pairs at first, and in long steps.
TEST(ManyLimits, CrowdThatClosesInWithLittleRoom_NeverOverlaps) {
  using Run = CrowdRun<float, 64>;
  auto run = std::make_unique<Run>();
  run->begin(Crowd::kDense, 3);
  std::uint32_t dropped = 0;
  for (int i = 0; i < 30; ++i) {
    for (std::uint16_t k = 0; k < 64; ++k) {
      auto& body = run->world().get(run->world().id_at(k))->body;
      body.momentum.linear_W = -2 / body.inverse_mass * body.X_WB.p_W;
    }
    ASSERT_EQ(run->world().step(0.1F), Status::kOk);
    dropped += run->world().report().pairs_dropped;
    // 0.3 m apart, bodies of 0.2 m, ways of 0.2 m.
    ASSERT_LE(deepest_overlap(run->world()), margin(1)) << "step " << i;
  }
  EXPECT_GT(dropped, 0U);
}

/// As many bodies as a world takes, in room for half of the pairs of a row of them.
constexpr int kMostBodies = 65534;
constexpr SceneOptions long_row() {
  SceneOptions scene = straight_spheres();
  scene.engine = Engine::kGeneral;
  scene.max_bodies = kMostBodies;
  scene.max_pairs = kMostBodies / 2;
  scene.max_events = 1;
  scene.response = false;
  scene.restitution = false;
  return scene;
}

// Its capsules taken two at a time are more than 32 bits count.
TEST(ManyLimits, AsManyBodiesAsThereMayBe_TellEachPairThatHasNoRoom) {
  using Row = Scene<long_row, Spheres<float>>;
  auto world = std::make_unique<World<Row>>();
  for (int i = 0; i < kMostBodies; ++i) {
    Actor<Row> actor;
    actor.radius = 0.5625F;  // each reaches into its two neighbours
    actor.body = make_straight_body<float>({static_cast<float>(i), 0, 0}, 1).value;
    ASSERT_EQ(world->add(actor).status, Status::kOk);
  }
  ASSERT_EQ(world->step(1e-3F), Status::kOk);
  EXPECT_EQ(world->report().pairs_dropped, kMostBodies - 1 - kMostBodies / 2);
  EXPECT_EQ(world->report().pairs, kMostBodies / 2);
}

/// With little room for everything, so that limits are met as well.
template <RestingContact kRests, int kParts>
constexpr SceneOptions small_options() {
  SceneOptions scene;
  scene.max_bodies = 5;
  scene.capsules_per_body = kParts;
  scene.max_pairs = 6;
  scene.max_contacts = 4;
  scene.resting = kRests;
  return scene;
}
template <RestingContact kRests, int kParts>
using Small = Scene<small_options<kRests, kParts>>;

template <class SceneT>
Actor<SceneT> draw_actor(Draws& draws) {
  Actor<SceneT> actor;
  const bool fixed = draws.chance(0.2);
  const Vec3<double> place = draws.in_ball(0.35);
  const Quat<double> q_WB = draws.rotation();
  const Vec3<double> p = draws.in_ball(5) - 4 * place;
  const Vec3<double> b = draws.in_ball(0.2);
  const double moment = 0.002 + 0.02 * draws.unit();
  if (!fixed) {
    const auto m = static_cast<float>(moment);
    actor.body = make_body<float>({}, 1, {m, 1.2F * m, 1.5F * m}).value;
    actor.body.momentum = {p.cast<float>(), b.cast<float>()};
  }
  actor.body.X_WB = {place.cast<float>(), q_WB.cast<float>()};
  for (int i = 0; i < SceneT::kCapsulesPerBody; ++i) {
    const Vec3<double> from = draws.in_ball(0.2);
    const Vec3<double> to = draws.in_ball(0.2);
    const Capsule<float> part{{from.cast<float>(), to.cast<float>()},
                              static_cast<float>(0.02 + 0.05 * draws.unit())};
    if constexpr (SceneT::kCapsulesPerBody == 1) {
      actor.capsule_B = part;
    } else {
      (void)actor.capsules_B.push(part);
    }
  }
  actor.restitution = static_cast<float>(draws.unit());
  return actor;
}

/// Scenes that do not overlap at the beginning, a few steps each. @returns contacts
template <class SceneT>
std::uint32_t play(std::uint64_t first, std::uint64_t last) {
  std::uint32_t contacts = 0;
  auto world = std::make_unique<World<SceneT>>();
  for (std::uint64_t index = first; index < last; ++index) {
    Draws draws(20061107, SceneT::kCapsulesPerBody, index);
    for (std::uint16_t i = 0; i < SceneT::kMaxBodies; ++i) (void)world->remove(world->id_at(i));
    while (world->size() < SceneT::kMaxBodies) {
      const auto id = world->add(draw_actor<SceneT>(draws));
      if (deepest_overlap(*world) > 0) (void)world->remove(id.value);
    }
    for (int i = 0; i < 4; ++i) {
      const double dt = draws.power_of_two(-8, -3);
      EXPECT_EQ(world->step(static_cast<float>(dt)), Status::kOk);
      contacts += world->report().collisions + world->report().separations;
      // 0.7 m apart, 0.6 m of bodies, ways of 0.8 m each, and ends that turn by 2.5 m each.
      EXPECT_LE(deepest_overlap(*world), margin(8)) << "scene " << index << " step " << i;
      if (::testing::Test::HasFailure()) return contacts;
    }
  }
  return contacts;
}

TEST(ManyLimits, TenThousandSmallScenes_NeverOverlap) {
  std::uint32_t contacts = 0;
  contacts += play<Small<RestingContact::kNone, 1>>(0, 2500);
  contacts += play<Small<RestingContact::kSeparation, 1>>(2500, 5000);
  contacts += play<Small<RestingContact::kSettling, 1>>(5000, 7500);
  contacts += play<Small<RestingContact::kSettling, 3>>(7500, 10000);
  EXPECT_GT(contacts, 8000U);
}

}  // namespace
}  // namespace batuta
