// SPDX-License-Identifier: MIT
#pragma once
// What fuzz targets share: numbers and shapes drawn from the bytes of an input, and the end of a
// run whose promise was broken. Bytes that are not there are zero, so every input means something
// and a shorter one means something simpler.

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "batuta/geometry/capsule.hpp"
#include "batuta/mechanics/motion.hpp"
#include "hostile_numbers.hpp"

namespace batuta::fuzz {

/// u of the numbers that are drawn, and what a number below the smallest normal one is rounded by.
inline constexpr double kU = kRoundOff<float>;
inline constexpr double kLeast = std::numeric_limits<float>::denorm_min();

inline void require(bool condition, const char* what) {
  if (condition) return;
  std::fprintf(stderr, "a promise was broken: %s\n", what);
  std::abort();
}

/// Which numbers an input is made of.
enum class Numbers : std::uint8_t {
  kGrid,    ///< multiples of kGridStep below kGridEnd: exact differences, ties, parallels, touches
  kNudged,  ///< those, some a few neighbouring numbers off: what rounding makes of ties
  kScaled,  ///< those times powers of two between 2^-24 and 2^23, each its own
  kAny,     ///< all bit patterns: infinite, subnormal, not a number; and each hostile number
};

inline constexpr float kGridStep = 0x1p-12F;
inline constexpr float kGridEnd = 8;

class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t size) : data_(data), left_(size) {}

  std::size_t left() const { return left_; }
  std::uint8_t byte() {
    if (left_ == 0) return 0;
    --left_;
    return *data_++;
  }
  /// @pre count >= 1; @returns 0 ... count - 1
  int choice(int count) { return byte() % count; }
  bool flag() { return (byte() & 1) != 0; }
  std::uint16_t word() {
    const unsigned low = byte();
    return static_cast<std::uint16_t>(low | unsigned{byte()} << 8);
  }

  Numbers numbers() { return static_cast<Numbers>(choice(4)); }
  /// In [-kGridEnd, kGridEnd), a multiple of kGridStep.
  float grid() { return static_cast<float>(static_cast<std::int16_t>(word())) * kGridStep; }
  /// In [0, 1], a multiple of 1/255.
  float share() { return static_cast<float>(byte()) / 255.0F; }
  /// Any number. Not-a-number with a small payload stands for the hostile number of that index.
  float bits() {
    const std::uint32_t low = word();
    const std::uint32_t pattern = low | std::uint32_t{word()} << 16;
    const std::uint32_t payload = pattern - kQuietNaN;  // large for any other number
    if (payload < test::kHostile<float>.size()) return test::kHostile<float>[payload];
    float x = 0;
    std::memcpy(&x, &pattern, sizeof x);
    return x;
  }
  float number(Numbers from) {
    if (from == Numbers::kAny) return bits();
    const float x = grid();
    if (from == Numbers::kGrid) return x;
    const int how = byte();
    if (from == Numbers::kScaled) return std::ldexp(x, how % 48 - 24);
    return how < 128 ? x : neighbour(x, how % 16 - 8);
  }
  Vec3<float> vector(Numbers from) {
    const float x = number(from);
    const float y = number(from);
    return {x, y, number(from)};
  }
  /// Unit, or what renewed() makes of four small integers.
  Quat<float> turn() {
    float parts[4] = {};
    for (float& part : parts) part = static_cast<float>(static_cast<std::int8_t>(byte()));
    return renewed(Quat<float>(parts[0] + 1, parts[1], parts[2], parts[3]));
  }
  /// Ends that coincide with, mirror or lengthen each other are as likely as any.
  Segment<float> segment(Numbers from) {
    const Vec3<float> a = vector(from);
    switch (choice(4)) {
      case 0:
        return {a, a};
      case 1:
        return {a, -a};
      default:
        return {a, vector(from)};
    }
  }
  float radius(Numbers from) {
    const float r = number(from);
    return from == Numbers::kAny ? r : std::abs(r);
  }

 private:
  static constexpr std::uint32_t kQuietNaN = 0x7FC00000;

  static float neighbour(float x, int steps) {
    if (x == 0) return x;  // next to it are subnormal numbers, which are kAny's
    const float end = steps < 0 ? -2 * kGridEnd : 2 * kGridEnd;
    for (int i = 0; i < std::abs(steps); ++i) x = std::nextafter(x, end);
    return x;
  }

  const std::uint8_t* data_;
  std::size_t left_;
};

/// Two quarter turns, about z and about x: no axis stays. Exact: components only change places and
/// signs.
template <class Scalar>
Vec3<Scalar> cube_turned(const Vec3<Scalar>& v) {
  return {-v.y(), -v.z(), v.x()};
}

}  // namespace batuta::fuzz
