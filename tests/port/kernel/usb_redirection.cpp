// SPDX-License-Identifier: MIT

#include "usb_redirection.hpp"

#include <sys/socket.h>

#include <cerrno>
#include <cstdio>

#include "shared/usb_stick/descriptors.hpp"

namespace batuta::test {
namespace {

constexpr std::uint8_t kSetConfiguration = 9;
constexpr std::uint8_t kSetInterface = 11;
constexpr std::uint8_t kFromHost = 0x00;
constexpr std::uint8_t kFromHostToInterface = 0x01;
constexpr std::uint8_t kToHost = 0x80;
/// usbredir counts the endpoints: OUT from 0, IN from 16.
constexpr std::size_t kOutPlace = usb::kEndpointOut;
constexpr std::size_t kInPlace = 16U + (usb::kEndpointIn & 0x0FU);

void log(void* /*priv*/, int level, const char* message) {
  if (level <= usbredirparser_warning) std::fprintf(stderr, "usbredir: %s\n", message);
}

/// As the parser wants it: 0 where nothing can be moved now, -1 at the end.
int moved(ssize_t bytes) {
  if (bytes > 0) return static_cast<int>(bytes);
  return bytes < 0 && (errno == EAGAIN || errno == EINTR) ? 0 : -1;
}

}  // namespace

UsbRedirection::UsbRedirection(FakeUsb& bus, int socket)
    : bus_(bus), socket_(socket), parser_(usbredirparser_create()) {
  parser_->priv = this;
  set_callbacks();
  std::array<std::uint32_t, USB_REDIR_CAPS_SIZE> able{};
  for (const int ability :
       {usb_redir_cap_connect_device_version, usb_redir_cap_device_disconnect_ack,
        usb_redir_cap_ep_info_max_packet_size, usb_redir_cap_64bits_ids,
        usb_redir_cap_32bits_bulk_length}) {
    usbredirparser_caps_set_cap(able.data(), ability);
  }
  usbredirparser_init(parser_.get(), "batuta", able.data(), USB_REDIR_CAPS_SIZE,
                      usbredirparser_fl_usb_host);
}

/// Of the packets of devices without bulk and isochronous endpoints. A packet's bytes are ours.
void UsbRedirection::set_callbacks() {
  usbredirparser& p = *parser_;
  p.log_func = log;
  p.read_func = [](void* priv, std::uint8_t* bytes, int size) {
    return moved(recv(self(priv).socket_, bytes, static_cast<std::size_t>(size), 0));
  };
  p.write_func = [](void* priv, std::uint8_t* bytes, int size) {
    return moved(send(self(priv).socket_, bytes, static_cast<std::size_t>(size), MSG_NOSIGNAL));
  };
  p.hello_func = [](void* priv, usb_redir_hello_header*) { self(priv).plug(); };
  p.reset_func = [](void* priv) { self(priv).bus_.plug(); };
  p.set_configuration_func = [](void* priv, std::uint64_t id,
                                usb_redir_set_configuration_header* asked) {
    self(priv).configure(id, asked->configuration);
  };
  p.get_configuration_func = [](void* priv, std::uint64_t id) {
    usb_redir_configuration_status_header status{};
    status.configuration = self(priv).bus_.configured() ? 1 : 0;
    usbredirparser_send_configuration_status(self(priv).parser_.get(), id, &status);
  };
  p.set_alt_setting_func = [](void* priv, std::uint64_t id,
                              usb_redir_set_alt_setting_header* asked) {
    usb_redir_alt_setting_status_header status{};
    status.interface = asked->interface;
    status.alt = asked->alt;
    status.status =
        self(priv).standard(kFromHostToInterface, kSetInterface, asked->alt, asked->interface);
    usbredirparser_send_alt_setting_status(self(priv).parser_.get(), id, &status);
  };
  p.get_alt_setting_func = [](void* priv, std::uint64_t id,
                              usb_redir_get_alt_setting_header* asked) {
    usb_redir_alt_setting_status_header status{};
    status.interface = asked->interface;
    usbredirparser_send_alt_setting_status(self(priv).parser_.get(), id, &status);
  };
  p.start_interrupt_receiving_func = [](void* priv, std::uint64_t id,
                                        usb_redir_start_interrupt_receiving_header* asked) {
    self(priv).receive(id, asked->endpoint, true);
  };
  p.stop_interrupt_receiving_func = [](void* priv, std::uint64_t id,
                                       usb_redir_stop_interrupt_receiving_header* asked) {
    self(priv).receive(id, asked->endpoint, false);
  };
  p.control_packet_func = [](void* priv, std::uint64_t id, usb_redir_control_packet_header* header,
                             std::uint8_t* bytes, int size) {
    self(priv).control(id, *header, bytes, size);
    usbredirparser_free_packet_data(self(priv).parser_.get(), bytes);
  };
  p.interrupt_packet_func = [](void* priv, std::uint64_t id,
                               usb_redir_interrupt_packet_header* header, std::uint8_t* bytes,
                               int size) {
    self(priv).interrupt(id, *header, bytes, size);
    usbredirparser_free_packet_data(self(priv).parser_.get(), bytes);
  };
  p.cancel_data_packet_func = [](void*, std::uint64_t) {};  // it was answered before
  p.device_disconnect_ack_func = [](void*) {};
}

/// The emulator wants to know them before it connects, and anew for each configuration.
void UsbRedirection::tell_endpoints() {
  usb_redir_interface_info_header interfaces{};
  interfaces.interface_count = 1;
  interfaces.interface_class[0] = usb::descriptor::kHidClass;
  usb_redir_ep_info_header endpoints{};
  for (std::uint8_t& type : endpoints.type) type = usb_redir_type_invalid;
  endpoints.type[0] = endpoints.type[16] = usb_redir_type_control;
  endpoints.max_packet_size[0] = endpoints.max_packet_size[16] = usb::kPacket;
  for (const std::size_t place : {kOutPlace, kInPlace}) {
    endpoints.type[place] = usb_redir_type_interrupt;
    endpoints.interval[place] = usb::kIntervalMs;
    endpoints.max_packet_size[place] = usb::kPacket;
  }
  usbredirparser_send_interface_info(parser_.get(), &interfaces);
  usbredirparser_send_ep_info(parser_.get(), &endpoints);
}

void UsbRedirection::plug() {
  bus_.plug();
  tell_endpoints();
  usb_redir_device_connect_header device{};
  device.speed = usb_redir_speed_full;
  device.vendor_id = usb::kVendor;
  device.product_id = usb::kProduct;
  device.device_version_bcd = usb::kRelease;
  usbredirparser_send_device_connect(parser_.get(), &device);
}

void UsbRedirection::unplug() {
  polled_ = false;
  bus_.unplug();
  usbredirparser_send_device_disconnect(parser_.get());
}

/// A request that the protocol has a packet of its own for, as the control transfer that it is.
std::uint8_t UsbRedirection::standard(std::uint8_t type, std::uint8_t request, int value,
                                      int index) {
  const Setup setup{type, request, static_cast<std::uint16_t>(value),
                    static_cast<std::uint16_t>(index), 0};
  return bus_.control(setup, {}).has_value() ? usb_redir_success : usb_redir_stall;
}

void UsbRedirection::configure(std::uint64_t id, std::uint8_t number) {
  usb_redir_configuration_status_header status{};
  status.configuration = number;
  status.status = standard(kFromHost, kSetConfiguration, number, 0);
  tell_endpoints();
  usbredirparser_send_configuration_status(parser_.get(), id, &status);
}

void UsbRedirection::control(std::uint64_t id, usb_redir_control_packet_header header,
                             const std::uint8_t* bytes, int size) {
  const Setup setup{header.requesttype, header.request, header.value, header.index, header.length};
  std::optional<UsbBytes> said = bus_.control(setup, UsbBytes(bytes, bytes + size));
  header.status = said.has_value() ? usb_redir_success : usb_redir_stall;
  const bool reads = (header.requesttype & kToHost) != 0;
  if (!said.has_value()) said = UsbBytes();
  if (reads) header.length = static_cast<std::uint16_t>(said->size());
  usbredirparser_send_control_packet(parser_.get(), id, &header, said->data(),
                                     reads ? static_cast<int>(said->size()) : 0);
}

void UsbRedirection::interrupt(std::uint64_t id, usb_redir_interrupt_packet_header header,
                               const std::uint8_t* bytes, int size) {
  const bool taken = bus_.out(UsbBytes(bytes, bytes + size));
  header.status = taken ? usb_redir_success : usb_redir_stall;
  if (taken && size > 0) ++counts_[bytes[0]];
  usbredirparser_send_interrupt_packet(parser_.get(), id, &header, nullptr, 0);
}

void UsbRedirection::receive(std::uint64_t id, std::uint8_t endpoint, bool on) {
  polled_ = on;
  usb_redir_interrupt_receiving_status_header status{};
  status.endpoint = endpoint;
  usbredirparser_send_interrupt_receiving_status(parser_.get(), id, &status);
}

bool UsbRedirection::read() {
  return usbredirparser_do_read(parser_.get()) != usbredirparser_read_io_error;
}

bool UsbRedirection::write() {
  std::optional<UsbBytes> report;
  if (polled_) report = bus_.in();
  if (report.has_value()) {
    usb_redir_interrupt_packet_header header{};
    header.endpoint = usb::kEndpointIn;
    header.length = static_cast<std::uint16_t>(report->size());
    usbredirparser_send_interrupt_packet(parser_.get(), 0, &header, report->data(),
                                         static_cast<int>(report->size()));
  }
  return usbredirparser_do_write(parser_.get()) == 0;
}

bool UsbRedirection::has_output() const {
  return usbredirparser_has_data_to_write(parser_.get()) > 0;
}

}  // namespace batuta::test
