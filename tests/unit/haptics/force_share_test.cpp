// SPDX-License-Identifier: MIT
#include "batuta/haptics/force_share.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

namespace batuta {
using namespace haptics;
namespace {

TEST(ForceShare, Scaled_HasAGainForEachAxis) {
  EXPECT_EQ(scaled({50, -25}, {0.01F, 0.04F}), Vec2<float>(0.5F, -1));
}

TEST(ForceShare, WithinTheRange_IsLeftAlone) {
  for (const Vec2<float>& share : {Vec2<float>(0.5F, -0.25F), Vec2<float>(1, -1)}) {
    const ForceShare force = clipped(share);
    EXPECT_EQ(force.share, share);
    EXPECT_EQ(force.excess, 0.0F);
    EXPECT_FALSE(force.is_clipped());
  }
}

TEST(ForceShare, BeyondTheRange_KeepsItsDirection_AndSaysByHowMuch) {
  const ForceShare force = clipped({-4, 1});
  EXPECT_EQ(force.share, Vec2<float>(-1, 0.25F));
  EXPECT_EQ(force.excess, 3.0F);
  EXPECT_TRUE(force.is_clipped());
  EXPECT_TRUE(clipped({0, std::nextafter(1.0F, 2.0F)}).is_clipped());
}

RC_GTEST_PROP(ForceShare, Clipped_IsInTheSquareAndPointsTheSameWay, ()) {
  const auto coordinate = [] {
    return std::ldexp(static_cast<float>(*rc::gen::inRange(-1000, 1001)),
                      *rc::gen::inRange(-140, 118));
  };
  const Vec2<float> demand(coordinate(), coordinate());
  const ForceShare force = clipped(demand);
  RC_ASSERT(std::abs(force.share.x()) <= 1 && std::abs(force.share.y()) <= 1);
  RC_ASSERT(!force.is_clipped() || force.share.cwiseAbs().maxCoeff() == 1);
  const Vec2<double> before = demand.cast<double>();
  const Vec2<double> after = force.share.cast<double>();
  const double cross = before.x() * after.y() - before.y() * after.x();
  const double denormal = before.norm() * std::numeric_limits<float>::denorm_min();
  RC_ASSERT(std::abs(cross) <= 1.2e-7 * before.norm() * after.norm() + denormal);
  RC_ASSERT(before.dot(after) >= 0);
}

}  // namespace
}  // namespace batuta
