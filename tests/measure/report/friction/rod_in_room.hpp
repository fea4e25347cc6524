// SPDX-License-Identifier: MIT
#pragma once
// A rod that flies freely between the six walls of a cube and meets them with its ends, without
// weight: whatever its energy does, a law of contact did. Frame W: the middle of the cube.

#include <array>
#include <cstdint>

#include "batuta/mechanics/motion.hpp"
#include "law.hpp"

namespace batuta::report {

class RodInRoom {
 public:
  static constexpr double kHalfRoom = 1;     ///< m
  static constexpr double kHalfAxis = 0.5;   ///< m
  static constexpr double kRadius = 0.01;    ///< m
  static constexpr double kLeastWay = 5e-3;  ///< of an end between two looks, m
  static constexpr int kMostLooks = 100'000;

  /// In the middle, with a way, a turn and a speed that are a function of the number.
  explicit RodInRoom(std::uint64_t number);

  /// Flies on until an end is at a wall and approaches it, and answers that.
  /// @returns false where that does not happen within kMostLooks looks
  /// Bound: kMostLooks looks.
  bool meet(const Law& law);

  double energy() const { return kinetic_energy(body_); }  ///< J
  const Body<double>& body() const { return body_; }

 private:
  using Ends = std::array<Vec3<double>, 2>;  ///< of the axis

  Ends ends() const;
  bool answer_at(const Vec3<double>& end, int axis, const Law& law);
  bool answer_one(const Ends& ends, const Law& law);
  void fly(double way);

  Body<double> body_;
};

}  // namespace batuta::report
