// SPDX-License-Identifier: MIT
#pragma once
// A tty or pty as a stream of bytes: raw, nothing translated, nothing waited for.

#include <termios.h>

#include <memory>
#include <string>

#include "shared/link/byte_stream.hpp"

namespace batuta::host {

class SerialPort;

struct OpenedSerialPort {
  std::unique_ptr<SerialPort> port;  ///< null if it could not be opened
  std::string error;                 ///< why not, in one line: "<path>: ..."
};

/// Rates that open() knows, baud: 9600 doubled up to 38400, 57600 doubled up to 921600, and 1, 2, 3
/// and 4 million. A pty and a USB line take any of them, and go as fast as they go; a line that
/// cannot do one of them is refused.
inline constexpr int kDefaultBaud = 115200;

/// Its own for as long as it lives: a second program is refused where the system can do so. What
/// was received before is thrown away. The line's settings are put back at the end.
class SerialPort final : public link::ByteStream {
 public:
  static OpenedSerialPort open(const std::string& path, int baud = kDefaultBaud);

  ~SerialPort();
  SerialPort(const SerialPort&) = delete;
  SerialPort& operator=(const SerialPort&) = delete;

  /// Waits until read() has something to say, bytes or that the line is gone, for `timeout_ms` at
  /// most; 0 or less: not at all. @returns false: the time is over
  bool wait_readable(int timeout_ms) const;

 private:
  SerialPort(int descriptor, const termios& before);
  int do_read(std::uint8_t* bytes, int capacity) override;
  int do_write(const std::uint8_t* bytes, int count) override;

  int descriptor_;
  termios before_;
};

}  // namespace batuta::host
