// SPDX-License-Identifier: MIT

#include "fake_tinyusb.hpp"

#include <algorithm>
#include <cstdlib>

#include "tusb.h"

namespace batuta::test {
namespace {

FakeUsb* the_bus = nullptr;

// Of Setup::request_type
constexpr int kToHost = 0x80;
constexpr int kTypeMask = 0x60;
constexpr int kStandard = 0x00;
constexpr int kClass = 0x20;
constexpr int kRecipientMask = 0x1F;

// USB 2.0, tables 9-4 to 9-6
enum Request {
  kGetStatus = 0,
  kClearFeature = 1,
  kSetFeature = 3,
  kSetAddress = 5,
  kGetDescriptor = 6,
  kGetConfiguration = 8,
  kSetConfiguration = 9,
  kGetInterface = 10,
  kSetInterface = 11,
};
constexpr int kEndpointHalt = 0;

// HID 1.11, section 7.2
enum HidRequest {
  kGetReport = 1,
  kGetIdle = 2,
  kGetProtocol = 3,
  kSetReport = 9,
  kSetIdle = 10,
  kSetProtocol = 11,
};

bool reads(const Setup& setup) {
  return (setup.request_type & kToHost) != 0;
}

int type_of(const Setup& setup) {
  return setup.request_type & kTypeMask;
}

/// What there is, up to what was asked for.
std::optional<UsbBytes> answer(const Setup& setup, const std::uint8_t* bytes, std::size_t size) {
  if (bytes == nullptr || !reads(setup)) return std::nullopt;
  return UsbBytes(bytes, bytes + std::min<std::size_t>(size, setup.length));
}

/// The byte that the host sent, whatever it is: TinyUSB is C, where an enumeration may hold it.
hid_report_type_t report_type(const Setup& setup) {
  return static_cast<hid_report_type_t>(setup.value >> 8);
}

std::optional<UsbBytes> done() {
  return UsbBytes();
}

}  // namespace

FakeUsb::FakeUsb() {
  if (the_bus != nullptr) std::abort();
  the_bus = this;
}

FakeUsb::~FakeUsb() {
  the_bus = nullptr;
}

void FakeUsb::forget() {
  pending_.reset();
  configuration_ = address_ = 0;
  idle_ = 0;
  protocol_ = 1;
  suspended_ = in_halted_ = out_halted_ = false;
}

void FakeUsb::plug() {
  forget();
  plugged_ = true;
}

void FakeUsb::unplug() {
  const bool was_configured = configured();
  forget();
  plugged_ = false;
  if (was_configured) tud_umount_cb();
}

void FakeUsb::suspend() {
  if (!plugged_ || suspended_) return;
  suspended_ = true;
  tud_suspend_cb(false);
}

void FakeUsb::resume() {
  suspended_ = false;
}

std::optional<UsbBytes> FakeUsb::control(const Setup& setup, const UsbBytes& out) {
  if (!plugged_ || suspended_) return std::nullopt;
  switch (setup.request_type & kRecipientMask) {
    case 0:
      return to_device(setup);
    case 1:
      return to_interface(setup, out);
    case 2:
      return to_endpoint(setup);
    default:
      return std::nullopt;
  }
}

std::optional<UsbBytes> FakeUsb::to_device(const Setup& setup) {
  if (type_of(setup) != kStandard) return std::nullopt;
  const std::array<std::uint8_t, 2> status = {configured() ? std::uint8_t{1} : std::uint8_t{0}, 0};
  const auto number = static_cast<std::uint8_t>(configuration_);
  switch (setup.request) {
    case kGetStatus:
      return answer(setup, status.data(), status.size());
    case kSetAddress:
      address_ = setup.value & 0x7F;
      return done();
    case kGetDescriptor:
      return get_descriptor(setup);
    case kGetConfiguration:
      return answer(setup, &number, 1);
    case kSetConfiguration:
      return configure(setup.value & 0xFF);
    default:
      return std::nullopt;
  }
}

std::optional<UsbBytes> FakeUsb::get_descriptor(const Setup& setup) const {
  const auto index = static_cast<std::uint8_t>(setup.value & 0xFF);
  switch (setup.value >> 8) {
    case 1:
      return answer(setup, tud_descriptor_device_cb(), 18);
    case 2: {
      const std::uint8_t* const bytes = tud_descriptor_configuration_cb(index);
      if (bytes == nullptr) return std::nullopt;
      return answer(setup, bytes, std::size_t{bytes[2]} + 256U * bytes[3]);
    }
    case 3: {
      // Windows asks for number 0xEE on its own, and TinyUSB asks the firmware then, too.
      const std::uint16_t* const words = tud_descriptor_string_cb(index, setup.index);
      if (words == nullptr) return std::nullopt;
      UsbBytes bytes;
      for (int i = 0; i < (words[0] & 0xFF) / 2; ++i) {
        bytes.push_back(static_cast<std::uint8_t>(words[i] & 0xFF));
        bytes.push_back(static_cast<std::uint8_t>(words[i] >> 8));
      }
      return answer(setup, bytes.data(), bytes.size());
    }
    default:
      return std::nullopt;
  }
}

std::optional<UsbBytes> FakeUsb::configure(int number) {
  if (number == configuration_) return done();
  if (number != 0) {
    const std::uint8_t* const bytes =
        tud_descriptor_configuration_cb(static_cast<std::uint8_t>(number - 1));
    if (bytes == nullptr) return std::nullopt;
  }
  const int address = address_;
  forget();
  address_ = address;
  configuration_ = number;
  if (number == 0) tud_umount_cb();
  return done();
}

std::optional<UsbBytes> FakeUsb::to_interface(const Setup& setup, const UsbBytes& out) {
  if (!configured() || (setup.index & 0xFF) != 0) return std::nullopt;
  if (type_of(setup) == kClass) return to_hid(setup, out);
  if (type_of(setup) != kStandard) return std::nullopt;
  const std::uint8_t alternative = 0;
  switch (setup.request) {
    case kGetInterface:
      return answer(setup, &alternative, 1);
    case kSetInterface:
      return setup.value == 0 ? done() : std::nullopt;
    case kGetDescriptor: {
      const std::uint8_t* const hid = tud_descriptor_configuration_cb(0) + 18;
      if (setup.value >> 8 == 0x21) return answer(setup, hid, hid[0]);
      if (setup.value >> 8 != 0x22) return std::nullopt;
      return answer(setup, tud_hid_descriptor_report_cb(0), std::size_t{hid[7]} + 256U * hid[8]);
    }
    default:
      return std::nullopt;
  }
}

std::optional<UsbBytes> FakeUsb::to_hid(const Setup& setup, const UsbBytes& out) {
  switch (setup.request) {
    case kGetReport:
      return get_report(setup);
    case kSetReport:
      return set_report(setup, out);
    case kSetIdle:
      idle_ = static_cast<std::uint8_t>(setup.value >> 8);
      return done();
    case kGetIdle:
      return answer(setup, &idle_, 1);
    case kGetProtocol:
      return answer(setup, &protocol_, 1);
    case kSetProtocol:
      protocol_ = static_cast<std::uint8_t>(setup.value & 0xFF);
      return done();
    default:
      return std::nullopt;
  }
}

/// Where the host names a report its number goes first, and is sent also where the firmware has
/// nothing to say: an answer of one byte, not a stall.
std::optional<UsbBytes> FakeUsb::get_report(const Setup& setup) {
  const auto id = static_cast<std::uint8_t>(setup.value & 0xFF);
  const auto room = std::min<std::size_t>(setup.length, kBuffer);
  std::size_t size = 0;
  if (id != 0 && room > 1) buffer_[size++] = id;
  size += tud_hid_get_report_cb(0, id, report_type(setup), buffer_.data() + size,
                                static_cast<std::uint16_t>(room - size));
  if (size == 0) return std::nullopt;
  return answer(setup, buffer_.data(), size);
}

/// A host that sends less than it said leaves the rest of the buffer as it was.
std::optional<UsbBytes> FakeUsb::set_report(const Setup& setup, const UsbBytes& out) {
  if (setup.length > kBuffer) return std::nullopt;
  std::optional<UsbBytes> said = done();
  if (reads(setup)) {
    said = answer(setup, buffer_.data(), setup.length);
  } else {
    std::copy_n(out.begin(), std::min<std::size_t>(out.size(), setup.length), buffer_.begin());
  }
  const auto id = static_cast<std::uint8_t>(setup.value & 0xFF);
  const std::size_t skipped = id != 0 && setup.length > 1 && buffer_[0] == id ? 1 : 0;
  tud_hid_set_report_cb(0, id, report_type(setup), buffer_.data() + skipped,
                        static_cast<std::uint16_t>(setup.length - skipped));
  return said;
}

std::optional<UsbBytes> FakeUsb::to_endpoint(const Setup& setup) {
  if (!configured() || type_of(setup) != kStandard) return std::nullopt;
  const int endpoint = setup.index & 0xFF;
  if (endpoint != 0x81 && endpoint != 0x01) return std::nullopt;
  bool& halted = endpoint == 0x81 ? in_halted_ : out_halted_;
  const std::array<std::uint8_t, 2> status = {halted ? std::uint8_t{1} : std::uint8_t{0}, 0};
  switch (setup.request) {
    case kGetStatus:
      return answer(setup, status.data(), status.size());
    case kClearFeature:
    case kSetFeature:
      if (setup.value == kEndpointHalt) halted = setup.request == kSetFeature;
      return done();
    default:
      return std::nullopt;
  }
}

bool FakeUsb::out(const UsbBytes& bytes) {
  if (!configured() || suspended_ || out_halted_ || bytes.size() > kBuffer) return false;
  std::array<std::uint8_t, kBuffer> packet{};
  std::copy(bytes.begin(), bytes.end(), packet.begin());
  tud_hid_set_report_cb(0, 0, HID_REPORT_TYPE_OUTPUT, packet.data(),
                        static_cast<std::uint16_t>(bytes.size()));
  return true;
}

std::optional<UsbBytes> FakeUsb::in() {
  if (!configured() || suspended_ || in_halted_) return std::nullopt;
  std::optional<UsbBytes> packet;
  packet.swap(pending_);
  return packet;
}

bool FakeUsb::send(std::uint8_t id, const std::uint8_t* bytes, int size) {
  if (!ready()) return false;
  UsbBytes packet(bytes, bytes + std::min(size, static_cast<int>(kBuffer) - 1));
  packet.insert(packet.begin(), id);
  pending_ = packet;
  return true;
}

bool FakeUsb::enumerate() {
  plug();
  const bool good = control({0x80, kGetDescriptor, 0x0100, 0, 64}, {}).has_value() &&
                    control({0x00, kSetAddress, 5, 0, 0}, {}).has_value() &&
                    control({0x80, kGetDescriptor, 0x0200, 0, 255}, {}).has_value() &&
                    control({0x00, kSetConfiguration, 1, 0, 0}, {}).has_value();
  return good && control({0x81, kGetDescriptor, 0x2200, 0, 4096}, {}).has_value();
}

}  // namespace batuta::test

using batuta::test::the_bus;

bool tusb_rhport_init(uint8_t /*rhport*/, const tusb_rhport_init_t* /*rh_init*/) {
  return the_bus != nullptr;
}

void dcd_int_handler(uint8_t /*rhport*/) {}

void tud_task_ext(uint32_t /*timeout_ms*/, bool /*in_isr*/) {}

bool tud_mounted(void) {
  return the_bus != nullptr && the_bus->configured();
}

bool tud_suspended(void) {
  return the_bus != nullptr && the_bus->suspended();
}

bool tud_hid_n_ready(uint8_t /*instance*/) {
  return the_bus != nullptr && the_bus->ready();
}

bool tud_hid_n_report(uint8_t /*instance*/, uint8_t report_id, void const* report, uint16_t len) {
  return the_bus != nullptr &&
         the_bus->send(report_id, static_cast<const std::uint8_t*>(report), len);
}
