// SPDX-License-Identifier: MIT
#pragma once
// The scenes in which engines are compared, each drawn anew from a number.

#include "engine.hpp"

namespace batuta::worlds {

enum class Play : std::uint8_t {
  kCage,    ///< capsules in a cage of fixed ones, elastic, no weight
  kPile,    ///< capsules that fall into a trough of fixed ones, rub, and come to rest
  kVolley,  ///< rods in flight at 50 m/s, each straight at one that hangs in the air
};
inline constexpr Play kPlays[] = {Play::kCage, Play::kPile, Play::kVolley};

const char* name(Play play);
double duration(Play play);  ///< s
Plan draw(Play play, std::uint64_t number);

inline constexpr int kMovers = 32;      ///< in the volley, half of them are shot; movers come first
inline constexpr double kHalfCage = 1;  ///< m, from the middle to the axes of the walls

}  // namespace batuta::worlds
