// SPDX-License-Identifier: MIT
// Arm "Semihosting for AArch32 and AArch64", version 3: operation in r0, argument block in r1.
#include "platforms/cortex_m/semihosting.hpp"

namespace batuta::semihosting {
namespace {

enum class Operation : std::uint32_t {
  kOpen = 0x01,
  kClose = 0x02,
  kWriteText = 0x04,
  kWrite = 0x05,
  kRead = 0x06,
  kGetCommandLine = 0x15,
  kExitExtended = 0x20,
};

int call(Operation operation, const void* argument) {
  register auto r0 __asm__("r0") = static_cast<std::uint32_t>(operation);
  register const auto* r1 __asm__("r1") = argument;
  __asm volatile("bkpt 0xAB" : "+r"(r0) : "r"(r1) : "memory");
  return static_cast<int>(r0);
}

std::uint32_t as_word(const void* pointer) {
  return static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(pointer));
}

/// Bound: the length of the text.
std::uint32_t length_of(const char* text) {
  std::uint32_t length = 0;
  while (text[length] != '\0') ++length;
  return length;
}

}  // namespace

void exit(int status) {
  constexpr std::uint32_t kApplicationExit = 0x20026;
  const std::uint32_t block[] = {kApplicationExit, static_cast<std::uint32_t>(status)};
  for (;;) (void)call(Operation::kExitExtended, block);  // Bound: does not come back.
}

void write(const char* text) {
  (void)call(Operation::kWriteText, text);
}

void write_unsigned(std::uint32_t value) {
  char digits[11] = {};
  char* first = digits + 10;
  // Bound: 10 digits.
  do {
    *--first = static_cast<char>('0' + value % 10U);
    value /= 10U;
  } while (value != 0);
  write(first);
}

void write_hex(std::uint32_t value) {
  char text[11] = "0x";
  for (int i = 0; i < 8; ++i) text[2 + i] = "0123456789abcdef"[(value >> (28 - 4 * i)) & 15U];
  write(text);
}

int read_command_line(char* line, int capacity) {
  std::uint32_t block[] = {as_word(line), static_cast<std::uint32_t>(capacity)};
  if (capacity <= 0 || call(Operation::kGetCommandLine, block) != 0) return -1;
  return static_cast<int>(length_of(line));
}

int word_of(const char* line, int index, char* word, int capacity) {
  // Bound: the length of the line, in both loops.
  for (; index > 0 && *line != '\0'; ++line) {
    if (*line == ' ') --index;
  }
  int length = 0;
  for (; line[length] != '\0' && line[length] != ' '; ++length) {
    if (length + 1 >= capacity) return -1;
    word[length] = line[length];
  }
  if (length == 0) return -1;
  word[length] = '\0';
  return length;
}

bool File::open(const char* path, Mode mode) {
  close();
  const std::uint32_t block[] = {as_word(path), static_cast<std::uint32_t>(mode), length_of(path)};
  handle_ = call(Operation::kOpen, block);
  return is_open();
}

// NOLINTNEXTLINE(readability-make-member-function-const) deviation: file-position
int File::read(void* bytes, int count) {
  if (!is_open() || count < 0) return -1;
  const std::uint32_t block[] = {static_cast<std::uint32_t>(handle_), as_word(bytes),
                                 static_cast<std::uint32_t>(count)};
  const int missing = call(Operation::kRead, block);
  return missing < 0 || missing > count ? -1 : count - missing;
}

// NOLINTNEXTLINE(readability-make-member-function-const) deviation: file-position
int File::write(const void* bytes, int count) {
  if (!is_open() || count < 0) return -1;
  const std::uint32_t block[] = {static_cast<std::uint32_t>(handle_), as_word(bytes),
                                 static_cast<std::uint32_t>(count)};
  const int missing = call(Operation::kWrite, block);
  return missing < 0 || missing > count ? -1 : count - missing;
}

bool File::close() {
  if (!is_open()) return true;
  const std::uint32_t block[] = {static_cast<std::uint32_t>(handle_)};
  handle_ = -1;
  return call(Operation::kClose, block) == 0;
}

}  // namespace batuta::semihosting
