// SPDX-License-Identifier: MIT
#pragma once
// The recording that ships with the program: recordings/default.events, embedded at build time.

#include <string_view>

namespace batuta::host {

extern const std::string_view kDefaultRecording;

}  // namespace batuta::host
