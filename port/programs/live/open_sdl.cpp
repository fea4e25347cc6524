// SPDX-License-Identifier: MIT

#include <memory>

#include "programs/live/live_source.hpp"
#include "programs/live/open_live.hpp"
#include "programs/live/sdl_feed.hpp"
#include "programs/live/sdl_force.hpp"

namespace batuta::host {

OpenedSource open_sdl(const std::string& words, const std::string& choice) {
  OpenedSource opened;
  const SdlSession session;
  if (!session.is_open()) {
    opened.error = words + ": SDL cannot be started: " + SDL_GetError();
    return opened;
  }
  const auto stick = std::make_shared<SdlStick>(choice);
  if (!stick->open()) {
    opened.error = words + ": " + stick->problem() + found_words(list_sdl());
    return opened;
  }
  opened.source = std::make_unique<LiveSource>("SDL", std::make_unique<SdlFeed>(stick), [stick] {
    return std::make_unique<SdlForce>(stick);
  });
  return opened;
}

}  // namespace batuta::host
