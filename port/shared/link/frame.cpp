// SPDX-License-Identifier: MIT

#include "shared/link/frame.hpp"

#include <algorithm>

#include "shared/link/cobs.hpp"
#include "shared/link/crc32.hpp"
#include "shared/link/fields.hpp"

namespace batuta::link {

static_assert(kMaxRawFrame <= kMaxCobsInput, "a frame must fit into short blocks of COBS");

int encode_frame(const Frame& frame, std::uint8_t* wire, int capacity) {
  if (frame.size < 0 || frame.size > kMaxPayload) return 0;
  if (capacity < kMinRawFrame + frame.size + 3) return 0;
  std::array<std::uint8_t, kMaxRawFrame> raw;
  Fields header = Fields::writer(raw.data(), kHeaderBytes);
  std::uint8_t version = kProtocolVersion;
  auto type = static_cast<std::uint8_t>(frame.type);
  std::uint16_t sequence = frame.sequence;
  header.u8(version);
  header.u8(type);
  header.u16(sequence);
  std::copy_n(frame.payload, frame.size, raw.data() + kHeaderBytes);
  const int crc_at = kHeaderBytes + frame.size;
  std::uint32_t crc = crc32(raw.data(), crc_at);
  Fields::writer(raw.data() + crc_at, kCrcBytes).u32(crc);
  wire[0] = 0;
  const int end = 1 + cobs_encode(raw.data(), crc_at + kCrcBytes, wire + 1);
  wire[end] = 0;
  return end + 1;
}

int FrameEncoder::wrap(MessageType type, const Payload& payload, std::uint8_t* wire, int capacity) {
  const int count =
      encode_frame({type, sequence_, payload.bytes.data(), payload.size}, wire, capacity);
  if (count > 0) ++sequence_;
  return count;
}

}  // namespace batuta::link
