// SPDX-License-Identifier: MIT
#include "programs/duel/device/device_setup.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fcntl.h>
#include <unistd.h>
#include <cstdlib>

namespace batuta::host {
using namespace fencing;
namespace {

TEST(DeviceSetup, TheRateOfTheWords_ReachesTheLine) {
  for (const char* words : {"serial:/dev/none@12345", "serial:/dev/none@12345,script:attack"}) {
    DeviceSetup setup;
    EXPECT_EQ(setup.open(open_source("script:guard"), open_source(words)),
              "/dev/none: unknown rate of 12345 baud");
  }
}

TEST(DeviceSetup, WithoutARate_TheLineIsOpenedWithAKnownOne) {
  DeviceSetup setup;
  EXPECT_THAT(setup.open(open_source("serial:/dev/none"), open_source("script:guard")),
              testing::HasSubstr("no such file"));
}

/// A live device that has had its troubles.
class Worn final : public Source {
 public:
  std::string description() const override { return "worn"; }
  double duration() const override { return 1; }
  std::uint32_t losses() const override { return 3; }
  std::uint32_t unplugs() const override { return 2; }

 private:
  Status do_read(Microseconds /*now*/, InputSample& /*sample*/) override {
    return Status::kUnavailable;
  }
};

TEST(DeviceSetup, BesideADevicesOwnStick_TheOtherFencersLossesAreStillTold) {
  const int terminal = ::posix_openpt(O_RDWR | O_NOCTTY);
  ASSERT_GE(terminal, 0);
  ASSERT_EQ(::grantpt(terminal) + ::unlockpt(terminal), 0);
  const OpenedSource left = open_source(std::string("serial:") + ::ptsname(terminal));
  OpenedSource right;
  right.source = std::make_unique<Worn>();
  DeviceSetup setup;
  ASSERT_EQ(setup.open(left, right), "");
  EXPECT_EQ(setup.source(Side::kRight).losses(), 3U);
  EXPECT_EQ(setup.source(Side::kRight).unplugs(), 2U);
  EXPECT_EQ(setup.source(Side::kLeft).unplugs(), 0U);
  ::close(terminal);
}

TEST(DeviceSetup, ASilentLine_IsGivenUpAfterThePatience) {
  const int terminal = ::posix_openpt(O_RDWR | O_NOCTTY);
  ASSERT_GE(terminal, 0);
  ASSERT_EQ(::grantpt(terminal) + ::unlockpt(terminal), 0);
  const OpenedSource left = open_source(std::string("serial:") + ::ptsname(terminal));
  const OpenedSource right = open_source("script:guard");
  DeviceSetup setup;
  ASSERT_EQ(setup.open(left, right, Patience{1, 2, 3}), "");
  EXPECT_FALSE(setup.partner()->open());
  EXPECT_THAT(setup.partner()->problem(), testing::HasSubstr("no answer to Hello within 3 ms"));
  ::close(terminal);
}

}  // namespace
}  // namespace batuta::host
