// SPDX-License-Identifier: MIT

#include "host/devices/source.hpp"

#include <filesystem>
#include <utility>

#include "host/devices/default_recording.hpp"
#include "host/devices/replay_device.hpp"
#include "host/devices/script_device.hpp"

namespace batuta::host {
namespace {

constexpr const char* kKnown =
    "a recording (.events, .evemu), default, or script:guard|parry|attack";

OpenedSource refuse(const std::string& error) {
  return {nullptr, error, {}};
}

bool starts_with(const std::string& words, const std::string& beginning) {
  return words.compare(0, beginning.size(), beginning) == 0;
}

OpenedSource open_script(const std::string& words) {
  const std::optional<Script> script = script_named(words.substr(words.find(':') + 1));
  if (!script) return refuse(words + ": unknown script; known are guard, parry and attack");
  return {std::make_unique<ScriptDevice>(*script), {}, {}};
}

OpenedSource open_replay(LoadedRecording loaded, const std::string& label) {
  if (!loaded.error.empty()) return refuse(loaded.error);
  const std::string note =
      loaded.recording.note.empty() ? "" : label + ": " + loaded.recording.note;
  return {std::make_unique<ReplayDevice>(std::move(loaded.recording), label), {}, note};
}

}  // namespace

OpenedSource open_source(const std::string& words) {
  if (words == "default") {
    return open_replay(parse_recording(kDefaultRecording, "default", {}), "default");
  }
  if (starts_with(words, "script:")) return open_script(words);
  if (starts_with(words, "device:") || starts_with(words, "serial:")) {
    return refuse(words + ": live devices are not built into this version");
  }
  std::error_code error;
  if (!std::filesystem::exists(words, error)) {
    const bool path = words.find_first_of("/.") != std::string::npos;
    return refuse(path ? words + ": no such file"
                       : words + ": unknown source; a source is " + kKnown);
  }
  return open_replay(load_recording(words), std::filesystem::path(words).filename().string());
}

}  // namespace batuta::host
