// SPDX-License-Identifier: MIT
// The contract suite as a board runs it: the checks that GoogleTest has, by the same names, and
// each rule of the contract is missed by the device that breaks it.

#include "contract_on_board.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "faulty_rigs.hpp"

namespace batuta::test {
namespace {

using ::testing::HasSubstr;
using Names = std::set<std::string>;

std::string told;

void tell(const char* text) {
  told += text;
}

/// Suites and tests whose lines begin with a word.
Names told_as(const std::string& word) {
  Names names;
  for (std::size_t at = 0; at < told.size(); at = told.find('\n', at) + 1) {
    const std::string line = told.substr(at, told.find('\n', at) - at);
    const std::size_t end = line.find(',');
    if (line.rfind(word, 0) == 0) names.insert(line.substr(6, end == line.npos ? end : end - 6));
  }
  return names;
}

/// What fails of a rig in a suite.
template <class Rig>
Names failures(void (ContractOnBoard::*suite)()) {
  told.clear();
  ContractOnBoard contract(tell);
  (contract.*suite)();
  EXPECT_EQ(contract.end(), told_as("fails ").empty());
  return told_as("fails ");
}
template <Fault kFault>
Names stick() {
  return failures<TickingStick<kFault>>(&ContractOnBoard::input<TickingStick<kFault>>);
}
template <Fault kFault>
Names time() {
  return failures<CountingClock<kFault>>(&ContractOnBoard::clock<CountingClock<kFault>>);
}
template <Fault kFault>
Names motor() {
  return failures<Lamp<kFault>>(&ContractOnBoard::force<Lamp<kFault>>);
}

/// The names that GoogleTest runs in this program.
Names of_google_test() {
  Names names;
  const ::testing::UnitTest& all = *::testing::UnitTest::GetInstance();
  for (int i = 0; i < all.total_test_suite_count(); ++i) {
    const ::testing::TestSuite& suite = *all.GetTestSuite(i);
    const std::string name = suite.name();
    if (name.rfind("Template/", 0) != 0) continue;
    const std::string bare = name.substr(9, name.rfind('/') - 9);
    for (int k = 0; k < suite.total_test_count(); ++k) {
      names.insert(bare + "." + suite.GetTestInfo(k)->name());
    }
  }
  return names;
}

TEST(ContractOnBoard, Checks_AreThoseOfGoogleTest) {
  told.clear();
  ContractOnBoard contract(tell);
  contract.input<TickingStick<Fault::kNone>>();
  contract.clock<CountingClock<Fault::kNone>>();
  contract.force<Lamp<Fault::kNone>>();
  EXPECT_TRUE(contract.end());
  EXPECT_EQ(told_as("ok"), of_google_test());
  EXPECT_EQ(told_as("ok").size(), 10U);
  EXPECT_THAT(told, HasSubstr("the contract is kept\n"));
}

TEST(ContractOnBoard, NoChecks_AreNoContract) {
  ContractOnBoard contract(tell);
  EXPECT_FALSE(contract.end());
}

TEST(ContractOnBoard, FaultyStick_FailsWhereItIsWrong) {
  const std::string range = "InputContract.Samples_AreInRangeAndNotFromTheFuture";
  const std::string order = "InputContract.Samples_AreCountedAndInOrder";
  const std::string once = "InputContract.SameTime_IsNewOnce";
  const std::string nothing = "InputContract.NothingNew_LeavesTheSample";
  EXPECT_EQ(stick<Fault::kSilent>(), (Names{range, order, once}));
  EXPECT_EQ(stick<Fault::kOutOfRange>(), (Names{range, order, once}));
  EXPECT_EQ(stick<Fault::kTooHigh>(), (Names{range, order, once}));
  EXPECT_THAT(told, HasSubstr(range + ", should hold: axes are numbers within 1\n"));
  EXPECT_EQ(stick<Fault::kFuture>(), Names{range});
  EXPECT_EQ(stick<Fault::kOlder>(), Names{order});
  EXPECT_EQ(stick<Fault::kUncounted>(), Names{order});
  EXPECT_EQ(stick<Fault::kNewTwice>(), (Names{order, once, nothing}));
  EXPECT_EQ(stick<Fault::kAllocates>(), Names{"InputContract.Reading_AllocatesNothing"});
}

TEST(ContractOnBoard, FaultyClockOrMotor_FailsWhereItIsWrong) {
  const Names now = {"ClockContract.Now_NeverGoesBackAndAllocatesNothing"};
  const std::string next = "ForceContract.InvalidCommand_IsRefusedAndTheNextIsTaken";
  const std::string off = "ForceContract.Off_IsTakenOrTheDeviceIsGone_AndTheNextCommandIsTaken";
  EXPECT_EQ(time<Fault::kGoesBack>(), now);
  EXPECT_EQ(time<Fault::kAllocates>(), now);
  EXPECT_EQ(motor<Fault::kRefuses>(), Names{"ForceContract.ValidCommand_IsTakenOrTheDeviceIsGone"});
  EXPECT_EQ(motor<Fault::kGoneAfterOff>(), Names{off});
  EXPECT_EQ(motor<Fault::kFlaky>(), (Names{next, off}));
  EXPECT_EQ(motor<Fault::kAllocates>(), Names{"ForceContract.Writing_AllocatesNothing"});
}

}  // namespace
}  // namespace batuta::test
