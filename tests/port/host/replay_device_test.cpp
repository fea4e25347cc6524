// SPDX-License-Identifier: MIT
#include "programs/devices/replay_device.hpp"

#include <gtest/gtest.h>

namespace batuta::host {
namespace {

ReplayDevice replay_of(const std::vector<Microseconds>& times) {
  Recording recording;
  for (const Microseconds time : times) {
    InputSample sample;
    sample.time = time;
    sample.sequence = static_cast<std::uint32_t>(recording.samples.size());
    recording.samples.push_back(sample);
  }
  return {recording, "test"};
}

TEST(ReplayDevice, LatestSampleWins_AndIsTakenOnce) {
  ReplayDevice device = replay_of({0, 1000, 1500, 3000});
  InputSample sample;
  EXPECT_EQ(device.read(0, sample), Status::kOk);
  EXPECT_EQ(sample.sequence, 0U);
  EXPECT_EQ(device.read(999, sample), Status::kUnavailable);
  EXPECT_EQ(device.read(2000, sample), Status::kOk);
  EXPECT_EQ(sample.sequence, 2U) << "1 was overwritten";
  EXPECT_EQ(device.read(2000, sample), Status::kUnavailable);
  EXPECT_EQ(device.read(3000, sample), Status::kOk);
  EXPECT_EQ(device.read(99999, sample), Status::kUnavailable);
}

TEST(ReplayDevice, BackwardStamps_AreHandedOutAtOnce) {
  ReplayDevice device = replay_of({0, 5000, 4000, 6000});
  InputSample sample;
  EXPECT_EQ(device.read(4500, sample), Status::kOk);
  EXPECT_EQ(sample.sequence, 0U);
  EXPECT_EQ(device.read(5000, sample), Status::kOk);
  EXPECT_EQ(sample.sequence, 2U);
}

TEST(ReplayDevice, PlaysAcrossTheWrapOfTheClock) {
  const Microseconds half_hour = 1'799'000'000U;
  ReplayDevice device =
      replay_of({0, half_hour, 2 * half_hour, 3U * half_hour, 3U * half_hour + 1000U});
  InputSample sample;
  std::uint32_t read = 0;
  Microseconds now = 0;
  for (int minute = 0; minute < 100; ++minute, now += 60'000'000U) {
    if (device.read(now, sample) == Status::kOk) {
      EXPECT_FALSE(is_later(sample.time, now));
      read = sample.sequence;
    }
  }
  EXPECT_EQ(read, 4U);
}

TEST(ReplayDevice, Description_NamesTheDevice) {
  Recording recording;
  EXPECT_EQ(ReplayDevice(recording, "a.events").description(), "a.events");
  recording.device = "a mouse";
  EXPECT_EQ(ReplayDevice(recording, "a.events").description(), "a.events (a mouse)");
}

}  // namespace
}  // namespace batuta::host
