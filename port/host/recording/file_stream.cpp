// SPDX-License-Identifier: MIT

#include "host/recording/file_stream.hpp"

#include <cerrno>
#include <cstring>

namespace batuta::host {
namespace {

std::string open_file(const std::string& path, const char* mode, File& file) {
  file.reset(std::fopen(path.c_str(), mode));
  return file ? "" : path + ": " + std::strerror(errno);
}

}  // namespace

std::string FileSink::open(const std::string& path) {
  return open_file(path, "wb", file_);
}

bool FileSink::close() {
  if (!file_) return false;
  const bool good = std::ferror(file_.get()) == 0;
  return std::fclose(file_.release()) == 0 && good;
}

int FileSink::do_write(const std::uint8_t* bytes, int count) {
  if (!file_) return 0;
  return static_cast<int>(std::fwrite(bytes, 1, static_cast<std::size_t>(count), file_.get()));
}

/// A folder can be opened, but not read.
std::string FileSource::open(const std::string& path) {
  std::string error = open_file(path, "rb", file_);
  if (!error.empty()) return error;
  const int first = std::fgetc(file_.get());
  if (first != EOF) return std::ungetc(first, file_.get()) == first ? "" : path + ": not read";
  error = path + ": " + (std::ferror(file_.get()) != 0 ? std::strerror(errno) : "is empty");
  file_.reset();
  return error;
}

int FileSource::do_read(std::uint8_t* bytes, int capacity) {
  if (!file_) return -1;
  const std::size_t count = std::fread(bytes, 1, static_cast<std::size_t>(capacity), file_.get());
  return count > 0 ? static_cast<int>(count) : -1;
}

}  // namespace batuta::host
