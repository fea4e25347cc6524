// SPDX-License-Identifier: MIT
#pragma once
// Random numbers that are a function of a key: integers by a mixing function, doubles from their
// bits by exact steps, so every platform draws the same.

#include <cmath>
#include <cstdint>

#include "batuta/core/types.hpp"

namespace batuta::test {

/// The numbers that belong to (seed, stream, index). Each function draws in the order in which its
/// lines stand; callers put draws into statements of their own, because the order in which
/// arguments are evaluated is not defined.
class Draws {
 public:
  Draws(std::uint64_t seed, std::uint64_t stream, std::uint64_t index)
      : state_(mix(mix(mix(seed) + stream) + index)) {}

  std::uint64_t bits() {
    state_ += kStep;
    return mix(state_);
  }
  /// In [0, 1), a multiple of 2^-53.
  double unit() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
  double between(double low, double high) { return low + (high - low) * unit(); }
  double signed_unit() { return between(-1, 1); }
  bool chance(double share) { return unit() < share; }
  /// Any order of magnitude between 2^low and 2^high alike.
  double power_of_two(int low, int high) {
    const int exponent = low + static_cast<int>(unit() * (high - low));
    return std::ldexp(1 + unit(), exponent);
  }

  /// Uniform on the sphere.
  Vec3<double> direction() {
    for (int i = 0; i < kTries; ++i) {  // Bound: kTries; all fail once in 2e10
      const double x = signed_unit();
      const double y = signed_unit();
      const double z = signed_unit();
      const double square = x * x + y * y + z * z;
      if (square <= 1 && square > kTooShort) return Vec3<double>(x, y, z) / std::sqrt(square);
    }
    return Vec3<double>::UnitX();
  }
  /// Uniform in the ball.
  Vec3<double> in_ball(double radius) {
    const double size = radius * unit();
    return size * direction();
  }
  /// Unit, uniform over the rotations.
  Quat<double> rotation() {
    for (int i = 0; i < kTries; ++i) {  // Bound: kTries; all fail once in 1e5, harmlessly
      const double w = signed_unit();
      const double x = signed_unit();
      const double y = signed_unit();
      const double z = signed_unit();
      const double square = w * w + x * x + y * y + z * z;
      const double size = std::sqrt(square);
      if (square <= 1 && square > kTooShort) return {w / size, x / size, y / size, z / size};
    }
    return Quat<double>::Identity();
  }

 private:
  static constexpr int kTries = 32;
  static constexpr double kTooShort = 0x1p-10;
  static constexpr std::uint64_t kStep = 0x9e3779b97f4a7c15;  // 2^64 / golden ratio, odd

  /// A bijection in which every bit of the argument moves every bit of the result (splitmix64).
  static std::uint64_t mix(std::uint64_t x) {
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9;
    x = (x ^ (x >> 27)) * 0x94d049bb133111eb;
    return x ^ (x >> 31);
  }

  std::uint64_t state_;
};

}  // namespace batuta::test
