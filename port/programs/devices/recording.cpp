// SPDX-License-Identifier: MIT

#include "programs/devices/recording.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <filesystem>
#include <system_error>

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

/// What a file holds, or why that is not known, in one line.
struct Text {
  std::string words;
  std::string error;
};

Text unread(const std::string& path, int number) {
  return {{}, path + ": cannot be read: " + std::generic_category().message(number)};
}

Text too_long(const std::string& path) {
  return {{}, path + ": cannot be read: too long"};
}

/// By the system's own calls: a stream says of a failure neither where nor why.
Text read_all(const std::string& path, int file, std::size_t most) {
  constexpr std::size_t kAtOnce = 65536;
  struct stat about = {};
  const bool is_known = fstat(file, &about) == 0 && about.st_size > 0;
  if (is_known && static_cast<std::uintmax_t>(about.st_size) > most) return too_long(path);
  Text text;
  std::vector<char> some(kAtOnce);
  ssize_t count = 0;
  while ((count = ::read(file, some.data(), some.size())) != 0) {  // Bound: `most` characters
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return unread(path, errno);
    text.words.append(some.data(), static_cast<std::size_t>(count));
    if (text.words.size() > most) return too_long(path);
  }
  return text;
}

Text read_file(const std::string& path, int flags, std::size_t most) {
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | flags);
  if (file < 0 && errno == ENOENT) return {{}, path + ": no such file"};
  if (file < 0) return unread(path, errno);
  Text text = read_all(path, file, most);
  ::close(file);
  return text;
}

/// It may come through a pipe.
Text read_recording(const std::string& path) {
  constexpr std::size_t kLongest = std::size_t{1} << 30;  // days of a mouse
  return read_file(path, 0, kLongest);
}

/// Nobody has named it: what is no plain file is not even opened, and what has become one since
/// does not have the program wait.
Text read_description(const std::string& path, const std::filesystem::file_status& status) {
  constexpr std::size_t kLongest = std::size_t{1} << 20;  // real ones have some thousand characters
  const bool may_be = status.type() == std::filesystem::file_type::regular ||
                      status.type() == std::filesystem::file_type::none;  // then opening says why
  if (!may_be) return {{}, path + ": cannot be read: no plain file"};
  return read_file(path, O_NONBLOCK, kLongest);
}

/// The first that there is, also where it cannot be read: without it the device would have other
/// ranges.
Text description_beside(const std::string& path) {
  const std::vector<std::string> files = files_of_recording(path);
  for (std::size_t i = 1; i < files.size(); ++i) {  // Bound: three for each dot in the name
    std::error_code error;
    const auto status = std::filesystem::status(files[i], error);
    if (status.type() == std::filesystem::file_type::not_found) continue;
    return read_description(files[i], status);
  }
  return {};
}

/// @param beside  what describes the device where the text does not
LoadedRecording parse(std::string_view text, const std::string& name, const Text& beside) {
  const Lines lines = read_lines(text, name);
  if (!lines.error.empty()) return refuse(lines.error);
  if (lines.events.empty()) return refuse(name + ": holds no events");
  const bool inline_description = lines.description.find("N:") != std::string::npos;
  if (!inline_description && !beside.error.empty()) return refuse(beside.error);
  const std::string& words = inline_description ? lines.description : beside.words;
  const std::optional<Description> device = Description::parse(words);
  if (!words.empty() && !device) return refuse(name + ": its device description is not readable");
  const std::optional<MotionAxes> axes = find_motion_axes(lines.events, device);
  if (!axes) return refuse(name + ": holds no motion of a pointing device or stick");
  LoadedRecording loaded{decode(lines, *axes), {}};
  if (loaded.recording.samples.empty()) return refuse(name + ": holds no sync mark, so no sample");
  if (device) loaded.recording.device = device->name();
  return loaded;
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
  return parse(text, name, {description, {}});
}

LoadedRecording load_recording(const std::string& path) {
  const Text text = read_recording(path);
  if (!text.error.empty()) return refuse(text.error);
  return parse(text.words, path, description_beside(path));
}

}  // namespace batuta::host
