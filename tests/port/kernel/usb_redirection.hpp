// SPDX-License-Identifier: MIT
#pragma once
// The fake bus at the far end of a socket: the usbredir protocol, by which an emulator takes a USB
// device that lives in another program. Every transfer is answered at once.

#include <usbredirparser.h>

#include <array>
#include <memory>

#include "fake_tinyusb.hpp"

namespace batuta::test {

class UsbRedirection {
 public:
  /// @param socket  connected to the emulator, not blocking; outlives this
  UsbRedirection(FakeUsb& bus, int socket);

  /// Puts the stick into the emulator's socket, or takes it out.
  void plug();
  void unplug();
  /// Hands what has come to the bus. @returns whether the emulator is still there
  bool read();
  /// Sends what is queued, and an input report that waits. @returns as read()
  bool write();
  bool has_output() const;
  /// Reports that came to the OUT endpoint, by their number.
  unsigned count(std::uint8_t report) const { return counts_[report]; }

 private:
  struct Destroy {
    void operator()(usbredirparser* parser) const { usbredirparser_destroy(parser); }
  };
  static UsbRedirection& self(void* priv) { return *static_cast<UsbRedirection*>(priv); }

  void set_callbacks();
  void tell_endpoints();
  std::uint8_t standard(std::uint8_t type, std::uint8_t request, int value, int index);
  void configure(std::uint64_t id, std::uint8_t number);
  void control(std::uint64_t id, usb_redir_control_packet_header header, const std::uint8_t* bytes,
               int size);
  void interrupt(std::uint64_t id, usb_redir_interrupt_packet_header header,
                 const std::uint8_t* bytes, int size);
  void receive(std::uint64_t id, std::uint8_t endpoint, bool on);

  FakeUsb& bus_;
  int socket_;
  bool polled_ = false;  ///< the host reads the IN endpoint
  std::array<unsigned, 256> counts_{};
  std::unique_ptr<usbredirparser, Destroy> parser_;
};

}  // namespace batuta::test
