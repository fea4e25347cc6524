// SPDX-License-Identifier: MIT
#pragma once
// Numbers that no careful caller hands over: what tests/extreme puts into every place of an
// argument, and what the fuzzers of tests/fuzz are given among all bit patterns. The one list.

#include <array>
#include <cstdint>
#include <limits>

namespace batuta::test {

/// Not finite first. The corpus of the fuzzers names them by their index: new ones go to the end.
template <class S>
constexpr std::array<S, 17> kHostile = {
    std::numeric_limits<S>::quiet_NaN(),
    std::numeric_limits<S>::infinity(),
    -std::numeric_limits<S>::infinity(),
    std::numeric_limits<S>::max(),
    std::numeric_limits<S>::lowest(),
    std::numeric_limits<S>::max() / 4,  // beyond kLargestCoordinate
    std::numeric_limits<S>::max() / 8,  // at it
    S(1e30),
    S(-1e20),
    std::numeric_limits<S>::min(),
    std::numeric_limits<S>::denorm_min(),
    -std::numeric_limits<S>::denorm_min(),
    S(-1),
    S(0),
    S(-0.0),
    S(0x1p63),
    S(1),
};

/// What 32 bits of a saved state are forged into, whether they are a number or a count: not a
/// number, infinite, the largest, the least, minus zero or the least integer, 2^63, one, all bits,
/// the least normal one. The corpus names these, too, by their index, modulo their number.
constexpr std::array<std::uint32_t, 10> kHostileWords = {
    0x7FC00000U, 0x7F800000U, 0xFF800000U, 0x7F7FFFFFU, 0x00000001U,
    0x80000000U, 0x5F000000U, 0x3F800000U, 0xFFFFFFFFU, 0x00800000U};

/// The ends of an integer's range, each with its neighbour.
template <class I>
constexpr std::array<I, 2> kHighest = {std::numeric_limits<I>::max(),
                                       std::numeric_limits<I>::max() - 1};
template <class I>
constexpr std::array<I, 2> kLowest = {std::numeric_limits<I>::min(),
                                      std::numeric_limits<I>::min() + 1};

}  // namespace batuta::test
