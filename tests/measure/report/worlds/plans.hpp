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

/// Crossed bars, four to a layer, on eight fixed logs that come first: the lower layers are too
/// narrow for many. @param bodies  logs included
Plan draw_bars(int bodies, std::uint64_t number);

/// Capsules in flight in a cube, half a metre to the next one, elastic, no weight.
Plan draw_crowd(int bodies, std::uint64_t number);
/// Half the edge of that cube, m.
double half_cube(int bodies);

inline constexpr int kMovers = 32;      ///< in the volley, half of them are shot; movers come first
inline constexpr double kHalfCage = 1;  ///< m, from the middle to the axes of the walls

}  // namespace batuta::worlds
