// SPDX-License-Identifier: MIT
// Who has been quiet for nearly long enough to sleep, and is then set moving, goes on; who is
// changed is noticed, who only has a momentum is not (src/world/world.md, "Sleep"). Pencil and
// paper.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "scenes.hpp"

namespace batuta {
namespace {

using test::vec;

constexpr SceneOptions quiet_options() {
  SceneOptions scene = test::flight_scene_options();
  scene.max_contacts = 64;
  scene.gravity = scene.sleep = scene.friction = true;
  scene.resting = RestingContact::kSettling;
  return scene;
}

constexpr double kStep = 1e-3;
constexpr int kUntilAsleep = 248;  // steps after which it is still awake, of 250
constexpr double kRadius = 0.05;   // of rails and balls
constexpr double kNear = 5e-5;     // gap to the rail, m: within D
constexpr double kHeight = 2 * kRadius + kNear;

template <class S>
struct QuietRig {
  using SceneT = Scene<quiet_options, Advancement<S>, test::AnyFlight<S>>;
  using Id = typename World<SceneT>::BodyId;

  /// Led, along x or along y, through the origin of its body.
  static Actor<SceneT> rail(double x, bool along_x) {
    Actor<SceneT> actor;
    actor.controller = Fixed<S>{};
    const Vec3<S> half = along_x ? vec<S>(4, 0, 0) : vec<S>(0, 4, 0);
    actor.capsule_B = {{-half, half}, S(kRadius)};
    actor.body.X_WB.p_W = vec<S>(x, 0, 0);
    return actor;
  }
  /// Of 1 kg, on a rail. @param v  along it, m/s
  static Actor<SceneT> ball(double x, double v, double restitution) {
    auto actor = test::ball<SceneT>(x, kRadius, v);
    actor.body.X_WB.p_W.z() = S(kHeight);
    actor.restitution = S(restitution);
    return actor;
  }
  Id add(const Actor<SceneT>& actor) { return world().add(actor).value; }
  World<SceneT>& world() { return *world_; }
  bool is_asleep(Id id) const { return world_->is_asleep(id); }
  void steps(int count) {
    for (int i = 0; i < count; ++i) {
      ASSERT_EQ(world().step(S(kStep)), Status::kOk);
      ASSERT_TRUE(world().report().complete()) << i;
    }
  }
  /// Read alone: nothing of it is looked at again.
  const Body<S>& body(Id id) const { return std::as_const(*world_).get(id)->body; }
  double x(Id id) const { return static_cast<double>(body(id).X_WB.p_W.x()); }
  double z(Id id) const { return static_cast<double>(body(id).X_WB.p_W.z()); }
  double speed(Id id) const { return static_cast<double>(body(id).momentum.linear_W.x()); }
  void set_gravity(double gx, double gz) {
    auto settings = world().settings();
    settings.gravity_W = vec<S>(gx, 0, gz);
    ASSERT_EQ(world().configure(settings), Status::kOk);
  }

