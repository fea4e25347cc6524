// SPDX-License-Identifier: MIT
#pragma once
// Frames on their way to a stream that takes a few bytes at a time. A frame is taken whole or not
// at all, so a full ring costs frames, never the framing.

#include "batuta/core/status.hpp"
#include "shared/link/byte_stream.hpp"
#include "shared/link/frame.hpp"

namespace batuta::link {

/// What does not depend on the size of the ring. From one context at a time.
class SenderBase {
 public:
  SenderBase(const SenderBase&) = delete;
  SenderBase& operator=(const SenderBase&) = delete;

  /// Queues a message; nothing is written before pump(). A refused one uses up no sequence number.
  /// @returns kOk | kPoolFull: no room, counted in refused() | kInvalidArgument: a field out of its
  ///   range, counted in invalid()
  template <class Message>
  Status send(const Message& message) {
    Payload payload;
    if (!encode(message, payload)) return refuse_invalid();
    return queue(Message::kType, payload);
  }

  /// Moves what the stream takes now. Never blocks. @returns bytes moved
  /// Bound: two writes.
  int pump(ByteStream& stream);

  /// Forgets what is queued: what was begun on the wire is then torn, and will be rejected there.
  void clear();

  int pending() const { return used_; }           ///< bytes
  int room() const { return capacity_ - used_; }  ///< bytes
  std::uint32_t sent() const { return sent_; }    ///< frames queued
  std::uint32_t refused() const { return refused_; }
  std::uint32_t invalid() const { return invalid_; }

 protected:
  SenderBase(std::uint8_t* ring, int capacity) : ring_(ring), capacity_(capacity) {}
  ~SenderBase() = default;

 private:
  Status refuse_invalid();
  Status queue(MessageType type, const Payload& payload);
  int write_front(ByteStream& stream);

  std::uint8_t* ring_;
  int capacity_;
  int first_ = 0;  ///< where the oldest byte lies
  int used_ = 0;
  FrameEncoder encoder_;
  std::uint32_t sent_ = 0;
  std::uint32_t refused_ = 0;
  std::uint32_t invalid_ = 0;
};

/// Comes before SenderBase among the bases, so that it exists when that learns its address.
template <int kBytes>
struct SenderRing {
  std::array<std::uint8_t, static_cast<std::size_t>(kBytes)> bytes{};
};

/// A sender with room for kBytes bytes; a frame takes kMaxWireFrame of them at most.
template <int kBytes>
class Sender final : private SenderRing<kBytes>, public SenderBase {
  static_assert(kBytes >= kMaxWireFrame, "Sender: room for one frame at least");

 public:
  Sender() : SenderBase(SenderRing<kBytes>::bytes.data(), kBytes) {}
};

}  // namespace batuta::link
