// SPDX-License-Identifier: MIT
// What newlib asks of a system, so that the planted images link: nothing of it does anything.

#include <cstddef>

extern "C" {
void* _sbrk(std::ptrdiff_t) {
  return nullptr;
}
int _write(int, const void*, std::size_t count) {
  return static_cast<int>(count);
}
int _read(int, void*, std::size_t) {
  return 0;
}
int _close(int) {
  return -1;
}
int _lseek(int, int, int) {
  return 0;
}
int _fstat(int, void*) {
  return -1;
}
int _isatty(int) {
  return 0;
}
int _kill(int, int) {
  return -1;
}
int _getpid() {
  return 1;
}
[[noreturn]] void _exit(int) {
  while (true) {  // Bound: none: nothing goes on
  }
}
}
