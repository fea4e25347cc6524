// SPDX-License-Identifier: MIT
// Laws 1 and 2: what happens among bodies that nobody holds does not depend on how fast all of them
// fly, and leaves their angular momentum about the common centre. Truth: the same set at rest, and
// the sum at the start.
#include <gtest/gtest.h>

#include "closed_sets.hpp"

namespace batuta {
namespace {

using test::LawScene;
using test::Sums;
using test::Vector;

constexpr double kSpeed = 25;

template <class S>
class Frame : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(Frame, Scalars);

/// Balls in line that close at 20 mm/s each, or crossed rods that do, and turn.
template <class SceneT>
std::unique_ptr<World<SceneT>> closing_set(bool are_balls, double speed) {
  using S = typename SceneT::Scalar;
  auto world = std::make_unique<World<SceneT>>();
  for (int i = 0; i < 4; ++i) {
    const Vector place(0, 0.001 * i, (are_balls ? 0.102 : 0.042) * i);
    auto body = are_balls ? test::solid_ball<SceneT>(0.05, place)
                          : test::solid_rod<SceneT>(0.5, 0.02, place,
                                                    i % 2 == 0 ? test::along_x() : test::along_y());
    body.restitution = S(0.5);
    if constexpr (SceneT::kFriction) body.friction = S(0.3);
    test::throw_body(body, {speed, 0, -0.02 * i}, are_balls ? Vector::Zero() : Vector(0, 0, 0.1));
    EXPECT_TRUE(world->add(body).ok());
  }
  return world;
}

template <class SceneT>
Vector place_of(const World<SceneT>& world, std::uint16_t slot) {
  return world.get(world.id_at(slot))->body.X_WB.p_W.template cast<double>();
}

template <class T>
struct Is {
  using Type = T;
};

/// A set and what it has answered.
template <class SceneT>
struct Flock {
  std::unique_ptr<World<SceneT>> world;
  long contacts = 0;  ///< blows and separations
  long seen = 0;      ///< these, and contacts that lasted

