// SPDX-License-Identifier: MIT
#pragma once
// What happens to a caller's mistake: the condition is compiled in every build, evaluated by level,
// and its failure goes to one function that the port supplies. No text, no streams, no exceptions.

#include <cstdint>

#include "batuta/core/config.hpp"

/// The end of the line, supplied by the port: bring actuators to a safe state and stop.
/// @param file_id  batuta::file_id() of the source file's name
/// @param line     line in that file
extern "C" [[noreturn]] void batuta_trap(std::uint32_t file_id, std::uint32_t line);

namespace batuta {

/// FNV-1a hash of a file's base name: tells the file in a trap report and costs no string in flash.
/// Bound: the length of the path, at compile time.
constexpr std::uint32_t file_id(const char* path) {
  constexpr std::uint32_t kOffset = 2166136261U;
  constexpr std::uint32_t kPrime = 16777619U;
  std::uint32_t hash = kOffset;
  for (const char* c = path; *c != '\0'; ++c) {
    hash = (*c == '/' || *c == '\\') ? kOffset : (hash ^ static_cast<std::uint8_t>(*c)) * kPrime;
  }
  return hash;
}

}  // namespace batuta

/// Calls batuta_trap() where BATUTA_ASSERT_LEVEL is at least `level` and the condition does not
/// hold. Use the three below.
#define BATUTA_CHECK_AT(level, condition)                                   \
  do {                                                                      \
    if (BATUTA_ASSERT_LEVEL >= (level) && !(condition)) {                   \
      constexpr std::uint32_t batuta_file_id = ::batuta::file_id(__FILE__); \
      batuta_trap(batuta_file_id, static_cast<std::uint32_t>(__LINE__));    \
    }                                                                       \
  } while (false)

/// A precondition of a public call.
#define BATUTA_ASSERT(condition) BATUTA_CHECK_AT(1, condition)
/// Something the library itself guarantees.
#define BATUTA_INVARIANT(condition) BATUTA_CHECK_AT(2, condition)
/// A check whose cost is more than a few comparisons.
#define BATUTA_SLOW_CHECK(condition) BATUTA_CHECK_AT(3, condition)

// clang that is told -ffp-contract=fast disregards what config.hpp says, and has no macro for it:
// so each file asks at the start of the program, where the part can fuse.
#if defined(__clang__) && !defined(BATUTA_CONTRACTION_IS_OFF)
#include "batuta/core/detail/start_check.hpp"
#endif
