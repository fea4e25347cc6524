// SPDX-License-Identifier: MIT
#pragma once
// The stick that the tests of live devices plug into the fake kernel.

#include "fake_event_device.hpp"

namespace batuta::test {

inline constexpr const char* kPath = "/dev/input/fake0";

/// A stick with ranges and a dead zone of its own, its centre between two counts, and two buttons.
struct FakeStick : FakeEventDevice {
  FakeStick() : FakeEventDevice(kPath) {
    name("Test Stick");
    axis(ABS_X, {127, 0, 255, 0, 15, 0});
    axis(ABS_Y, {127, 0, 255, 0, 15, 0});
    has(EV_KEY, BTN_TRIGGER).has(EV_KEY, BTN_THUMB);
  }
};

}  // namespace batuta::test
