// SPDX-License-Identifier: MIT
#pragma once
// What TinyUSB's device core and its HID class do with a bus: they hand transfers to the callbacks
// that the firmware defines. Written after how TinyUSB 0.18 behaves: usbd.c, usbd_control.c,
// hid_device.c.

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace batuta::test {

using UsbBytes = std::vector<std::uint8_t>;

/// A control transfer's first eight bytes: USB 2.0, table 9-2.
struct Setup {
  std::uint8_t request_type = 0;
  std::uint8_t request = 0;
  std::uint16_t value = 0;
  std::uint16_t index = 0;
  std::uint16_t length = 0;
};

/// One at a time: TinyUSB is one, too. Callbacks come at once, not at the next tud_task().
class FakeUsb {
 public:
  FakeUsb();
  ~FakeUsb();
  FakeUsb(const FakeUsb&) = delete;
  FakeUsb& operator=(const FakeUsb&) = delete;
  FakeUsb(FakeUsb&&) = delete;
  FakeUsb& operator=(FakeUsb&&) = delete;

  /// A bus reset: not configured any more. TinyUSB tells the firmware nothing of it.
  void plug();
  void unplug();
  void suspend();
  void resume();

  /// A control transfer. @param out  the data stage that the host sends
  /// @returns what the host gets, empty where it only sends | nothing: stalled, or nobody answers
  std::optional<UsbBytes> control(const Setup& setup, const UsbBytes& out);
  /// Interrupt OUT, endpoint 0x01, report number first. @returns whether the endpoint took it
  bool out(const UsbBytes& bytes);
  /// Interrupt IN, endpoint 0x81, report number first. @returns nothing: there is none
  std::optional<UsbBytes> in();

  /// Address and configuration as an operating system gives them. @returns whether nothing stalled
  bool enumerate();

  bool configured() const { return configuration_ != 0; }
  bool suspended() const { return suspended_; }
  int address() const { return address_; }
  /// For the functions of tusb.h.
  bool ready() const { return configured() && !suspended_ && !in_halted_ && !pending_.has_value(); }
  bool send(std::uint8_t id, const std::uint8_t* bytes, int size);

 private:
  static constexpr std::size_t kBuffer = 64;  ///< CFG_TUD_HID_EP_BUFSIZE

  std::optional<UsbBytes> to_device(const Setup& setup);
  std::optional<UsbBytes> to_interface(const Setup& setup, const UsbBytes& out);
  std::optional<UsbBytes> to_endpoint(const Setup& setup);
  std::optional<UsbBytes> to_hid(const Setup& setup, const UsbBytes& out);
  std::optional<UsbBytes> get_descriptor(const Setup& setup) const;
  std::optional<UsbBytes> get_report(const Setup& setup);
  std::optional<UsbBytes> set_report(const Setup& setup, const UsbBytes& out);
  std::optional<UsbBytes> configure(int number);
  void forget();

  std::array<std::uint8_t, kBuffer> buffer_{};  ///< of control transfers: keeps what it had
  std::optional<UsbBytes> pending_;
  std::uint8_t idle_ = 0;
  std::uint8_t protocol_ = 1;
  int address_ = 0;
  int configuration_ = 0;
  bool plugged_ = false;
  bool suspended_ = false;
  bool in_halted_ = false;
  bool out_halted_ = false;
};

}  // namespace batuta::test
