// SPDX-License-Identifier: MIT
#pragma once
// Query file in, answer file out: what all kinds of queries have in common.

#include <ostream>

#include "query_kind.hpp"

namespace batuta::answer {

/// Writes the header and one row for every line of `file`, in the same order. A line that cannot be
/// read or makes no sense gets a row with only its number and INVALID, and a line on `errors`. Ends
/// where `out` takes no more.
/// @returns how many lines were invalid
long answer_file(host::QueryFile& file, const char* columns, RowAnswer answer,
                 const SearchSettings& settings, std::ostream& out, std::ostream& errors);

}  // namespace batuta::answer
