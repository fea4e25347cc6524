// SPDX-License-Identifier: MIT
#pragma once
// The first byte of each report. No number is used twice, whichever way the report goes.

#include <cstdint>

namespace batuta::pid {

enum class ReportId : std::uint8_t {
  // input: device to host
  kJoystick = 0x01,
  kState = 0x02,
  // output: host to device
  kSetEffect = 0x11,
  kSetEnvelope = 0x12,
  kSetCondition = 0x13,
  kSetPeriodic = 0x14,
  kSetConstant = 0x15,
  kSetRamp = 0x16,
  kEffectOperation = 0x1A,
  kBlockFree = 0x1B,
  kDeviceControl = 0x1C,
  kDeviceGain = 0x1D,
  // feature: host to device
  kCreateNewEffect = 0x21,
  // feature: device to host
  kBlockLoad = 0x22,
  kPool = 0x23,
};

}  // namespace batuta::pid
