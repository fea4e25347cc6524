// SPDX-License-Identifier: MIT
#pragma once
// Reads the CSV query files: one header line of column names, then one query a line. Input numbers
// are float32, by their bits or decimal, and a line that may be meant either way is refused; true
// answers are decimal. Lines are independent: a bad one is reported, the others are read.

#include <cstddef>
#include <istream>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace batuta::host {

/// The float whose IEEE-754 bits are the hexadecimal number `text`, most significant digit first,
/// with trailing zero digits left out: "3f8" is 1.0f, "8" is -0.0f. Nothing for an empty text, more
/// than 8 digits, another character.
std::optional<float> float_of_bits(std::string_view text);

/// The number written in `text`, the whole of it ("inf" and "nan" included). Nothing for anything
/// else.
std::optional<double> double_of_decimal(std::string_view text);

/// Column name -> position, shared by all rows of a file.
using Columns = std::map<std::string, std::size_t, std::less<>>;

/// One line of a query file. A getter that fails returns 0 and notes why; the first reason is kept,
/// so that a caller may read all fields and then ask ok() once.
class QueryRow {
 public:
  QueryRow() = default;
  QueryRow(const QueryRow&) = delete;  // fields refer to the row's own text
  QueryRow& operator=(const QueryRow&) = delete;

  /// 1-based number of the line, not counting the header.
  long line() const { return line_; }
  bool ok() const { return error_.empty(); }
  /// Empty, or "line 7, column A0x: ..." for the first thing that was wrong.
  const std::string& error() const { return error_; }

  /// A float32 field. By its bits: float_of_bits(), with 0x before it or bare. Decimal: with a
  /// point or a sign in it (2.0, -3, 1e-3, +2), "inf" or "nan"; rounded to float32 by way of
  /// double.
  float number(std::string_view column);
  /// To be called when all numbers of a query are read: fails where a bare field may be meant
  /// either way. A letter other than e shows that a field means bits, and then so do all bare ones
  /// of its line, unless one of the line is decimal.
  void check_notation();
  /// A decimal field, correctly rounded.
  double decimal(std::string_view column);
  /// A text field; refers to the row, so valid until it is read anew.
  std::string_view text(std::string_view column);

 private:
  friend class QueryFile;
  void start(long line, const Columns& columns);
  void fail(std::string_view column, std::string_view reason);

  const Columns* columns_ = nullptr;
  std::string content_;
  std::vector<std::string_view> fields_;  // views of content_
  std::string error_;
  long line_ = 0;
  std::string unclear_;         // the first column that may mean either
  bool has_decimal_ = false;    // the line has a number that is decimal for sure
  bool has_bare_bits_ = false;  // and one that is bits for sure, and bare
};

/// A query file as a stream of rows. Line ends may be LF or CR LF; the last one may be missing.
class QueryFile {
 public:
  /// A longer line is reported and skipped: no file makes the reader take unbounded memory.
  static constexpr std::size_t kMaxLineLength = 65536;

  /// Reads the header. @pre `in` outlives the file
  explicit QueryFile(std::istream& in);
  QueryFile(const QueryFile&) = delete;  // rows refer to the file's columns
  QueryFile& operator=(const QueryFile&) = delete;

  bool ok() const { return error_.empty(); }
  /// Empty, or why the header cannot be used; then there are no rows.
  const std::string& error() const { return error_; }
  bool has(std::string_view column) const { return columns_.find(column) != columns_.end(); }
  /// The columns without which a query cannot be read: the header cannot be used where one is
  /// missing, and error() names all of them.
  void require(const std::vector<std::string>& columns);

  /// Whether reading ended because the system failed, not because the file did.
  bool is_broken() const { return is_broken_; }

  /// Reads the next line into `row`, good or bad (ask row.ok()). Every line counts, also an empty
  /// one.
  /// @returns false at the end of the file, or where it cannot be read further: is_broken()
  bool next(QueryRow& row);

 private:
  enum class Line { kEnd, kRead, kTooLong };
  Line read_line(std::string& content);
  int read_byte();
  void read_header();
  void add_error(const std::string& what);

  std::istream& in_;
  Columns columns_;
  std::string error_;
  long line_ = 0;
  bool is_broken_ = false;
};

}  // namespace batuta::host
