// SPDX-License-Identifier: MIT
#include "programs/query_file.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <iostream>
#include <set>

namespace batuta::host {
namespace {

constexpr std::size_t kFloatDigits = 8;
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

void split(std::string_view content, std::vector<std::string_view>& fields) {
  fields.clear();
  std::size_t begin = 0;
  for (std::size_t comma = content.find(','); comma != std::string_view::npos;
       comma = content.find(',', begin)) {  // Bound: the length of the line
    fields.push_back(content.substr(begin, comma - begin));
    begin = comma + 1;
  }
  fields.push_back(content.substr(begin));
}

/// Digits behind it are bits.
constexpr std::string_view kBitsPrefix = "0x";

/// Not hexadecimal digits, and words that are none.
bool is_decimal(std::string_view text) {
  return text.find_first_of(".+-") != std::string_view::npos || text == "inf" || text == "nan";
}

/// What no decimal number looks like.
bool is_surely_bits(std::string_view text) {
  return text.find_first_of("abcdfABCDF") != std::string_view::npos;
}

/// The same either way.
bool is_zero(std::string_view text) {
  return text.find_first_not_of('0') == std::string_view::npos;
}

/// Nothing for what is none, and for what is finite and beyond float32. @pre is_decimal()
std::optional<float> float_of_decimal(std::string_view text) {
  if (text.front() == '+' && text.substr(1, 1) != "-") text.remove_prefix(1);
  const std::optional<double> value = double_of_decimal(text);
  if (!value) return std::nullopt;
  const auto rounded = static_cast<float>(*value);
  if (std::isfinite(*value) && !std::isfinite(rounded)) return std::nullopt;
  return rounded;
}

}  // namespace

std::optional<float> float_of_bits(std::string_view text) {
  if (text.empty() || text.size() > kFloatDigits) return std::nullopt;
  std::uint32_t bits = 0;
  const char* end = text.data() + text.size();
  const auto [stop, status] = std::from_chars(text.data(), end, bits, 16);
  if (status != std::errc() || stop != end) return std::nullopt;
  bits <<= 4 * (kFloatDigits - text.size());
  float value = 0;
  static_assert(sizeof value == sizeof bits);
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

std::optional<double> double_of_decimal(std::string_view text) {
  double value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, status] = std::from_chars(text.data(), end, value);
  if (status != std::errc() || stop != end) return std::nullopt;
  return value;
}

void QueryRow::start(long line, const Columns& columns) {
  columns_ = &columns;
  content_.clear();
  fields_.clear();
  error_.clear();
  line_ = line;
  unclear_.clear();
  has_decimal_ = has_bare_bits_ = false;
}

void QueryRow::fail(std::string_view column, std::string_view reason) {
  if (!error_.empty()) return;
  error_ = "line " + std::to_string(line_);
  if (!column.empty()) error_.append(", column ").append(column);
  error_.append(": ").append(reason);
}

std::string_view QueryRow::text(std::string_view column) {
  if (!ok() || columns_ == nullptr) return {};
  const auto found = columns_->find(column);
  if (found != columns_->end()) return fields_[found->second];
  fail(column, "the file has no such column");
  return {};
}

float QueryRow::number(std::string_view column) {
  std::string_view field = text(column);
  std::optional<float> value;
  if (is_decimal(field)) {
    has_decimal_ = true;
    value = float_of_decimal(field);
  } else if (field.substr(0, kBitsPrefix.size()) == kBitsPrefix) {
    value = float_of_bits(field.substr(kBitsPrefix.size()));
  } else {
    has_bare_bits_ = has_bare_bits_ || is_surely_bits(field);
    const bool is_clear = is_surely_bits(field) || is_zero(field);
    if (!is_clear && unclear_.empty()) unclear_ = column;
    value = float_of_bits(field);
  }
  if (!value)
    fail(column,
         "expected a float: its bits, 1 to 8 hexadecimal digits, or decimal, 2.0, in its range");
  return value.value_or(0.0F);
}

void QueryRow::check_notation() {
  if (unclear_.empty() || (has_bare_bits_ && !has_decimal_)) return;
  const std::string field(text(unclear_));
  std::string number = field;
  number.insert(std::min(number.find_first_of("eE"), number.size()), ".0");
  fail(unclear_, field + " is not clear: 0x" + field + " for bits, " + number + " for a number");
}

double QueryRow::decimal(std::string_view column) {
  const std::optional<double> value = double_of_decimal(text(column));
  if (!value) fail(column, "expected a decimal number");
  return value.value_or(0.0);
}

QueryFile::QueryFile(std::istream& in) : in_(in) {
  read_header();
}

/// The next byte; the end of the file, also where the system cannot read on. Files tell that by an
/// exception, standard input by stdin alone.
int QueryFile::read_byte() {
  using Traits = std::istream::traits_type;
  try {
    const int byte = is_broken_ ? Traits::eof() : in_.rdbuf()->sbumpc();
    const bool is_end = Traits::eq_int_type(byte, Traits::eof());
    is_broken_ = is_broken_ || (is_end && &in_ == &std::cin && std::ferror(stdin) != 0);
    return byte;
  } catch (const std::ios_base::failure&) {
    is_broken_ = true;
    return Traits::eof();
  }
}

QueryFile::Line QueryFile::read_line(std::string& content) {
  using Traits = std::istream::traits_type;
  content.clear();
  if (in_.rdbuf() == nullptr) return Line::kEnd;
  bool read_any = false;
  bool too_long = false;
  // Bound: the length of the file.
  for (int c = read_byte(); !Traits::eq_int_type(c, Traits::eof()); c = read_byte()) {
    read_any = true;
    if (Traits::to_char_type(c) == '\n') break;
    too_long = too_long || content.size() == kMaxLineLength;
    if (!too_long) content.push_back(Traits::to_char_type(c));
  }
  if (!read_any || is_broken_) return Line::kEnd;  // half a line may read like a whole one
  if (too_long) return Line::kTooLong;
  if (!content.empty() && content.back() == '\r') content.pop_back();
  return Line::kRead;
}

void QueryFile::add_error(const std::string& what) {
  error_ += (error_.empty() ? "header: " : "; ") + what;
}

void QueryFile::require(const std::vector<std::string>& columns) {
  if (columns_.empty()) return;  // told already
  std::string missing;
  for (const std::string& column : columns) {  // Bound: columns of a query
    if (!has(column)) missing += (missing.empty() ? "" : ", ") + column;
  }
  if (!missing.empty()) add_error("there is no column " + missing);
}

void QueryFile::read_header() {
  std::string content;
  const Line result = read_line(content);
  if (result == Line::kTooLong) {
    add_error("the line is too long");
    return;
  }
  std::string_view header = content;
  if (header.substr(0, kByteOrderMark.size()) == kByteOrderMark) {
    header.remove_prefix(kByteOrderMark.size());
  }
  if (header.empty()) {
    add_error("the file has none");
    return;
  }
  std::vector<std::string_view> names;
  split(header, names);
  std::set<std::string_view> told;
  for (std::size_t i = 0; i < names.size(); ++i) {  // Bound: the length of the line
    if (names[i].empty()) {
      add_error("column " + std::to_string(i + 1) + " has no name");
    } else if (!columns_.emplace(names[i], i).second && told.insert(names[i]).second) {
      add_error("there are two columns " + std::string(names[i]));
    }
  }
}

bool QueryFile::next(QueryRow& row) {
  if (!ok()) return false;
  row.start(line_ + 1, columns_);
  const Line result = read_line(row.content_);
  if (result == Line::kEnd) return false;
  ++line_;
  if (result == Line::kTooLong) {
    row.fail({}, "longer than " + std::to_string(kMaxLineLength) + " characters");
    return true;
  }
  split(row.content_, row.fields_);
  if (row.fields_.size() != columns_.size()) {
    row.fail({}, "expected " + std::to_string(columns_.size()) + " fields, found " +
                     std::to_string(row.fields_.size()));
  }
  return true;
}

}  // namespace batuta::host
