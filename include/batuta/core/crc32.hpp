// SPDX-License-Identifier: MIT
#pragma once
// The CRC-32 of Ethernet, zlib and PNG: polynomial 0x04C11DB7, bits reflected, start and final
// exclusive-or 0xFFFFFFFF; 0xCBF43926 for "123456789". Why this one: port/shared/link/link.md.

#include <cstdint>

#include "batuta/core/assert.hpp"

namespace batuta {

/// Bound: two table look-ups a byte. Allocates: never. ISR-safe: yes.
std::uint32_t crc32(const std::uint8_t* bytes, int count);

}  // namespace batuta
