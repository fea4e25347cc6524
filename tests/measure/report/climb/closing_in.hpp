// SPDX-License-Identifier: MIT
#pragma once
// What it costs to tell a near miss from a graze: queries whose least gap is set to a chosen share
// of S, by changing nothing but the radii.

#include <array>

#include "figures.hpp"

namespace batuta::report {

/// Least gaps over S; negative: the two overlap by so much.
inline constexpr std::array<double, 9> kDistances = {1e-2, 1e-3, 1e-4,  1e-5, 1e-6,
                                                     1e-7, 1e-8, -1e-3, -1e-5};

/// Generic queries, those of them that come nearest on the way and start well apart, in double with
/// a contact tolerance far below all distances: for each of kDistances what they cost. @param
/// indices  which of the family are looked at
std::array<Figures, kDistances.size()> close_in(Range indices, Progress& progress);

}  // namespace batuta::report
