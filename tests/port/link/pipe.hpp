// SPDX-License-Identifier: MIT
#pragma once
// A stream in memory that takes as much as a test wants it to take.

#include <algorithm>
#include <vector>

#include "shared/link/byte_stream.hpp"

namespace batuta::link::test {

class Pipe final : public ByteStream {
 public:
  std::vector<std::uint8_t> bytes;  ///< written, and not yet read
  int room = 1'000'000;             ///< what it still takes

 private:
  int do_read(std::uint8_t* out, int capacity) override {
    const int count = std::min(capacity, static_cast<int>(bytes.size()));
    std::copy_n(bytes.begin(), count, out);
    bytes.erase(bytes.begin(), bytes.begin() + count);
    return count;
  }
  int do_write(const std::uint8_t* in, int count) override {
    const int taken = std::min(count, room);
    bytes.insert(bytes.end(), in, in + taken);
    room -= taken;
    return taken;
  }
};

}  // namespace batuta::link::test