  std::unique_ptr<World<SceneT>> world_ = std::make_unique<World<SceneT>>();
};

template <class S>
class Quiet : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(Quiet, Scalars);

// The ball between spins on the spot, and keeps the last one awake, which has long been quiet. C =
// 1: the last one leaves with what the first one came with.
TYPED_TEST(Quiet, WhoIsStruckThroughANeighbour_GoesOn) {
  using S = TypeParam;
  constexpr double kAfter = 0.2;
  for (const double V : {0.3, 1.0}) {
    for (const double wait : {0.3, 0.77}) {
      QuietRig<S> rig;
      rig.add(rig.rail(0, true));
      const auto last = rig.add(rig.ball(0, 0, 1));
      auto between = rig.ball(-kHeight, 0, 1);
      between.body.momentum.angular_W.z() = S(1) / between.body.inverse_moments.z();  // 1 rad/s
      rig.add(between);
      rig.add(rig.ball(-2 * kHeight - V * wait, V, 1));
      rig.steps(static_cast<int>((wait + kAfter) / kStep));
      EXPECT_FALSE(rig.is_asleep(last));
      EXPECT_NEAR(rig.speed(last), V, 1e-3 * V);
      EXPECT_NEAR(rig.x(last), V * kAfter, 0.01 * V * kAfter) << V << " m/s after " << wait << " s";
    }
  }
}

// 45 degrees without friction, from the step on: g t^2 / 2 sqrt(1/2).
TYPED_TEST(Quiet, AnotherGravity_SetsItMoving) {
  using S = TypeParam;
  constexpr double kG = 6.94;
  QuietRig<S> rig;
  rig.add(rig.rail(0, true));
  const auto lying = rig.add(rig.ball(0, 0, 0));
  rig.steps(kUntilAsleep);
  ASSERT_FALSE(rig.is_asleep(lying));
  rig.set_gravity(kG, -kG);
  rig.steps(500);
  EXPECT_NEAR(rig.x(lying), kG / 8, 0.01 * kG / 8);
}

// On its two rails it has lain for nearly long enough; then it tips over the one that is left.
TYPED_TEST(Quiet, SupportThatIsRemoved_SetsItMoving) {
  using S = TypeParam;
  QuietRig<S> rig;
  const auto gone = rig.add(rig.rail(-0.2, false));
  rig.add(rig.rail(0.2, false));
  auto rod = test::rod<typename QuietRig<S>::SceneT>(0, 0.4, kRadius);
  const S half = S(std::sqrt(0.5));
  rod.body.X_WB = {vec<S>(0, 0, kHeight), Quat<S>(half, 0, half, 0)};
  const auto lying = rig.add(rod);
  rig.steps(kUntilAsleep);
  ASSERT_FALSE(rig.is_asleep(lying));
  ASSERT_EQ(rig.world().remove(gone), Status::kOk);
  rig.steps(300);
  EXPECT_FALSE(rig.is_asleep(lying));
  EXPECT_LT(rig.z(lying), kHeight - 0.03);
}

// A slope of 30 degrees that held it by friction: g t^2 / 4.
TYPED_TEST(Quiet, FrictionThatIsTaken_SetsItMoving) {
  using S = TypeParam;
  constexpr double kG = 9.81;
  for (const int before : {kUntilAsleep, kUntilAsleep - 20}) {
    QuietRig<S> rig;
    rig.set_gravity(kG / 2, -kG * std::sqrt(0.75));
    auto rail = rig.rail(0, true);
    rail.body.X_WB.p_W.y() = S(-0.06);
    rail.friction = 2;
    const auto left = rig.add(rail);
    rail.body.X_WB.p_W.y() = S(0.06);
    const auto right = rig.add(rail);
    auto rod = test::rod<typename QuietRig<S>::SceneT>(0, 0.2, kRadius);
    const S half = S(std::sqrt(0.5));
    rod.body.X_WB = {vec<S>(0, 0, 0.08 + kNear), Quat<S>(half, 0, half, 0)};
    rod.friction = 2;
    const auto lying = rig.add(rod);
    rig.steps(before);
    ASSERT_FALSE(rig.is_asleep(lying));
    const double start = rig.x(lying);
    rig.world().get(left)->friction = rig.world().get(right)->friction = 0;
    rig.steps(300);
    EXPECT_NEAR(rig.x(lying) - start, kG * 0.09 / 4, 0.02 * kG * 0.09 / 4) << before;
  }
}

TYPED_TEST(Quiet, WhoIsPushedByTheCaller_GoesOn) {
  using S = TypeParam;
  QuietRig<S> rig;
  rig.add(rig.rail(0, true));
  const auto lying = rig.add(rig.ball(0, 0, 0));
  rig.steps(kUntilAsleep);
  ASSERT_FALSE(rig.is_asleep(lying));
  for (const double v : {0.05, 1.0}) {
    rig.world().get(lying)->body.momentum.linear_W.x() = S(v);
    rig.steps(10);
    EXPECT_NEAR(rig.speed(lying), v, 1e-3 * v);
  }
}

// Signs alone: its axis is mirrored, and what slept on it falls.
TYPED_TEST(Quiet, SupportThatIsMirrored_WakesWhoLiesOnIt) {
  using S = TypeParam;
  for (const bool is_height : {true, false}) {
    QuietRig<S> rig;
    auto rail = rig.rail(0, true);
    rail.capsule_B.axis = is_height ? Segment<S>{vec<S>(-0.5, 0, 0.1), vec<S>(0.5, 0, 0.1)}
                                    : Segment<S>{vec<S>(0.1, 0, 0), vec<S>(0.5, 0, 0)};
    const auto support = rig.add(rail);
    auto actor = rig.ball(0.3, 0, 0);
    if (is_height) actor.body.X_WB.p_W.z() += S(0.1);
    const auto lying = rig.add(actor);
    rig.steps(400);
    ASSERT_TRUE(rig.is_asleep(lying));
    const double before = rig.z(lying);
    auto& axis = rig.world().get(support)->capsule_B.axis;
    const int flipped = is_height ? 2 : 0;
    axis.a[flipped] = -axis.a[flipped];
    axis.b[flipped] = -axis.b[flipped];
    rig.steps(150);
    EXPECT_NEAR(before - rig.z(lying), 9.81 * 0.0225 / 2, 1e-3) << is_height;
  }
}

// What a blow has left to a rail that is led moves nothing: who lies on it sleeps on.
TYPED_TEST(Quiet, MomentumOfWhoIsLed_WakesNobody) {
  using S = TypeParam;
  QuietRig<S> rig;
  const auto support = rig.add(rig.rail(0, true));
  const auto lying = rig.add(rig.ball(0, 0, 0));
  rig.steps(400);
  ASSERT_TRUE(rig.is_asleep(lying));
  rig.world().get(support)->body.momentum.linear_W = vec<S>(0, 0, 1);
  for (int i = 0; i < 10; ++i) {
    rig.steps(1);
    EXPECT_TRUE(rig.is_asleep(lying)) << i;
  }
}

// Of all words that may change in a shape, no two signs cancel.
TEST(BitSum, TwoSigns_AreNoneTheSame) {
  constexpr int kWords = 12;
  const auto sum_of_signs = [](int a, int b) {
    detail::BitSum sum;
    for (int i = 0; i < kWords; ++i) sum.add_number(i == a || i == b ? -1.0F : 1.0F);
    return sum.value();
  };
  const auto before = sum_of_signs(-1, -1);
  for (int a = 0; a < kWords; ++a) {
    for (int b = a; b < kWords; ++b) EXPECT_NE(sum_of_signs(a, b), before) << a << ", " << b;
  }
}

}  // namespace
}  // namespace batuta
