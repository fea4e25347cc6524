// SPDX-License-Identifier: MIT

#include "shared/link/sender.hpp"

#include <algorithm>

namespace batuta::link {

Status SenderBase::refuse_invalid() {
  ++invalid_;
  return Status::kInvalidArgument;
}

Status SenderBase::queue(MessageType type, const Payload& payload) {
  std::array<std::uint8_t, kMaxWireFrame> wire;
  const int count = encoder_.wrap(type, payload, wire.data(), room());
  if (count == 0) {
    ++refused_;
    return Status::kPoolFull;
  }
  const int end = first_ + used_;
  const int at = end < capacity_ ? end : end - capacity_;
  const int front = std::min(count, capacity_ - at);
  std::copy_n(wire.data(), front, ring_ + at);
  std::copy_n(wire.data() + front, count - front, ring_);
  used_ += count;
  ++sent_;
  return Status::kOk;
}

int SenderBase::write_front(ByteStream& stream) {
  const int taken = stream.write(ring_ + first_, std::min(used_, capacity_ - first_));
  first_ += taken;
  if (first_ == capacity_) first_ = 0;
  used_ -= taken;
  return taken;
}

int SenderBase::pump(ByteStream& stream) {
  const bool wraps = first_ + used_ > capacity_;
  const int front = write_front(stream);
  return wraps ? front + write_front(stream) : front;
}

void SenderBase::clear() {
  first_ = 0;
  used_ = 0;
}

}  // namespace batuta::link
