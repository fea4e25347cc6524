// SPDX-License-Identifier: MIT
#pragma once
// Every row of a file of exact answers before a judge. The committed part of each file is always
// judged (committed/README.md); the whole file beside it, where ../shared/vectors is there.

#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "programs/query_file.hpp"

namespace batuta::test {

/// A file of exact answers, and how many rows it has at least: as a whole, and the committed part.
struct EvidenceFile {
  const char* name;
  std::size_t whole;
  std::size_t part;
};
constexpr EvidenceFile kTimes{"toc.csv", 20300, 2000};
constexpr EvidenceFile kDistances{"dist.csv", 20000, 2000};
constexpr EvidenceFile kImpulses{"resp.csv", 2000, 500};

/// One of the two.
struct Evidence {
  std::string path;
  std::size_t rows;   ///< at least
  std::size_t whole;  ///< rows of the whole file

  /// What is left of a number of rows of the whole file. Of the part: less a tenth, for its hardest
  /// rows are not drawn in proportion.
  std::size_t part_of(std::size_t number) const {
    return rows == whole ? number : number * rows * 9 / (whole * 10);
  }
};

inline Evidence committed_part(const EvidenceFile& file) {
  return {std::string(BATUTA_COMMITTED_VECTORS "/") + file.name, file.part, file.whole};
}

/// What is there of a file: the committed part, and the whole of it.
inline std::vector<Evidence> evidence_of(const EvidenceFile& file) {
  std::vector<Evidence> found = {committed_part(file)};
  const std::string whole = std::string(BATUTA_SHARED_DIR "/vectors/") + file.name;
  if (std::filesystem::exists(whole)) {
    found.push_back({whole, file.whole, file.whole});
  } else {
    std::printf("only the committed part: there is no %s\n", whole.c_str());
  }
  return found;
}

/// Every row before the judge.
template <class Judge>
void judge_rows(const std::string& path, Judge& judge) {
  std::ifstream in(path);
  ASSERT_TRUE(in) << "there is no " << path;
  host::QueryFile file(in);
  ASSERT_TRUE(file.ok()) << file.error();
  host::QueryRow row;
  while (file.next(row)) judge.judge(row);  // Bound: the length of the file
}

/// @tparam Judge  has judge(host::QueryRow&) and report(scalar, evidence)
template <class Judge>
void judge_file(const EvidenceFile& file, const char* scalar) {
  for (const Evidence& evidence : evidence_of(file)) {
    SCOPED_TRACE(evidence.path);
    std::printf("%s, %zu rows or more: ",
                evidence.rows < evidence.whole ? "committed part" : "whole", evidence.rows);
    Judge judge;
    judge_rows(evidence.path, judge);
    judge.report(scalar, evidence);
  }
}

}  // namespace batuta::test
