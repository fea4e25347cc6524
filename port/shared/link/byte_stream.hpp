// SPDX-License-Identifier: MIT
#pragma once
// Bytes in and out of a device, as far as the link wants to know: a UART, a tty, a pair of pipes in
// a test. Nothing here blocks and nothing here has a size of its own; what cannot be had now is
// asked for again later.

#include <cstdint>

namespace batuta::link {

/// Both directions of a serial line. Bounds are checked once, here; a port implements do_read() and
/// do_write() only. From one context at a time; ISR-safe where the port says so.
class ByteStream {
 public:
  /// Moves bytes that have arrived into `bytes`. Never blocks.
  /// @param[out] bytes  room for `capacity` bytes; not touched beyond what is returned
  /// @returns 0 ... capacity: how many came; 0 also where capacity <= 0 or `bytes` is null |
  ///   -1: the stream is gone, and nothing will come any more
  int read(std::uint8_t* bytes, int capacity);

  /// Hands bytes over for sending, in their order. Never blocks.
  /// @returns 0 ... count: how many were taken, from the first on; the caller keeps the rest. A
  ///   stream that is gone takes none.
  int write(const std::uint8_t* bytes, int count);

 protected:
  ByteStream() = default;
  ~ByteStream() = default;
  ByteStream(const ByteStream&) = default;
  ByteStream& operator=(const ByteStream&) = default;

 private:
  /// @pre bytes is not null, capacity > 0. @returns as read()
  virtual int do_read(std::uint8_t* bytes, int capacity) = 0;
  /// @pre bytes is not null, count > 0. @returns as write()
  virtual int do_write(const std::uint8_t* bytes, int count) = 0;
};

}  // namespace batuta::link
