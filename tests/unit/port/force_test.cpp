// SPDX-License-Identifier: MIT
#include "batuta/port/force.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

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

TEST(ForceDevice, Write_PassesOnWhatIsInRange) {
  FakeDevice device;
  EXPECT_EQ(device.write({42, -1.0F, 1.0F}), Status::kOk);
  ASSERT_EQ(device.told.size(), 1U);
  EXPECT_EQ(device.told[0].time, 42U);
  EXPECT_EQ(device.told[0].x, -1.0F);
  EXPECT_EQ(device.told[0].y, 1.0F);
}

TEST(ForceDevice, Write_Nonsense_TellsTheDeviceZero) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float above = std::nextafter(1.0F, 2.0F);
  for (const float bad : {nan, std::numeric_limits<float>::infinity(), above, -above}) {
    for (const ForceCommand& command : {ForceCommand{1, bad, 0}, ForceCommand{1, 0, bad}}) {
      FakeDevice device;
      EXPECT_EQ(device.write(command), Status::kInvalidArgument);
      ASSERT_EQ(device.told.size(), 1U);
      EXPECT_EQ(device.told[0].time, 1U);
      EXPECT_EQ(device.told[0].x, 0.0F);
      EXPECT_EQ(device.told[0].y, 0.0F);
    }
  }
}

TEST(ForceDevice, Write_DeviceGone_SaysSo) {
  FakeDevice device;
  device.status = Status::kUnavailable;
  EXPECT_EQ(device.write({1, 0.5F, 0}), Status::kUnavailable);
  EXPECT_EQ(device.write({1, 2.0F, 0}), Status::kUnavailable);
}

}  // namespace
}  // namespace batuta
