// SPDX-License-Identifier: MIT
#pragma once
// A CSV whose columns say how they merge, so that merge.py needs to know no section:
//   name        key: rows with equal keys are one row
//   name:sum    whole number, merged by adding
//   name:max    number, merged by the larger; name:min by the smaller; empty: nothing was seen
//   name:hist   Histogram::text(), merged by adding bins
// Names of columns that hold times begin with "time": they differ from run to run. A row that has
// any gets two more: time_baselines:sum and time_disturbed:sum, how many baselines were measured
// since the row before, and how many of them on a host that was busy (timing.hpp).

#include <cstdint>
#include <string>
#include <vector>

#include "histogram.hpp"
#include "options.hpp"
#include "timing.hpp"

namespace batuta::report {

class Table {
 public:
  /// @param section  name of the file, see About
  Table(const Options& options, std::string section);

  Table& key(const char* name, const std::string& value);
  Table& key(const char* name, double value);
  Table& sum(const char* name, std::uint64_t value);
  /// NaN: nothing was seen.
  Table& max(const char* name, double value);
  Table& min(const char* name, double value);
  Table& hist(const char* name, const Histogram& value);
  /// Ends a row. All rows have the same columns in the same order, or the program ends with a
  /// message.
  void end_row();

  /// Writes the file and says where. @returns exit code of the program: 0, or 1 with a sentence on
  /// standard error where the file cannot be written
  int write() const;

 private:
  Table& cell(std::string name, std::string value);
  void count_baselines();

  Options options_;
  std::string section_;
  std::vector<std::string> columns_;
  std::vector<std::string> names_;
  std::vector<std::string> values_;
  std::string rows_;
  BaselineCount seen_;  ///< by the end of the row before
};

/// Shortest text that reads back as the same number; empty for NaN.
std::string text_of(double value);

}  // namespace batuta::report
