// SPDX-License-Identifier: MIT
// The world for C against the library's world of the same scene, to the bit, and against pencil and
// paper.

#include "batuta/world/world.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <memory>

#include "batuta/c.h"
#include "batuta/record/world.hpp"
#include "batuta/world/make_actor.hpp"
#include "batuta/world/scenes.hpp"
#include "heap_trap.hpp"

namespace batuta {
namespace {

constexpr SceneOptions as_c_h_says() {
  SceneOptions scene = rack();
  scene.max_bodies = 16;
  scene.max_pairs = 64;
  scene.max_contacts = 128;
  scene.max_events = 64;
  return scene;
}
using SceneOfTest = Scene<as_c_h_says>;
using WorldOfTest = World<SceneOfTest>;
using Moving = std::array<float, BATUTA_MOVING_NUMBERS>;

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr batuta_material kWood = {700, 0.5F, 0.4F};
constexpr batuta_material kFloor = {kInfinity, 0.5F, 0.8F};

Moving moving(const Capsule<float>& capsule, const Pose<float>& X, const Twist<float>& twist) {
  const auto& [a, b] = capsule.axis;
  const Vec3<float>& p = X.p_W;
  const Quat<float>& q = X.q_WB;
  const auto& [v, w] = twist;
  return {a.x(), a.y(), a.z(), b.x(), b.y(), b.z(), capsule.radius, p.x(), p.y(), p.z(),
          q.w(), q.x(), q.y(), q.z(), v.x(), v.y(), v.z(),          w.x(), w.y(), w.z()};
}

class WorldForC : public testing::Test {
 protected:
  void SetUp() override { ASSERT_EQ(batuta_world_init(world.get(), sizeof *world), BATUTA_OK); }

  /// Puts a body into both worlds.
  void add(const Capsule<float>& capsule, const Pose<float>& X, const Twist<float>& twist,
           const batuta_material& material) {
    std::int32_t number = -1;
    ASSERT_EQ(batuta_world_add(world.get(), moving(capsule, X, twist).data(), &material, &number),
              BATUTA_OK);
    EXPECT_EQ(number, own->size());
    auto actor =
        make_actor<SceneOfTest>(capsule, material.density, {X.p_W, renewed(X.q_WB)}, twist);
    ASSERT_TRUE(actor.ok());
    actor.value.restitution = material.restitution;
    actor.value.friction = material.friction;
    ASSERT_TRUE(own->add(actor.value).ok());
  }
  /// A floor of one thick capsule, and sticks that fall onto it and each other.
  void add_heap() {
    const Quat<float> upright = Quat<float>::Identity();
    add({{{-50, 0, 0}, {50, 0, 0}}, 10}, {{0, 0, -10}, upright}, {}, kFloor);
    for (int i = 0; i < 7; ++i) {
      const float h = static_cast<float>(i);
      const Quat<float> q = Quat<float>(1, 0.3F * h, 0.1F, -0.2F * h).normalized();
      add({{{-0.2F, 0, 0}, {0.2F, 0.1F, 0}}, 0.05F}, {{0.02F * h, 0, 0.2F + 0.3F * h}, q},
          {{0.1F * h, 0, 0}, {0, 1, h}}, kWood);
    }
  }
  std::uint64_t hash() const {
    std::uint64_t told = 0;
    EXPECT_EQ(batuta_world_hash(world.get(), &told), BATUTA_OK);
    return told;
  }

