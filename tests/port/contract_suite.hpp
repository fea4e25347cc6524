// SPDX-License-Identifier: MIT
#pragma once
// The checks of contract_checks.hpp as typed tests of GoogleTest, on rigs as they are described
// there:
//   INSTANTIATE_TYPED_TEST_SUITE_P(Mine, InputContract, ::testing::Types<MyStick>);
// Link batuta_heap_trap.

#include <gtest/gtest.h>

#include "contract_checks.hpp"

namespace batuta::test {

class Expectations final : public Verdicts {
 public:
  void that(bool holds, const char* what) override { EXPECT_TRUE(holds) << what; }
};

template <class Checks>
class Contract : public ::testing::Test {
 private:
  Expectations expectations_;

 protected:
  Checks checks_{expectations_};
};

template <class Rig>
class InputContract : public Contract<InputChecks<Rig>> {};
TYPED_TEST_SUITE_P(InputContract);

TYPED_TEST_P(InputContract, Samples_AreInRangeAndNotFromTheFuture) {
  this->checks_.samples_are_in_range_and_not_from_the_future();
}
TYPED_TEST_P(InputContract, Samples_AreCountedAndInOrder) {
  this->checks_.samples_are_counted_and_in_order();
}
TYPED_TEST_P(InputContract, SameTime_IsNewOnce) {
  this->checks_.same_time_is_new_once();
}
TYPED_TEST_P(InputContract, NothingNew_LeavesTheSample) {
  this->checks_.nothing_new_leaves_the_sample();
}
TYPED_TEST_P(InputContract, Reading_AllocatesNothing) {
  this->checks_.reading_allocates_nothing();
}
REGISTER_TYPED_TEST_SUITE_P(InputContract, Samples_AreInRangeAndNotFromTheFuture,
                            Samples_AreCountedAndInOrder, SameTime_IsNewOnce,
                            NothingNew_LeavesTheSample, Reading_AllocatesNothing);

template <class Rig>
class ClockContract : public Contract<ClockChecks<Rig>> {};
TYPED_TEST_SUITE_P(ClockContract);

TYPED_TEST_P(ClockContract, Now_NeverGoesBackAndAllocatesNothing) {
  this->checks_.now_never_goes_back_and_allocates_nothing();
}
REGISTER_TYPED_TEST_SUITE_P(ClockContract, Now_NeverGoesBackAndAllocatesNothing);

template <class Rig>
class ForceContract : public Contract<ForceChecks<Rig>> {};
TYPED_TEST_SUITE_P(ForceContract);

TYPED_TEST_P(ForceContract, ValidCommand_IsTakenOrTheDeviceIsGone) {
  this->checks_.valid_command_is_taken_or_the_device_is_gone();
}
TYPED_TEST_P(ForceContract, InvalidCommand_IsRefusedAndTheNextIsTaken) {
  this->checks_.invalid_command_is_refused_and_the_next_is_taken();
}
TYPED_TEST_P(ForceContract, Off_IsTakenOrTheDeviceIsGone_AndTheNextCommandIsTaken) {
  this->checks_.off_is_taken_or_the_device_is_gone_and_the_next_command_is_taken();
}
TYPED_TEST_P(ForceContract, Writing_AllocatesNothing) {
  this->checks_.writing_allocates_nothing();
}
REGISTER_TYPED_TEST_SUITE_P(ForceContract, ValidCommand_IsTakenOrTheDeviceIsGone,
                            InvalidCommand_IsRefusedAndTheNextIsTaken,
                            Off_IsTakenOrTheDeviceIsGone_AndTheNextCommandIsTaken,
                            Writing_AllocatesNothing);

}  // namespace batuta::test
