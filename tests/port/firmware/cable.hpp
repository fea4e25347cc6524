// SPDX-License-Identifier: MIT
#pragma once
// A serial cable in memory, as bad as a test wants it, and a clock that stands where it is put.

#include <deque>
#include <random>

#include "batuta/port/clock.hpp"
#include "shared/link/byte_stream.hpp"

namespace batuta::test {

/// What happens to a byte on its way; shares of all bytes, each by itself.
struct Damage {
  double dropped = 0;
  double doubled = 0;
  double flipped = 0;  ///< one of its bits
};

/// One direction.
class Wire {
 public:
  void worsen(const Damage& damage, unsigned seed) {
    damage_ = damage;
    random_.seed(seed);
  }
  void cut(bool is_cut) { cut_ = is_cut; }
  /// Bytes that are taken before the line is busy.
  void limit(std::size_t bytes) { limit_ = bytes; }
  bool has_room() const { return bytes_.size() < limit_; }

  void put(std::uint8_t byte) {
    if (cut_ || happens(damage_.dropped)) return;
    if (happens(damage_.flipped)) byte ^= static_cast<std::uint8_t>(1U << (random_() % 8));
    bytes_.push_back(byte);
    if (happens(damage_.doubled)) bytes_.push_back(byte);
  }
  int take(std::uint8_t* bytes, int capacity) {
    int count = 0;
    for (; count < capacity && !bytes_.empty(); ++count) {
      bytes[count] = bytes_.front();
      bytes_.pop_front();
    }
    return count;
  }

 private:
  bool happens(double share) {
    return share > 0 && std::uniform_real_distribution<>(0, 1)(random_) < share;
  }

  std::deque<std::uint8_t> bytes_;
  Damage damage_;
  std::mt19937 random_;
  std::size_t limit_ = 1U << 20U;
  bool cut_ = false;
};

class CableEnd final : public link::ByteStream {
 public:
  CableEnd(Wire& in, Wire& out) : in_(in), out_(out) {}

 private:
  int do_read(std::uint8_t* bytes, int capacity) override { return in_.take(bytes, capacity); }
  int do_write(const std::uint8_t* bytes, int count) override {
    int taken = 0;
    for (; taken < count && out_.has_room(); ++taken) out_.put(bytes[taken]);
    return taken;
  }

  Wire& in_;
  Wire& out_;
};

struct Cable {
  Wire to_device;
  Wire to_host;
  CableEnd device{to_device, to_host};
  CableEnd host{to_host, to_device};

  void worsen(const Damage& damage, unsigned seed) {
    to_device.worsen(damage, seed);
    to_host.worsen(damage, seed + 1);
  }
  void cut(bool is_cut) {
    to_device.cut(is_cut);
    to_host.cut(is_cut);
  }
};

class HandClock final : public Clock {
 public:
  Microseconds time = 0;
  Microseconds per_call = 0;  ///< how long it takes until somebody asks again

 private:
  Microseconds do_now() override {
    time += per_call;
    return time;
  }
};

}  // namespace batuta::test