  std::unique_ptr<batuta_world> world = std::make_unique<batuta_world>();
  std::unique_ptr<WorldOfTest> own = std::make_unique<WorldOfTest>();
};

void expect_same(const batuta_event& told, const ContactEvent<float>& event) {
  EXPECT_EQ(told.kind, static_cast<int>(event.kind));
  EXPECT_EQ(told.body_A, event.body_A);
  EXPECT_EQ(told.body_B, event.body_B);
  EXPECT_EQ(told.time, event.time);
  EXPECT_EQ(told.impulse, event.impulse);
  EXPECT_EQ(Vec3<float>(told.point_W), event.contact.point_W);
  EXPECT_EQ(Vec3<float>(told.normal_W), event.contact.normal_BA_W);
}

TEST_F(WorldForC, AHeap_HasTheBitsOfTheLibrarysWorld) {
  add_heap();
  int events = 0;
  for (int step = 0; step < 500; ++step) {
    ASSERT_EQ(batuta_world_step(world.get(), 2e-3F), BATUTA_OK);
    ASSERT_EQ(own->step(2e-3F), Status::kOk);
    ASSERT_EQ(hash(), hash_of(*own)) << "step " << step;
    ASSERT_EQ(batuta_world_complete(world.get()) == 1, own->report().complete());
    ASSERT_EQ(batuta_world_event_count(world.get()), own->events().size());
    for (int i = 0; i < own->events().size(); ++i) {
      batuta_event told;
      ASSERT_EQ(batuta_world_event(world.get(), i, &told), BATUTA_OK);
      expect_same(told, own->events()[i]);
      ++events;
    }
  }
  EXPECT_GT(events, 100);
  for (int number = 0; number < own->size(); ++number) {
    batuta_body told;
    ASSERT_EQ(batuta_world_body(world.get(), number, &told), BATUTA_OK);
    const auto id = own->id_at(static_cast<std::uint16_t>(number));
    const auto* const actor = own->get(id);
    ASSERT_NE(actor, nullptr);
    const Capsule<float> capsule_W = to_world(actor->body.X_WB, actor->capsule_B);
    EXPECT_EQ(Vec3<float>(told.capsule_W), capsule_W.axis.a);
    EXPECT_EQ(Vec3<float>(told.capsule_W + 3), capsule_W.axis.b);
    EXPECT_EQ(told.capsule_W[6], capsule_W.radius);
    EXPECT_EQ(Vec3<float>(told.v_W), twist_of(actor->body).v_W);
    EXPECT_EQ(Vec3<float>(told.w_W), twist_of(actor->body).w_W);
    EXPECT_EQ(told.asleep == 1, own->is_asleep(id));
  }
}

TEST_F(WorldForC, AStoneThatFalls_IsOnItsParabola) {
  const std::array<float, 3> gravity_W = {0, 0, -4};
  ASSERT_EQ(batuta_world_set_gravity(world.get(), gravity_W.data()), BATUTA_OK);
  const Moving stone = moving(Capsule<float>::sphere({0, 0, 0}, 0.125F),
                              {{1, 2, 3}, Quat<float>::Identity()}, {{2, 0, 0}, {0, 0, 0}});
  std::int32_t number = -1;
  ASSERT_EQ(batuta_world_add(world.get(), stone.data(), &kWood, &number), BATUTA_OK);
  for (int i = 0; i < 64; ++i) {
    ASSERT_EQ(batuta_world_step(world.get(), 1.0F / 64), BATUTA_OK);
  }
  batuta_body body;
  ASSERT_EQ(batuta_world_body(world.get(), number, &body), BATUTA_OK);
  EXPECT_NEAR(body.capsule_W[0], 3, 1e-5);  // 1 + 2 t
  EXPECT_NEAR(body.capsule_W[2], 1, 1e-5);  // 3 - 4 t^2 / 2
  EXPECT_NEAR(body.v_W[2], -4, 1e-5);
}

/// Faster than anything whose blow a float can hold: refused, and what is accepted stays finite.
TEST_F(WorldForC, TooFastABody_IsRefused) {
  const Capsule<float> blade = {{{0, 0, -0.45F}, {0, 0, 0.45F}}, 0.005F};
  constexpr batuta_material kSteel = {7850, 0.6F, 0.3F};
  const auto add_at = [&](const Vec3<float>& place, const Vec3<float>& v_W) {
    std::int32_t number = -1;
    const Moving blade_W = moving(blade, {place, Quat<float>::Identity()}, {v_W, {0, 0, 0}});
    return batuta_world_add(world.get(), blade_W.data(), &kSteel, &number);
  };
  for (int axis = 0; axis < 3; ++axis) {
    for (const float speed : {1e3F, 1e10F, 1e18F, 1e20F, 1e30F, 1e35F, 3e38F}) {
      ASSERT_EQ(batuta_world_init(world.get(), sizeof *world), BATUTA_OK);
      ASSERT_EQ(add_at({0, 0, 1}, {4, 0, 0}), BATUTA_OK);
      const Vec3<float> v_W = speed * Vec3<float>::Unit(axis);
      const std::int32_t added = add_at({0.2F, 0, 1.3F}, v_W);
      EXPECT_EQ(added, speed < 1e19F ? BATUTA_OK : BATUTA_INVALID_ARGUMENT) << axis << ' ' << speed;
      for (int k = 0; k < 20; ++k) ASSERT_EQ(batuta_world_step(world.get(), 1e-3F), BATUTA_OK);
      for (int i = 0; i < (added == BATUTA_OK ? 2 : 1); ++i) {
        batuta_body body;
        ASSERT_EQ(batuta_world_body(world.get(), i, &body), BATUTA_OK);
        for (int k = 0; k < 3; ++k) {
          EXPECT_TRUE(std::isfinite(body.v_W[k]) && std::isfinite(body.w_W[k]))
              << axis << ' ' << speed;
        }
      }
    }
  }
}

TEST_F(WorldForC, RemovedBody_IsGoneAndItsNumberIsFree) {
  add_heap();
  ASSERT_EQ(batuta_world_remove(world.get(), 3), BATUTA_OK);
  batuta_body body;
  EXPECT_EQ(batuta_world_body(world.get(), 3, &body), BATUTA_STALE_HANDLE);
  EXPECT_EQ(batuta_world_remove(world.get(), 3), BATUTA_STALE_HANDLE);
  std::int32_t number = -1;
  const Moving ball =
      moving(Capsule<float>::sphere({0, 0, 0}, 0.1F), {{0, 5, 3}, Quat<float>::Identity()}, {});
  EXPECT_EQ(batuta_world_add(world.get(), ball.data(), &kWood, &number), BATUTA_OK);
  EXPECT_EQ(number, 3);
}

TEST_F(WorldForC, FullWorld_SaysSoAndIsAsItWas) {
  std::int32_t number = -1;
  for (int i = 0; i < BATUTA_WORLD_BODIES; ++i) {
    const Moving ball = moving(Capsule<float>::sphere({0, 0, 0}, 0.1F),
                               {{0, static_cast<float>(i), 3}, Quat<float>::Identity()}, {});
    ASSERT_EQ(batuta_world_add(world.get(), ball.data(), &kWood, &number), BATUTA_OK);
    EXPECT_EQ(number, i);
  }
  const auto before = hash();
  const Moving one_more =
      moving(Capsule<float>::sphere({0, 0, 0}, 0.1F), {{9, 0, 3}, Quat<float>::Identity()}, {});
  number = -1;
  EXPECT_EQ(batuta_world_add(world.get(), one_more.data(), &kWood, &number), BATUTA_POOL_FULL);
  EXPECT_EQ(number, -1);
  EXPECT_EQ(hash(), before);
}

TEST_F(WorldForC, Storage_IsFilledAndAllocatesNothing) {
  EXPECT_LE(batuta_world_size(), std::size_t{BATUTA_WORLD_BYTES});
  EXPECT_EQ(alignof(batuta_world) % batuta_world_align(), 0U);
  const test::HeapTrap trap;
  ASSERT_EQ(batuta_world_init(world.get(), batuta_world_size()), BATUTA_OK);
  const Moving ball =
      moving(Capsule<float>::sphere({0, 0, 0}, 0.1F), {{0, 0, 3}, Quat<float>::Identity()}, {});
  std::int32_t number = -1;
  ASSERT_EQ(batuta_world_add(world.get(), ball.data(), &kWood, &number), BATUTA_OK);
  ASSERT_EQ(batuta_world_step(world.get(), 1e-3F), BATUTA_OK);
  EXPECT_EQ(trap.allocations(), 0);
}

}  // namespace
}  // namespace batuta
