// SPDX-License-Identifier: MIT
#pragma once
// Files, text and the words of the command line, on a host by its library (io_host.cpp) and on a
// bare part through the debugger (io_semihosting.cpp).

#include <array>
#include <cstdint>

namespace batuta::digest {

/// The words of the command line, without the program's name.
struct Words {
  static constexpr int kMost = 24;
  std::array<const char*, kMost> word{};
  int count = 0;
};

/// @param count, words  of main(); a bare part has none and asks the debugger
Words command_line(int count, char** words);

/// A number that the platform gives to an open file; negative: none.
using File = int;

File open_to_read(const char* path);
File open_to_write(const char* path);
/// @returns bytes read: fewer than `capacity` only at the end of the file, or where reading fails
std::uint32_t read_bytes(File file, void* bytes, std::uint32_t capacity);
/// @returns whether all were written
bool write_bytes(File file, const void* bytes, std::uint32_t count);
bool close_file(File file);

/// @param text  ends with a zero
void say(const char* text);

/// The end of main(): what it is to return, on a platform where it may.
int leave(int status);

}  // namespace batuta::digest
