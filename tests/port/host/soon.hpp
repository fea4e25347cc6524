// SPDX-License-Identifier: MIT
#pragma once
// Waiting for another thread: as long as it takes, but not for ever. The limit is only there to end
// a test that fails: no working thread needs a thousandth of it, nor a hundredth on a busy machine.

#include <chrono>
#include <thread>

namespace batuta::test {

template <class Condition>
bool soon(const Condition& condition) {
  constexpr int kPatience_ms = 60000;
  for (int i = 0; i < kPatience_ms; ++i) {
    if (condition()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return false;
}

}  // namespace batuta::test
