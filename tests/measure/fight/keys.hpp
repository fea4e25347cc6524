// SPDX-License-Identifier: MIT
#pragma once
// From the knobs to the 45 keys of a map: nine columns (x = -1 ... 1, left to right), five rows
// (y = -1 ... 1, from the back).

#include <array>
#include <cstdio>

#include "batuta/fencing/map.hpp"
#include "knobs.hpp"

namespace fight {

using MapKey = batuta::fencing::MapKey<float>;

inline constexpr int kColumns = 9;
inline constexpr int kRows = 5;
/// Row by row from the back, left to right.
using Keys = std::array<MapKey, static_cast<std::size_t>(kColumns* kRows)>;

/// The lines of attack, by the one who attacks, and the parry against each.
enum class Line { kHighInside, kLowInside, kLowOutside, kHighOutside };
inline constexpr int kLines = 4;
inline constexpr std::array<const char*, kLines> kLineNames = {"high inside", "low inside",
                                                               "low outside", "high outside"};
inline constexpr std::array<const char*, kLines> kParryNames = {"quarte", "septime", "octave",
                                                                "sixte"};

/// The distance of the fencers' origins for which the spots of the attacks are given, m.
inline constexpr double kGuardDistance = 2.25;

using Triple = std::array<double, 3>;

/// Rotation vector of the shortest turn of +x into a direction of any length. @pre not zero, not
/// straight backwards
Triple turn_onto(const Triple& aim);
/// Unit vector into which +x goes.
Triple aim_of(const Triple& turn);

/// The keys, to 0.1 mm and 0.1 mrad: what is printed is what is played.
Keys keys_from(const Knobs& knobs);

/// The keys as a constexpr table of C++.
void print_keys(const Keys& keys, std::FILE* out);

}  // namespace fight
