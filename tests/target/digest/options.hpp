// SPDX-License-Identifier: MIT
#pragma once
// What the program is asked to do.

#include "io.hpp"
#include "section.hpp"

namespace batuta::digest {

/// A query by section and number; `any` false: none.
struct QueryName {
  bool any = false;
  Section section = Section::kToc;
  std::uint32_t index = 0;

  bool is(Section other, std::uint32_t number) const {
    return any && section == other && index == number;
  }
};

struct Options {
  const char* in = "digest.bin";
  const char* hashes = nullptr;  ///< file for the hash of every query; null: none
  std::uint32_t every = 1;       ///< 1: all queries; k: every k-th, and sequences k times shorter
  std::uint32_t sections = (1U << kSections) - 1;  ///< bit by section
  QueryName shown;                                 ///< its answer is printed, and no digest
  QueryName doctored;                              ///< its answer is falsified by one ulp

  bool takes(Section section) const {
    return (sections >> static_cast<unsigned>(section) & 1U) != 0;
  }
};

/// @returns whether the words make sense
bool read_options(const Words& words, Options& options);

}  // namespace batuta::digest
