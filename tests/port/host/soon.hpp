// SPDX-License-Identifier: MIT
#pragma once
// Waiting for another thread: as long as it takes, but not for ever.

#include <chrono>
#include <thread>

namespace batuta::test {

template <class Condition>
bool soon(const Condition& condition) {
  constexpr int kPatience_ms = 5000;
  for (int i = 0; i < kPatience_ms; ++i) {
    if (condition()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return false;
}

}  // namespace batuta::test
