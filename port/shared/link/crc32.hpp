// SPDX-License-Identifier: MIT
#pragma once
// The check sum of a frame is the library's own. Why this one: link.md.

#include "batuta/core/crc32.hpp"

namespace batuta::link {

using batuta::crc32;

}  // namespace batuta::link
