// SPDX-License-Identifier: MIT
#pragma once
// How deep the stack was used: start-up paints it, and the paint that is left tells.

#include <cstddef>

namespace batuta::cortex_m {

/// Bytes of the stack.
std::size_t stack_size();

/// Most bytes in use at once since start-up or the last repaint, interrupts included.
/// Exact unless what was written deepest happens to be the paint. Bound: stack_size() / 4.
std::size_t stack_used();

/// Paints what lies below the caller's frame again, to measure one part of a program.
/// Bound: stack_size() / 4.
void repaint_stack();

}  // namespace batuta::cortex_m
