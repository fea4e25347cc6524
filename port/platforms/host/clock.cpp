// SPDX-License-Identifier: MIT

#include "platforms/host/clock.hpp"

#include <chrono>

namespace batuta {

Microseconds HostClock::do_now() {
  const auto since_start = std::chrono::steady_clock::now().time_since_epoch();
  const auto us = std::chrono::duration_cast<std::chrono::microseconds>(since_start).count();
  return static_cast<Microseconds>(us);  // modulo 2^32, as agreed
}

}  // namespace batuta
