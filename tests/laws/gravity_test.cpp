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

// Every rule and engine: bodies that turn, those that do not, and the small engine's balls.
template <class S>
using Settles = LawScene<S, RestingContact::kSettling, test::kFalling>;
template <class S>
using Separates = LawScene<S, RestingContact::kSeparation, test::kFalling>;
template <class S>
using Strikes = LawScene<S, RestingContact::kNone, test::kFalling>;
constexpr SceneOptions straight_fall() {
  SceneOptions scene;
  scene.rotation = false;
  scene.gravity = true;
  scene.resting = RestingContact::kNone;
  return scene;
}
template <class S>
using Straight = Scene<straight_fall, Translation<S>>;
constexpr SceneOptions small_fall() {
  SceneOptions scene = straight_spheres();
  scene.gravity = true;
  return scene;
}
template <class S>
using Small = Scene<small_fall, Spheres<S>>;

/// A ball of 1 kg, or as solid_ball() has it.
template <class SceneT>
Actor<SceneT> ball_of(double radius, const Vector& place) {
  using S = typename SceneT::Scalar;
  if constexpr (SceneT::kRotation) {
    return test::solid_ball<SceneT>(radius, place);
  } else {
    Actor<SceneT> ball;
    ball.body = make_straight_body<S>(place.template cast<S>(), S(1)).value;
    if constexpr (SceneT::Search::kForSpheres) {
      ball.radius = static_cast<S>(radius);
    } else {
      ball.capsule_B = Capsule<S>::sphere(Vec3<S>::Zero(), static_cast<S>(radius));
    }
    return ball;
  }
}
template <class SceneT>
Actor<SceneT> floor_of(double radius) {
  const Vector place(0, 0, -radius);
  if constexpr (SceneT::kRotation) {
    return test::fixed_rod<SceneT>(10, radius, place, test::along_x());
  } else {
    auto floor = ball_of<SceneT>(radius, place);
    floor.body.inverse_mass = 0;
    return floor;
  }
}
template <class S>
Vector place_of(const Body<S>& body) {
  return body.X_WB.p_W.template cast<double>();
}
template <class S>
Vector place_of(const StraightBody<S>& body) {
  return body.p_W.template cast<double>();
}
template <class S>
Vector velocity(const Body<S>& body) {
  return (body.inverse_mass * body.momentum.linear_W).template cast<double>();
}
template <class S>
Vector velocity(const StraightBody<S>& body) {
  return (body.inverse_mass * body.momentum_W).template cast<double>();
}

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
  auto ball = ball_of<SceneT>(0.05, {0, 0, 0});
  if constexpr (SceneT::kRotation) {
    test::throw_body(ball, {3, 0, 5}, {1, 2, 3});
  } else {
    ball.body.momentum_W = {3, 0, 5};
  }
  const auto id = world->add(ball).value;
  const int count = static_cast<int>(std::lround(1 / dt));
  double time = 0;
  for (int i = 0; i < count; ++i) {
    ASSERT_EQ(world->step(static_cast<S>(dt)), Status::kOk);
    ASSERT_TRUE(world->report().complete());
    time += static_cast<double>(static_cast<S>(dt));
  }
  const Vector place = place_of(std::as_const(*world).get(id)->body);
  const Vector want(3 * time, 0, 5 * time - kG * time * time / 2);
  const double length = 3 * time + 5 * time + kG * time * time / 2;
  EXPECT_LE((place - want).norm(), share * length) << dt;
  const Vector v = velocity(std::as_const(*world).get(id)->body);
  EXPECT_LE((v - Vector(3, 0, 5 - kG * time)).norm(), share * (3 + 5 + kG * time)) << dt;
}

TYPED_TEST(Gravity, Projectile_IsOnTheParabola) {
  for (const double dt : {1e-4, 1e-3, 1e-2, 1.0 / 60, 1.0 / 30, 0.1}) {
    const double share = !TestFixture::kIsFloat ? 1e-12 : (dt < 5e-4 ? 1e-4 : 1e-5);
    throw_ball<Strikes<TypeParam>>(dt, share);
    throw_ball<Settles<TypeParam>>(dt, share);
    throw_ball<Separates<TypeParam>>(dt, share);
    throw_ball<Straight<TypeParam>>(dt, share);
    throw_ball<Small<TypeParam>>(dt, share);
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
    (void)world->add(floor_of<SceneT>(kRadius));
    auto ball = ball_of<SceneT>(kRadius, {0, 0, kRadius + height});
    ball.restitution = static_cast<S>(restitution);
    id = world->add(ball).value;
  }
  const auto& ball() const { return std::as_const(*world).get(id)->body; }
  double height() const { return place_of(ball()).z() - kRadius; }
  double speed() const { return velocity(ball()).z(); }
  double energy() const { return kG * height() + speed() * speed() / 2; }
  void step(double dt) { ASSERT_EQ(world->step(static_cast<S>(dt)), Status::kOk); }
};

