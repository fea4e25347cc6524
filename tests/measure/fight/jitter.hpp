// SPDX-License-Identifier: MIT
#pragma once
// What is left to chance in a trial. The same bits on every machine: no generator or distribution
// of a library, whose answers are its own.

#include <cstdint>

namespace fight {

/// splitmix64 [Steele, Lea, Flood 2014].
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t next() {
    state_ += 0x9e3779b97f4a7c15U;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31U);
  }
  /// Evenly in [from, to).
  double between(double from, double to) {
    return from + (to - from) * (static_cast<double>(next() >> 11U) * 0x1p-53);
  }

 private:
  std::uint64_t state_;
};

/// A seed of its own for each of many.
inline std::uint64_t seed_of(std::uint64_t seed, std::uint64_t cell, std::uint64_t trial) {
  return Random(Random(Random(seed).next() + cell).next() + trial).next();
}

/// A place of the stick, -1 ... 1.
struct Place {
  double x = 0;
  double y = 0;
};

inline constexpr double kDistanceJitter = 0.04;  // m
inline constexpr double kStartJitter = 0.015;    // s
inline constexpr double kPlaceJitter = 0.03;     // of the stick
inline constexpr double kDurationJitter = 0.1;   // share

/// What a hand and its place do not do twice alike.
class Jitter {
 public:
  explicit Jitter(std::uint64_t seed) : random_(seed) {}

  double distance(double metres) { return metres + around(kDistanceJitter); }
  double start(double seconds) { return seconds + around(kStartJitter); }
  Place place(const Place& wanted) {
    const double x = wanted.x + around(kPlaceJitter);
    return {x, wanted.y + around(kPlaceJitter)};
  }
  double duration(double seconds) { return seconds * (1 + around(kDurationJitter)); }
  double between(double from, double to) { return random_.between(from, to); }
  bool coin() { return random_.next() >> 63U != 0; }

 private:
  double around(double most) { return random_.between(-most, most); }

  Random random_;
};

}  // namespace fight
