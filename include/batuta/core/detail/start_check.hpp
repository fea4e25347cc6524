// SPDX-License-Identifier: MIT
#pragma once
// The end of assert.hpp where a compiler may have been told to contract in spite of what a file
// says: before main(), each file that was compiled so ends in batuta_trap().

#include "batuta/core/assert.hpp"
#include "batuta/core/detail/rounds_products.hpp"

#if defined(__i386__) || defined(__x86_64__)
#if defined(__FMA__) || defined(__FMA4__)
#define BATUTA_PART_MAY_FUSE 1
#endif
#elif !defined(__SOFTFP__) && !defined(__wasm__)
#define BATUTA_PART_MAY_FUSE 1
#endif

#if defined(__clang__) && defined(BATUTA_PART_MAY_FUSE) && BATUTA_ASSERT_LEVEL >= 1
#pragma clang diagnostic push
#pragma clang diagnostic ignored "-Wglobal-constructors"  // it is meant to be one
namespace batuta::detail {
namespace {

/// A copy in each file, because it tells about the flags of that file.
[[maybe_unused]] const bool kProductsAreRounded = [] {
  BATUTA_ASSERT(rounds_products<float>());
  return true;
}();

}  // namespace
}  // namespace batuta::detail
#pragma clang diagnostic pop
#endif
#undef BATUTA_PART_MAY_FUSE
