// SPDX-License-Identifier: MIT
// Laws 1 and 2: what happens among bodies that nobody holds does not depend on how fast all of them
// fly, and leaves their angular momentum about the common centre. Truth: the same set at rest, and
// the sum at the start.
#include <gtest/gtest.h>

#include "law_worlds.hpp"

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

/// Until the third contact: contacts amplify rounding.
template <class SceneT>
void fly_beside(bool are_balls, double dt) {
  using S = typename SceneT::Scalar;
  const double share = std::is_same_v<S, float> ? 1e-5 : 1e-10;
  const auto rests = closing_set<SceneT>(are_balls, 0);
  const auto flies = closing_set<SceneT>(are_balls, kSpeed);
  long contacts = 0;
  const int count = static_cast<int>(std::lround(0.5 / dt));
  for (int i = 0; i < count && contacts < 3; ++i) {
    ASSERT_EQ(rests->step(static_cast<S>(dt)), Status::kOk);
    ASSERT_EQ(flies->step(static_cast<S>(dt)), Status::kOk);
    contacts += max_of(rests->report().collisions, flies->report().collisions);
    for (std::uint16_t k = 1; k < 4; ++k) {
      const Vector at_rest =
          place_of(std::as_const(*rests), k) - place_of(std::as_const(*rests), 0);
      const Vector flying = place_of(std::as_const(*flies), k) - place_of(std::as_const(*flies), 0);
      ASSERT_LE((flying - at_rest).norm(), share * kSpeed * dt * (i + 1)) << k << ", step " << i;
    }
  }
  EXPECT_GE(contacts, 1) << "or nothing is seen";
}

TYPED_TEST(Frame, SetsThatFly_DoWhatTheyDoAtRest) {
  for (const bool are_balls : {true, false}) {
    for (const double dt : {1e-3, 1e-2, 1.0 / 60}) {
      SCOPED_TRACE(::testing::Message() << are_balls << ' ' << dt);
      fly_beside<LawScene<TypeParam, RestingContact::kSettling, test::kFloating>>(are_balls, dt);
      fly_beside<LawScene<TypeParam, RestingContact::kSeparation, test::kFloating>>(are_balls, dt);
      fly_beside<LawScene<TypeParam, RestingContact::kNone, test::kFloating>>(are_balls, dt);
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
