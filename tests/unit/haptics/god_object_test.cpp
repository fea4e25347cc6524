// SPDX-License-Identifier: MIT
// The held body is the god object: a hand that goes through a wire pulls a rod as thin as a hair
// against it, and the rod stays on its side, whatever the hand's speed and the coupling's strength.

#include <gtest/gtest.h>

#include "batuta/haptics/coupling.hpp"
#include "batuta/world/scenes.hpp"
#include "batuta/world/world.hpp"

namespace batuta {
using namespace haptics;
namespace {

template <class S>
using WireScene = Scene<two_blades, Advancement<S>>;

/// A wire along y at z = 0, and a rod along x above it that a hand holds.
template <class S>
class GodObject : public ::testing::Test {
 protected:
  using WorldType = World<WireScene<S>>;
  static constexpr S kStep = S(1e-3);
  static constexpr S kRadius = S(5e-5);
  WorldType world;
  typename WorldType::BodyId rod;
  CouplingSettings<S> settings;

  void SetUp() override {
    Actor<WireScene<S>> wire;
    const S infinite = std::numeric_limits<S>::infinity();
    wire.body = make_body<S>({}, infinite, Vec3<S>(infinite, infinite, infinite)).value;
    wire.capsule_B = {{Vec3<S>(0, S(-0.5), 0), Vec3<S>(0, S(0.5), 0)}, kRadius};
    ASSERT_TRUE(world.add(wire).ok());
    Actor<WireScene<S>> held;
    const Vec3<S> moments(S(1e-5), S(1e-3), S(1e-3));
    held.body = make_body<S>({Vec3<S>(0, 0, S(0.05)), Quat<S>::Identity()}, S(0.1), moments).value;
    held.capsule_B = {{Vec3<S>(S(-0.3), 0, 0), Vec3<S>(S(0.3), 0, 0)}, kRadius};
    const auto added = world.add(held);
    ASSERT_TRUE(added.ok());
    rod = added.value;
  }

  S height() { return world.get(rod)->body.X_WB.p_W.z(); }

  /// A step with the hand at height z, moving at `rate`. @returns what the hand feels upwards, N
  S step(S z, S rate) {
    MovingFrame<S> hand;
    hand.X_W.p_W.z() = z;
    hand.twist.v_W.z() = rate;
    const auto felt = couple(settings, hand, world.get(rod)->body, kStep);
    EXPECT_TRUE(felt.ok());
    EXPECT_EQ(world.step(kStep), Status::kOk);
    return felt.value.force_W.z();
  }
};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(GodObject, Scalars);

TYPED_TEST(GodObject, HandGoesThroughTheWire_RodStaysAboveAndPullsBack) {
  using S = TypeParam;
  for (const S speed : {S(0.5), S(20), S(500)}) {
    S z = S(0.05);
    S felt = 0;
    for (int i = 0; i < 400; ++i) {
      const bool moves = z > S(-0.05);
      if (moves) z = std::max(S(-0.05), z - speed * this->kStep);
      felt = this->step(z, moves ? -speed : S(0));
      ASSERT_GT(this->height(), 2 * this->kRadius) << speed << " m/s, step " << i;
    }
    // 400 N/m, 50 mm; the rod hops on the wire as it comes to rest.
    EXPECT_NEAR(static_cast<double>(felt), 20, 4) << speed << " m/s";
    for (int i = 0; i < 400; ++i) (void)this->step(S(0.05), 0);  // and back
    EXPECT_NEAR(static_cast<double>(this->height()), 0.05, 5e-3) << speed << " m/s";
  }
}

TYPED_TEST(GodObject, CouplingAsStiffAsCanBe_StillDoesNotPushThrough) {
  using S = TypeParam;
  this->settings.stiffness = S(1e7);
  this->settings.max_force = S(1e6);
  for (int i = 0; i < 200; ++i) {
    (void)this->step(S(-0.1), 0);
    ASSERT_GT(this->height(), 2 * this->kRadius) << i;
  }
}

}  // namespace
}  // namespace batuta
