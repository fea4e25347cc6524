// SPDX-License-Identifier: MIT
// Laws 1, 2 and 3: a set of bodies that nobody holds keeps its momentum, its common centre goes
// straight on (or along the parabola) whatever its speed, and no contact adds energy. By the
// bodies' own poses and momenta, summed in double.
#include <gtest/gtest.h>

#include "law_worlds.hpp"

namespace batuta {
namespace {

using test::LawFeatures;
using test::LawScene;
using test::Sums;
using test::Vector;

constexpr LawFeatures kForkFloats = test::kCompound;
constexpr LawFeatures kForkFalls = test::kFallingCompound;

/// A fork round a rod, with `room` between them.
template <class SceneT>
void add_fork(World<SceneT>& world, double room, double speed) {
  using S = typename SceneT::Scalar;
  const double side = 0.03 + room / 2 + 0.005;
  const auto capsule = [](const Vector& a, const Vector& b, double r) {
    return CapsulePart<S>{{{a.cast<S>(), b.cast<S>()}, static_cast<S>(r)}, S(1000)};
  };
  const CapsulePart<S> fork[] = {capsule({-side, 0, 0}, {-side, 0, 0.3}, 0.005),
                                 capsule({side, 0, 0}, {side, 0, 0.3}, 0.005),
                                 capsule({-0.03, 0, 0}, {0.03, 0, 0}, 0.005)};
  const CapsulePart<S> rod[] = {capsule({0, -0.3, 0.15}, {0, 0.3, 0.15}, 0.03)};
  const auto add = [&world](const auto& compound, const Vector& v, const Vector& w) {
    Actor<SceneT> actor;
    actor.body = compound.body;
    for (const auto& part : compound.capsules_B) (void)actor.capsules_B.push(part);
    actor.restitution = S(0.5);
    test::throw_body(actor, v, w);
    ASSERT_TRUE(world.add(actor).ok());
  };
  add(make_compound<3>(&fork[0], 3, Pose<S>{}).value, {speed + 0.01, 0.003, 0}, {0, 0, 0.3});
  add(make_compound<3>(&rod[0], 1, Pose<S>{}).value, {speed - 0.02, 0.002, 0.01}, {0, 0, 0});
}

/// What a run came to, and what it may.
template <class SceneT>
struct Flight {
  using S = typename SceneT::Scalar;
  static constexpr double kRounding = static_cast<double>(kRoundOff<S>);

  std::unique_ptr<World<SceneT>> world = std::make_unique<World<SceneT>>();
  Sums before;
  double time = 0;
  long contacts = 0;
  long steps = 0;
  long incomplete = 0;
  double deepest = 0;

