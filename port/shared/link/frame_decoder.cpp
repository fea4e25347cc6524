// SPDX-License-Identifier: MIT

#include "shared/link/frame_decoder.hpp"

#include "shared/link/crc32.hpp"
#include "shared/link/fields.hpp"

namespace batuta::link {
namespace {

constexpr std::uint32_t kHalfRange = 0x8000;

/// Hello and Welcome begin with the number of their session.
bool tells_session(MessageType type) {
  return type == MessageType::kHello || type == MessageType::kWelcome;
}

}  // namespace

std::uint32_t LinkCounters::rejected() const {
  std::uint32_t sum = 0;
  for (const std::uint32_t count : rejected_for) sum += count;  // Bound: kRejections
  return sum;
}

Arrival FrameDecoderBase::take(std::uint8_t byte) {
  if (byte == 0) return end_stretch();
  if (!started_) {
    started_ = true;
    block_left_ = byte - 1;
  } else if (block_left_ == 0) {
    append(0);  // the end of a block stands for a zero, except at the end of the frame
    block_left_ = byte - 1;
  } else {
    append(byte);
    --block_left_;
  }
  return Arrival::kNone;
}

void FrameDecoderBase::append(std::uint8_t byte) {
  if (size_ == kMaxRawFrame) {
    too_long_ = true;
    return;
  }
  raw_[static_cast<std::size_t>(size_)] = byte;
  ++size_;
}

/// A delimiter has come: whatever was before it, the next byte begins a frame.
Arrival FrameDecoderBase::end_stretch() {
  if (!started_) return Arrival::kNone;  // two delimiters in a row
  const Arrival arrival = unwrap();
  started_ = false;
  too_long_ = false;
  size_ = 0;
  return arrival;
}

Arrival FrameDecoderBase::unwrap() {
  if (too_long_) return reject(Rejection::kTooLong);
  if (block_left_ != 0) return reject(Rejection::kBadCobs);
  if (size_ < kMinRawFrame) return reject(Rejection::kTooShort);
  const int crc_at = size_ - kCrcBytes;
  std::uint32_t crc = 0;
  Fields::reader(raw_.data() + crc_at, kCrcBytes).u32(crc);
  if (crc != crc32(raw_.data(), crc_at)) return reject(Rejection::kCrc);
  Fields fields = Fields::reader(raw_.data(), kHeaderBytes);
  std::uint8_t version = 0;
  std::uint8_t type = 0;
  fields.u8(version);
  fields.u8(type);
  fields.u16(candidate_.sequence);
  if (version != kProtocolVersion) {
    other_version_ = version;
    return reject(Rejection::kVersion);
  }
  candidate_.type = static_cast<MessageType>(type);
  candidate_.payload = raw_.data() + kHeaderBytes;
  candidate_.size = crc_at - kHeaderBytes;
  return Arrival::kFrame;
}

Arrival FrameDecoderBase::conclude(Verdict verdict) {
  if (verdict == Verdict::kUnknownType) return reject(Rejection::kType);
  if (verdict != Verdict::kGood) return reject(Rejection::kPayload);
  if (!opens_session() && in_sequence_) {
    const auto ahead = static_cast<std::uint16_t>(candidate_.sequence - last_sequence_);
    if (ahead == 0) return reject(Rejection::kRepeated);
    if (ahead >= kHalfRange) return reject(Rejection::kOld);
    if (ahead > 1) ++counters_.gaps;
    counters_.lost += ahead - 1U;
  }
  in_sequence_ = true;
  last_sequence_ = candidate_.sequence;
  frame_ = candidate_;
  ++counters_.accepted;
  return Arrival::kFrame;
}

/// Whether the candidate begins another session; if so, it is that from now on.
bool FrameDecoderBase::opens_session() {
  if (!tells_session(candidate_.type)) return false;
  std::uint32_t session = 0;
  Fields::reader(candidate_.payload, candidate_.size).u32(session);
  if (session == session_) return false;
  session_ = session;
  ++counters_.sessions;
  return true;
}

Arrival FrameDecoderBase::reject(Rejection why) {
  last_rejection_ = why;
  ++counters_.rejected_for[static_cast<std::size_t>(why)];
  return Arrival::kRejected;
}

}  // namespace batuta::link
