// SPDX-License-Identifier: MIT

#include "programs/devices/event_line.hpp"

#include <charconv>

namespace batuta::host {
namespace {

constexpr std::string_view kBlanks = " \t\r";
constexpr std::int64_t kMaxSeconds = 1'000'000'000'000;  // year 33658: no overflow in microseconds

/// Cuts the first word off `rest`; empty if there is none.
std::string_view next_word(std::string_view& rest) {
  const std::size_t begin = rest.find_first_not_of(kBlanks);
  if (begin == std::string_view::npos) return rest = {};
  rest.remove_prefix(begin);
  const std::string_view word = rest.substr(0, rest.find_first_of(kBlanks));
  rest.remove_prefix(word.size());
  return word;
}

/// The whole word as a number of type T, or false.
template <class T>
bool read_number(std::string_view word, int base, T& number) {
  const char* end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, number, base);
  return error == std::errc{} && stop == end;
}

/// <seconds>.<microseconds, six digits>
bool read_time(std::string_view word, std::int64_t& time_us) {
  constexpr std::size_t kDigits = 6;
  const std::size_t point = word.find('.');
  if (point == std::string_view::npos || word.size() - point - 1 != kDigits) return false;
  std::uint64_t seconds = 0;
  std::uint32_t micros = 0;
  if (!read_number(word.substr(0, point), 10, seconds) || seconds > kMaxSeconds) return false;
  if (!read_number(word.substr(point + 1), 10, micros)) return false;
  time_us = static_cast<std::int64_t>(seconds) * 1'000'000 + micros;
  return true;
}

bool read_event(std::string_view fields, DeviceEvent& event) {
  DeviceEvent read;
  if (!read_time(next_word(fields), read.time_us)) return false;
  if (!read_number(next_word(fields), 16, read.type)) return false;
  if (!read_number(next_word(fields), 16, read.code)) return false;
  if (!read_number(next_word(fields), 10, read.value)) return false;
  const std::string_view comment = next_word(fields);
  if (!comment.empty() && comment.front() != '#') return false;
  event = read;
  return true;
}

/// Whether an axis's numbers fit in 32 bits: libevemu takes those that do not for other ones.
bool are_numbers_of_an_axis(std::string_view fields) {
  std::string_view word = next_word(fields);
  while (!word.empty() && word.front() != '#') {  // Bound: words of the line
    std::int32_t number = 0;
    const auto read = std::from_chars(word.data(), word.data() + word.size(), number);
    if (read.ec == std::errc::result_out_of_range) return false;
    word = next_word(fields);
  }
  return true;
}

}  // namespace

LineKind read_line(std::string_view line, DeviceEvent& event) {
  const std::size_t begin = line.find_first_not_of(kBlanks);
  if (begin == std::string_view::npos || line[begin] == '#') return LineKind::kNothing;
  if (line.size() < 2 || line[1] != ':') return LineKind::kMalformed;
  if (line[0] == 'E') {
    return read_event(line.substr(2), event) ? LineKind::kEvent : LineKind::kMalformed;
  }
  if (line[0] == 'A' && !are_numbers_of_an_axis(line.substr(2))) return LineKind::kMalformed;
  constexpr std::string_view kDescription = "NIPBALS";
  const bool known = kDescription.find(line[0]) != std::string_view::npos;
  return known ? LineKind::kDescription : LineKind::kMalformed;
}

}  // namespace batuta::host