/// @param share  of the energy, that may be gained or lost in `duration`
template <class SceneT>
void bounce_on(double height, double dt, double duration, double share) {
  Drop<SceneT> drop(height, 1);
  const double energy = kG * height;
  const int count = static_cast<int>(std::lround(duration / dt));
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
  EXPECT_GE(static_cast<double>(bounces), duration / longest - 2);
  EXPECT_LE(static_cast<double>(bounces), duration / shortest + 2);
}
template <class S>
void bounce_in_all(double height, double dt, double duration) {
  // At 0.1 ms places are rounded so often that the parabola is known to 1e-4 of its length in
  // float; and that is twice the height.
  const double in_float = dt < 5e-4 ? 2e-4 : 1e-4;
  const double share = std::is_same_v<S, float> ? in_float : 1e-9;
  bounce_on<Settles<S>>(height, dt, duration, share);
  bounce_on<Strikes<S>>(height, dt, duration, share);
  bounce_on<Separates<S>>(height, dt, duration, share);
  bounce_on<Straight<S>>(height, dt, duration, share);
  bounce_on<Small<S>>(height, dt, duration, share);
}

// A minute of them; at 0.1 ms three seconds.
TYPED_TEST(Gravity, ElasticBounces_NeitherGainNorLose) {
  for (const double height : {0.01, 0.1, 1.0, 10.0}) {
    for (const double dt : {1e-3, 1e-2, 1.0 / 60, 1.0 / 30}) {
      bounce_in_all<TypeParam>(height, dt, 60);
    }
    bounce_in_all<TypeParam>(height, 1e-4, 3);
  }
}

/// C = 0.8 from 1 m: the n-th apex is C^(2n) h, to D where the floor is met.
template <class SceneT>
void climb_again(double dt) {
  Drop<SceneT> drop(1, 0.8);
  double want = 1;
  double before = 1;
  int apexes = 0;
  for (int i = 0; i * dt < 6 && apexes < 6; ++i) {
    const bool was_rising = drop.speed() > 0;
    drop.step(dt);
    if (was_rising && drop.speed() <= 0) {
      want *= 0.64;
      const double apex = drop.height() + drop.speed() * drop.speed() / (2 * kG);
      EXPECT_NEAR(apex, want, max_of(0.01 * want, 1e-4)) << apexes << ", " << dt;
      EXPECT_LT(apex, before);
      before = apex;
      ++apexes;
    }
  }
  EXPECT_EQ(apexes, 6) << dt;
}

TYPED_TEST(Gravity, Apexes_FollowTheRestitution) {
  for (const double dt : {1e-4, 1e-3, 1e-2}) {
    climb_again<Settles<TypeParam>>(dt);
    climb_again<Strikes<TypeParam>>(dt);
    climb_again<Separates<TypeParam>>(dt);
    climb_again<Straight<TypeParam>>(dt);
    climb_again<Small<TypeParam>>(dt);
  }
}

/// All bounces take sqrt(2 h / g) (1 + C) / (1 - C). No step adds energy, whatever becomes of
/// bounces that are shorter than it; after them the ball is at rest, within 2 D of the floor, where
/// a contact ends.
template <class SceneT>
void bounce_out(double height, double restitution, double dt) {
  Drop<SceneT> drop(height, restitution);
  const double whole = std::sqrt(2 * height / kG) * (1 + restitution) / (1 - restitution);
  const double rest = 2 * kG * max_of(1e-4, kG * dt * dt / 4);
  const int count = static_cast<int>(std::lround((1.2 * whole + 1) / dt));
  for (int i = 0; i < count; ++i) {
    drop.step(dt);
    ASSERT_LE(drop.energy(), kG * height * (1 + 1e-6)) << i;
    ASSERT_GE(drop.height(), 0) << i;
    ASSERT_TRUE(drop.world->report().complete()) << i;
    if (i * dt > 1.2 * whole + 2 * dt) {
      ASSERT_LE(drop.energy(), rest) << i;
    }
  }
}

TYPED_TEST(Gravity, LossyBounces_EndInTheirTime) {
  for (const double dt : {1e-3, 1e-2}) {
    for (const double C : {0.0, 0.5, 0.9, 0.95}) {
      for (const double height : {0.01, 0.05}) {
        SCOPED_TRACE(::testing::Message() << height << " m, C " << C << ", " << dt << " s");
        bounce_out<Settles<TypeParam>>(height, C, dt);
        bounce_out<Strikes<TypeParam>>(height, C, dt);
        bounce_out<Separates<TypeParam>>(height, C, dt);
        bounce_out<Straight<TypeParam>>(height, C, dt);
        bounce_out<Small<TypeParam>>(height, C, dt);
      }
    }
  }
}

// Who lies still, to the last bit, is awake and pressed all the same: nothing happens to it.
TYPED_TEST(Gravity, BallThatLiesAwake_HasNothingToAnswer) {
  for (const double dt : kSteps) {
    Drop<Settles<TypeParam>> drop(5e-5, 0);
    for (int i = 0; i < 1000; ++i) {
      drop.step(dt);
      if (i < 20) continue;
      ASSERT_EQ(drop.world->events().size(), 0) << dt << ' ' << i;
      ASSERT_LE(std::abs(drop.speed()), 1e-6) << dt << ' ' << i;
    }
  }
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
