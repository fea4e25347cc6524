// SPDX-License-Identifier: MIT
// What must hold of the link for any bytes whatever, as a libFuzzer target. The first byte of an
// input says how the rest is used: as bytes on the line, or as frames whose check sum is put right,
// so that the fuzzer gets past it to the payloads and the sequence.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "shared/link/frame_decoder.hpp"
#include "shared/link/sender.hpp"

namespace batuta::link {
namespace {

using Bytes = std::vector<std::uint8_t>;

void require(bool condition, const char* what) {
  if (condition) return;
  std::fprintf(stderr, "the link broke a promise: %s\n", what);
  std::abort();
}

/// What comes out of a decoder is a message that can be sent again as the very same bytes.
template <class Message>
bool same_again(const Frame& frame) {
  Message message;
  if (!read_message(frame, message)) return false;
  Payload payload;
  require(encode(message, payload), "what was received may be sent");
  require(payload.size == frame.size, "a message has one length");
  require(std::equal(frame.payload, frame.payload + frame.size, payload.bytes.begin()),
          "decode, then encode: the same payload");
  Message again;
  require(decode(payload.bytes.data(), payload.size, again), "what may be sent is received");
  Payload twice;
  require(encode(again, twice) && twice.bytes == payload.bytes,
          "encode, then decode: the same message");
  return true;
}

template <class... Messages>
void check_message(const Frame& frame) {
  const int read = (0 + ... + (same_again<Messages>(frame) ? 1 : 0));
  require(read == 1, "an accepted frame is one message");
}

/// Bytes since the last delimiter, and how many times there were some when a delimiter came.
struct Stretch {
  Bytes bytes;
  std::uint32_t ended = 0;
};

void check_frame(const Frame& frame, const Stretch& stretch) {
  check_message<Hello, Welcome, Step, StickSample, StickUsed, Pose, Event, Touch, Force, StepReport,
                Refused>(frame);
  std::array<std::uint8_t, kMaxWireFrame> wire{};
  const int count = encode_frame(frame, wire.data(), kMaxWireFrame);
  require(count == static_cast<int>(stretch.bytes.size()) + 2, "a frame has one length");
  require(std::equal(stretch.bytes.begin(), stretch.bytes.end(), wire.begin() + 1),
          "unwrap, then wrap: the same bytes");
}

template <End kEnd>
void listen(const Bytes& wire) {
  FrameDecoder<kEnd> decoder;
  Stretch stretch;
  for (const std::uint8_t byte : wire) {
    const Arrival arrival = decoder.push(byte);
    const bool ends = byte == 0 && !stretch.bytes.empty();
    require((arrival != Arrival::kNone) == ends,
            "a verdict at the end of every stretch, only there");
    if (ends) ++stretch.ended;
    if (arrival == Arrival::kFrame) check_frame(decoder.frame(), stretch);
    if (byte == 0) {
      stretch.bytes.clear();
    } else {
      stretch.bytes.push_back(byte);
    }
  }
  const LinkCounters& counters = decoder.counters();
  require(counters.accepted + counters.rejected() == stretch.ended, "the counters add up");
  require(counters.gaps <= counters.accepted && counters.gaps <= counters.lost, "gaps are counted");
}

/// Frames of [type, number, number, length, payload...], well wrapped whatever is in them.
Bytes wrapped(const std::uint8_t* data, std::size_t size) {
  Bytes wire;
  std::size_t at = 0;
  while (size - at >= 4) {
    const std::size_t length =
        std::min({std::size_t{data[at + 3]}, size - at - 4, std::size_t{kMaxPayload}});
    Frame frame;
    frame.type = static_cast<MessageType>(data[at]);
    frame.sequence = static_cast<std::uint16_t>(data[at + 1] | (data[at + 2] << 8));
    frame.payload = data + at + 4;
    frame.size = static_cast<int>(length);
    std::array<std::uint8_t, kMaxWireFrame> one{};
    const int count = encode_frame(frame, one.data(), kMaxWireFrame);
    require(count == kMinRawFrame + frame.size + 3, "a frame's length follows from its payload's");
    wire.insert(wire.end(), one.begin(), one.begin() + count);
    at += 4 + length;
  }
  return wire;
}

}  // namespace
}  // namespace batuta::link

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace batuta::link;
  if (size == 0) return 0;
  const bool raw = data[0] == 0;
  const Bytes wire = raw ? Bytes(data + 1, data + size) : wrapped(data + 1, size - 1);
  listen<End::kDevice>(wire);
  listen<End::kHost>(wire);
  return 0;
}
