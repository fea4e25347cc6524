// SPDX-License-Identifier: MIT
#include "answer_file.hpp"

#include <iomanip>

namespace batuta::answer {

namespace {

constexpr int kDigits = 17;  // tells any two doubles apart

void write_row(std::ostream& out, long line, const Answer& answer) {
  out << line;
  if (!answer.word.empty()) out << ',' << answer.word;
  for (const double number : answer.numbers) out << ',' << number;  // Bound: columns of the kind
  out << '\n';
}

}  // namespace

long answer_file(host::QueryFile& file, const char* columns, RowAnswer answer,
                 const SearchSettings& settings, std::ostream& out, std::ostream& errors) {
  out << std::setprecision(kDigits) << columns << '\n';
  long invalid = 0;
  host::QueryRow row;
  while (out && file.next(row)) {  // Bound: lines of the file
    Answer answered = answer(row, settings);
    row.check_notation();
    if (row.ok() && answered.problem.empty()) {
      write_row(out, row.line(), answered);
      continue;
    }
    ++invalid;
    write_row(out, row.line(), {"INVALID", {}, {}});
    if (row.ok()) {
      errors << "line " << row.line() << ": " << answered.problem << '\n';
    } else {
      errors << row.error() << '\n';
    }
  }
  return invalid;
}

}  // namespace batuta::answer
