// SPDX-License-Identifier: MIT
#pragma once
// The console, files and exit status of the host that a debugger or QEMU runs on. Without one of
// them every call is a hard fault: for tests and tools, not for a product.

#include <cstdint>

namespace batuta::semihosting {

/// Ends the emulation; the host sees the lower 8 bits as exit status.
[[noreturn]] void exit(int status);

/// To the console.
void write(const char* text);
void write_unsigned(std::uint32_t value);
void write_hex(std::uint32_t value);  ///< 0x and eight digits

/// The program's command line, blanks between its arguments, the program's own name first.
/// @returns its length, or -1 where it does not fit or there is none; `line` ends with '\0'
int read_command_line(char* line, int capacity);

/// The `index`-th word of `line` (0: the program), copied to `word` with '\0'.
/// @returns its length, or -1 where there is none or it does not fit
int word_of(const char* line, int index, char* word, int capacity);

/// A file of the host; paths are relative to where the emulator was started.
class File {
 public:
  enum class Mode : std::uint32_t { kRead = 1, kWrite = 5 };  ///< binary; kWrite empties the file

  File() = default;
  ~File() { close(); }
  File(const File&) = delete;
  File& operator=(const File&) = delete;

  bool open(const char* path, Mode mode);
  bool is_open() const { return handle_ >= 0; }
  /// @returns how many bytes came: fewer than `count` at the end of the file; -1 where it failed
  int read(void* bytes, int count);
  /// @returns how many bytes were taken: fewer than `count` where the disk is full; -1 not open
  int write(const void* bytes, int count);
  /// @returns false where the host could not keep what was written
  bool close();

 private:
  int handle_ = -1;
};

}  // namespace batuta::semihosting
