// SPDX-License-Identifier: MIT

#include <memory>

#include "programs/live/evdev_feed.hpp"
#include "programs/live/evdev_force.hpp"
#include "programs/live/live_source.hpp"
#include "programs/live/open_live.hpp"

namespace batuta::host {

OpenedSource open_evdev(const std::string& words, const std::string& path) {
  OpenedSource opened;
  const auto claim = std::make_shared<Claim>();
  auto feed = std::make_unique<EvdevFeed>(path, claim);
  const std::string problem = feed->open();
  if (!problem.empty()) {
    opened.error = words + ": " + problem + found_words(list_evdev());
    return opened;
  }
  opened.source = std::make_unique<LiveSource>(
      path, std::move(feed), [path, claim] { return std::make_unique<EvdevForce>(path, claim); });
  return opened;
}

}  // namespace batuta::host
