// SPDX-License-Identifier: MIT
#pragma once
// The sections of the digest, and the form of the file with their queries. Little-endian words of
// 32 bits: magic, then chunks up to the end of the file. A chunk is a ChunkHead and `records`
// records of `words` words each; floats by their bits.

#include <array>
#include <cstddef>
#include <cstdint>

namespace batuta::digest {

enum class Section : std::uint8_t {
  kToc,          ///< search_advancement()
  kTranslation,  ///< search_translation(), where nothing turns
  kStepping,     ///< search_stepping(), cut after a few steps
  kDistance,     ///< closest points, capsule gap
  kImpulse,      ///< collision impulse, energies
  kDuel,         ///< all that a duel tells after each step
  kFlight,       ///< free flight of stiff bodies of revolution, in blocks of steps
  kScenes,       ///< the ready-made scenes, step by step
  kTumbling,     ///< free flight of bodies with three unlike moments, in blocks of steps
};
inline constexpr std::size_t kSections = 9;
inline constexpr std::array<const char*, kSections> kSectionNames = {
    "toc",  "translation", "stepping", "distance", "impulse",
    "duel", "flight",      "scenes",   "tumbling"};

inline constexpr std::uint32_t kMagic = 0x31544142U;  // "BAT1"

enum class Chunk : std::uint32_t { kToc = 1, kDistance = 2, kImpulse = 3, kBout = 4 };

struct ChunkHead {
  std::uint32_t chunk = 0;      ///< Chunk
  std::uint32_t records = 0;    ///< how many follow
  std::uint32_t words = 0;      ///< of a record
  std::uint32_t parameter = 0;  ///< of a bout: its steps; else 0
};

// Words of a record; the order of the fields is that of the columns in the query files.
inline constexpr std::uint32_t kMovingWords = 20;                    ///< c q v w e0 e1 r
inline constexpr std::uint32_t kTocWords = 1 + 2 * kMovingWords;     ///< T, A, B
inline constexpr std::uint32_t kDistanceWords = 12;                  ///< A0 A1 B0 B1
inline constexpr std::uint32_t kPartyWords = 17;                     ///< m J c q v w
inline constexpr std::uint32_t kImpulseWords = 2 * kPartyWords + 7;  ///< A, B, p, n, e
inline constexpr std::uint32_t kSampleWords = 7;  ///< step, side, time, x, y, buttons, sequence
inline constexpr std::uint32_t kMostWords = 41;

static_assert(kTocWords <= kMostWords && kImpulseWords <= kMostWords);

/// Number of a query that is one of a sequence: of steps of a bout, of blocks of a flight.
constexpr std::uint32_t index_in(std::uint32_t sequence, std::uint32_t place) {
  return sequence << 24U | place;
}

}  // namespace batuta::digest
