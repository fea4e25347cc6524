// SPDX-License-Identifier: MIT
#pragma once
// The numbers that the key poses of a map are made of, by name: a text file of name=value, one a
// line, that names each of them once. Lengths in m, frame F (skeleton.hpp).

#include <string>
#include <vector>

namespace fight {

/// A number, and how far the search moves it at first.
struct Knob {
  std::string name;
  double step;
};

/// All of them, in the order of the file.
const std::vector<Knob>& knobs();

/// A value for each of the knobs.
class Knobs {
 public:
  /// Reads a file. @returns what is wrong with it; empty: nothing
  std::string load(const std::string& path);
  /// Takes name=value lines; # begins a remark. @returns what is wrong with them; empty: nothing
  std::string parse(const std::string& text);
  /// Writes a file that load() reads; it takes its place when it is whole.
  /// @returns what is wrong with that; empty: nothing
  std::string save(const std::string& path) const;

  /// @pre one of the names
  double at(const std::string& name) const;
  double& at(const std::string& name);
  double& operator[](std::size_t i) { return values_[i]; }
  double operator[](std::size_t i) const { return values_[i]; }

 private:
  std::vector<double> values_ = std::vector<double>(knobs().size(), 0.0);
};

}  // namespace fight
