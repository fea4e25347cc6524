// SPDX-License-Identifier: MIT

#include "programs/recording/file_stream.hpp"

#include <cerrno>
#include <cstring>

namespace batuta::host {
namespace {

std::string reason(const std::string& path) {
  return path + ": " + (errno != 0 ? std::strerror(errno) : "cannot be read");
}

}  // namespace

std::string FileSink::open(const std::string& path) {
  has_taken_ = false;
  const std::string problem = file_.open(path);
  return problem.empty() ? "" : path + ": " + problem;
}

std::string FileSink::close() {
  return file_.commit();
}

int FileSink::do_write(const std::uint8_t* bytes, int count) {
  if (!file_.is_open()) return 0;
  has_taken_ = has_taken_ || count > 0;
  for (int i = 0; i < count; ++i) {  // Bound: count
    if (!file_.stream().put(static_cast<char>(bytes[i]))) return i;
  }
  return count;
}

/// A folder can be opened, but not read.
std::string FileSource::open(const std::string& path) {
  errno = 0;
  file_.open(path, std::ios::binary);
  if (!file_) return reason(path);
  if (file_.peek() != std::ifstream::traits_type::eof()) return "";
  std::string error = errno != 0 ? reason(path) : path + ": is empty";
  file_.close();
  return error;
}

int FileSource::do_read(std::uint8_t* bytes, int capacity) {
  int count = 0;
  for (; count < capacity; ++count) {  // Bound: capacity
    const int byte = file_.get();
    if (byte == std::ifstream::traits_type::eof()) break;
    bytes[count] = static_cast<std::uint8_t>(byte);
  }
  return count > 0 ? count : -1;
}

}  // namespace batuta::host
