// SPDX-License-Identifier: MIT
#pragma once
// The stick on TinyUSB: its callbacks, and what a board's loop calls once a millisecond.

#include "shared/usb_stick/usb_stick.hpp"

namespace batuta::usb {

/// Whose callbacks they are; to be called before tusb_init(). @param stick  lives as long as the
/// stack; null: nobody's, all is refused
void connect(UsbStick* stick);

/// A millisecond: the stack's events, the stick's tick, a report to the host where it takes one.
/// @param fresh  as UsbStick::tick()
void run(UsbStick& stick, const InputSample* fresh, Microseconds now);

}  // namespace batuta::usb
