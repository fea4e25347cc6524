// SPDX-License-Identifier: MIT

#include "batuta/haptics/force_map.hpp"

#include <gtest/gtest.h>

namespace batuta {
namespace {

TEST(ForceMap, OneColumn_IsTheWorkOfAUnitRate) {
  StickJacobian<double> jacobian = StickJacobian<double>::Zero();
  jacobian.col(0) << 1, 2, 3, 4, 5, 6;
  const Wrench<double> wrench{{1, 10, 100}, {1000, 10000, 100000}};
  const Vec2<double> force = stick_force(jacobian, wrench);
  EXPECT_EQ(force.x(), 654321);
  EXPECT_EQ(force.y(), 0);
}

}  // namespace
}  // namespace batuta
