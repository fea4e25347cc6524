// SPDX-License-Identifier: MIT
#include "programs/mass/words.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "programs/query_file.hpp"

namespace batuta::mesh {
namespace {

constexpr std::string_view kBlank = " \t\r";
constexpr std::size_t kMostQuoted = 40;

}  // namespace

bool Lines::next(std::vector<std::string_view>& words) {
  words.clear();
  if (rest_.empty()) return false;
  ++number_;
  const std::size_t end = std::min(rest_.find('\n'), rest_.size());
  std::string_view line = rest_.substr(0, end);
  rest_.remove_prefix(std::min(end + 1, rest_.size()));
  while (words.size() <= kMostWords) {  // Bound: kMostWords + 1
    const std::size_t from = line.find_first_not_of(kBlank);
    if (from == std::string_view::npos) return true;
    line.remove_prefix(from);
    const std::size_t size = std::min(line.find_first_of(kBlank), line.size());
    words.push_back(line.substr(0, size));
    line.remove_prefix(size);
  }
  return true;
}

std::optional<double> finite_number(std::string_view word) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  const std::optional<double> number = host::double_of_decimal(word);
  return number && std::isfinite(*number) ? number : std::nullopt;
}

std::optional<long> whole_number(std::string_view word) {
  long value = 0;
  const char* end = word.data() + word.size();
  const auto [stop, status] = std::from_chars(word.data(), end, value);
  if (status != std::errc() || stop != end) return std::nullopt;
  return value;
}

std::string quoted(std::string_view word) {
  std::string text = "'";
  for (const char c : word.substr(0, kMostQuoted)) {
    const bool printable = c >= ' ' && c <= '~';
    text += printable ? c : '.';
  }
  return text + (word.size() > kMostQuoted ? "...'" : "'");
}

}  // namespace batuta::mesh
