// SPDX-License-Identifier: MIT
#pragma once
// What the program needs to know of one kind of query. A new kind is one more file, a line
// of kind_of() and one of read_command_line().

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "programs/query_file.hpp"

namespace batuta::answer {

/// The searches of batuta/detection/search.hpp.
enum class Method { kAdvancement, kTranslation, kStepping };

/// How time-of-contact queries are searched.
struct SearchSettings {
  Method method = Method::kAdvancement;
  /// Distance evaluations; of stepping: steps.
  std::optional<std::uint32_t> budget;
  /// The gap that counts as contact, over S; of stepping: epsilon, times the thinner radius.
  std::optional<double> tolerance;
};

/// Of stepping: the thinnest query of the project's own files takes 5.2 million steps.
inline constexpr std::uint32_t kAmpleSteps = 100'000'000;

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
  /// Of the queries.
  std::vector<std::string> (*needed_columns)();
  RowAnswer in_float;
  RowAnswer in_double;
};

QueryKind time_of_contact_kind();
QueryKind distance_kind();
QueryKind impulse_kind();

}  // namespace batuta::answer