  void step(double dt) {
    ASSERT_EQ(world->step(static_cast<typename SceneT::Scalar>(dt)), Status::kOk);
    const auto& report = world->report();
    contacts += report.collisions + report.separations;
    seen = max_of(seen, contacts + world->events().size());
  }
  /// From the first body to another one.
  Vector way_to(std::uint16_t slot) const {
    return place_of(std::as_const(*world), slot) - place_of(std::as_const(*world), 0);
  }
};

/// The same set, made by make(speed), at rest and flying along x. Compared until its third blow or
/// separation: each amplifies what rounding has made of the one before.
template <class SceneT, class Make>
void fly_beside(const Make& make, double dt) {
  const double share = std::is_same_v<typename SceneT::Scalar, float> ? 1e-5 : 1e-10;
  Flock<SceneT> rests{make(0)};
  Flock<SceneT> flies{make(kSpeed)};
  const int count = static_cast<int>(std::lround(0.5 / dt));
  for (int i = 0; i < count; ++i) {
    rests.step(dt);
    flies.step(dt);
    if (max_of(rests.contacts, flies.contacts) >= 3) break;
    for (std::uint16_t k = 1; k < rests.world->size(); ++k) {
      const Vector off = flies.way_to(k) - rests.way_to(k);
      ASSERT_LE(off.norm(), share * kSpeed * dt * (i + 1)) << k << ", step " << i;
    }
  }
  EXPECT_GE(min_of(rests.seen, flies.seen), 1) << "or nothing is seen";
}

TYPED_TEST(Frame, SetsThatFly_DoWhatTheyDoAtRest) {
  const auto compare = [](auto scene, bool are_balls, double dt) {
    using SceneT = typename decltype(scene)::Type;
    fly_beside<SceneT>([&](double speed) { return closing_set<SceneT>(are_balls, speed); }, dt);
  };
  for (const bool are_balls : {true, false}) {
    for (const double dt : {1e-3, 1e-2, 1.0 / 60}) {
      SCOPED_TRACE(::testing::Message() << are_balls << ' ' << dt);
      compare(Is<LawScene<TypeParam, RestingContact::kSettling, test::kFloating>>{}, are_balls, dt);
      compare(Is<LawScene<TypeParam, RestingContact::kSeparation, test::kFloating>>{}, are_balls,
              dt);
      compare(Is<LawScene<TypeParam, RestingContact::kNone, test::kFloating>>{}, are_balls, dt);
    }
  }
}

TYPED_TEST(Frame, JammedForkThatFlies_DoesWhatItDoesAtRest) {
  const auto compare = [](auto scene, double room, double dt) {
    using SceneT = typename decltype(scene)::Type;
    const auto make = [room](double speed) {
      auto world = std::make_unique<World<SceneT>>();
      test::add_fork(*world, room, speed);
      return world;
    };
    fly_beside<SceneT>(make, dt);
  };
  for (const double room : {1e-3, 3e-3, 1e-2}) {
    for (const double dt : {1e-3, 1e-2, 1.0 / 60}) {
      SCOPED_TRACE(::testing::Message() << room << ' ' << dt);
      compare(Is<LawScene<TypeParam, RestingContact::kSettling, test::kCompound>>{}, room, dt);
      compare(Is<LawScene<TypeParam, RestingContact::kSeparation, test::kCompound>>{}, room, dt);
      compare(Is<LawScene<TypeParam, RestingContact::kNone, test::kCompound>>{}, room, dt);
    }
  }
}

TYPED_TEST(Frame, ClusterThatFliesAndFalls_DoesWhatItDoesAtRest) {
  const auto compare = [](auto scene, bool are_balls, double noise, double dt) {
    using SceneT = typename decltype(scene)::Type;
    const auto make = [&](double speed) {
      auto world = std::make_unique<World<SceneT>>();
      test::add_cluster(*world, are_balls, noise, speed);
      return world;
    };
    fly_beside<SceneT>(make, dt);
  };
  for (const bool are_balls : {true, false}) {
    for (const double noise : {5e-3, 0.1}) {
      for (const double dt : {1e-3, 1e-2}) {
        SCOPED_TRACE(::testing::Message() << are_balls << ' ' << noise << ' ' << dt);
        compare(Is<LawScene<TypeParam, RestingContact::kSettling, test::kFalling>>{}, are_balls,
                noise, dt);
        compare(Is<LawScene<TypeParam, RestingContact::kSeparation, test::kFalling>>{}, are_balls,
                noise, dt);
        compare(Is<LawScene<TypeParam, RestingContact::kNone, test::kFalling>>{}, are_balls, noise,
                dt);
      }
    }
  }
}

/// Angular momentum about the common centre.
Vector own_spin(const Sums& sums) {
  return sums.spin - sums.place.cross(sums.momentum);
}

template <class SceneT>
void keep_spin(bool are_balls, double speed, double dt) {
  using S = typename SceneT::Scalar;
  const auto world = closing_set<SceneT>(are_balls, speed);
  const Sums before = test::sums_of(std::as_const(*world));
  double spread = before.spread;
  const int count = static_cast<int>(std::lround(1 / dt));
  for (int i = 0; i < count; ++i) {
    ASSERT_EQ(world->step(static_cast<S>(dt)), Status::kOk);
    const Sums now = test::sums_of(std::as_const(*world));
    spread = max_of(spread, now.spread);
    ASSERT_LE((own_spin(now) - own_spin(before)).norm(), 1e-5 * spread) << i;
  }
}

TYPED_TEST(Frame, ClosedSet_KeepsItsAngularMomentum) {
  for (const bool are_balls : {true, false}) {
    for (const double speed : {0.0, kSpeed}) {
      for (const double dt : {1e-3, 1.0 / 60}) {
        SCOPED_TRACE(::testing::Message() << are_balls << ' ' << speed << ' ' << dt);
        keep_spin<LawScene<TypeParam, RestingContact::kSettling, test::kFloating>>(are_balls, speed,
                                                                                   dt);
        keep_spin<LawScene<TypeParam, RestingContact::kSeparation, test::kFloating>>(are_balls,
                                                                                     speed, dt);
        keep_spin<LawScene<TypeParam, RestingContact::kNone, test::kFloating>>(are_balls, speed,
                                                                               dt);
      }
    }
  }
}

}  // namespace
}  // namespace batuta
