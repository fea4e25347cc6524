// SPDX-License-Identifier: MIT
#include "batuta/port/input.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace batuta {
namespace {

class FakeDevice final : public InputDevice {
 public:
  Status status = Status::kOk;
  InputSample next;
  Microseconds asked = 0;

 private:
  Status do_read(Microseconds now, InputSample& sample) override {
    asked = now;
    sample = next;
    return status;
  }
};

InputSample sample_at(float x, float y) {
  InputSample sample;
  sample.time = 7;
  sample.x = x;
  sample.y = y;
  sample.feet_x = -y;
  sample.feet_y = x;
  sample.buttons = 5;
  sample.sequence = 9;
  return sample;
}

void expect_same(const InputSample& a, const InputSample& b) {
  EXPECT_EQ(a.time, b.time);
  EXPECT_EQ(a.x, b.x);
  EXPECT_EQ(a.y, b.y);
  EXPECT_EQ(a.feet_x, b.feet_x);
  EXPECT_EQ(a.feet_y, b.feet_y);
  EXPECT_EQ(a.buttons, b.buttons);
  EXPECT_EQ(a.sequence, b.sequence);
}

TEST(InputDevice, Read_HandsOverTheWholeSampleAndTheTime) {
  FakeDevice device;
  device.next = sample_at(-1.0F, 1.0F);
  InputSample sample;
  EXPECT_EQ(device.read(123, sample), Status::kOk);
  EXPECT_EQ(device.asked, 123U);
  expect_same(sample, device.next);
}

TEST(InputDevice, Read_NothingNew_LeavesTheSample) {
  FakeDevice device;
  device.next = sample_at(0.5F, 0.5F);
  device.status = Status::kUnavailable;
  InputSample sample = sample_at(0.1F, 0.2F);
  EXPECT_EQ(device.read(0, sample), Status::kUnavailable);
  expect_same(sample, sample_at(0.1F, 0.2F));
}

TEST(InputDevice, Read_RefusesWhatIsNoDeflection_AndLeavesTheSample) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  const float above = std::nextafter(1.0F, 2.0F);
  for (const float bad : {nan, infinity, -infinity, above, -above, 1e30F}) {
    for (const InputSample& delivered : {sample_at(bad, 0), sample_at(0, bad)}) {
      FakeDevice device;
      device.next = delivered;
      InputSample sample = sample_at(0.1F, 0.2F);
      EXPECT_EQ(device.read(0, sample), Status::kInvalidArgument) << bad;
      expect_same(sample, sample_at(0.1F, 0.2F));
    }
  }
}

TEST(Microseconds, Elapsed_AcrossTheWrap) {
  EXPECT_EQ(elapsed_us(0xFFFFFFF0U, 0x10U), 32);
  EXPECT_EQ(elapsed_us(0x10U, 0xFFFFFFF0U), -32);
  EXPECT_TRUE(is_later(6U, 5U));
  EXPECT_FALSE(is_later(5U, 6U));
  EXPECT_TRUE(is_later(0x10U, 0xFFFFFFF0U));
  EXPECT_FALSE(is_later(5U, 5U));
}

TEST(InputSample, Stale_IsOldOrFromTheFuture) {
  InputSample sample;
  sample.time = 0xFFFFFF00U;
  EXPECT_FALSE(is_stale(sample, sample.time, 0));
  EXPECT_FALSE(is_stale(sample, sample.time + 1000U, 1000));
  EXPECT_TRUE(is_stale(sample, sample.time + 1001U, 1000));
  EXPECT_FALSE(is_stale(sample, sample.time - 1000U, 1000));
  EXPECT_TRUE(is_stale(sample, sample.time - 1001U, 1000));
}

}  // namespace
}  // namespace batuta
