// SPDX-License-Identifier: MIT
#pragma once
// The checks of contract_checks.hpp where there is no test framework, on the same rigs: each is
// told by a line with the name that GoogleTest has for it.
//   batuta::test::ContractOnBoard contract(write);  // void write(const char* text), to a console
//   contract.clock<MyClock>();
//   contract.input<MyStick>();
//   contract.force<MyMotor>();
//   return contract.end() ? 0 : 1;
// Link heap_trap_of_board.cpp in place of batuta_heap_trap. Allocates: never.

#include "contract_checks.hpp"

namespace batuta::test {

class ContractOnBoard final : private Verdicts {
 public:
  using Write = void (*)(const char* text);

  explicit ContractOnBoard(Write write) : write_(write) {}

  template <class Rig>
  void input() {
    using Checks = InputChecks<Rig>;
    suite_ = "InputContract.";
    run("Samples_AreInRangeAndNotFromTheFuture",
        &Checks::samples_are_in_range_and_not_from_the_future);
    run("Samples_AreCountedAndInOrder", &Checks::samples_are_counted_and_in_order);
    run("SameTime_IsNewOnce", &Checks::same_time_is_new_once);
    run("NothingNew_LeavesTheSample", &Checks::nothing_new_leaves_the_sample);
    run("Reading_AllocatesNothing", &Checks::reading_allocates_nothing);
  }

  template <class Rig>
  void clock() {
    using Checks = ClockChecks<Rig>;
    suite_ = "ClockContract.";
    run("Now_NeverGoesBackAndAllocatesNothing", &Checks::now_never_goes_back_and_allocates_nothing);
  }

  template <class Rig>
  void force() {
    using Checks = ForceChecks<Rig>;
    suite_ = "ForceContract.";
    run("ValidCommand_IsTakenOrTheDeviceIsGone",
        &Checks::valid_command_is_taken_or_the_device_is_gone);
    run("InvalidCommand_IsRefusedAndTheNextIsTaken",
        &Checks::invalid_command_is_refused_and_the_next_is_taken);
    run("Off_IsTakenOrTheDeviceIsGone_AndTheNextCommandIsTaken",
        &Checks::off_is_taken_or_the_device_is_gone_and_the_next_command_is_taken);
    run("Writing_AllocatesNothing", &Checks::writing_allocates_nothing);
  }

  /// The last line. @returns whether there were checks and all hold
  bool end() {
    const bool all_hold = run_ > 0 && failed_ == 0;
    write_(all_hold ? "the contract is kept\n" : "the contract is broken\n");
    return all_hold;
  }

 private:
  template <class Checks>
  void run(const char* name, void (Checks::*check)()) {
    what_fails_ = nullptr;
    Checks checks(*this);
    (checks.*check)();
    ++run_;
    if (what_fails_ != nullptr) ++failed_;
    tell(name);
  }

  /// The first of a check's verdicts that fails is told; the others would say the same again.
  void that(bool holds, const char* what) override {
    if (!holds && what_fails_ == nullptr) what_fails_ = what;
  }

  void tell(const char* name) {
    write_(what_fails_ == nullptr ? "ok    " : "fails ");
    write_(suite_);
    write_(name);
    if (what_fails_ != nullptr) {
      write_(", should hold: ");
      write_(what_fails_);
    }
    write_("\n");
  }

  Write write_;
  const char* suite_ = "";
  const char* what_fails_ = nullptr;
  int run_ = 0;
  int failed_ = 0;
};

}  // namespace batuta::test
