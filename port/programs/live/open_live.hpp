// SPDX-License-Identifier: MIT
#pragma once
// From words to a live device: "device:/dev/input/eventN" through libevdev,
// "device:sdl[:INDEX|NAME]" through SDL.

#include <string>
#include <string_view>

#include "programs/devices/source.hpp"

namespace batuta::host {

inline constexpr std::string_view kLive = "device:";

/// @param words  begin with kLive
/// @returns a source whose is_live(), or an error that says what was found instead
OpenedSource open_live(const std::string& words);

/// @param path  of an event device of the Linux input stack
OpenedSource open_evdev(const std::string& words, const std::string& path);

/// @param choice  empty: the first free stick | its place in SDL's list | a part of its name
/// Where the program is built without SDL, an error that says so.
OpenedSource open_sdl(const std::string& words, const std::string& choice);

/// "; found: a, b" or "; found: none"
std::string found_words(const std::string& list);

}  // namespace batuta::host
