// SPDX-License-Identifier: MIT
// Built instead of open_sdl.cpp where SDL2 was not found.

#include "programs/live/open_live.hpp"

namespace batuta::host {

OpenedSource open_sdl(const std::string& words, const std::string& /*choice*/) {
  OpenedSource refused;
  refused.error = words + ": this program was built without SDL2; device:/dev/input/eventN works";
  return refused;
}

}  // namespace batuta::host
