// SPDX-License-Identifier: MIT
#pragma once
// Names of files and devices may hold any bytes; what the program writes is valid UTF-8.

#include <cstddef>
#include <string_view>

namespace batuta::host {

/// Bytes of the UTF-8 sequence at the start of `text`; 0 if there is none. @pre text is not empty
std::size_t utf8_length(std::string_view text);

}  // namespace batuta::host
