// SPDX-License-Identifier: MIT
#pragma once
// Files that a program writes: never half, never over what it reads, never one over another.

#include <fstream>
#include <string>
#include <vector>

namespace batuta::host {

/// A file that is written beside its place, and takes the place when it is whole: until then, and
/// where that never happens, what was there before stays. The new one has the owner, the group and
/// the permissions of the old one, from its first byte on; where the group cannot be kept, what it
/// may do is for no other group. Not over what the shell has opened for what is printed. A pipe or
/// a device is written in place. A signal that ends the program leaves nothing beside
/// (unfinished_files.hpp).
class OutputFile {
 public:
  OutputFile() = default;
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  ~OutputFile() { discard(); }

  /// Begins it; what an earlier open() began is forgotten.
  /// @returns an empty text | why it cannot be written, in the system's words
  std::string open(const std::string& path);

  /// Where it is written; one that is not open takes nothing.
  std::ostream& stream() { return file_; }
  bool is_open() const { return file_.is_open(); }

  /// It is whole, and takes its place.
  /// @returns an empty text | why not; then what was there before is there
  std::string commit();

 private:
  std::string open_stream(const std::string& path);
  void discard();
  void forget_beside();

  std::string place_;   ///< links followed
  std::string beside_;  ///< what is written; empty: the place itself
  std::ofstream file_;
};

/// What a program was told to read or write: the option, for a message, and the path.
struct NamedFile {
  std::string option;
  std::string path;
};

/// Whether two paths are one file, also by a link, or would be.
bool are_same_file(const std::string& one, const std::string& other);

/// Whether standard input is this file. Not told on Windows, where a file that is read cannot be
/// replaced.
bool is_standard_input(const std::string& path);

/// @returns an empty text | which output is also read, or written by another option, in one line;
///   what is printed, too, where the shell sends that to a file that is read; and an output to
///   which the shell sends what is printed. Where that is standard error and a file that is read,
///   nothing is told there from now on: the line itself would be written into it.
///   A pipe, a terminal or /dev/null may be so often as one likes.
std::string clash_of(const std::vector<NamedFile>& inputs, const std::vector<NamedFile>& outputs);

}  // namespace batuta::host
