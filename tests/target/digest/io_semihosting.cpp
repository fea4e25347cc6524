// SPDX-License-Identifier: MIT
#include "io.hpp"
#include "platforms/cortex_m/semihosting.hpp"

namespace batuta::digest {
namespace {

constexpr File kFiles = 2;  // what this program has open at a time
std::array<semihosting::File, kFiles> open_files;

semihosting::File& file_of(File file) {
  return open_files[static_cast<std::size_t>(file)];
}

File open_file(const char* path, semihosting::File::Mode mode) {
  for (File file = 0; file < kFiles; ++file) {  // Bound: kFiles
    if (file_of(file).is_open()) continue;
    return file_of(file).open(path, mode) ? file : -1;
  }
  return -1;
}

}  // namespace

/// Splits the debugger's line at blanks, in place; its first word is the program's name.
Words command_line(int /*count*/, char** /*words*/) {
  static std::array<char, 1024> line;
  Words words;
  if (semihosting::read_command_line(line.data(), static_cast<int>(line.size())) < 0) return words;
  char previous = 'x';    // the program's name begins here, and is left out
  for (char& c : line) {  // Bound: the length of the line
    if (c == '\0') break;
    if (c == ' ') c = '\0';
    const bool begins = previous == '\0' && c != '\0';
    if (begins && words.count < Words::kMost) {
      words.word[static_cast<std::size_t>(words.count)] = &c;
      ++words.count;
    }
    previous = c;
  }
  return words;
}

File open_to_read(const char* path) {
  return open_file(path, semihosting::File::Mode::kRead);
}

File open_to_write(const char* path) {
  return open_file(path, semihosting::File::Mode::kWrite);
}

std::uint32_t read_bytes(File file, void* bytes, std::uint32_t capacity) {
  const int count = file_of(file).read(bytes, static_cast<int>(capacity));
  return count < 0 ? 0 : static_cast<std::uint32_t>(count);
}

bool write_bytes(File file, const void* bytes, std::uint32_t count) {
  return file_of(file).write(bytes, static_cast<int>(count)) == static_cast<int>(count);
}

bool close_file(File file) {
  return file_of(file).close();
}

void say(const char* text) {
  semihosting::write(text);
}

int leave(int status) {
  semihosting::exit(status);
}

}  // namespace batuta::digest
