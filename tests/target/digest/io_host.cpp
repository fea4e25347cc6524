// SPDX-License-Identifier: MIT
#include <cstdio>
#include <fstream>

#include "io.hpp"

namespace batuta::digest {
namespace {

constexpr File kFiles = 2;  // what this program has open at a time
std::array<std::fstream, kFiles> open_files;

std::fstream& stream_of(File file) {
  return open_files[static_cast<std::size_t>(file)];
}

File open_file(const char* path, std::ios::openmode mode) {
  for (File file = 0; file < kFiles; ++file) {  // Bound: kFiles
    std::fstream& stream = stream_of(file);
    if (stream.is_open()) continue;
    stream.clear();
    stream.open(path, mode | std::ios::binary);
    return stream.is_open() ? file : -1;
  }
  return -1;
}

}  // namespace

Words command_line(int count, char** words) {
  Words line;
  for (int i = 1; i < count && line.count < Words::kMost; ++i) {  // Bound: Words::kMost
    line.word[static_cast<std::size_t>(line.count)] = words[i];
    ++line.count;
  }
  return line;
}

File open_to_read(const char* path) {
  return open_file(path, std::ios::in);
}

File open_to_write(const char* path) {
  return open_file(path, std::ios::out | std::ios::trunc);
}

std::uint32_t read_bytes(File file, void* bytes, std::uint32_t capacity) {
  std::fstream& stream = stream_of(file);
  stream.read(static_cast<char*>(bytes), static_cast<std::streamsize>(capacity));
  return static_cast<std::uint32_t>(stream.gcount());
}

bool write_bytes(File file, const void* bytes, std::uint32_t count) {
  const auto size = static_cast<std::streamsize>(count);  // of 32 bits in WebAssembly
  return static_cast<bool>(stream_of(file).write(static_cast<const char*>(bytes), size));
}

/// The end of a file that was read is no failure; that of the disk is.
bool close_file(File file) {
  std::fstream& stream = stream_of(file);
  const bool at_end = stream.eof();
  if (at_end) stream.clear();
  stream.close();
  return !stream.fail();
}

void say(const char* text) {
  (void)std::fputs(text, stdout);
}

int leave(int status) {
  return status;
}

}  // namespace batuta::digest
