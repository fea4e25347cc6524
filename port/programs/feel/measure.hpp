// SPDX-License-Identifier: MIT
#pragma once
// batuta-feel --measure: what a firmware does before it closes a loop on a stick that it does not
// know.

namespace batuta {

/// Measures a simulated stick through an output stage, and prints what it is, and may be, beside
/// what the gain advisor makes of it. @returns exit code: 0 | 1: it could not be measured
int measure();

}  // namespace batuta
