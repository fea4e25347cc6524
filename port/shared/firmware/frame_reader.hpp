// SPDX-License-Identifier: MIT
#pragma once
// Frames out of a stream, so many bytes a tick and no more: a host that talks too much makes the
// device slow to listen, never late.

#include "shared/link/byte_stream.hpp"
#include "shared/link/frame_decoder.hpp"

namespace batuta::firmware {

template <link::End kEnd>
class FrameReader {
 public:
  /// What is taken in one tick: two of the longest frames, so that the device catches up after a
  /// pause.
  static constexpr int kBytesPerTick = 2 * link::kMaxWireFrame;

  /// A new tick: its bytes may be read.
  void begin_tick() { budget_ = kBytesPerTick; }

  /// The next frame, or null if there is none yet or the tick's bytes are used up. Valid until the
  /// next call.
  /// Bound: kBytesPerTick bytes in all calls of a tick.
  const link::Frame* next(link::ByteStream& stream) {
    while (budget_ > 0) {  // Bound: kBytesPerTick
      if (next_ == size_ && !refill(stream)) return nullptr;
      --budget_;
      const std::uint8_t byte = chunk_[static_cast<std::size_t>(next_++)];
      if (decoder_.push(byte) == link::Arrival::kFrame) return &decoder_.frame();
    }
    return nullptr;
  }

  const link::LinkCounters& counters() const { return decoder_.counters(); }
  /// Of the protocol, in the frame that was last rejected for it.
  int other_version() const { return decoder_.other_version(); }
  /// The tick's bytes were used up before those that had been read.
  bool holds_bytes() const { return next_ != size_; }
  /// The stream has said that nothing will come any more.
  bool is_gone() const { return gone_; }

 private:
  bool refill(link::ByteStream& stream) {
    const int count = stream.read(chunk_.data(), static_cast<int>(chunk_.size()));
    gone_ = count < 0;
    next_ = 0;
    size_ = gone_ ? 0 : count;
    return size_ > 0;
  }

  link::FrameDecoder<kEnd> decoder_;
  std::array<std::uint8_t, 32> chunk_{};
  int next_ = 0;  ///< in chunk_
  int size_ = 0;  ///< of chunk_
  int budget_ = 0;
  bool gone_ = false;
};

}  // namespace batuta::firmware
