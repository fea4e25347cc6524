// SPDX-License-Identifier: MIT
#pragma once
// From bytes to frames, byte by byte, as an interrupt delivers them. Whatever comes, the decoder is
// in step again after the next delimiter; whatever is wrong is rejected and counted, once.

#include "shared/link/frame.hpp"

namespace batuta::link {

/// Which end of the line the decoder stands at: it takes only what the other end may send.
enum class End : std::uint8_t { kDevice, kHost };

/// Why a frame was rejected. Checked in this order; the first reason counts.
enum class Rejection : std::uint8_t {
  kTooLong,   ///< more than kMaxRawFrame bytes, after unstuffing, before the delimiter
  kBadCobs,   ///< the delimiter came inside a block
  kTooShort,  ///< less than a header and a CRC
  kCrc,       ///< damaged
  kVersion,   ///< intact, but of another version of the protocol
  kType,      ///< intact, but of a type that this end does not know, or must not be sent
  kPayload,   ///< intact, but of a wrong length, or a field out of its range
  kRepeated,  ///< the sequence number of the last accepted frame once more
  kOld,       ///< a sequence number behind the last accepted frame's by half the range at most
};
inline constexpr int kRejections = 9;

/// Sums since the start, modulo 2^32. accepted + rejected() = delimited stretches of at least one
/// byte.
struct LinkCounters {
  std::uint32_t accepted = 0;
  std::array<std::uint32_t, kRejections> rejected_for{};  ///< by Rejection
  std::uint32_t gaps = 0;  ///< accepted frames whose number was further on than the next
  std::uint32_t lost = 0;  ///< numbers skipped by these: frames that never came, or were rejected;
                           ///< of more than 32766 in a row not all: link.md, "Sequence numbers"
  std::uint32_t sessions = 0;  ///< accepted Hello or Welcome that began another session

  std::uint32_t count(Rejection why) const { return rejected_for[static_cast<std::size_t>(why)]; }
  std::uint32_t rejected() const;
};

/// What a byte has brought about.
enum class Arrival : std::uint8_t {
  kNone,      ///< inside a frame, or between two
  kFrame,     ///< frame() is a new one
  kRejected,  ///< a frame has ended that is not one: last_rejection()
};

/// What does not depend on the end of the line. From one context at a time.
class FrameDecoderBase {
 public:
  /// The frame accepted last. Valid until the next push(): the payload lies in the decoder.
  const Frame& frame() const { return frame_; }
  Rejection last_rejection() const { return last_rejection_; }
  const LinkCounters& counters() const { return counters_; }
  /// The version of the frame that was last rejected for it; 0 where there was none.
  int other_version() const { return other_version_; }
  /// Of the last Hello or Welcome accepted; 0: none yet.
  std::uint32_t session() const { return session_; }

 protected:
  FrameDecoderBase() = default;

  /// kFrame: candidate() is intact; its type, payload and number are still to be judged.
  Arrival take(std::uint8_t byte);
  const Frame& candidate() const { return candidate_; }
  Arrival conclude(Verdict verdict);

 private:
  void append(std::uint8_t byte);
  Arrival end_stretch();
  Arrival unwrap();
  Arrival reject(Rejection why);
  bool opens_session();

  std::array<std::uint8_t, kMaxRawFrame> raw_{};
  int size_ = 0;          ///< bytes in raw_
  int block_left_ = 0;    ///< bytes until the next code byte of COBS
  bool started_ = false;  ///< there was a byte since the last delimiter
  bool too_long_ = false;
  bool in_sequence_ = false;  ///< last_sequence_ is one
  std::uint8_t other_version_ = 0;
  std::uint16_t last_sequence_ = 0;
  std::uint32_t session_ = 0;
  Rejection last_rejection_ = Rejection::kTooLong;
  Frame candidate_;
  Frame frame_;
  LinkCounters counters_;
};

/// Allocates: never. ISR-safe: from one context at a time.
template <End kEnd>
class FrameDecoder final : public FrameDecoderBase {
 public:
  /// Takes one byte. Bound: constant; at a delimiter, kMaxRawFrame bytes are checked.
  Arrival push(std::uint8_t byte) {
    const Arrival arrival = take(byte);
    if (arrival != Arrival::kFrame) return arrival;
    const Frame& frame = candidate();
    if constexpr (kEnd == End::kDevice) {
      return conclude(judge_from_host(frame.type, frame.payload, frame.size));
    } else {
      return conclude(judge_from_device(frame.type, frame.payload, frame.size));
    }
  }
};
using DeviceDecoder = FrameDecoder<End::kDevice>;
using HostDecoder = FrameDecoder<End::kHost>;

}  // namespace batuta::link
