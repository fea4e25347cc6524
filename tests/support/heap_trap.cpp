// SPDX-License-Identifier: MIT
#include "heap_trap.hpp"

#include <atomic>
#include <cerrno>
#include <cstddef>

#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define BATUTA_HAS_ASAN 1
#endif
#endif
#if defined(__SANITIZE_ADDRESS__)
#define BATUTA_HAS_ASAN 1
#endif

namespace {

std::atomic<bool> armed{false};
std::atomic<int> allocations{0};
std::atomic<int> releases{0};

void count_allocation() {
  if (armed.load(std::memory_order_relaxed)) allocations.fetch_add(1, std::memory_order_relaxed);
}

void count_release() {
  if (armed.load(std::memory_order_relaxed)) releases.fetch_add(1, std::memory_order_relaxed);
}

}  // namespace

#ifdef BATUTA_HAS_ASAN

// The sanitizer owns the heap; it calls these for every block, also for those of operator new.
// Declared here because GCC does not ship the header.
// NOLINTBEGIN(*-reserved-identifier,cert-dcl*,readability-identifier-naming) deviation: heap-trap
extern "C" int __sanitizer_install_malloc_and_free_hooks(
    void (*on_malloc)(const volatile void* block, std::size_t size),
    void (*on_free)(const volatile void* block));
// NOLINTEND(*-reserved-identifier,cert-dcl*,readability-identifier-naming) deviation: heap-trap

namespace {
void on_malloc(const volatile void* /*block*/, std::size_t /*size*/) {
  count_allocation();
}
void on_free(const volatile void* /*block*/) {
  count_release();
}
[[maybe_unused]] const int hooks_installed =
    __sanitizer_install_malloc_and_free_hooks(on_malloc, on_free);
}  // namespace

#else

// The program's own definitions come before those of the C library, also for the C++ library's
// operator new.
extern "C" {
// NOLINTBEGIN(*-reserved-identifier,cert-dcl*,readability-identifier-naming) deviation: heap-trap
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* block, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
void __libc_free(void* block);
// NOLINTEND(*-reserved-identifier,cert-dcl*,readability-identifier-naming) deviation: heap-trap

void* malloc(std::size_t size) {
  count_allocation();
  return __libc_malloc(size);
}
void* calloc(std::size_t count, std::size_t size) {
  count_allocation();
  return __libc_calloc(count, size);
}
void* realloc(void* block, std::size_t size) {
  count_allocation();
  return __libc_realloc(block, size);
}
void* memalign(std::size_t alignment, std::size_t size) {
  count_allocation();
  return __libc_memalign(alignment, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) {
  count_allocation();
  return __libc_memalign(alignment, size);
}
int posix_memalign(void** block, std::size_t alignment, std::size_t size) {
  count_allocation();
  *block = __libc_memalign(alignment, size);
  return *block == nullptr ? ENOMEM : 0;
}
void free(void* block) {
  if (block != nullptr) count_release();
  __libc_free(block);
}
}  // extern "C"

#endif

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
