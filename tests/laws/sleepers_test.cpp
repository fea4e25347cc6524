// SPDX-License-Identifier: MIT
// Sleep changes nothing that anybody could see (src/world/world.md, "Sleep"): what is struck,
// loaded, left or changed wakes in the same step, and what was saved goes on with the same bits.
#include <gtest/gtest.h>

#include <vector>

#include "batuta/record/snapshot.hpp"
#include "batuta/record/world.hpp"
#include "choices.hpp"
#include "sleeping_rod.hpp"

namespace batuta {
namespace {

using test::Bed;
using test::kRadius;
using test::lead;
using test::Led;
using test::Vector;

template <class S>
class Sleepers : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(Sleepers, Scalars);

// Of two rods without friction the x momenta stay what they were, and both go on with one velocity:
// m V of 2 m where the search found a blow; where they were nearer than D when the step began, too.
TYPED_TEST(Sleepers, StruckFromAnyGap_TakesItsShare) {
  using SceneT = test::Settling<TypeParam, test::kSleeping>;
  for (const double dt : {1e-3, 1.0 / 60}) {
    for (const double V : {0.5, 5.0, 50.0}) {
      for (const double gap : {2e-5, 5e-5, 2e-4, 5e-4}) {
        Bed<SceneT> bed;
        bed.sleep(dt);
        const double x = static_cast<double>(bed.body(bed.sleeper).X_WB.p_W.x());
        auto block = test::solid_rod<SceneT>(
            1.2, kRadius, {x - 2 * kRadius - gap, 0, bed.height(bed.sleeper)}, test::along_y());
        test::throw_body(block, {V, 0, 0});
        const auto id = bed.world->add(block).value;
        for (int i = 0; i < 3; ++i) bed.step(dt);
        EXPECT_FALSE(bed.world->is_asleep(bed.sleeper)) << dt << ' ' << V << ' ' << gap;
        EXPECT_NEAR(bed.speed(id) + bed.speed(bed.sleeper), V, 1e-5 * V) << dt << ' ' << gap;
        EXPECT_NEAR(bed.speed(bed.sleeper), V / 2, 0.02 * V) << dt << ' ' << V << ' ' << gap;
      }
    }
  }
}

// One stands beside the sleeper, within D, and a third strikes it from the other side: without
// friction all that came in is there after the step, whoever has it.
TYPED_TEST(Sleepers, NeighbourOfWhoIsStruck_TakesItsShare) {
  using SceneT = test::Settling<TypeParam, test::kSleeping>;
  for (const double dt : {1e-3, 1.0 / 60}) {
    for (const double V : {0.5, 5.0}) {
      Bed<SceneT> bed;
      bed.sleep(dt);
      const double x = static_cast<double>(bed.body(bed.sleeper).X_WB.p_W.x());
      const double z = bed.height(bed.sleeper);
      const double beside = x - 2 * kRadius - 7e-5;
      const double apart = 2 * kRadius + V * dt / 2;
      const auto middle =
          bed.world->add(test::solid_rod<SceneT>(1.2, kRadius, {beside, 0, z}, test::along_y()));
      auto block = test::solid_rod<SceneT>(1.2, kRadius, {beside - apart, 0, z}, test::along_y());
      test::throw_body(block, {V, 0, 0});
      const auto id = bed.world->add(block).value;
      for (int i = 0; i < 2; ++i) {
        bed.step(dt);
        const double sum = bed.speed(id) + bed.speed(middle.value) + bed.speed(bed.sleeper);
        EXPECT_NEAR(sum, V, 1e-5 * V) << dt << ' ' << V << ' ' << i;
      }
      EXPECT_FALSE(bed.world->is_asleep(bed.sleeper)) << dt << ' ' << V;
    }
  }
}

// The plank reaches 0.2 m over a rail; ten times its mass at its end tip it.
TYPED_TEST(Sleepers, LoadedAtTheEnd_Tips) {
  using SceneT = test::Settling<TypeParam, test::kSleeping>;
  for (const double dt : {1e-3, 1.0 / 60}) {
    for (const double gap : {2e-5, 3e-4, 1e-3}) {
      Bed<SceneT> bed;
      bed.sleep(dt);
      const double z = bed.height(bed.sleeper) + kRadius + 0.1 + gap;
      (void)bed.world->add(test::solid_rod<SceneT>(0, 0.1, {0, 0.6, z}, {1, 0, 0, 0}, 23000));
      for (int i = 0; i * dt < 0.3; ++i) bed.step(dt);
      const Vec3<TypeParam> axis_W = bed.body(bed.sleeper).X_WB.q_WB * Vec3<TypeParam>::UnitZ();
      EXPECT_GT(std::abs(static_cast<double>(axis_W.z())), 0.02) << dt << ' ' << gap;
    }
  }
}

// What lies on something that sinks, however gently it begins, sinks with it.
TYPED_TEST(Sleepers, SupportThatLeavesGently_TakesThemAlong) {
  using S = TypeParam;
  for (const double dt : {1e-3, 1.0 / 60}) {
    for (const double a : {0.02, 0.1, 0.5}) {
      Bed<Led<S>> bed([](auto& rail) { rail.controller = Hand<S>{}; });
      for (int i = 0; i < 3000 && !bed.world->is_asleep(bed.sleeper); ++i) {
        lead<S>(bed, Vector::Zero(), dt);
        bed.step(dt);
      }
      ASSERT_TRUE(bed.world->is_asleep(bed.sleeper)) << dt;
      double t = 0;
      for (; t < 1; t += dt) {
        lead<S>(bed, Vector(0, 0, -a * (t + dt) * (t + dt) / 2), dt);
        bed.step(dt);
      }
      const double gap = bed.height(bed.sleeper) - bed.height(bed.rails[0]) - 2 * kRadius;
      EXPECT_LT(gap, max_of(2e-4, 9.81 * dt * dt / 2)) << dt << ' ' << a;
    }
  }
}

// Along the rod, so that it does not roll. At 2 mm/s nothing goes further in the time until sleep
// than what sleeps may: it stays awake all the same, and goes with what carries it.
TYPED_TEST(Sleepers, OnWhatMovesSlowly_NobodySleeps) {
  using S = TypeParam;
  for (const Vector& v : {Vector(0, 2e-3, 0), Vector(0, 0, -2e-3)}) {
    const double dt = 1e-3;
    Bed<Led<S>> bed([](auto& rail) {
      rail.controller = Hand<S>{};
      rail.friction = S(0.3);
    });
    for (int i = 0; i < 4000; ++i) {
      lead<S>(bed, (i + 1) * dt * v, dt);
      bed.step(dt);
      ASSERT_FALSE(bed.world->is_asleep(bed.sleeper)) << i;
    }
    const Vec3<S> way = bed.body(bed.sleeper).X_WB.p_W - bed.body(bed.rails[0]).X_WB.p_W;
    EXPECT_NEAR(static_cast<double>(way.y()), 0.4, 5e-4);
    EXPECT_NEAR(static_cast<double>(way.z()), 2 * kRadius, 2e-4);
  }
}

// What the caller changes of a sleeper or of what carries it is as if nobody had slept.
TYPED_TEST(Sleepers, WhatTheCallerChanges_IsSeen) {
  using SceneT = test::Settling<TypeParam, test::kSleeping>;
  using S = TypeParam;
  const double dt = 1e-3;
  const auto height_after = [dt](const auto& change) {
    Bed<SceneT> bed;
    bed.sleep(dt);
    change(bed);
    for (int i = 0; i < 500; ++i) bed.step(dt);
    return bed.height(bed.sleeper);
  };
  const double thinner = height_after([](Bed<SceneT>& bed) {
    for (const auto id : bed.rails) bed.world->get(id)->capsule_B.radius = S(0.02);
  });
  EXPECT_NEAR(thinner, 0.02, 2e-4);
  const double thin = height_after(
      [](Bed<SceneT>& bed) { bed.world->get(bed.sleeper)->capsule_B.radius = S(0.02); });
  EXPECT_NEAR(thin, 0.02, 2e-4);
  const double apart = height_after([](Bed<SceneT>& bed) {
    for (const auto id : bed.rails) bed.world->get(id)->owner = 7;
    bed.world->get(bed.sleeper)->owner = 7;
  });
  EXPECT_NEAR(apart, kRadius - 9.81 * 0.25 / 2, 3e-3);
  const double only_read =
      height_after([](Bed<SceneT>& bed) { (void)bed.world->get(bed.sleeper); });
  EXPECT_NEAR(only_read, kRadius, 1e-4);
}

// Along the rod, so that it does not roll: friction of 0.3 holds it, and no friction does not.
TYPED_TEST(Sleepers, FrictionThatTheCallerTakes_LetsItSlide) {
  using SceneT = test::Settling<TypeParam, test::kSleeping>;
  using S = TypeParam;
  constexpr double kAcross = 1.5;  // of gravity, m/s^2
  for (const double dt : {1e-3, 1.0 / 60}) {
    for (const bool of_rails : {false, true}) {
      Bed<SceneT> bed([](Actor<SceneT>& rail) { rail.friction = S(0.3); });
      auto settings = bed.world->settings();
      settings.gravity_W = Vector(0, kAcross, -9.81).template cast<S>();
      ASSERT_EQ(bed.world->configure(settings), Status::kOk);
      bed.sleep(dt);
      for (const auto id : bed.rails) bed.world->get(id)->friction = S(of_rails ? 0 : 0.3);
      bed.world->get(bed.sleeper)->friction = S(of_rails ? 0.3 : 0);
      const int count = static_cast<int>(std::lround(0.3 / dt));
      for (int i = 0; i < count; ++i) bed.step(dt);
      const auto& body = bed.body(bed.sleeper);
      const double speed = static_cast<double>(body.inverse_mass * body.momentum.linear_W.y());
      EXPECT_NEAR(speed, kAcross * count * dt, 1e-3 * kAcross * count * dt) << dt << of_rails;
    }
  }
}

// As above, of one that is awake and has stood for 50 steps: m a = m g_y - mu m g_z, whatever its
// contacts had begun with.
TYPED_TEST(Sleepers, FrictionThatIsTakenFromWhoIsAwake_LetsItSlide) {
  using SceneT = test::Settling<TypeParam, test::kFalling>;
  using S = TypeParam;
  constexpr double kAcross = 1.5;  // of gravity, m/s^2
  for (const double dt : {1e-3, 1.0 / 60}) {
    for (const double left : {0.0, 0.1}) {
      Bed<SceneT> bed([](Actor<SceneT>& rail) { rail.friction = S(0.3); });
      auto settings = bed.world->settings();
      settings.gravity_W = Vector(0, kAcross, -9.81).template cast<S>();
      ASSERT_EQ(bed.world->configure(settings), Status::kOk);
      for (int i = 0; i < 50; ++i) bed.step(dt);
      const auto speed = [&bed] {
        const auto& body = bed.body(bed.sleeper);
        return static_cast<double>(body.inverse_mass * body.momentum.linear_W.y());
      };
      EXPECT_NEAR(speed(), 0, 1e-4);
      for (const auto id : bed.rails) bed.world->get(id)->friction = static_cast<S>(left);
      bed.world->get(bed.sleeper)->friction = static_cast<S>(left);
      const int count = static_cast<int>(std::lround(0.3 / dt));
      for (int i = 0; i < count; ++i) bed.step(dt);
      const double expected = (kAcross - left * 9.81) * count * dt;
      EXPECT_NEAR(speed(), expected, 0.01 * expected) << dt << ' ' << left;
    }
  }
}

TYPED_TEST(Sleepers, WhoWasOnlyRead_SleepsOn) {
  using SceneT = test::Settling<TypeParam, test::kSleeping>;
  Bed<SceneT> bed;
  bed.sleep(1e-3);
  for (int i = 0; i < 10; ++i) {
    for (const auto id : {bed.sleeper, bed.rails[0]}) ASSERT_NE(bed.world->get(id), nullptr);
    bed.step(1e-3);
    ASSERT_TRUE(bed.world->is_asleep(bed.sleeper)) << i;
  }
}

/// A heap that grows rod by rod, so that some fall on sleepers.
template <class SceneT>
void drop_one(World<SceneT>& world, test::Choices& draw, int number) {
  using S = typename SceneT::Scalar;
  const Vector place(0.5 * draw.signed_share(), 0.3 * draw.signed_share(), 0.9 + 0.1 * number);
  auto rod = test::solid_rod<SceneT>(0.4, 0.04, place, draw.rotation().template cast<double>());
  rod.friction = S(0.5);
  rod.rolling_resistance = S(1e-3);
  test::throw_body(rod, draw.in_cube(), 5 * draw.in_cube());
  (void)world.add(rod);
}

TYPED_TEST(Sleepers, SavedAndRestored_GoOnWithTheSameBits) {
  using SceneT = test::Settling<TypeParam, test::kRolling>;
  std::vector<std::uint8_t> bytes(std::size_t{1} << 21U);
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    test::Choices draw(seed);
    auto world = std::make_unique<World<SceneT>>();
    for (int k = 0; k < 6; ++k) {
      auto log = test::fixed_rod<SceneT>(2.4, 0.15, {0, -0.75 + 0.3 * k, 0}, test::along_x());
      log.friction = TypeParam(0.5);
      (void)world->add(log);
    }
    for (int i = 0; i < 600; ++i) {
      if (i % 30 == 0 && i < 480) drop_one<SceneT>(*world, draw, i / 30);
      ASSERT_EQ(world->step(TypeParam(1) / 60), Status::kOk);
      if (i % 13 != 0) continue;
      auto copy = std::make_unique<World<SceneT>>();
      auto read = std::make_unique<World<SceneT>>();
      const auto size = save(*world, bytes.data(), static_cast<std::uint32_t>(bytes.size()));
      ASSERT_TRUE(size.ok());
      ASSERT_EQ(restore(*read, bytes.data(), size.value), Restored::kOk);
      copy->restore(*world);
      for (int k = 0; k < 3; ++k) {
        ASSERT_EQ(copy->step(TypeParam(1) / 60), Status::kOk);
        ASSERT_EQ(read->step(TypeParam(1) / 60), Status::kOk);
        ASSERT_EQ(hash_of(*copy), hash_of(*read)) << seed << ' ' << i;
      }
    }
  }
}

// No friction: nothing takes its spin, and the axis, which stays where it is, does not show it.
TYPED_TEST(Sleepers, WhatSpinsOnTheSpot_StaysAwake) {
  using SceneT = test::Settling<TypeParam, test::kSleeping>;
  for (const double dt : {1e-3, 1.0 / 60}) {
    Bed<SceneT> bed;
    auto* rod = bed.world->get(bed.sleeper);
    rod->friction = 0;
    test::throw_body(*rod, {0, 0, 0}, {0, 20, 0});
    const auto before = static_cast<double>(rod->body.momentum.angular_W.y());
    for (double t = 0; t < 1; t += dt) bed.step(dt);
    EXPECT_FALSE(bed.world->is_asleep(bed.sleeper)) << dt;
    const auto after = static_cast<double>(bed.body(bed.sleeper).momentum.angular_W.y());
    EXPECT_NEAR(after, before, 1e-4 * before) << dt;
    EXPECT_NEAR(bed.height(bed.sleeper), kRadius, 1e-3) << dt;
  }
}

// A ball on a light one on a slope without friction: both slide. Where the answers for that run
// out, they go on together with the slope, in that step, and it is told; asleep they would for
// ever, untold.
TYPED_TEST(Sleepers, WhatAWeldHolds_StaysAwake) {
  using SceneT = test::Settling<TypeParam, test::kSleeping>;
  int welded = 0;
  for (const double ratio : {1e2, 1e4, 1e6}) {
    World<SceneT> world;
    auto settings = world.settings();
    settings.gravity_W = Vec3<TypeParam>(TypeParam(6.9), 0, TypeParam(-6.9));
    ASSERT_EQ(world.configure(settings), Status::kOk);
    (void)world.add(test::fixed_rod<SceneT>(40, 0.5, {0, 0, -0.5}, test::along_x()));
    const auto light = world.add(test::solid_ball<SceneT>(0.1, {0, 0, 0.10005})).value;
    auto heavy = test::solid_ball<SceneT>(0.1, {0, 0, 0.3001});
    heavy.body.inverse_mass /= static_cast<TypeParam>(ratio);
    heavy.body.inverse_moments /= static_cast<TypeParam>(ratio);
    const auto id = world.add(heavy).value;
    for (int i = 0; i < 120; ++i) {
      ASSERT_EQ(world.step(TypeParam(1) / 60), Status::kOk);
      welded += world.report().complete() ? 0 : 1;
      ASSERT_FALSE(world.is_asleep(light) || world.is_asleep(id)) << ratio << ' ' << i;
    }
  }
  EXPECT_GT(welded, 0) << "nothing was welded: another scene";
}

// One arm of a body lies just below a rod, the other just above it, each on rails of its own:
// nobody presses, but each would if the other were gone, and wakes it when it falls asleep alone.
TYPED_TEST(Sleepers, NearEachOther_FallAsleepTogether) {
  using SceneT = test::Settling<TypeParam, test::kSleepingParts>;
  using S = TypeParam;
  constexpr double kR = 0.03;
  constexpr double kNear = 6.4e-5;  // between arm and rod: 0.64 D, less in a step of the fall
  constexpr double kRest = 5e-5;    // gap above rails: 0.5 D, where nothing moves
  World<SceneT> world;
  const double low = -2 * kR - kNear;
  for (const double side : {-1.0, 1.0}) {
    (void)world.add(
        test::fixed_rod<SceneT>(1, 0.05, {0, 0.4 * side, -kR - 0.05 - kRest}, test::along_x()));
    (void)world.add(test::fixed_rod<SceneT>(0.1, 0.05, {0.25 * side, 0, low - kR - 0.05 - kRest},
                                            test::along_y()));
  }
  const auto part = [&](const Vector& a, const Vector& b) {
    return CapsulePart<S>{{{a.cast<S>(), b.cast<S>()}, S(kR)}, 700};
  };
  const Vector end(0.3, 0, 0);
  const Vector up(0, 0, -2 * low);
  const CapsulePart<S> arms[] = {part(-end, end), part(end, end + up), part(end + up, up - end)};
  auto around =
      make_compound<3>(&arms[0], 3, Pose<S>{Vector(0, 0, low).cast<S>(), Quat<S>::Identity()})
          .value;
  Actor<SceneT> actor;
  actor.body = around.body;
  for (const auto& capsule_B : around.capsules_B) (void)actor.capsules_B.push(capsule_B);
  (void)world.add(actor).value;
  constexpr double kStep = 1e-3;  // s
  for (double t = 0; t < 0.1; t += kStep) ASSERT_EQ(world.step(S(kStep)), Status::kOk);
  (void)world.add(test::solid_rod<SceneT>(1, kR, Vector::Zero(), test::along_y(), 700)).value;
  for (double t = 0; t < 2; t += kStep) ASSERT_EQ(world.step(S(kStep)), Status::kOk);
  EXPECT_EQ(world.report().asleep, 2U);
}

}  // namespace
}  // namespace batuta
