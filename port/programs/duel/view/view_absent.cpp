// SPDX-License-Identifier: MIT
// Built instead of sdl_view.cpp where SDL2 was not found.

#include "programs/duel/view/view.hpp"

namespace batuta::host {

OpenedView open_view(const ViewNames& /*names*/) {
  OpenedView refused;
  refused.error = "--view: this program was built without SDL2; --svg draws the bout into a file";
  return refused;
}

}  // namespace batuta::host
