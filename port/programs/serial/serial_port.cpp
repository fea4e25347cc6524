// SPDX-License-Identifier: MIT

#include "programs/serial/serial_port.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <optional>
#include <system_error>

namespace batuta::host {
namespace {

struct Rate {
  int baud;
  speed_t code;
};

constexpr std::array<Rate, 12> kRates = {{{9600, B9600},
                                          {19200, B19200},
                                          {38400, B38400},
                                          {57600, B57600},
                                          {115200, B115200},
                                          {230400, B230400},
                                          {460800, B460800},
                                          {921600, B921600},
                                          {1000000, B1000000},
                                          {2000000, B2000000},
                                          {3000000, B3000000},
                                          {4000000, B4000000}}};

std::optional<speed_t> code_of(int baud) {
  const auto* const rate = std::find_if(kRates.begin(), kRates.end(),
                                        [baud](const Rate& known) { return known.baud == baud; });
  if (rate == kRates.end()) return std::nullopt;
  return rate->code;
}

/// In the words of the other devices where they have some, else in the system's.
std::string reason(int error) {
  switch (error) {
    case ENOENT:
      return "no such file";
    case EACCES:
      return "no permission to open it (is the user in the group of the device?)";
    case EBUSY:
      return "in use by another program";
    default:
      return "cannot be opened: " + std::generic_category().message(error);
  }
}

/// Eight bits, no parity, one stop bit; no character means anything but itself; no modem lines. At
/// least one byte a read: so that "nothing yet" (EAGAIN) and "gone" (0) are told apart.
termios raw_settings(termios settings, speed_t rate) {
  cfmakeraw(&settings);
  // What it leaves on: the line would be stopped by bytes 0x11 and 0x13, and bytes would be judged
  // by a parity that they do not have.
  settings.c_iflag &= ~static_cast<tcflag_t>(IXOFF | IXANY | INPCK);
  settings.c_cflag |= CLOCAL | CREAD;
  settings.c_cflag &= ~static_cast<tcflag_t>(CSTOPB | CRTSCTS);
  settings.c_cc[VMIN] = 1;
  settings.c_cc[VTIME] = 0;
  cfsetispeed(&settings, rate);
  cfsetospeed(&settings, rate);
  return settings;
}

int baud_of(speed_t code) {
  const auto* const rate = std::find_if(kRates.begin(), kRates.end(),
                                        [code](const Rate& known) { return known.code == code; });
  return rate == kRates.end() ? 0 : rate->baud;
}

/// tcsetattr() succeeds where the line could do anything of what was asked for.
/// @returns an empty text | what it does not do
std::string not_done(int descriptor, int baud) {
  termios now{};
  if (tcgetattr(descriptor, &now) != 0) return reason(errno);
  const std::string rate = std::to_string(baud) + " baud";
  const int out = baud_of(cfgetospeed(&now));
  if (out != baud || baud_of(cfgetispeed(&now)) != baud) {
    const std::string instead = out > 0 && out != baud ? "; it is at " + std::to_string(out) : "";
    return "the line cannot do " + rate + instead;
  }
  const bool plain = (now.c_cflag & CSIZE) == CS8 && (now.c_cflag & (PARENB | CSTOPB)) == 0;
  return plain ? "" : "the line cannot do eight bits without parity at " + rate;
}

bool would_block(int error) {
  return error == EAGAIN || error == EINTR;
}

}  // namespace

OpenedSerialPort SerialPort::open(const std::string& path, int baud) {
  const std::optional<speed_t> rate = code_of(baud);
  if (!rate) return {nullptr, path + ": unknown rate of " + std::to_string(baud) + " baud"};
  const int descriptor = ::open(path.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0) return {nullptr, path + ": " + reason(errno)};
  termios before{};
  if (tcgetattr(descriptor, &before) != 0) {
    ::close(descriptor);
    return {nullptr, path + ": not a serial line"};
  }
  std::unique_ptr<SerialPort> port(new SerialPort(descriptor, before));
  const termios raw = raw_settings(before, *rate);
  if (tcsetattr(descriptor, TCSANOW, &raw) != 0) return {nullptr, path + ": " + reason(errno)};
  const std::string lacking = not_done(descriptor, baud);
  if (!lacking.empty()) return {nullptr, path + ": " + lacking};
  // Best effort, both: a line that cannot do so is a line all the same.
  static_cast<void>(ioctl(descriptor, TIOCEXCL));
  static_cast<void>(tcflush(descriptor, TCIFLUSH));
  return {std::move(port), {}};
}

SerialPort::SerialPort(int descriptor, const termios& before)
    : descriptor_(descriptor), before_(before) {}

SerialPort::~SerialPort() {
  static_cast<void>(ioctl(descriptor_, TIOCNXCL));
  static_cast<void>(tcsetattr(descriptor_, TCSANOW, &before_));
  ::close(descriptor_);
}

bool SerialPort::wait_readable(int timeout_ms) const {
  pollfd wanted{descriptor_, POLLIN, 0};
  return ::poll(&wanted, 1, std::max(timeout_ms, 0)) > 0;
}

int SerialPort::do_read(std::uint8_t* bytes, int capacity) {
  const ssize_t count = ::read(descriptor_, bytes, static_cast<std::size_t>(capacity));
  if (count > 0) return static_cast<int>(count);
  return count < 0 && would_block(errno) ? 0 : -1;
}

int SerialPort::do_write(const std::uint8_t* bytes, int count) {
  const ssize_t taken = ::write(descriptor_, bytes, static_cast<std::size_t>(count));
  return taken > 0 ? static_cast<int>(taken) : 0;
}

}  // namespace batuta::host
