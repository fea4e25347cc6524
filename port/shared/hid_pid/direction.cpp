// SPDX-License-Identifier: MIT

#include "shared/hid_pid/direction.hpp"

#include "batuta/mechanics/trigonometry.hpp"

namespace batuta::pid {

Vec2<float> direction_of(unsigned angle) {
  constexpr unsigned kQuarter = kFullTurn / 4;
  static_assert(4 * kQuarter == kFullTurn, "the winds are whole numbers");
  // Quarters are turned in whole numbers, so that a force along one axis has no trace of the other.
  const auto rest = static_cast<float>(angle % kQuarter);
  const batuta::detail::SinCos<float> at =
      batuta::detail::sin_cos(rest * (kRadiansPerTurn / static_cast<float>(kFullTurn)));
  switch (angle / kQuarter % 4U) {
    case 0:
      return {at.sin, at.cos};
    case 1:
      return {at.cos, -at.sin};
    case 2:
      return {-at.sin, -at.cos};
    default:
      return {-at.cos, at.sin};
  }
}

}  // namespace batuta::pid
