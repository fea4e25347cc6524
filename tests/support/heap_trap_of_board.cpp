// SPDX-License-Identifier: MIT
// HeapTrap for a bare board, which has no heap behind these functions: they count, and give one
// and the same block. It is enough for a device that must not ask at all; nothing is kept in it.
#include "heap_trap.hpp"

#include <cstddef>

namespace {

bool armed = false;
int allocations = 0;
int releases = 0;
alignas(std::max_align_t) unsigned char block[1024];

void* counted(std::size_t size) {
  if (armed) ++allocations;
  return size <= sizeof block ? block : nullptr;
}

}  // namespace

extern "C" {

void* malloc(std::size_t size) {
  return counted(size);
}
void* calloc(std::size_t count, std::size_t size) {
  void* const room =
      count <= sizeof block && size <= sizeof block ? counted(count * size) : nullptr;
  for (std::size_t i = 0; room != nullptr && i < count * size; ++i) block[i] = 0;
  return room;
}
void* realloc(void*, std::size_t size) {
  return counted(size);
}
void free(void*) {
  if (armed) ++releases;  // a null pointer is counted as well
}

}  // extern "C"

namespace batuta::test {

HeapTrap::HeapTrap() {
  ::allocations = 0;
  ::releases = 0;
  armed = true;
}
HeapTrap::~HeapTrap() {
  armed = false;
}
int HeapTrap::allocations() const {
  return ::allocations;
}
int HeapTrap::releases() const {
  return ::releases;
}

}  // namespace batuta::test
