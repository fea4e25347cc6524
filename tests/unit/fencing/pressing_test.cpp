// SPDX-License-Identifier: MIT
// Two hands that want their blades in the same place.

#include <gtest/gtest.h>

#include "batuta/fencing/grip.hpp"
#include "batuta/world/scenes.hpp"
#include "batuta/world/world.hpp"

namespace batuta {
using namespace fencing;
namespace {

template <class S>
using PressingScene = Scene<two_blades, Advancement<S>, Grip<S>>;

template <class S>
class Pressing : public ::testing::Test {
 protected:
  using SceneT = PressingScene<S>;
  static constexpr int kSteps = 3000;

  World<SceneT> world;
  GripSettings<S> settings;

  void SetUp() override { settings.force = S(4); }

  typename World<SceneT>::BodyId add(S x) {
    Actor<SceneT> blade;
    const Vec3<S> moments(S(0.02), S(0.02), S(1e-4));
    blade.body = make_body<S>(pose(x), S(0.5), moments).value;
    blade.capsule_B = {{Vec3<S>(0, 0, S(-0.4)), Vec3<S>(0, 0, S(0.4))}, S(0.005)};
    blade.restitution = S(0.6);
    blade.controller.place(pose(x));
    EXPECT_EQ(blade.controller.configure(settings), Status::kOk);
    return world.add(blade).value;
  }
  static Pose<S> pose(S x) { return {Vec3<S>(x, 0, 0), Quat<S>::Identity()}; }
};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(Pressing, Scalars);

// Each hand wants to be 0.1 m beyond the other one.
TYPED_TEST(Pressing, PushesWithAboutTheHandsStrengthAndNeverOverlaps) {
  using S = TypeParam;
  const auto A = this->add(S(-0.05));
  const auto B = this->add(S(0.05));
  double impulses = 0;
  for (int k = 0; k < this->kSteps; ++k) {
    this->world.get(A)->controller.command(this->pose(S(0.05)), S(1e-3));
    this->world.get(B)->controller.command(this->pose(S(-0.05)), S(1e-3));
    ASSERT_EQ(this->world.step(S(1e-3)), Status::kOk);
    ASSERT_TRUE(this->world.report().complete()) << "step " << k;
    if (k >= 1000) {  // after the first blow
      for (const auto& event : this->world.events()) impulses += static_cast<double>(event.impulse);
    }
    const S gap = this->world.get(B)->body.X_WB.p_W.x() - this->world.get(A)->body.X_WB.p_W.x();
    ASSERT_GT(gap, S(0.01) - S(1e-6)) << "step " << k;
  }
  const double seconds = (this->kSteps - 1000) * 1e-3;
  // The mean force of the blows; that a step is as long as a bounce makes it a little more than the
  // hand's.
  const double strength = static_cast<double>(this->settings.force);
  EXPECT_GT(impulses / seconds, 0.5 * strength);
  EXPECT_LT(impulses / seconds, 1.5 * strength);
}

}  // namespace
}  // namespace batuta
