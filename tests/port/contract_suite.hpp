// SPDX-License-Identifier: MIT
#pragma once
// What every device of every port must do, as typed tests. A port describes its devices by rigs:
//   struct MyStick {                                     // for InputContract
//     static constexpr bool kHasSamples = true;          // false: a device that never has any
//     batuta::InputDevice& device();
//     batuta::Microseconds next();                       // makes time pass and tells it; samples
//     may have come
//   };
//   struct MyClock { batuta::Clock& clock(); };          // for ClockContract
//   struct MyMotor { batuta::ForceDevice& device(); };   // for ForceContract
//   INSTANTIATE_TYPED_TEST_SUITE_P(Mine, InputContract, ::testing::Types<MyStick>);
// Link batuta_heap_trap.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "batuta/port/clock.hpp"
#include "batuta/port/force.hpp"
#include "batuta/port/input.hpp"
#include "heap_trap.hpp"
#include "plain_force.hpp"

namespace batuta::test {

inline constexpr int kReads = 1000;

inline bool same(const InputSample& a, const InputSample& b) {
  return a.time == b.time && a.x == b.x && a.y == b.y && a.buttons == b.buttons &&
         a.sequence == b.sequence;
}

template <class Rig>
class InputContract : public ::testing::Test {
 protected:
  /// Calls check(now, sample) with each sample of many reads; fails where it had none but should.
  template <class Check>
  void for_each_sample(const Check& check) {
    int samples = 0;
    for (int i = 0; i < kReads; ++i) {
      const Microseconds now = rig_.next();
      InputSample sample;
      if (rig_.device().read(now, sample) != Status::kOk) continue;
      ++samples;
      check(now, sample);
    }
    EXPECT_EQ(samples > 0, Rig::kHasSamples);
  }

  Rig rig_;
};
TYPED_TEST_SUITE_P(InputContract);

TYPED_TEST_P(InputContract, Samples_AreInRangeAndNotFromTheFuture) {
  this->for_each_sample([](Microseconds now, const InputSample& sample) {
    EXPECT_LE(std::abs(sample.x), 1.0F);
    EXPECT_LE(std::abs(sample.y), 1.0F);
    EXPECT_FALSE(is_later(sample.time, now));
  });
}

TYPED_TEST_P(InputContract, Samples_AreCountedAndInOrder) {
  InputSample last;
  bool first = true;
  this->for_each_sample([&](Microseconds, const InputSample& sample) {
    if (!first) {
      EXPECT_GE(elapsed_us(last.time, sample.time), 0);
      EXPECT_GT(static_cast<std::int32_t>(sample.sequence - last.sequence), 0);
    }
    first = false;
    last = sample;
  });
}

TYPED_TEST_P(InputContract, SameTime_IsNewOnce) {
  this->for_each_sample([this](Microseconds now, const InputSample&) {
    InputSample again;
    EXPECT_EQ(this->rig_.device().read(now, again), Status::kUnavailable);
  });
}

TYPED_TEST_P(InputContract, NothingNew_LeavesTheSample) {
  InputSample marked;
  marked.time = 77;
  marked.x = 0.25F;
  marked.y = -0.75F;
  marked.buttons = 5;
  marked.sequence = 99;
  int unavailable = 0;
  for (int i = 0; i < kReads; ++i) {
    const Microseconds now = this->rig_.next();
    InputSample drained;
    (void)this->rig_.device().read(now, drained);
    InputSample sample = marked;
    if (this->rig_.device().read(now, sample) == Status::kOk) continue;
    ++unavailable;
    EXPECT_TRUE(same(sample, marked));
  }
  EXPECT_GT(unavailable, 0);
}

TYPED_TEST_P(InputContract, Reading_AllocatesNothing) {
  InputSample sample;
  (void)this->rig_.device().read(this->rig_.next(), sample);
  int allocations = 0;
  for (int i = 0; i < kReads; ++i) {
    const Microseconds now = this->rig_.next();
    const HeapTrap trap;
    (void)this->rig_.device().read(now, sample);
    allocations += trap.allocations();
  }
  EXPECT_EQ(allocations, 0);
}

REGISTER_TYPED_TEST_SUITE_P(InputContract, Samples_AreInRangeAndNotFromTheFuture,
                            Samples_AreCountedAndInOrder, SameTime_IsNewOnce,
                            NothingNew_LeavesTheSample, Reading_AllocatesNothing);

template <class Rig>
class ClockContract : public ::testing::Test {
 protected:
  Rig rig_;
};
TYPED_TEST_SUITE_P(ClockContract);

TYPED_TEST_P(ClockContract, Now_NeverGoesBackAndAllocatesNothing) {
  const HeapTrap trap;
  Microseconds last = this->rig_.clock().now();
  int backwards = 0;
  for (int i = 0; i < kReads; ++i) {
    const Microseconds now = this->rig_.clock().now();
    if (is_later(last, now)) ++backwards;
    last = now;
  }
  EXPECT_EQ(backwards, 0);
  EXPECT_EQ(trap.allocations(), 0);
}

REGISTER_TYPED_TEST_SUITE_P(ClockContract, Now_NeverGoesBackAndAllocatesNothing);

template <class Rig>
class ForceContract : public ::testing::Test {
 protected:
  Status write(float x, float y) { return force_.write({0, x, y}); }

  Rig rig_;
  PlainForce force_{rig_.device()};
};
TYPED_TEST_SUITE_P(ForceContract);

TYPED_TEST_P(ForceContract, ValidCommand_IsTakenOrTheDeviceIsGone) {
  for (const float x : {-1.0F, -0.5F, 0.0F, 0.5F, 1.0F}) {
    const Status status = this->write(x, -x);
    EXPECT_TRUE(status == Status::kOk || status == Status::kUnavailable);
  }
}

TYPED_TEST_P(ForceContract, InvalidCommand_IsRefusedAndTheNextIsTaken) {
  const Status valid = this->write(0, 0);
  const Status refused = valid == Status::kOk ? Status::kInvalidArgument : Status::kUnavailable;
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  for (const float bad : {kNan, kInfinity, -kInfinity}) {
    EXPECT_EQ(this->write(bad, 0), refused) << bad;
    EXPECT_EQ(this->write(0, bad), refused) << bad;
    EXPECT_EQ(this->write(0, 0), valid);
  }
}

TYPED_TEST_P(ForceContract, Off_IsTakenOrTheDeviceIsGone_AndTheNextCommandIsTaken) {
  const Status valid = this->write(1, -1);
  EXPECT_EQ(this->rig_.device().off(0), valid);
  EXPECT_EQ(this->write(1, -1), valid);
}

TYPED_TEST_P(ForceContract, Writing_AllocatesNothing) {
  (void)this->write(0, 0);
  const HeapTrap trap;
  for (int i = 0; i < kReads; ++i) (void)this->write(0.25F, -0.25F);
  EXPECT_EQ(trap.allocations(), 0);
}

REGISTER_TYPED_TEST_SUITE_P(ForceContract, ValidCommand_IsTakenOrTheDeviceIsGone,
                            InvalidCommand_IsRefusedAndTheNextIsTaken,
                            Off_IsTakenOrTheDeviceIsGone_AndTheNextCommandIsTaken,
                            Writing_AllocatesNothing);

}  // namespace batuta::test
