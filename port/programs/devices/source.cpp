// SPDX-License-Identifier: MIT

#include "programs/devices/source.hpp"

#include <charconv>
#include <filesystem>
#include <optional>
#include <string_view>
#include <utility>

#include "programs/devices/default_recording.hpp"
#include "programs/devices/replay_device.hpp"
#include "programs/devices/reported_stick.hpp"
#include "programs/devices/script_device.hpp"
#include "programs/devices/seeing_device.hpp"
#include "programs/live/open_live.hpp"

namespace batuta::host {
namespace {

constexpr std::string_view kSerial = "serial:";

constexpr const char* kKnown =
    "a recording (.events, .evemu), default, script:guard|parry|attack|novice|club|master, "
    "device:/dev/input/eventN, device:sdl[:INDEX|NAME], or serial:LINE[@BAUD][,SOURCE]";

OpenedSource refuse(const std::string& error) {
  OpenedSource refused;
  refused.error = error;
  return refused;
}

bool starts_with(std::string_view words, std::string_view beginning) {
  return words.substr(0, beginning.size()) == beginning;
}

OpenedSource open_script(const std::string& words) {
  const std::string name = words.substr(words.find(':') + 1);
  OpenedSource opened;
  if (const std::optional<Script> script = script_named(name)) {
    opened.source = std::make_unique<ScriptDevice>(*script);
  } else if (const std::optional<SeeingScript> fencer = seeing_script(name)) {
    opened.source = std::make_unique<SeeingDevice>(*fencer);
  } else {
    return refuse(words + ": unknown script; known are guard, parry, attack, and those that see: " +
                  "novice, club, master, each with @SEED or without");
  }
  return opened;
}

OpenedSource open_replay(LoadedRecording loaded, const std::string& label) {
  if (!loaded.error.empty()) return refuse(loaded.error);
  OpenedSource opened;
  if (!loaded.recording.note.empty()) opened.note = label + ": " + loaded.recording.note;
  opened.source = std::make_unique<ReplayDevice>(std::move(loaded.recording), label);
  return opened;
}

/// A whole number above 0 and nothing beside it.
std::optional<int> baud_of(std::string_view words) {
  int baud = 0;
  const char* const end = words.data() + words.size();
  const std::from_chars_result read = std::from_chars(words.data(), end, baud);
  const bool number = read.ec == std::errc() && read.ptr == end && baud > 0;
  return number ? std::optional<int>(baud) : std::nullopt;
}

/// Whatever is not at the other end of a serial line.
OpenedSource open_here(const std::string& words) {
  if (words == "default") {
    return open_replay(parse_recording(kDefaultRecording, "default", {}), "default");
  }
  if (starts_with(words, "script:")) return open_script(words);
  if (starts_with(words, kLive)) return open_live(words);
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(words, error);
  if (status.type() == std::filesystem::file_type::not_found) {
    const bool path = words.find_first_of("/.") != std::string::npos;
    return refuse(path ? words + ": no such file"
                       : words + ": unknown source; a source is " + kKnown);
  }
  if (status.type() == std::filesystem::file_type::none) {
    return refuse(words + ": cannot be read: " + error.message());
  }
  if (std::filesystem::is_character_file(status)) {  // it would be read without an end
    return refuse(words + ": a device and no recording; write device:" + words +
                  " or serial:" + words);
  }
  OpenedSource opened =
      open_replay(load_recording(words), std::filesystem::path(words).filename().string());
  opened.files = files_of_recording(words);
  return opened;
}

/// A device on a serial line, with its own stick or with a source in its place.
OpenedSource open_serial(const std::string& words) {
  const std::size_t comma = words.find(',');
  const std::string place = words.substr(kSerial.size(), comma - kSerial.size());
  const std::size_t at = place.rfind('@');
  const std::string line = place.substr(0, at);
  if (line.empty()) return refuse(words + ": no line; write serial:LINE[@BAUD][,SOURCE]");
  const std::optional<int> baud =
      at == std::string::npos ? kDeviceBaud : baud_of(std::string_view(place).substr(at + 1));
  if (!baud) return refuse(words + ": BAUD is a number such as " + std::to_string(kDeviceBaud));
  OpenedSource opened;
  if (comma == std::string::npos) {
    opened.source = std::make_unique<ReportedStick>("the stick of the device at " + line);
    opened.own_stick = true;
  } else {
    const std::string inner = words.substr(comma + 1);
    if (starts_with(inner, kSerial)) return refuse(words + ": a device is no stick of a device");
    opened = open_here(inner);
  }
  opened.line = line;
  opened.baud = *baud;
  return opened;
}

}  // namespace

OpenedSource open_source(const std::string& words) {
  return starts_with(words, kSerial) ? open_serial(words) : open_here(words);
}

}  // namespace batuta::host
