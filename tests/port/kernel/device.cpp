// SPDX-License-Identifier: MIT
// The stick as a program beside the emulator: USB on one socket, and on another one the emulated
// machine's second serial line, by which the program in it moves the stick and reads its force.
// usage: batuta_kernel_device FOLDER; listens on FOLDER/usb and FOLDER/line, says "ready", and ends
// when the emulator does.

#include <fcntl.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstdio>
#include <cstring>
#include <string>

#include "moved_stick.hpp"
#include "shared/hid_pid/report_ids.hpp"
#include "usb_redirection.hpp"

namespace batuta::test {
namespace {

int listen_at(const std::string& path) {
  const int socket = ::socket(AF_UNIX, SOCK_STREAM, 0);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::snprintf(address.sun_path, sizeof address.sun_path, "%s", path.c_str());
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): how sockets take addresses
  const auto* const any = reinterpret_cast<const sockaddr*>(&address);
  const bool good = socket >= 0 && bind(socket, any, sizeof address) == 0 && listen(socket, 1) == 0;
  return good ? socket : -1;
}

int connected(int listening) {
  const int socket = accept(listening, nullptr, nullptr);
  if (socket >= 0) fcntl(socket, F_SETFL, O_NONBLOCK);
  return socket;
}

/// A command a line, an answer a line: what the motor was told, and what has come.
class Line {
 public:
  Line(int socket, MovedStick& stick, UsbRedirection& usb)
      : socket_(socket), stick_(stick), usb_(usb) {}

  /// @returns whether the emulator is still there
  bool read() {
    std::array<char, 256> bytes{};
    const ssize_t size = recv(socket_, bytes.data(), bytes.size(), 0);
    if (size <= 0) return false;
    text_.append(bytes.data(), static_cast<std::size_t>(size));
    for (std::size_t end = 0; (end = text_.find('\n')) != std::string::npos;) {
      const std::string command = text_.substr(0, end);
      text_.erase(0, end + 1);
      if (!obey(command) || !answer()) return false;
    }
    return true;
  }

 private:
  bool obey(const std::string& command) {
    if (command == "plug") {
      usb_.plug();
    } else if (command == "unplug") {
      usb_.unplug();
    } else {
      return move(command);
    }
    return true;
  }

  bool move(const std::string& command) {
    int milliseconds = 0;
    Movement m;
    const int read =
        std::sscanf(command.c_str(), "move %d %lf %lf %lf %lf %lf %lf %x", &milliseconds,
                    &m.from.x(), &m.from.y(), &m.velocity.x(), &m.velocity.y(), &m.acceleration.x(),
                    &m.acceleration.y(), &m.buttons);
    if (read != 8) {
      std::fprintf(stderr, "device: what is \"%s\"?\n", command.c_str());
      return false;
    }
    stick_.move(m, milliseconds);
    return true;
  }

  bool answer() {
    std::array<char, 160> bytes{};
    const pid::DeviceBase& effects = stick_.stick().effects();
    const ForceCommand& force = stick_.force();
    const int size =
        std::snprintf(bytes.data(), bytes.size(), "%.9g %.9g %d %u %u\n",
                      static_cast<double>(force.x), static_cast<double>(force.y), effects.playing(),
                      usb_.count(static_cast<std::uint8_t>(pid::ReportId::kDeviceGain)),
                      effects.counters().refused());
    return send(socket_, bytes.data(), static_cast<std::size_t>(size), MSG_NOSIGNAL) == size;
  }

  int socket_;
  MovedStick& stick_;
  UsbRedirection& usb_;
  std::string text_;
};

int run(const std::string& folder) {
  const int usb_door = listen_at(folder + "/usb");
  const int line_door = listen_at(folder + "/line");
  if (usb_door < 0 || line_door < 0) {
    std::perror("device: the sockets");
    return 1;
  }
  std::puts("ready");
  std::fflush(stdout);
  const int usb_socket = connected(usb_door);
  const int line_socket = connected(line_door);
  FakeUsb bus;
  MovedStick stick;
  UsbRedirection usb(bus, usb_socket);
  Line line(line_socket, stick, usb);
  bool there = true;
  while (there) {
    std::array<pollfd, 2> sockets = {pollfd{usb_socket, POLLIN, 0}, pollfd{line_socket, POLLIN, 0}};
    if (usb.has_output()) sockets[0].events |= POLLOUT;
    if (poll(sockets.data(), sockets.size(), -1) < 0) break;
    if (sockets[0].revents != 0) there = usb.read();
    if (there && sockets[1].revents != 0) there = line.read();
    there = there && usb.write();
  }
  return 0;
}

}  // namespace
}  // namespace batuta::test

int main(int count, char** words) {
  if (count != 2) {
    std::fputs("usage: batuta_kernel_device FOLDER\n", stderr);
    return 2;
  }
  return batuta::test::run(words[1]);
}
