// SPDX-License-Identifier: MIT

#include "programs/devices/recording.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "programs/devices/event_decoder.hpp"

namespace batuta::host {
namespace {

/// Time stamps are compared modulo 2^32 us: neighbours must be less than half of that apart.
constexpr std::int64_t kLongestGap_us = std::int64_t{30} * 60 * 1'000'000;

struct Lines {
  std::vector<DeviceEvent> events;
  std::int64_t latest_us = 0;  ///< the latest time stamp among them
  std::string description;
  std::string error;
};

std::string complaint(const std::string& name, std::size_t line, const std::string& what) {
  return name + ":" + std::to_string(line) + ": " + what;
}

/// The line for a message: short, and with nothing that a terminal would obey.
std::string quoted(std::string_view line) {
  constexpr std::size_t kLongest = 60;
  std::string text = "\"";
  for (const char c : line.substr(0, kLongest)) {
    text += (c >= ' ' && c <= '~') ? c : (c == '\t' || c == '\r' ? ' ' : '?');
  }
  return text + (line.size() > kLongest ? "...\"" : "\"");
}

bool gap_too_long(const Lines& lines, const DeviceEvent& next) {
  if (lines.events.empty()) return false;
  const std::int64_t gap_us = next.time_us - lines.latest_us;
  return gap_us > kLongestGap_us || gap_us < -kLongestGap_us;
}

/// A comment with a meaning: it tells how many fields the description's lines have.
bool is_version(std::string_view line) {
  constexpr std::string_view kBeginning = "# EVEMU ";
  return line.substr(0, kBeginning.size()) == kBeginning;
}

/// What one line adds, or what is wrong with it.
std::string take_line(std::string_view line, Lines& lines) {
  DeviceEvent event;
  const LineKind kind = read_line(line, event);
  if (kind == LineKind::kMalformed) {
    return "neither an event, nor a description, nor a comment: " + quoted(line);
  }
  if (kind == LineKind::kDescription || is_version(line)) {
    lines.description.append(line).append("\n");
  }
  if (kind != LineKind::kEvent) return {};
  if (gap_too_long(lines, event)) return "the time stamp leaps by more than 30 minutes";
  lines.latest_us = lines.events.empty() ? event.time_us : std::max(lines.latest_us, event.time_us);
  lines.events.push_back(event);
  return {};
}

Lines read_lines(std::string_view text, const std::string& name) {
  Lines lines;
  std::size_t number = 0;
  while (!text.empty()) {  // Bound: the lines of the text
    const std::size_t end = text.find('\n');
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    ++number;
    const std::string wrong = take_line(line, lines);
    if (!wrong.empty()) {
      lines.error = complaint(name, number, wrong);
      return lines;
    }
  }
  return lines;
}

Recording decode(const Lines& lines, const MotionAxes& axes) {
  Recording recording;
  EventDecoder decoder(axes);
  const std::int64_t start_us = lines.events.front().time_us;
  for (const DeviceEvent& event : lines.events) {
    const auto time =
        static_cast<Microseconds>(event.time_us - start_us);  // modulo 2^32, as agreed
    const Result<InputSample> sample = decoder.decode(event, time);
    if (sample.ok()) recording.samples.push_back(sample.value);
  }
  recording.duration = static_cast<double>(lines.latest_us - start_us) * 1e-6;
  recording.losses = decoder.losses();
  recording.note = axes.note;
  return recording;
}

LoadedRecording refuse(const std::string& error) {
  return {{}, error};
}

bool read_file(const std::filesystem::path& path, std::string& text) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) return false;
  std::ifstream file(path, std::ios::binary);
  text.assign(std::istreambuf_iterator<char>(file), {});
  return file.good() || file.eof();
}

/// The first that there is.
std::string description_beside(const std::string& path) {
  std::string text;
  const std::vector<std::string> files = files_of_recording(path);
  for (std::size_t i = 1; i < files.size(); ++i) {  // Bound: three for each dot in the name
    if (read_file(files[i], text)) return text;
  }
  return {};
}

}  // namespace

/// "a.b.events" is described by "a.b.desc", and where several recordings share a description by
/// "a.desc".
std::vector<std::string> files_of_recording(const std::string& path) {
  std::vector<std::string> files = {path};
  std::filesystem::path name = path;
  while (name.has_extension()) {  // Bound: the dots in the name
    name.replace_extension();
    for (const char* extension : {".desc", ".device", ".prop"}) {
      files.push_back(name.string() + extension);
    }
  }
  return files;
}

LoadedRecording parse_recording(std::string_view text, const std::string& name,
                                const std::string& description) {
  const Lines lines = read_lines(text, name);
  if (!lines.error.empty()) return refuse(lines.error);
  if (lines.events.empty()) return refuse(name + ": holds no events");
  const bool inline_description = lines.description.find("N:") != std::string::npos;
  const std::string& words = inline_description ? lines.description : description;
  const std::optional<Description> device = Description::parse(words);
  if (!words.empty() && !device) return refuse(name + ": its device description is not readable");
  const std::optional<MotionAxes> axes = find_motion_axes(lines.events, device);
  if (!axes) return refuse(name + ": holds no motion of a pointing device or stick");
  LoadedRecording loaded{decode(lines, *axes), {}};
  if (loaded.recording.samples.empty()) return refuse(name + ": holds no sync mark, so no sample");
  if (device) loaded.recording.device = device->name();
  return loaded;
}

LoadedRecording load_recording(const std::string& path) {
  std::string text;
  if (!std::filesystem::exists(path)) return refuse(path + ": no such file");
  if (!read_file(path, text)) return refuse(path + ": cannot be read");
  return parse_recording(text, path, description_beside(path));
}

}  // namespace batuta::host
