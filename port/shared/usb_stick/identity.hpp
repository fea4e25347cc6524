// SPDX-License-Identifier: MIT
#pragma once
// Who the stick says it is. The two numbers are borrowed and yours to set: a vendor's number is
// bought (usb.org), or one of a vendor that lends them (pid.codes). Devices with the same numbers
// and serial number are the same device to a host.

#include <cstdint>

// pid.codes 1209:0001, "test PID": for the desk; no device may be given away with it.
#ifndef BATUTA_USB_VENDOR
#define BATUTA_USB_VENDOR 0x1209
#endif
#ifndef BATUTA_USB_PRODUCT
#define BATUTA_USB_PRODUCT 0x0001
#endif

namespace batuta::usb {

inline constexpr std::uint16_t kVendor = BATUTA_USB_VENDOR;
inline constexpr std::uint16_t kProduct = BATUTA_USB_PRODUCT;
/// Of the device, in binary coded decimals; to be raised when the reports change: Windows keeps
/// what it has read of a release.
inline constexpr std::uint16_t kRelease = 0x0100;

/// In ASCII; what is longer than kLongestString is cut off.
struct Identity {
  const char* manufacturer = "batuta";
  const char* product = "batuta force feedback stick";
  const char* serial = "0";  ///< another one for each board
};

}  // namespace batuta::usb
