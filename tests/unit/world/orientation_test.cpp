// SPDX-License-Identifier: MIT
// An orientation that a caller puts in place of a body's, off unit length by more than rounding.
#include <gtest/gtest.h>

#include "batuta/world/make_actor.hpp"
#include "batuta/world/scenes.hpp"
#include "batuta/world/world.hpp"

namespace batuta {
namespace {

using Rod = Actor<TwoBlades>;

/// A ball that flies at the tip of a rod whose quaternion is `length` long. @returns the least gap
/// that the true shapes had after any step
float least_gap(float length) {
  World<TwoBlades> world;
  const Capsule<float> steel = {{{0, 0, -0.5F}, {0, 0, 0.5F}}, 0.01F};
  Pose<float> X_WA;
  X_WA.q_WB = Quat<float>(0, 1, 0, 0);
  const auto rod = world.add(make_actor<TwoBlades>(steel, 7850.0F, X_WA).value);
  Pose<float> X_WB;
  X_WB.p_W = {0, 0, 0.53F};
  const auto ball = world.add(make_actor<TwoBlades>(Capsule<float>::sphere({0, 0, 0}, 0.01F),
                                                    7850.0F, X_WB, {{0, 0, -1}, {0, 0, 0}})
                                  .value);
  world.get(rod.value)->body.X_WB.q_WB.coeffs() *= length;
  float least = 1;
  for (int i = 0; i < 200; ++i) {
    EXPECT_EQ(world.step(1e-4F), Status::kOk);
    EXPECT_TRUE(world.report().complete());
    const Rod& A = *world.get(rod.value);
    const Rod& B = *world.get(ball.value);
    Pose<float> X_W = A.body.X_WB;
    EXPECT_NEAR(X_W.q_WB.norm(), 1.0F, 16 * kRoundOff<float>);
    X_W.q_WB = renewed(X_W.q_WB);
    const auto gap = capsule_gap(to_world(X_W, A.capsule_B), to_world(B.body.X_WB, B.capsule_B));
    least = std::min(least, gap.gap);
  }
  return least;
}

TEST(Orientation, OffUnitLength_IsRenewedBeforeAnythingIsMet) {
  for (const float length : {1.0F, 1.0001F, 0.9999F, 1.0009F, 0.9991F}) {
    const float gap = least_gap(length);
    EXPECT_GT(gap, 0.0F) << length;
    EXPECT_LT(gap, 0.001F) << "they meet";
  }
}

}  // namespace
}  // namespace batuta
