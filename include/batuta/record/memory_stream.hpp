// SPDX-License-Identifier: MIT
#pragma once
// Bytes in memory as source and sink: a recording in flash, or in RAM until somebody fetches it.

#include <cstring>

#include "batuta/core/types.hpp"
#include "batuta/port/byte_stream.hpp"

namespace batuta {

/// Gives `size` bytes, none where that is below zero, then says that it is at its end.
class MemorySource final : public ByteSource {
 public:
  /// From the bytes of the caller, which stay as long as the source is used.
  MemorySource(const std::uint8_t* bytes, int size) : bytes_(bytes), size_(max_of(size, 0)) {}

 private:
  int do_read(std::uint8_t* bytes, int capacity) override {
    if (at_ == size_) return -1;
    const int count = min_of(capacity, size_ - at_);
    std::memcpy(bytes, bytes_ + at_, static_cast<std::size_t>(count));
    at_ += count;
    return count;
  }

  const std::uint8_t* bytes_;
  int size_;
  int at_ = 0;
};

/// Takes up to `capacity` bytes, and no more; none where that is below zero.
class MemorySink final : public ByteSink {
 public:
  /// Into the bytes of the caller, which stay as long as the sink is used.
  MemorySink(std::uint8_t* bytes, int capacity) : bytes_(bytes), capacity_(max_of(capacity, 0)) {}
  /// Bytes taken so far.
  int size() const { return size_; }

 private:
  int do_write(const std::uint8_t* bytes, int count) override {
    const int taken = min_of(count, capacity_ - size_);
    std::memcpy(bytes_ + size_, bytes, static_cast<std::size_t>(taken));
    size_ += taken;
    return taken;
  }

  std::uint8_t* bytes_;
  int capacity_;
  int size_ = 0;
};

}  // namespace batuta
