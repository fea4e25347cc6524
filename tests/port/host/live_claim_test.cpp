// SPDX-License-Identifier: MIT
#include "programs/live/claim.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>

namespace batuta::host {
namespace {

TEST(DeviceNumber, IsTheDevices_WhateverItsName) {
  const DeviceNumber null = number_at("/dev/null");
  EXPECT_NE(null, kNoDevice);
  EXPECT_NE(null, number_at("/dev/zero"));
  const int file = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
  ASSERT_GE(file, 0);
  EXPECT_EQ(number_of(file), null);
  ::close(file);
  const std::filesystem::path link =
      std::filesystem::temp_directory_path() / ("batuta_claim_" + std::to_string(::getpid()));
  std::filesystem::create_symlink("/dev/null", link);
  EXPECT_EQ(number_at(link.string()), null);
  std::filesystem::remove(link);
  EXPECT_EQ(number_at(link.string()), kNoDevice);
  EXPECT_EQ(number_at("/"), kNoDevice);
  EXPECT_EQ(number_of(-1), kNoDevice);
}

TEST(Claim, IsOfOneAlone_UntilItLetsGo) {
  Claim left;
  EXPECT_TRUE(left.take(7));
  EXPECT_TRUE(left.holds(7));
  {
    Claim right;
    EXPECT_FALSE(right.take(7));
    EXPECT_FALSE(right.holds(7));
    EXPECT_TRUE(right.take(8));
    EXPECT_FALSE(right.take(7)) << "and what it had is free";
    EXPECT_TRUE(left.take(8));
    EXPECT_TRUE(right.take(7));
  }
  EXPECT_TRUE(left.take(7)) << "who is no more holds nothing";
  left.release();
  EXPECT_FALSE(left.holds(7));
  EXPECT_TRUE(Claim().take(7));
}

TEST(Claim, OfADeviceWithoutANumber_IsNobodys) {
  Claim left;
  Claim right;
  EXPECT_TRUE(left.take(kNoDevice));
  EXPECT_TRUE(right.take(kNoDevice));
}

}  // namespace
}  // namespace batuta::host
