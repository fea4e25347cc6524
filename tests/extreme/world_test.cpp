// SPDX-License-Identifier: MIT
// Worlds of every kind among bodies, steps and settings that make no sense: a status or a count,
// nothing changed where something is refused, and no place that is not a number in a step that says
// it was complete.
#include <memory>

#include "world_scenes.hpp"

namespace batuta {
namespace {

template <class SceneT>
class HostileWorld : public testing::Test {
 protected:
  using Number = typename SceneT::Scalar;
  using WorldType = World<SceneT>;

  /// Two that meet, in a world of its own.
  std::unique_ptr<WorldType> fresh() {
    auto world = std::make_unique<WorldType>();
    EXPECT_TRUE(world->add(test::flyer<SceneT>(-1, 2)).ok());
    EXPECT_TRUE(world->add(test::flyer<SceneT>(1, -2)).ok());
    return world;
  }
  /// Steps, and what a step has to keep.
  void step(WorldType& world, Number dt) {
    ASSERT_EQ(world.step(dt), Status::kOk);
    const auto& report = world.report();
    EXPECT_TRUE(is_finite(report.time_held) && is_finite(report.deepest_overlap));
    for (std::uint16_t slot = 0; slot < SceneT::kMaxBodies; ++slot) {
      const auto* actor = std::as_const(world).get(world.id_at(slot));
      if (actor != nullptr && report.complete()) {
        EXPECT_TRUE(test::is_sound(*actor)) << "slot " << slot;
      }
    }
  }
};
TYPED_TEST_SUITE(HostileWorld, test::Worlds);

TYPED_TEST(HostileWorld, HostileBody_IsRefusedOrFlies) {
  using S = typename TypeParam::Scalar;
  const auto good = test::flyer<TypeParam>(0.125, 0);
  const auto start = this->fresh();
  test::for_each_spoiled_actor(good, [&](const Actor<TypeParam>& actor, bool is_number) {
    World<TypeParam> world;
    world.restore(*start);
    const auto before = hash_of(world);
    const auto id = world.add(actor);
    if (!is_number) {
      EXPECT_EQ(id.status, Status::kInvalidArgument);
    }
    if (!id.ok()) {
      EXPECT_EQ(hash_of(world), before);
      return;
    }
    for (const S dt : {S(1e-3), S(0.25), S(1e-6), S(1)}) this->step(world, dt);
  });
}

TYPED_TEST(HostileWorld, BodySpoiledLater_IsLeftOutOrFlies) {
  using S = typename TypeParam::Scalar;
  const auto good = test::flyer<TypeParam>(0.125, 0);
  const auto start = this->fresh();
  test::for_each_spoiled_actor(good, [&](const Actor<TypeParam>& actor, bool is_number) {
    World<TypeParam> world;
    world.restore(*start);
    *world.get(world.id_at(1)) = actor;
    this->step(world, S(1e-3));
    if (!is_number) {
      EXPECT_FALSE(world.report().complete());
    }
    this->step(world, S(1));
    EXPECT_TRUE(test::is_sound(*world.get(world.id_at(0)))) << "the other one";
  });
}

TYPED_TEST(HostileWorld, StepOfAnyLength_IsMadeOrRefusedWithoutATrace) {
  using S = typename TypeParam::Scalar;
  const auto start = this->fresh();
  for (const S dt : test::kHostile<S>) {
    World<TypeParam> world;
    world.restore(*start);
    const auto before = hash_of(world);
    if (is_positive(dt)) {
      this->step(world, dt);
      this->step(world, dt);
    } else {
      EXPECT_EQ(world.step(dt), Status::kInvalidArgument) << dt;
      EXPECT_EQ(hash_of(world), before) << dt;
    }
  }
}

TYPED_TEST(HostileWorld, StepsFromAMicrosecondToASecond_MeetAndPart) {
  using S = typename TypeParam::Scalar;
  for (const double dt : {1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 0.1, 1.0}) {
    World<TypeParam> world;
    WorldSettings<TypeParam> settings;
    if constexpr (TypeParam::kGravity) settings.gravity_W.setZero();
    ASSERT_EQ(world.configure(settings), Status::kOk);
    const double ahead = min_of(dt, 0.125);  // they meet in the first step
    auto left = test::flyer<TypeParam>(-0.125 - ahead, 2);
    auto right = test::flyer<TypeParam>(0.125 + ahead, -2);
    if constexpr (TypeParam::kRotation) {
      left.body.momentum.angular_W.setZero();
      right.body.momentum.angular_W.setZero();
    }
    ASSERT_TRUE(world.add(left).ok() && world.add(right).ok());
    this->step(world, static_cast<S>(dt));
    EXPECT_TRUE(world.report().complete()) << dt;
    EXPECT_EQ(world.report().collisions, 1U) << dt;
    auto* A = world.get(world.id_at(0));
    auto* B = world.get(world.id_at(1));
    EXPECT_LT(test::own_place_of(*A).x() + S(0.2499), test::own_place_of(*B).x()) << dt;
  }
}

TYPED_TEST(HostileWorld, SettingsWithHostileNumbers_AreRefusedAndTheOldStay) {
  using S = typename TypeParam::Scalar;
  World<TypeParam> world;
  const auto before = hash_of(world);
  const auto judge = [&](const WorldSettings<TypeParam>& settings, bool good) {
    EXPECT_EQ(world.configure(settings) == Status::kOk, good);
    if (good) {
      EXPECT_EQ(world.configure({}), Status::kOk);
    }
    EXPECT_EQ(hash_of(world), before);
  };
  for (const S number : test::kHostile<S>) {
    SCOPED_TRACE(number);
    if constexpr (detail::kKnowsRest<TypeParam>) {
      for (S detail::RestSettings<S>::*member :
           {&detail::RestSettings<S>::rest_speed, &detail::RestSettings<S>::separation,
            &detail::RestSettings<S>::min_separation_time}) {
        WorldSettings<TypeParam> settings;
        settings.*member = number;
        judge(settings, is_positive(number));
      }
    }
    if constexpr (TypeParam::kGravity) {
      WorldSettings<TypeParam> settings;
      settings.gravity_W.y() = number;
      judge(settings, is_finite(number));
    }
  }
}

TYPED_TEST(HostileWorld, AcceptedSettingsAtTheirEnds_LeaveNumbers) {
  using S = typename TypeParam::Scalar;
  const auto start = this->fresh();
  for (const S number : test::kHostile<S>) {
    SCOPED_TRACE(number);
    for (int member = 0; member < 4; ++member) {
      WorldSettings<TypeParam> settings;
      if constexpr (detail::kKnowsRest<TypeParam>) {
        if (member == 0) settings.rest_speed = number;
        if (member == 1) settings.separation = number;
        if (member == 2) settings.min_separation_time = number;
      }
      if constexpr (TypeParam::kGravity) {
        if (member == 3) settings.gravity_W.z() = number;
      }
      World<TypeParam> world;
      world.restore(*start);
      if (world.configure(settings) != Status::kOk) continue;
      for (const S dt : {S(0.25), S(0.5), S(1e-3), S(1)}) this->step(world, dt);
    }
  }
}

TYPED_TEST(HostileWorld, FeaturesOutOfRange_AreRefused) {
  using S = typename TypeParam::Scalar;
  World<TypeParam> world;
  for (const S number : test::kHostile<S>) {
    auto actor = test::flyer<TypeParam>(0, 0);
    if constexpr (TypeParam::kRestitution) {
      actor.restitution = number;
      const bool good = number >= S(0) && number <= S(1);
      const auto id = world.add(actor);
      EXPECT_EQ(id.ok(), good) << number;
      (void)world.remove(id.value);
    }
    if constexpr (TypeParam::kFriction) {
      actor = test::flyer<TypeParam>(0, 0);
      actor.friction = number;
      const auto id = world.add(actor);
      EXPECT_EQ(id.ok(), is_finite(number) && number >= S(0)) << number;
      (void)world.remove(id.value);
    }
  }
  EXPECT_EQ(world.size(), 0);
}

TYPED_TEST(HostileWorld, IdsThatNameNothing_AreRefused) {
  const auto world = this->fresh();
  const auto before = hash_of(*world);
  using Id = typename World<TypeParam>::BodyId;
  for (const Id id : {Id{}, Id{1, 0, 77}, Id{65535, 0, 1}, Id{3, 0, 1}, Id{1, 9, 1}}) {
    EXPECT_EQ(world->remove(id), Status::kStaleHandle);
    EXPECT_EQ(world->get(id), nullptr);
    EXPECT_EQ(world->steer(id), nullptr);
    EXPECT_FALSE(world->is_asleep(id));
  }
  for (const std::uint16_t slot : {std::uint16_t{2}, std::uint16_t{4}, std::uint16_t{65535}}) {
    EXPECT_TRUE(world->id_at(slot).is_null());
  }
  EXPECT_EQ(hash_of(*world), before);
}

TYPED_TEST(HostileWorld, FullWorld_RefusesAndStays) {
  const auto world = this->fresh();
  while (world->size() < TypeParam::kMaxBodies) {
    ASSERT_TRUE(world->add(test::flyer<TypeParam>(10 + world->size(), 0)).ok());
  }
  const auto before = hash_of(*world);
  EXPECT_EQ(world->add(test::flyer<TypeParam>(0, 0)).status, Status::kPoolFull);
  EXPECT_EQ(hash_of(*world), before);
}

// To 1e6 m/s and beyond, head on, in a step in which they would be kilometres past each other.
TYPED_TEST(HostileWorld, AnySpeed_IsStoppedAtTheContactOrCounted) {
  using S = typename TypeParam::Scalar;
  for (double speed = 1; speed < 1e30; speed *= 10) {
    World<TypeParam> world;
    WorldSettings<TypeParam> settings;
    if constexpr (TypeParam::kGravity) settings.gravity_W.setZero();
    ASSERT_EQ(world.configure(settings), Status::kOk);
    auto fast = test::flyer<TypeParam>(-1, speed);
    auto slow = test::flyer<TypeParam>(1, 0);
    ASSERT_TRUE(world.add(fast).ok() && world.add(slow).ok());
    this->step(world, S(0.125));
    if (world.report().collisions == 0 && speed >= 16) {
      EXPECT_FALSE(world.report().complete()) << speed;
    }
    if (speed <= 1e6 && TypeParam::Search::kNumber != Stepping<S>::kNumber) {
      EXPECT_TRUE(world.report().complete()) << speed;
    }
    EXPECT_LE(test::own_place_of(*world.get(world.id_at(0))).x(),
              test::own_place_of(*world.get(world.id_at(1))).x())
        << speed;
  }
}

// Nobody else is there to be searched for. The small world, whose flash counts, lets it go and
// counts it from the next step on.
TYPED_TEST(HostileWorld, LoneBodyBeyondTheNumbers_IsHeldAndCounted) {
  using S = typename TypeParam::Scalar;
  for (const S dt : {S(1), S(1e30), std::numeric_limits<S>::max() / 4}) {
    World<TypeParam> world;
    WorldSettings<TypeParam> settings;
    if constexpr (TypeParam::kGravity) settings.gravity_W.setZero();
    ASSERT_EQ(world.configure(settings), Status::kOk);
    auto lone = test::flyer<TypeParam>(0, 0);
    if constexpr (TypeParam::kRotation) {
      lone.body.momentum.linear_W.x() = std::numeric_limits<S>::max() / 2;
      lone.body.momentum.angular_W.setZero();
    } else {
      lone.body.momentum_W.x() = std::numeric_limits<S>::max() / 2;
    }
    ASSERT_TRUE(world.add(lone).ok());
    for (int step = 0; step < 4; ++step) {
      ASSERT_EQ(world.step(dt), Status::kOk);
      const bool sound = test::is_sound(*std::as_const(world).get(world.id_at(0)));
      const bool counts_late = (TypeParam::kEngine == Engine::kSmall) && step == 0;
      EXPECT_TRUE(sound || counts_late || world.report().plans_invalid == 1U) << dt;
      EXPECT_TRUE(sound || (TypeParam::kEngine == Engine::kSmall)) << dt;
    }
  }
}

template <class SceneT>
class TurningWorld : public HostileWorld<SceneT> {};
using Turning = testing::Types<test::Rich<float>, test::Paper<double>>;
TYPED_TEST_SUITE(TurningWorld, Turning);

// The stated limit is kMaxAngle in a step.
TYPED_TEST(TurningWorld, SpinToTheLimitAndBeyond_TurnsOrIsHeldAndCounted) {
  using S = typename TypeParam::Scalar;
  for (const double share : {1e-6, 1e-3, 0.5, 0.999, 1.001, 2.0, 1e3, 1e20}) {
    World<TypeParam> world;
    auto top = test::flyer<TypeParam>(0, 0);
    const S dt = S(1e-3);
    const double rate = share * static_cast<double>(detail::kMaxAngle<S>) / static_cast<double>(dt);
    const auto moment = S(1) / top.body.inverse_moments.x();
    top.body.momentum.angular_W = {static_cast<S>(rate) * moment, 0, 0};
    ASSERT_TRUE(world.add(top).ok());
    this->step(world, dt);
    EXPECT_EQ(world.report().plans_invalid, share < 1 ? 0U : 1U) << share;
    const auto& q = world.get(world.id_at(0))->body.X_WB.q_WB;
    EXPECT_NEAR(static_cast<double>(q.norm()), 1, 8 * static_cast<double>(kRoundOff<S>)) << share;
  }
}

}  // namespace
}  // namespace batuta
