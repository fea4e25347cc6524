// SPDX-License-Identifier: MIT
#pragma once
// The few settings that are not a scene's. Each has a default, a range and a check; set one with
// -D on batuta_config, or in a header named by BATUTA_USER_CONFIG ("my_config.hpp").

// Names in the standard library, in Eigen and here. What is said of them is all that is said: the
// rest compiles without them.
#if defined(F) || defined(B1) || defined(abs) || defined(round) || defined(min) || defined(max)
#error \
    "batuta: F, B1, abs, round, min or max is a macro here, as Arduino.h makes them: include all of batuta's headers before it (in Arduino's package batuta.h does), or #undef them"
#undef F
#undef B1
#undef abs
#undef round
#undef min
#undef max
#endif

// A product and a sum that a compiler contracts into one instruction have other bits, and void what
// the searches prove. Who hands every file the flag that forbids it says so by
// BATUTA_CONTRACTION_IS_OFF, as the library's own build does; for all others it is said here, from
// where on it holds to the end of the file, at the price of some code (docs/cost.md).
#ifndef BATUTA_CONTRACTION_IS_OFF
#ifdef __clang__
#pragma clang fp contract(off)
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off")
#elif defined(_MSC_VER)  // deviation: names-of-compilers
#pragma fp_contract(off)
#endif
#endif

#ifdef BATUTA_USER_CONFIG
#include BATUTA_USER_CONFIG
#endif

/// Which caller mistakes end in batuta_trap().
/// 0 none, 1 preconditions of public calls, 2 also invariants and Eigen's own checks, 3 also slow
/// checks.
#ifndef BATUTA_ASSERT_LEVEL
#define BATUTA_ASSERT_LEVEL 2
#endif

static_assert(BATUTA_ASSERT_LEVEL >= 0 && BATUTA_ASSERT_LEVEL <= 3,
              "BATUTA_ASSERT_LEVEL: choose 0, 1, 2 or 3");

/// Whether the library is built for double beside float: 1 on a host, where double is the oracle
/// and time is cheap; 0 halves what a target compiles.
#ifndef BATUTA_WITH_DOUBLE
#define BATUTA_WITH_DOUBLE 1
#endif

static_assert(BATUTA_WITH_DOUBLE == 0 || BATUTA_WITH_DOUBLE == 1,
              "BATUTA_WITH_DOUBLE: choose 0 or 1");

namespace batuta::detail {

/// Whether the compiler is silent where a constant is asked of a constexpr function in which it has
/// found an error already.
#if defined(__clang__)
inline constexpr bool kTellsErrorsOnce = false;
#else
inline constexpr bool kTellsErrorsOnce = true;
#endif

}  // namespace batuta::detail