  /// Steps, and holds after each that no energy came from anywhere.
  void run(double dt, double duration) {
    before = test::sums_of(*world);
    double energy = before.kinetic;
    const int count = static_cast<int>(std::lround(duration / dt));
    for (int i = 0; i < count; ++i) {
      ASSERT_EQ(world->step(static_cast<S>(dt)), Status::kOk);
      time += static_cast<double>(static_cast<S>(dt));
      ++steps;
      contacts += world->report().collisions;
      incomplete += world->report().complete() ? 0 : 1;
      if (SceneT::kGravity) continue;
      const Sums now = test::sums_of(*world);
      // Of three unlike moments, the energy sways by a term of second order in the turn of a step.
      ASSERT_LE(now.kinetic, energy * (1 + 64 * kRounding) + 2e-6 * before.kinetic) << i;
      energy = now.kinetic;
    }
  }
  /// To 8 u of the summed |p| for each step and each impulse.
  void expect_momentum_kept() const {
    const Sums now = test::sums_of(*world);
    Vector gained = now.momentum - before.momentum;
    if constexpr (SceneT::kGravity) gained.z() += 9.81 * time * before.mass;
    const double each = 8 * kRounding * (before.pushes + now.pushes);
    EXPECT_LE(gained.norm(), each * static_cast<double>(1 + steps + contacts));
  }
  /// The common centre is where it would be without a contact.
  void expect_centre_on_its_way(double speed, double share) const {
    const Sums now = test::sums_of(*world);
    Vector way = now.place - before.place - time * before.momentum / before.mass;
    if constexpr (SceneT::kGravity) way.z() += 9.81 * time * time / 2;
    const double length = time * (speed + 1) + (SceneT::kGravity ? 5 * time * time : 0);
    EXPECT_LE(way.norm(), share * length);
  }
};

template <class SceneT>
void jam(double room, double speed) {
  using S = typename SceneT::Scalar;
  Flight<SceneT> flight;
  add_fork(*flight.world, room, speed);
  flight.run(1e-3, 2);
  if (::testing::Test::HasFatalFailure()) return;
  flight.expect_momentum_kept();
  flight.expect_centre_on_its_way(speed, std::is_same_v<S, float> ? 5e-5 : 1e-12);
  EXPECT_GT(flight.contacts, 0) << "or nothing is seen";
}

template <class S>
class Momentum : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(Momentum, Scalars);

TYPED_TEST(Momentum, ForkJammedRoundARod_FliesOnAtEverySpeed) {
  for (const double room : {1e-3, 3e-3}) {
    for (const double speed : {0.0, 5.0, 25.0, 100.0}) {
      SCOPED_TRACE(::testing::Message() << "room " << room << ", " << speed << " m/s");
      jam<LawScene<TypeParam, RestingContact::kNone, kForkFloats>>(room, speed);
      jam<LawScene<TypeParam, RestingContact::kSeparation, kForkFloats>>(room, speed);
      jam<LawScene<TypeParam, RestingContact::kSettling, kForkFloats>>(room, speed);
    }
  }
}

TYPED_TEST(Momentum, ForkJammedRoundARod_FallsAsIfAlone) {
  for (const double speed : {0.0, 20.0}) {
    SCOPED_TRACE(::testing::Message() << speed << " m/s");
    jam<LawScene<TypeParam, RestingContact::kNone, kForkFalls>>(1e-3, speed);
    jam<LawScene<TypeParam, RestingContact::kSeparation, kForkFalls>>(1e-3, speed);
    jam<LawScene<TypeParam, RestingContact::kSettling, kForkFalls>>(1e-3, speed);
  }
}

/// Balls in line that close at 5 ... 50 mm/s.
template <class SceneT>
void fly_in_line(double speed, double closing, double dt) {
  using S = typename SceneT::Scalar;
  Flight<SceneT> flight;
  for (int i = 0; i < 4; ++i) {
    auto ball = test::solid_ball<SceneT>(0.05, {0, 0, 0.102 * i});
    ball.restitution = S(0.5);
    test::throw_body(ball, {speed, 0, -closing * i});
    ASSERT_TRUE(flight.world->add(ball).ok());
  }
  flight.run(dt, 0.5);
  if (::testing::Test::HasFatalFailure()) return;
  flight.expect_momentum_kept();
  flight.expect_centre_on_its_way(speed, std::is_same_v<S, float> ? 5e-5 : 1e-12);
  EXPECT_GT(test::smallest_gap(*flight.world), -1e-5);
}

TYPED_TEST(Momentum, BallsInLine_GoOnAtEverySpeed) {
  using Settles = LawScene<TypeParam, RestingContact::kSettling, test::kFloating>;
  using Separates = LawScene<TypeParam, RestingContact::kSeparation, test::kFloating>;
  for (const double speed : {0.0, 25.0}) {
    for (const double closing : {5e-3, 5e-2}) {
      for (const double dt : {1e-4, 1e-3, 1.0 / 60}) {
        SCOPED_TRACE(::testing::Message() << speed << " m/s, " << closing << " m/s, " << dt);
        fly_in_line<Settles>(speed, closing, dt);
        fly_in_line<Separates>(speed, closing, dt);
      }
    }
  }
}

/// Touching rods, crosswise on each other, or balls, that fall together.
template <class SceneT>
void fall_together(bool are_balls, double noise, double dt) {
  using S = typename SceneT::Scalar;
  Flight<SceneT> flight;
  for (int i = 0; i < 12; ++i) {
    const double height = (are_balls ? 0.1 : 0.04) + 1e-4;
    const Vector place(0, 0, height * i);
    auto body = are_balls ? test::solid_ball<SceneT>(0.05, place)
                          : test::solid_rod<SceneT>(0.5, 0.02, place,
                                                    i % 2 == 0 ? test::along_x() : test::along_y());
    body.restitution = S(0.3);
    body.friction = S(0.5);
    test::throw_body(body, {0, noise * ((i * 7) % 5 - 2), noise * ((i * 3) % 7 - 3)});
    ASSERT_TRUE(flight.world->add(body).ok());
  }
  flight.run(dt, 0.4);
  if (::testing::Test::HasFatalFailure()) return;
  flight.expect_momentum_kept();
  flight.expect_centre_on_its_way(0, std::is_same_v<S, float> ? 5e-5 : 1e-12);
}

TYPED_TEST(Momentum, ClusterThatFalls_FallsAsIfItWereOne) {
  using Settles = LawScene<TypeParam, RestingContact::kSettling, test::kFalling>;
  for (const bool are_balls : {false, true}) {
    for (const double noise : {0.0, 0.005, 0.1}) {
      for (const double dt : {1e-3, 1e-2}) {
        SCOPED_TRACE(::testing::Message() << are_balls << ' ' << noise << ' ' << dt);
        fall_together<Settles>(are_balls, noise, dt);
      }
    }
  }
}

}  // namespace
}  // namespace batuta
