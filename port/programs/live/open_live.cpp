// SPDX-License-Identifier: MIT

#include "programs/live/open_live.hpp"

namespace batuta::host {

std::string found_words(const std::string& list) {
  return "; found: " + (list.empty() ? "none" : list);
}

OpenedSource open_live(const std::string& words) {
  const std::string device = words.substr(kLive.size());
  if (device == "sdl") return open_sdl(words, {});
  constexpr std::string_view kSdl = "sdl:";
  if (device.compare(0, kSdl.size(), kSdl) == 0) return open_sdl(words, device.substr(kSdl.size()));
  if (!device.empty() && device.front() == '/') return open_evdev(words, device);
  OpenedSource refused;
  refused.error = words + ": a live device is device:/dev/input/eventN or device:sdl[:INDEX|NAME]";
  return refused;
}

}  // namespace batuta::host
