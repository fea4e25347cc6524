// SPDX-License-Identifier: MIT
// A thread whose library ends the program, and the others that have something to finish.
#include "programs/duel/view/held_exit.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <future>
#include <thread>

namespace batuta::host {
namespace {

/// What a program with a window does whose display goes.
void finish_while_exit_is_held() {
  static std::promise<void> told;  // lives as long as the thread that is held
  std::thread window([] {
    const HeldExit held([] { told.set_value(); });
    std::exit(3);
  });
  told.get_future().wait();
  window.detach();
  std::fputs("finished", stderr);
  HeldExit::end_program(5);
}

void exit_after_it_was_held() {
  {
    const HeldExit held([] {});
  }
  std::exit(3);
}

/// Only the thread that asked for it is held.
void exit_beside_a_held_thread() {
  static std::promise<void> is_there;
  std::thread window([] {
    const HeldExit held([] {});
    is_there.set_value();
    while (true) std::this_thread::sleep_for(std::chrono::hours(1));  // Bound: the program
  });
  is_there.get_future().wait();
  window.detach();
  HeldExit::end_program(4);
}

TEST(HeldExitDeathTest, WhileItIsHeld_TheProgramFinishes) {
  EXPECT_EXIT(finish_while_exit_is_held(), testing::ExitedWithCode(5), "finished");
}

TEST(HeldExitDeathTest, Afterwards_ExitIsExit) {
  EXPECT_EXIT(exit_after_it_was_held(), testing::ExitedWithCode(3), "");
}

TEST(HeldExitDeathTest, OfAnotherThread_ExitIsExit) {
  EXPECT_EXIT(exit_beside_a_held_thread(), testing::ExitedWithCode(4), "");
}

}  // namespace
}  // namespace batuta::host
