// SPDX-License-Identifier: MIT
#pragma once
// What the program needs to know of one kind of query. A new kind is one more file and one line in
// main.cpp.

#include <cstdint>
#include <string>
#include <vector>

#include "host/query_file.hpp"

namespace batuta::answer {

/// How time-of-contact queries are searched.
struct SearchSettings {
  std::uint32_t budget =
      100'000'000;  ///< steps; the thinnest query of the project's own files takes 5.2 million
  double tolerance = 0.5;  ///< epsilon, times the thinner radius
};

/// The answer to one query: either what goes into the row, or why there is none.
struct Answer {
  std::string word;             ///< first column after `line`, if it is a word
  std::vector<double> numbers;  ///< the other columns
  std::string problem;          ///< why the query makes no sense; empty if it does
};

/// Answers the query in `row` in one precision. A field that cannot be read is noted in the row.
using RowAnswer = Answer (*)(host::QueryRow& row, const SearchSettings& settings);

struct QueryKind {
  const char* columns;  ///< of the output
  /// Name of a column that the queries need and the file lacks; empty if it has all.
  std::string (*missing_column)(const host::QueryFile& file);
  RowAnswer in_float;
  RowAnswer in_double;
};

QueryKind time_of_contact_kind();
QueryKind distance_kind();
QueryKind impulse_kind();

}  // namespace batuta::answer
