// SPDX-License-Identifier: MIT
// Law 4 under gravity, and bounces: the parabola z = v t - g t^2 / 2, and E = m (g h + v^2 / 2), by
// pencil and paper; in every resting rule for which the row has a meaning.
#include <gtest/gtest.h>

#include "law_worlds.hpp"

namespace batuta {
namespace {

using test::LawScene;
using test::Vector;

constexpr double kG = 9.81;
constexpr double kSteps[] = {1e-4, 1e-3, 1e-2, 1.0 / 60, 1.0 / 30};

template <class S>
class Gravity : public ::testing::Test {
 public:
  static constexpr bool kIsFloat = std::is_same_v<S, float>;
};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(Gravity, Scalars);

template <class SceneT>
void throw_ball(double dt, double share) {
  using S = typename SceneT::Scalar;
  auto world = std::make_unique<World<SceneT>>();
  auto ball = test::solid_ball<SceneT>(0.05, {0, 0, 0});
  test::throw_body(ball, {3, 0, 5}, {1, 2, 3});
  const auto id = world->add(ball).value;
  const int count = static_cast<int>(std::lround(1 / dt));
  double time = 0;
  for (int i = 0; i < count; ++i) {
    ASSERT_EQ(world->step(static_cast<S>(dt)), Status::kOk);
    ASSERT_TRUE(world->report().complete());
    time += static_cast<double>(static_cast<S>(dt));
  }
  const auto& body = world->get(id)->body;
  const Vector want(3 * time, 0, 5 * time - kG * time * time / 2);
  const double length = 3 * time + 5 * time + kG * time * time / 2;
  EXPECT_LE((body.X_WB.p_W.template cast<double>() - want).norm(), share * length) << dt;
}

TYPED_TEST(Gravity, Projectile_IsOnTheParabola) {
  for (const double dt : kSteps) {
    const double share = !TestFixture::kIsFloat ? 1e-12 : (dt < 5e-4 ? 1e-4 : 1e-5);
    throw_ball<LawScene<TypeParam, RestingContact::kNone, test::kFalling>>(dt, share);
    throw_ball<LawScene<TypeParam, RestingContact::kSettling, test::kFalling>>(dt, share);
    throw_ball<LawScene<TypeParam, RestingContact::kSeparation, test::kFalling>>(dt, share);
  }
}

/// A ball above a floor, and what it does.
template <class SceneT>
struct Drop {
  using S = typename SceneT::Scalar;
  static constexpr double kRadius = 0.05;
  std::unique_ptr<World<SceneT>> world = std::make_unique<World<SceneT>>();
  typename World<SceneT>::BodyId id;

  Drop(double height, double restitution) {
    auto floor = test::fixed_rod<SceneT>(10, kRadius, {0, 0, -kRadius}, test::along_x());
    (void)world->add(floor);
    auto ball = test::solid_ball<SceneT>(kRadius, {0, 0, kRadius + height});
    ball.restitution = static_cast<S>(restitution);
    id = world->add(ball).value;
  }
  const Body<S>& ball() const { return std::as_const(*world).get(id)->body; }
  double height() const { return static_cast<double>(ball().X_WB.p_W.z()) - kRadius; }
  double speed() const {
    return static_cast<double>(ball().inverse_mass * ball().momentum.linear_W.z());
  }
  double energy() const { return kG * height() + speed() * speed() / 2; }
  void step(double dt) { ASSERT_EQ(world->step(static_cast<S>(dt)), Status::kOk); }
};

/// @param share  of the energy, that may be gained or lost in a minute
template <class SceneT>
void bounce_for_a_minute(double height, double dt, double share) {
  Drop<SceneT> drop(height, 1);
  const double energy = kG * height;
  const int count = static_cast<int>(std::lround(60 / dt));
  long bounces = 0;
  for (int i = 0; i < count; ++i) {
    drop.step(dt);
    bounces += drop.world->report().collisions;
    ASSERT_NEAR(drop.energy() / energy, 1, share) << height << ' ' << dt << ' ' << i;
    ASSERT_TRUE(drop.world->report().complete()) << height << ' ' << dt << ' ' << i;
  }
  // The chord of a step is below the parabola by g dt^2 / 8 at most: so much higher it may meet.
  const double longest = 2 * std::sqrt(2 * height / kG);
  const double shortest = 2 * std::sqrt(2 * (height - kG * dt * dt / 8) / kG);
  EXPECT_GE(static_cast<double>(bounces), 60 / longest - 2);
  EXPECT_LE(static_cast<double>(bounces), 60 / shortest + 2);
}

TYPED_TEST(Gravity, ElasticBounces_NeitherGainNorLose) {
  const double share = TestFixture::kIsFloat ? 1e-4 : 1e-9;
  for (const double height : {0.01, 0.1, 1.0, 10.0}) {
    for (const double dt : {1e-3, 1.0 / 60, 1.0 / 30}) {
      bounce_for_a_minute<LawScene<TypeParam, RestingContact::kSettling, test::kFalling>>(
          height, dt, share);
      bounce_for_a_minute<LawScene<TypeParam, RestingContact::kNone, test::kFalling>>(height, dt,
                                                                                      share);
      bounce_for_a_minute<LawScene<TypeParam, RestingContact::kSeparation, test::kFalling>>(
          height, dt, share);
    }
  }
}

// C = 0.8 from 1 m: the n-th apex is C^(2n) h, to D where the floor is met.
TYPED_TEST(Gravity, Apexes_FollowTheRestitution) {
  using SceneT = LawScene<TypeParam, RestingContact::kSettling, test::kFalling>;
  Drop<SceneT> drop(1, 0.8);
  double want = 1;
  double before = 1;
  int apexes = 0;
  for (int i = 0; i < 6000 && apexes < 6; ++i) {
    const bool was_rising = drop.speed() > 0;
    drop.step(1e-3);
    if (was_rising && drop.speed() <= 0) {
      want *= 0.64;
      const double apex = drop.height() + drop.speed() * drop.speed() / (2 * kG);
      EXPECT_NEAR(apex, want, max_of(0.01 * want, 1e-4)) << apexes;
      EXPECT_LT(apex, before);
      before = apex;
      ++apexes;
    }
  }
  EXPECT_EQ(apexes, 6);
}

// All bounces of C = 0.9 from 1 cm take 0.86 s; after them it rests, and sleeps.
TYPED_TEST(Gravity, BouncesShorterThanAStep_End) {
  using SceneT = LawScene<TypeParam, RestingContact::kSettling, test::kSleeping>;
  for (const double dt : kSteps) {
    Drop<SceneT> drop(0.01, 0.9);
    double asleep = -1;
    double most = 0;
    const int count = static_cast<int>(std::lround(3 / dt));
    for (int i = 0; i < count && asleep < 0; ++i) {
      drop.step(dt);
      most = std::max(most, drop.energy());
      if (drop.world->is_asleep(drop.id)) asleep = dt * i;
    }
    EXPECT_GE(asleep, 0) << dt;
    EXPECT_LE(most, kG * 0.01 * (1 + 1e-4) + 1e-6) << dt;
  }
}

}  // namespace
}  // namespace batuta
