// SPDX-License-Identifier: MIT
#pragma once
// What the host reads before it knows anything: a full-speed device with one configuration, which
// has one HID interface with an endpoint each way. Constant data, made while compiling. Source:
// USB 2.0, section 9.6; HID 1.11, section 6.2.1.

#include <array>
#include <cstdint>

#include "shared/hid_pid/device.hpp"
#include "shared/usb_stick/identity.hpp"

namespace batuta::usb {

/// Effects at the same time.
inline constexpr int kBlocks = 16;
using PidDevice = pid::Device<kBlocks>;

inline constexpr std::uint8_t kEndpointIn = 0x81;
inline constexpr std::uint8_t kEndpointOut = 0x01;
/// Of every endpoint: the most that full speed has for interrupts.
inline constexpr std::uint8_t kPacket = 64;
inline constexpr std::uint8_t kIntervalMs = 1;
/// What the board takes from the bus; motors never run on it.
inline constexpr int kBusMilliamperes = 100;

/// Numbers of the strings.
enum StringIndex : std::uint8_t { kLanguages, kManufacturer, kProductName, kSerial };
inline constexpr std::uint16_t kEnglish = 0x0409;

namespace descriptor {

enum Type : std::uint8_t {
  kDeviceType = 1,
  kConfigurationType,
  kStringType,
  kInterfaceType,
  kEndpointType,
  kHidType = 0x21,
  kReportType,
};

constexpr std::uint8_t low(int word) {
  return static_cast<std::uint8_t>(word & 0xFF);
}
constexpr std::uint8_t high(int word) {
  return static_cast<std::uint8_t>((word >> 8) & 0xFF);
}

inline constexpr int kReportSize = static_cast<int>(PidDevice::report_descriptor().size());
inline constexpr int kConfigurationSize = 9 + 9 + 9 + 7 + 7;
inline constexpr std::uint8_t kHidClass = 3;
inline constexpr std::uint8_t kSelfPowered = 0x80 | 0x40;  ///< the first bit is always set
inline constexpr std::uint8_t kInterrupt = 3;

}  // namespace descriptor

inline constexpr std::array<std::uint8_t, 18> kDeviceDescriptor = {
    18, descriptor::kDeviceType,
    // USB 2.0: with 2.1 a host asks for capabilities that there are none of
    0x00, 0x02,
    // class, subclass and protocol: the interface says it
    0, 0, 0, kPacket,
    // numbers
    descriptor::low(kVendor), descriptor::high(kVendor), descriptor::low(kProduct),
    descriptor::high(kProduct), descriptor::low(kRelease), descriptor::high(kRelease),
    // strings, configurations
    kManufacturer, kProductName, kSerial, 1};

inline constexpr std::array<std::uint8_t, descriptor::kConfigurationSize> kConfiguration = {
    // the configuration: its size and that of all below, one interface, number 1, no name
    9, descriptor::kConfigurationType, descriptor::low(descriptor::kConfigurationSize),
    descriptor::high(descriptor::kConfigurationSize), 1, 1, 0, descriptor::kSelfPowered,
    kBusMilliamperes / 2,
    // interface 0, no alternative, two endpoints, HID without a boot protocol, no name
    9, descriptor::kInterfaceType, 0, 0, 2, descriptor::kHidClass, 0, 0, 0,
    // HID 1.11, no country, one report descriptor
    9, descriptor::kHidType, 0x11, 0x01, 0, 1, descriptor::kReportType,
    descriptor::low(descriptor::kReportSize), descriptor::high(descriptor::kReportSize),
    // endpoints
    7, descriptor::kEndpointType, kEndpointIn, descriptor::kInterrupt, kPacket, 0, kIntervalMs,  //
    7, descriptor::kEndpointType, kEndpointOut, descriptor::kInterrupt, kPacket, 0, kIntervalMs};

/// Letters of a string.
inline constexpr int kLongestString = 31;
/// A string descriptor as TinyUSB takes it: size and type in the first word, then UTF-16.
using StringDescriptor = std::array<std::uint16_t, kLongestString + 1>;

/// @returns whether there is a string of this number
/// Bound: kLongestString. Allocates: never.
bool write_string(const Identity& identity, int index, StringDescriptor& descriptor);

}  // namespace batuta::usb
