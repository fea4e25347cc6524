// SPDX-License-Identifier: MIT
#pragma once
// What a random scene is drawn from: a seed, or the bytes of a fuzzer's input. Bytes that are not
// there are zero, so that a shorter input means something simpler.

#include <cstddef>

#include "draws.hpp"

namespace batuta::test {

class Choices {
 public:
  explicit Choices(std::uint64_t seed) : draws_(seed, 0, 0), is_seeded_(true) {}
  Choices(const std::uint8_t* data, std::size_t size) : draws_(0, 0, 0), data_(data), left_(size) {}

  /// 0 ... count - 1. @pre 1 <= count <= 256
  int of(int count) { return byte() % count; }
  bool chance(int one_in) { return of(one_in) == one_in - 1; }
  /// In [0, 1), a multiple of 2^-16.
  double share() {
    const unsigned low = byte();
    return (256.0 * byte() + low) / 65536;
  }
  double between(double low, double high) { return low + (high - low) * share(); }
  double signed_share() { return between(-1, 1); }
  Vec3<double> in_cube() {
    const double x = signed_share();
    const double y = signed_share();
    return {x, y, signed_share()};
  }
  /// Any, but not uniform.
  Quat<double> rotation() {
    const Vec3<double> v = in_cube();
    return Quat<double>(0.05 + share(), v.x(), v.y(), v.z()).normalized();
  }

 private:
  unsigned byte() {
    if (is_seeded_) return static_cast<unsigned>(draws_.bits() >> 56);
    if (left_ == 0) return 0;
    --left_;
    return *data_++;
  }

  Draws draws_;
  const std::uint8_t* data_ = nullptr;
  std::size_t left_ = 0;
  bool is_seeded_ = false;
};

}  // namespace batuta::test
