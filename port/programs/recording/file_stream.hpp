// SPDX-License-Identifier: MIT
#pragma once
// A file as sink and source of a recording.

#include <fstream>
#include <string>

#include "batuta/port/byte_stream.hpp"
#include "programs/files/output_file.hpp"

namespace batuta::host {

/// Takes everything as long as the disk does; the file takes its place when it is closed.
class FileSink final : public ByteSink {
 public:
  /// @returns an empty text, or what is wrong
  std::string open(const std::string& path);
  /// Whether it was given anything since it was opened.
  bool has_taken() const { return has_taken_; }
  /// @returns an empty text | why not everything that was taken is in the file
  std::string close();

 private:
  int do_write(const std::uint8_t* bytes, int count) override;

  OutputFile file_;
  bool has_taken_ = false;
};

class FileSource final : public ByteSource {
 public:
  /// @returns an empty text, or what is wrong
  std::string open(const std::string& path);

 private:
  int do_read(std::uint8_t* bytes, int capacity) override;

  std::ifstream file_;
};

}  // namespace batuta::host
