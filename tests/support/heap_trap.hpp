// SPDX-License-Identifier: MIT
#pragma once
// Counts calls of the heap on the host: malloc and its kin, and with them every operator new. For
// tests that show that something allocates nothing; link batuta_heap_trap. Works with glibc, and
// under the address sanitizer.

namespace batuta::test {

/// Counts from its construction on, in all threads. One at a time.
class HeapTrap {
 public:
  HeapTrap();
  ~HeapTrap();
  HeapTrap(const HeapTrap&) = delete;
  HeapTrap(HeapTrap&&) = delete;
  HeapTrap& operator=(const HeapTrap&) = delete;
  HeapTrap& operator=(HeapTrap&&) = delete;

  /// Blocks that were asked for since, resized ones included.
  int allocations() const;
  /// Blocks that were given back since.
  int releases() const;
};

}  // namespace batuta::test
