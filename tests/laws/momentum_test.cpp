// SPDX-License-Identifier: MIT
// Laws 1, 2 and 3: a set of bodies that nobody holds keeps its momentum, its common centre goes
// straight on (or along the parabola) whatever its speed, and no contact adds energy. By the
// bodies' own poses and momenta, summed in double.
#include <gtest/gtest.h>

#include "closed_sets.hpp"
#include "seen_world.hpp"

namespace batuta {
namespace {

using test::LawFeatures;
using test::LawScene;
using test::Sums;
using test::Vector;

constexpr LawFeatures kForkFloats = test::kCompound;
constexpr LawFeatures kForkFalls = test::kFallingCompound;

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
  double overlap = 0;  ///< after the last step, m
  double deepest = 0;  ///< after any step, m

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
      see_overlap();
      if (::testing::Test::HasFatalFailure()) return;
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
  /// What the search cannot tell from contact (margin.md), of bodies that are 2 m long together.
  double margin() const {
    const double speed = before.momentum.norm() / before.mass;
    const double far = time * speed + 1 + (SceneT::kGravity ? 5 * time * time : 0);
    return 2 * (1e-6 + 72 * kRounding) * 2 + 2 * 64 * kRounding * far;
  }
  /// What the step told is as deep as it was at its start, or between that and what it is now.
  void see_overlap() {
    const double was = overlap;
    overlap = static_cast<double>(test::true_overlap(std::as_const(*world)));
    deepest = max_of(deepest, overlap);
    const double told = static_cast<double>(world->report().deepest_overlap);
    ASSERT_GE(told, was - margin());
    ASSERT_LE(told, max_of(was, overlap) + margin());
  }
  /// Nobody is deeper in another than the margin. Under kNone nothing is opened, and who goes side
  /// by side may creep by one rounding of each place and step.
  void expect_nobody_inside() const {
    constexpr bool kOpens = SceneT::kResting != RestingContact::kNone;
    const double place = margin() / 64;
    EXPECT_LE(deepest, margin() + (kOpens ? 0 : place * static_cast<double>(steps)));
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
  test::add_fork(*flight.world, room, speed);
  flight.run(1e-3, 2);
  if (::testing::Test::HasFatalFailure()) return;
  flight.expect_momentum_kept();
  flight.expect_nobody_inside();
  flight.expect_centre_on_its_way(speed, std::is_same_v<S, float> ? 5e-5 : 1e-12);
  EXPECT_GT(flight.contacts, 0) << "or nothing is seen";
}

template <class S>
class Momentum : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(Momentum, Scalars);

// From no more than a tenth of D, 10 um, to so much that it rattles.
TYPED_TEST(Momentum, ForkJammedRoundARod_FliesOnAtEverySpeed) {
  for (const double room : {1e-5, 5e-5, 1e-4, 1e-3, 3e-3, 1e-2}) {
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
  flight.expect_nobody_inside();
  flight.expect_centre_on_its_way(speed, std::is_same_v<S, float> ? 5e-5 : 1e-12);
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
void fall_together(bool are_balls, double noise, double speed, double dt) {
  using S = typename SceneT::Scalar;
  Flight<SceneT> flight;
  test::add_cluster(*flight.world, are_balls, noise, speed);
  flight.run(dt, 0.4);
  if (::testing::Test::HasFatalFailure()) return;
  flight.expect_momentum_kept();
  flight.expect_nobody_inside();
  flight.expect_centre_on_its_way(speed, std::is_same_v<S, float> ? 5e-5 : 1e-12);
}

TYPED_TEST(Momentum, ClusterThatFalls_FallsAsIfItWereOneAtEverySpeed) {
  using Settles = LawScene<TypeParam, RestingContact::kSettling, test::kFalling>;
  using Separates = LawScene<TypeParam, RestingContact::kSeparation, test::kFalling>;
  using Strikes = LawScene<TypeParam, RestingContact::kNone, test::kFalling>;
  for (const bool are_balls : {false, true}) {
    for (const double noise : {0.0, 0.005, 0.1}) {
      for (const double speed : {0.0, 25.0}) {
        for (const double dt : {1e-3, 1e-2}) {
          SCOPED_TRACE(::testing::Message()
                       << are_balls << ' ' << noise << ' ' << speed << ' ' << dt);
          fall_together<Settles>(are_balls, noise, speed, dt);
          fall_together<Separates>(are_balls, noise, speed, dt);
          fall_together<Strikes>(are_balls, noise, speed, dt);
        }
      }
    }
  }
}

}  // namespace
}  // namespace batuta
