// SPDX-License-Identifier: MIT
#pragma once
// Bytes out of and into the library, for recordings: a file, a flash memory, a serial line. Nothing
// here blocks; what cannot be had now is asked for again later.

#include <cstdint>

#include "batuta/core/assert.hpp"

namespace batuta {

/// Takes bytes. Bounds are checked once, here; a port implements do_write() only. From one context
/// at a time.
class ByteSink {
 public:
  /// Hands bytes over, in their order. Never blocks.
  /// @returns 0 ... count: how many were taken, from the first on; the caller keeps the rest. A
  ///   sink that is gone or full takes none.
  int write(const std::uint8_t* bytes, int count);

 protected:
  ByteSink() = default;
  ~ByteSink() = default;
  /// Copied only with what derives from it.
  ByteSink(const ByteSink&) = default;
  /// Copied only with what derives from it.
  ByteSink& operator=(const ByteSink&) = default;

 private:
  /// @pre bytes is not null, count > 0. @returns as write()
  virtual int do_write(const std::uint8_t* bytes, int count) = 0;
};

/// Gives bytes; a port implements do_read() only. From one context at a time.
class ByteSource {
 public:
  /// Takes over what has come.
  /// @param[out] bytes  room for `capacity` bytes; not touched beyond what is returned
  /// @returns 0 ... capacity: how many came; 0: none at present | -1: none will come any more
  int read(std::uint8_t* bytes, int capacity);

 protected:
  ByteSource() = default;
  ~ByteSource() = default;
  /// Copied only with what derives from it.
  ByteSource(const ByteSource&) = default;
  /// Copied only with what derives from it.
  ByteSource& operator=(const ByteSource&) = default;

 private:
  /// @pre bytes is not null, capacity > 0. @returns as read()
  virtual int do_read(std::uint8_t* bytes, int capacity) = 0;
};

}  // namespace batuta
