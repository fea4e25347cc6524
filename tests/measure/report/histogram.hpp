// SPDX-License-Identifier: MIT
#pragma once
// Counts of values >= 0 in bins that are the same everywhere: 32 equal parts of every octave. Two
// histograms merge exactly by adding; whole numbers below 64 have bins of their own.

#include <cstdint>
#include <map>
#include <string>

namespace batuta::report {

class Histogram {
 public:
  static constexpr int kPartsOfOctave = 32;

  /// Counts a value. Negative values and NaN are counted as zero; infinity as the largest.
  void add(double value, std::uint64_t times = 1);
  void add(const Histogram& other);

  std::uint64_t count() const { return count_; }
  /// Lower edge of the bin of the value that `share` of all values do not exceed, the bin of rank
  /// ceil(share count); 0 where nothing was counted. @pre 0 < share <= 1
  double quantile(double share) const;
  /// "bin:count bin:count ...", bins ascending; empty where nothing was counted.
  std::string text() const;

  /// Bin of a value: 0 for zero, else 1 + 32 (exponent - least exponent) + part of the octave.
  static int bin_of(double value);
  /// Least value in a bin.
  static double edge_of(int bin);

 private:
  std::map<int, std::uint64_t> bins_;
  std::uint64_t count_ = 0;
};

}  // namespace batuta::report
