// SPDX-License-Identifier: MIT

#include "shared/link/cobs.hpp"

namespace batuta::link {

int cobs_encode(const std::uint8_t* bytes, int count, std::uint8_t* out) {
  int code_at = 0;  // where the length of the block that is being written will stand
  int end = 1;
  for (int i = 0; i < count; ++i) {  // Bound: count
    if (bytes[i] != 0) {
      out[end] = bytes[i];
    } else {
      out[code_at] = static_cast<std::uint8_t>(end - code_at);
      code_at = end;
    }
    ++end;
  }
  out[code_at] = static_cast<std::uint8_t>(end - code_at);
  return end;
}

}  // namespace batuta::link
