// SPDX-License-Identifier: MIT
#pragma once
// Files that are not whole yet, and go when a signal ends the program. Process-wide, as signals
// are.

#include <string>

namespace batuta::host {

/// Names that fit at once; one beyond them, or one that is too long, stays where it is.
inline constexpr int kMostUnfinished = 8;

/// From now on a signal that ends the program removes this file first, once it is there, but for
/// SIGKILL and the signals that have a number alone. What has a handler of its own, or is ignored,
/// is left so. Nothing of this on Windows.
void remove_when_ended(const std::string& path);

/// It is whole, or gone: nothing removes it any more.
void keep_when_ended(const std::string& path);

/// A handler: removes these files, and ends the program by the signal. It has no effect but that of
/// the signal on Windows.
extern "C" void batuta_remove_and_end(int signal);

}  // namespace batuta::host
