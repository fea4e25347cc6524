// SPDX-License-Identifier: MIT
#pragma once
// Consistent Overhead Byte Stuffing: bytes without a zero in them, so that a zero can end a frame.
// Source: S. Cheshire and M. Baker, "Consistent Overhead Byte Stuffing", IEEE/ACM Transactions on
// Networking 7(2), 1999. The decoder is part of FrameDecoder, which works byte by byte.

#include <cstdint>

namespace batuta::link {

/// Up to here the overhead is one byte, and a block never reaches the length that needs a code of
/// its own.
inline constexpr int kMaxCobsInput = 253;

/// @param[out] out  room for count + 1 bytes, apart from `bytes`
/// @pre 0 <= count <= kMaxCobsInput
/// @returns bytes written: count + 1
/// Bound: count. Allocates: never. ISR-safe: yes.
int cobs_encode(const std::uint8_t* bytes, int count, std::uint8_t* out);

}  // namespace batuta::link
