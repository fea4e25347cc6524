// SPDX-License-Identifier: MIT

#include "programs/duel/view/held_exit.hpp"

#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <thread>
#include <utility>

namespace batuta::host {
namespace {

/// What this thread's exit() calls; null: it may end the program.
thread_local const std::function<void()>* told_here = nullptr;
std::atomic<bool> held{false};

/// Runs in the thread that has called exit().
void hold() {
  if (told_here == nullptr) return;
  held = true;
  (*told_here)();
  while (true) std::this_thread::sleep_for(std::chrono::hours(1));  // Bound: the program
}

}  // namespace

HeldExit::HeldExit(std::function<void()> told) : told_(std::move(told)) {
  [[maybe_unused]] static const int registered = std::atexit(hold);
  told_here = &told_;
}

HeldExit::~HeldExit() {
  told_here = nullptr;
}

void HeldExit::end_program(int exit_code) {
  if (!held) std::exit(exit_code);
  std::fflush(nullptr);
  std::_Exit(exit_code);
}

}  // namespace batuta::host
