// SPDX-License-Identifier: MIT
#pragma once
// Lines, words and numbers of a text.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace batuta::mesh {

/// A line with more words than this is cut after one more, so that its reader sees that it is too
/// long.
inline constexpr std::size_t kMostWords = 4096;

/// A text, line by line. Line ends may be LF or CR LF; the last one may be missing.
class Lines {
 public:
  explicit Lines(std::string_view text) : rest_(text) {}
  /// Cuts the next line into its words, which are views of the text. @returns false at the end
  bool next(std::vector<std::string_view>& words);
  /// 1-based number of the line last read.
  std::size_t number() const { return number_; }

 private:
  std::string_view rest_;
  std::size_t number_ = 0;
};

/// The finite number written in the whole of `word`.
std::optional<double> finite_number(std::string_view word);

/// The whole number written in the whole of `word`.
std::optional<long> whole_number(std::string_view word);

/// The word in quotes for a message, cut where it is long, with a dot for what cannot be printed.
std::string quoted(std::string_view word);

}  // namespace batuta::mesh
