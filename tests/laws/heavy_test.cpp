// SPDX-License-Identifier: MIT
// Law 5: the heavy rests on the light. What a sweep over contacts hands on from one to the other is
// the share of the light one in the mass of both, so sweeps alone would need as many as the ratio.
//
// Truth: a ball on a ball on a floor, one above the other, stands: nobody moves, and nobody is
// struck any more.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "law_worlds.hpp"

namespace batuta {
namespace {

using test::Settling;
using test::Vector;

template <class S>
class Heavy : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(Heavy, Scalars);

constexpr double kRadius = 0.1;  // m
constexpr double kG = 9.81;
constexpr double kSeconds = 4;

/// What became of the upper ball in the second half of the time.
struct Rested {
  double lowest = 1;    ///< m, of its place less where it was laid
  double highest = -1;  ///< m
  long struck = 0;      ///< contacts that were answered
  long incomplete = 0;  ///< steps, of all
};

template <class SceneT>
Rested rest(double ratio, double dt) {
  using S = typename SceneT::Scalar;
  auto world = std::make_unique<World<SceneT>>();
  const auto add = [&world](Actor<SceneT> actor) {
    actor.friction = S(0.5);
    return world->add(actor).value;
  };
  add(test::fixed_rod<SceneT>(4, 0.5, {0, 0, -0.5}, test::along_y()));
  add(test::solid_ball<SceneT>(kRadius, {0, 0, kRadius + 1e-4}));
  const Vector place(0, 0, 3 * kRadius + 2e-4);
  const auto heavy = add(test::solid_rod<SceneT>(0, kRadius, place, {1, 0, 0, 0}, 1000 * ratio));
  Rested rested;
  const int steps = static_cast<int>(kSeconds / dt);
  for (int i = 0; i < steps; ++i) {
    EXPECT_EQ(world->step(static_cast<S>(dt)), Status::kOk);
    if (!world->report().complete()) ++rested.incomplete;
    if (i < steps / 2) continue;
    rested.struck += world->report().collisions;
    const double z = static_cast<double>(world->get(heavy)->body.X_WB.p_W.z()) - place.z();
    rested.lowest = std::min(rested.lowest, z);
    rested.highest = std::max(rested.highest, z);
  }
  return rested;
}

TYPED_TEST(Heavy, BallOnALightBall_RestsAndIsStruckNoMore) {
  for (const double ratio : {10.0, 100.0, 1e3, 1e4}) {
    for (const double dt : {1e-3, 1.0 / 60}) {
      SCOPED_TRACE(::testing::Message() << "1 : " << ratio << ", " << dt << " s");
      const Rested rested = rest<Settling<TypeParam, test::kFalling>>(ratio, dt);
      const double D = std::max(1e-4, kG * dt * dt / 4);
      EXPECT_EQ(rested.struck, 0);
      EXPECT_EQ(rested.incomplete, 0);
      EXPECT_LT(rested.highest - rested.lowest, D);
      EXPECT_GT(rested.lowest, -2 * D);  // two gaps, each of D at most
      EXPECT_LT(rested.highest, 2 * D);
    }
  }
}

}  // namespace
}  // namespace batuta
