// SPDX-License-Identifier: MIT
// How a group turns that goes on together (src/world/detail/group_motion.cpp).
#include "batuta/world/detail/group_motion.hpp"

#include <gtest/gtest.h>

namespace batuta {
namespace {

template <class S>
class GroupMotion : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(GroupMotion, Scalars);

/// With 4 u of the trace added along the diagonal it is solved twice, the second time for what the
/// first has left. Of the turn about an axis with the share r of the trace, each leaves
/// 4 u / (r + 4 u).
TYPED_TEST(GroupMotion, ThinnerThanRounding_TurnsAsSolvedTwice) {
  using S = TypeParam;
  const double added = 4 * static_cast<double>(kRoundOff<S>);
  for (const double times : {1.0, 3.0, 7.0}) {
    const double thin = 2 * times * added;  // of a trace of 2
    detail::RigidGroup<S> group;
    group.mass = 1;
    group.inertia_W = {Vec3<S>::UnitX(), Vec3<S>::UnitY(), static_cast<S>(thin) * Vec3<S>::UnitZ()};
    const Vec3<S> L(S(2), S(3), static_cast<S>(thin));
    const Vec3<S> w = detail::group_twist(group, L).w_W;
    const double left = 1 / (1 + times);
    EXPECT_NEAR(static_cast<double>(w.z()), 1 - left * left, 1e-4) << times;
    EXPECT_NEAR(static_cast<double>(w.x()), 2, 8 * added);
    EXPECT_NEAR(static_cast<double>(w.y()), 3, 12 * added);
  }
}

}  // namespace
}  // namespace batuta
