// SPDX-License-Identifier: MIT
#pragma once
// A message on the wire: 0x00, COBS of [version, type, sequence number, payload, CRC-32], 0x00. The
// delimiter comes at both ends, so that noise between two frames costs neither of them. Layout:
// link.md.

#include "shared/link/messages.hpp"

namespace batuta::link {

inline constexpr int kHeaderBytes = 4;  ///< version, type, sequence number
inline constexpr int kCrcBytes = 4;
inline constexpr int kMinRawFrame = kHeaderBytes + kCrcBytes;
inline constexpr int kMaxRawFrame = kMinRawFrame + kMaxPayload;
/// With the byte of COBS and both delimiters.
inline constexpr int kMaxWireFrame = kMaxRawFrame + 3;

/// A frame whose wrapping is off. The payload belongs to somebody else.
struct Frame {
  MessageType type = MessageType::kHello;
  std::uint16_t sequence = 0;
  const std::uint8_t* payload = nullptr;
  int size = 0;  ///< of the payload, bytes
};

/// Reads the message of a frame. @returns false: another type, or not valid; `message` is unchanged
template <class Message>
bool read_message(const Frame& frame, Message& message) {
  return frame.type == Message::kType && decode(frame.payload, frame.size, message);
}

/// Wraps a frame.
/// @param[out] wire  room for `capacity` bytes
/// @returns bytes written | 0: no room, or the payload is too long; nothing was written
/// Bound: kMaxWireFrame bytes. Allocates: never. ISR-safe: yes.
int encode_frame(const Frame& frame, std::uint8_t* wire, int capacity);

/// Wraps one message after the other, and numbers them.
class FrameEncoder {
 public:
  /// @returns bytes written | 0: a field out of its range, or no room: no number was used up
  template <class Message>
  int encode(const Message& message, std::uint8_t* wire, int capacity) {
    Payload payload;
    if (!link::encode(message, payload)) return 0;
    return wrap(Message::kType, payload, wire, capacity);
  }

  /// The same for a message that is bytes already.
  int wrap(MessageType type, const Payload& payload, std::uint8_t* wire, int capacity);

  /// Of the next frame.
  std::uint16_t sequence() const { return sequence_; }

 private:
  std::uint16_t sequence_ = 0;
};

}  // namespace batuta::link
