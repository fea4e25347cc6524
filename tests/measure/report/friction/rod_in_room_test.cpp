// SPDX-License-Identifier: MIT
#include "rod_in_room.hpp"

#include <gtest/gtest.h>

namespace batuta::report {
namespace {

constexpr int kContacts = 300;

TEST(RodInRoom, ElasticWithoutFriction_KeepsItsEnergy) {
  for (const int rounds : kRounds) {
    RodInRoom rod(1);
    const double start = rod.energy();
    for (int i = 0; i < kContacts; ++i) ASSERT_TRUE(rod.meet({{1, 0, 0}, rounds}));
    EXPECT_NEAR(rod.energy() / start, 1, 1e-12) << rounds;
  }
}

TEST(RodInRoom, EndsStayWithinTheRoom) {
  RodInRoom rod(2);
  for (int i = 0; i < kContacts; ++i) {
    ASSERT_TRUE(rod.meet({{1, 0.5, 0}, 0}));
    for (const double side : {1.0, -1.0}) {
      const Vec3<double> end = to_world(rod.body().X_WB, {0, 0, side * RodInRoom::kHalfAxis});
      const double most = RodInRoom::kHalfRoom - RodInRoom::kRadius;
      EXPECT_LE(end.cwiseAbs().maxCoeff(), most + 2 * RodInRoom::kLeastWay);
    }
  }
}

TEST(RodInRoom, ClosedForm_NeverGainsAtAnyContact) {
  for (std::uint64_t number = 0; number < 8; ++number) {
    RodInRoom rod(number);
    for (int i = 0; i < kContacts; ++i) {
      const double before = rod.energy();
      ASSERT_TRUE(rod.meet({{1, 0.5, 0}, 0}));
      EXPECT_LE(rod.energy(), before * (1 + test::kGain));
    }
  }
}

}  // namespace
}  // namespace batuta::report
