// SPDX-License-Identifier: MIT
// The one place where what a stream claims is checked, whatever the port: a count that cannot be
// true must not become an index.

#include "shared/link/byte_stream.hpp"

namespace batuta::link {

int ByteStream::read(std::uint8_t* bytes, int capacity) {
  if (bytes == nullptr || capacity <= 0) return 0;
  const int count = do_read(bytes, capacity);
  return count >= 0 && count <= capacity ? count : -1;
}

int ByteStream::write(const std::uint8_t* bytes, int count) {
  if (bytes == nullptr || count <= 0) return 0;
  const int taken = do_write(bytes, count);
  return taken >= 0 && taken <= count ? taken : 0;
}

}  // namespace batuta::link
