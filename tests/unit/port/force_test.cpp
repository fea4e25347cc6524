// SPDX-License-Identifier: MIT
#include "batuta/port/force.hpp"

#include <gtest/gtest.h>

#include <type_traits>
#include <vector>

#include "plain_force.hpp"

namespace batuta {
namespace {

class FakeDevice final : public ForceDevice {
 public:
  Status status = Status::kOk;
  std::vector<ForceCommand> told;

 private:
  Status do_write(const ForceCommand& command) override {
    told.push_back(command);
    return status;
  }
};

TEST(ForceDevice, OfTheOutputStage_IsToldTheCommand) {
  FakeDevice device;
  test::PlainForce force(device);
  EXPECT_EQ(force.write({42, -1.0F, 0.25F}), Status::kOk);
  ASSERT_FALSE(device.told.empty());
  EXPECT_EQ(device.told.back().time, 42U);
  EXPECT_EQ(device.told.back().x, -1.0F);
  EXPECT_EQ(device.told.back().y, 0.25F);
}

TEST(ForceDevice, Off_TellsZero_AndWhetherTheDeviceIsThere) {
  FakeDevice device;
  EXPECT_EQ(device.off(7), Status::kOk);
  ASSERT_EQ(device.told.size(), 1U);
  EXPECT_EQ(device.told[0].time, 7U);
  EXPECT_EQ(device.told[0].x, 0.0F);
  EXPECT_EQ(device.told[0].y, 0.0F);
  EXPECT_EQ(device.told[0].own, 0.0F);
  device.status = Status::kUnavailable;
  EXPECT_EQ(device.off(8), Status::kUnavailable);
}

TEST(ForceCommand, ThatNobodyMade_IsNoForce) {
  const ForceCommand none;
  EXPECT_EQ(none.x, 0.0F);
  EXPECT_EQ(none.y, 0.0F);
  EXPECT_EQ(none.own, 0.0F);
}

TEST(ForcePermit, IsMadeByNobodyElse) {
  static_assert(!std::is_default_constructible_v<ForcePermit>);
  static_assert(!std::is_aggregate_v<ForcePermit>);
}

}  // namespace
}  // namespace batuta
