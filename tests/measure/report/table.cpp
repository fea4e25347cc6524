// SPDX-License-Identifier: MIT
#include "table.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace batuta::report {

namespace {

std::string joined(const std::vector<std::string>& cells) {
  std::string line;
  for (const std::string& cell : cells) line += cell + ",";
  if (!line.empty()) line.pop_back();
  return line + "\n";
}

}  // namespace

std::string text_of(double value) {
  if (std::isnan(value)) return "";
  char text[40];
  const auto end = std::to_chars(text, text + sizeof text, value);
  return std::string(text, end.ptr);
}

Table::Table(const Options& options, std::string section)
    : options_(options), section_(std::move(section)), seen_(baselines()) {}

Table& Table::cell(std::string name, std::string value) {
  names_.push_back(std::move(name));
  values_.push_back(std::move(value));
  return *this;
}

Table& Table::key(const char* name, const std::string& value) {
  return cell(name, value);
}
Table& Table::key(const char* name, double value) {
  return cell(name, text_of(value));
}
Table& Table::sum(const char* name, std::uint64_t value) {
  return cell(std::string(name) + ":sum", std::to_string(value));
}
Table& Table::max(const char* name, double value) {
  return cell(std::string(name) + ":max", text_of(value));
}
Table& Table::min(const char* name, double value) {
  return cell(std::string(name) + ":min", text_of(value));
}
Table& Table::hist(const char* name, const Histogram& value) {
  return cell(std::string(name) + ":hist", value.text());
}

void Table::count_baselines() {
  const auto is_time = [](const std::string& name) { return name.rfind("time", 0) == 0; };
  if (std::none_of(names_.begin(), names_.end(), is_time)) return;
  if (baselines().all == seen_.all) (void)plain_ns();
  const BaselineCount now = baselines();
  sum("time_baselines", now.all - seen_.all);
  sum("time_disturbed", now.disturbed - seen_.disturbed);
  seen_ = now;
}

void Table::end_row() {
  count_baselines();
  if (columns_.empty()) columns_ = names_;
  if (columns_ != names_) {
    std::fprintf(stderr, "%s: a row has other columns than the first\n", section_.c_str());
    std::exit(1);
  }
  rows_ += joined(values_);
  names_.clear();
  values_.clear();
}

int Table::write() const {
  std::error_code ignored;  // a folder that cannot be made shows in the file
  std::filesystem::create_directories(options_.out, ignored);
  std::string name = section_;
  if (options_.shards > 1) {
    name += "." + std::to_string(options_.shard) + "-of-" + std::to_string(options_.shards);
  }
  const std::string path = options_.out + "/" + name + ".csv";
  std::ofstream file(path, std::ios::binary);
  file << joined(columns_) << rows_;
  file.close();
  if (!file) {
    std::fprintf(stderr, "%s: cannot write %s\n", section_.c_str(), path.c_str());
    return 1;
  }
  std::fprintf(stderr, "%s: wrote %s\n", section_.c_str(), path.c_str());
  return 0;
}

}  // namespace batuta::report
