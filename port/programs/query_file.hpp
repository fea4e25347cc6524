// SPDX-License-Identifier: MIT
#pragma once
// Reads the CSV query files: one header line of column names, then one query a line. Input numbers
// are float32 by their bits, true answers are decimal. Lines are independent: a bad one is
// reported, the others are read.

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

  /// A float32 field, exactly.
  float bits(std::string_view column);
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

  /// Reads the next line into `row`, good or bad (ask row.ok()). Every line counts, also an empty
  /// one.
  /// @returns false at the end of the file
  bool next(QueryRow& row);

 private:
  enum class Line { kEnd, kRead, kTooLong };
  Line read_line(std::string& content);
  void read_header();

  std::istream& in_;
  Columns columns_;
  std::string error_;
  long line_ = 0;
};

}  // namespace batuta::host
