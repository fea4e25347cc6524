// SPDX-License-Identifier: MIT
#pragma once
// Frames as tests want them: made by hand or by the library, and what came out at the other end.

#include <gtest/gtest.h>

#include <algorithm>
#include <initializer_list>

#include "any_message.hpp"
#include "shared/link/crc32.hpp"
#include "shared/link/frame_decoder.hpp"

namespace batuta::link::test {

/// COBS by its definition: a zero is put behind the bytes, and each stretch up to a zero is sent as
/// its length, the zero included, and its bytes. For less than 254 bytes.
inline Bytes stuffed(Bytes bytes) {
  bytes.push_back(0);
  Bytes out;
  auto begin = bytes.begin();
  while (begin != bytes.end()) {
    const auto zero = std::find(begin, bytes.end(), std::uint8_t{0});
    out.push_back(static_cast<std::uint8_t>(zero - begin + 1));
    out.insert(out.end(), begin, zero);
    begin = zero + 1;
  }
  return out;
}

/// What lies under COBS, with the check sum at its end.
inline Bytes raw_frame(std::uint8_t version, std::uint8_t type, std::uint16_t sequence,
                       const Bytes& payload) {
  Bytes raw(4 + payload.size());
  raw[0] = version;
  raw[1] = type;
  raw[2] = static_cast<std::uint8_t>(sequence & 0xFFU);
  raw[3] = static_cast<std::uint8_t>(sequence >> 8U);
  std::copy(payload.begin(), payload.end(), raw.begin() + 4);
  std::uint32_t crc = crc32(raw.data(), static_cast<int>(raw.size()));
  for (int i = 0; i < 4; ++i, crc >>= 8U) raw.push_back(static_cast<std::uint8_t>(crc & 0xFFU));
  return raw;
}

/// Between delimiters.
inline Bytes delimited(const Bytes& inside) {
  Bytes wire(inside.size() + 2, 0);
  std::copy(inside.begin(), inside.end(), wire.begin() + 1);
  return wire;
}

inline Bytes wire_of(std::uint8_t type, std::uint16_t sequence, const Bytes& payload) {
  return delimited(stuffed(raw_frame(kProtocolVersion, type, sequence, payload)));
}

inline Bytes wire_of(const AnyMessage& message, std::uint16_t sequence) {
  const Bytes payload = std::visit([](const auto& m) { return expected_payload(m); }, message);
  return wire_of(static_cast<std::uint8_t>(type_of(message)), sequence, payload);
}

inline Bytes joined(std::initializer_list<Bytes> parts) {
  Bytes all;
  for (const Bytes& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

/// Stretches of at least one byte that a delimiter has ended.
inline std::uint32_t stretches(const Bytes& wire) {
  std::uint32_t count = 0;
  for (std::size_t i = 1; i < wire.size(); ++i) {
    if (wire[i] == 0 && wire[i - 1] != 0) ++count;
  }
  return count;
}

struct Received {
  MessageType type;
  std::uint16_t sequence;
  Bytes payload;

  friend bool operator==(const Received& a, const Received& b) {
    return a.type == b.type && a.sequence == b.sequence && a.payload == b.payload;
  }
};

inline Received received(const AnyMessage& message, std::uint16_t sequence) {
  return {type_of(message), sequence,
          std::visit([](const auto& m) { return expected_payload(m); }, message)};
}

/// Both ends listen to the same line; a message is for one of them.
template <class Decoder>
std::vector<Received> receive(Decoder& decoder, const Bytes& wire) {
  std::vector<Received> all;
  for (const std::uint8_t byte : wire) {
    if (decoder.push(byte) != Arrival::kFrame) continue;
    const Frame& frame = decoder.frame();
    all.push_back({frame.type, frame.sequence, Bytes(frame.payload, frame.payload + frame.size)});
  }
  return all;
}

/// Calls use(decoder) with a new decoder of the end that takes such a message.
template <class Use>
void with_decoder_for(const AnyMessage& message, const Use& use) {
  if (is_from_device(type_of(message))) {
    HostDecoder decoder;
    use(decoder);
  } else {
    DeviceDecoder decoder;
    use(decoder);
  }
}

}  // namespace batuta::link::test
