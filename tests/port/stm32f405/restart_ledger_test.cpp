// SPDX-License-Identifier: MIT
// When a board may try again, and when it parks.

#include "platforms/stm32f405/drivers/restart_ledger.hpp"

#include <gtest/gtest.h>

namespace batuta::stm32f405 {
namespace {

/// What RAM holds after power-on: anything.
RestartLedger random_memory() {
  return {0xDEADBEEF, 0x12345678};
}

int runs_until_parked(RestartLedger& ledger, ResetCause cause, bool fault_recorded) {
  int runs = 0;
  while (runs < 100 && may_run(ledger, cause, fault_recorded)) ++runs;
  return runs;
}

TEST(RestartLedger, PowerOn_RunsWhateverTheMemoryHolds) {
  RestartLedger ledger = random_memory();
  EXPECT_TRUE(may_run(ledger, ResetCause::kPowerOn, false));
  EXPECT_EQ(restarts_in(ledger), 0U);
}

TEST(RestartLedger, FaultsInARow_ParkAfterTheLimit) {
  for (const ResetCause cause : {ResetCause::kSoftware, ResetCause::kWatchdog}) {
    RestartLedger ledger = random_memory();
    ASSERT_TRUE(may_run(ledger, ResetCause::kPowerOn, false));
    EXPECT_EQ(runs_until_parked(ledger, cause, true), static_cast<int>(kMaxRestarts));
    EXPECT_FALSE(may_run(ledger, cause, true));  // and stays parked
  }
}

TEST(RestartLedger, DebuggersReset_Runs) {
  RestartLedger ledger = random_memory();
  EXPECT_EQ(runs_until_parked(ledger, ResetCause::kSoftware, false), 100);
  EXPECT_EQ(restarts_in(ledger), 0U);
  // A watchdog's restart counts with and without a record.
  EXPECT_EQ(runs_until_parked(ledger, ResetCause::kWatchdog, false),
            static_cast<int>(kMaxRestarts));
}

TEST(RestartLedger, ResetButton_UnparksAndCountsFromZero) {
  RestartLedger ledger = random_memory();
  (void)runs_until_parked(ledger, ResetCause::kSoftware, true);
  EXPECT_TRUE(may_run(ledger, ResetCause::kPin, true));
  EXPECT_EQ(runs_until_parked(ledger, ResetCause::kSoftware, true), static_cast<int>(kMaxRestarts));
}

TEST(RestartLedger, HealthyRun_ForgetsWhatWasBefore) {
  RestartLedger ledger = random_memory();
  for (int i = 0; i < 50; ++i) {
    EXPECT_TRUE(may_run(ledger, ResetCause::kWatchdog, true));
    note_healthy(ledger);
  }
}

TEST(RestartLedger, UnknownCause_IsJudgedByTheRecord) {
  RestartLedger ledger = random_memory();
  EXPECT_EQ(runs_until_parked(ledger, ResetCause::kUnknown, false), 100);
  EXPECT_EQ(runs_until_parked(ledger, ResetCause::kUnknown, true), static_cast<int>(kMaxRestarts));
}

}  // namespace
}  // namespace batuta::stm32f405
