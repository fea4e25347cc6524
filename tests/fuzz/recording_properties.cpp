// SPDX-License-Identifier: MIT
// What must hold of recordings in the evemu format for any text whatever, as a libFuzzer target.
// The first byte says how the rest is used: as text, or as events that are written as text, so that
// the fuzzer gets past the spelling to what the events mean.

#include <algorithm>
#include <cmath>
#include <string>

#include "bytes.hpp"
#include "programs/devices/event_line.hpp"
#include "programs/devices/recording.hpp"

namespace batuta::fuzz {
using namespace detail;
namespace {

using host::DeviceEvent;
using host::LineKind;
using host::LoadedRecording;

constexpr const char* kDescription =
    "N: any stick\nI: 0003 0000 0000 0001\nP: 00 00 00 00 00 00 00 00\n"
    "B: 00 0b 00 00 00 00 00 00 00\nB: 03 03 00 00 00 00 00 00 00\n"
    "A: 00 -512 511 0 15 0\nA: 01 0 1 0 0 0\n";

LoadedRecording load(const std::string& text) {
  return host::parse_recording(text, "any", "");
}

bool is_same(const InputSample& a, const InputSample& b) {
  return a.time == b.time && a.x == b.x && a.y == b.y && a.buttons == b.buttons &&
         a.sequence == b.sequence;
}

void require_same(const LoadedRecording& one, const LoadedRecording& other, const char* what) {
  require(one.error.empty() == other.error.empty(), what);
  if (!one.error.empty()) return;
  const auto& a = one.recording;
  const auto& b = other.recording;
  require(a.samples.size() == b.samples.size() && a.duration == b.duration &&
              a.losses == b.losses && a.device == b.device,
          what);
  for (std::size_t i = 0; i < a.samples.size(); ++i) {
    require(is_same(a.samples[i], b.samples[i]), what);
  }
}

/// A recording is refused in one printable line, or full of samples that a stick may have.
void check_answer(const LoadedRecording& loaded) {
  if (!loaded.error.empty()) {
    for (const char c : loaded.error) require(c >= ' ' && c <= '~', "a complaint is one line");
    return;
  }
  const auto& recording = loaded.recording;
  require(!recording.samples.empty(), "a recording has samples");
  require(std::isfinite(recording.duration) && recording.duration >= 0, "and a duration");
  for (std::size_t i = 0; i < recording.samples.size(); ++i) {
    const InputSample& sample = recording.samples[i];
    require(sample.x >= -1 && sample.x <= 1 && sample.y >= -1 && sample.y <= 1, "within the rim");
    require(sample.sequence == i, "counted from 0");
  }
}

/// What adds nothing changes nothing: how lines end, and comments and blanks among them.
void check_spelling(const std::string& text, const LoadedRecording& loaded) {
  std::string other = "# made of something else\n\n";
  for (const char c : text) {
    if (c == '\n') other += " \r";
    other += c;
  }
  require_same(loaded, load(other), "ends of lines and comments mean nothing");
}

/// Cuts the text into lines: of each kind there is one, and only events change the event.
void check_lines(const std::string& text) {
  std::size_t begin = 0;
  while (begin < text.size()) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    constexpr DeviceEvent kBefore{-7, 7, 7, 7};
    DeviceEvent event = kBefore;
    const LineKind kind = host::read_line(text.substr(begin, end - begin), event);
    const bool is_changed = event.time_us != kBefore.time_us;
    require(is_changed == (kind == LineKind::kEvent), "only an event is one");
    require(!is_changed || event.time_us >= 0, "and no time is before the first");
    begin = end + 1;
  }
}

std::string line_of(const DeviceEvent& event) {
  char line[80];
  (void)std::snprintf(line, sizeof line, "E: %lld.%06lld %04x %04x %04d",
                      static_cast<long long>(event.time_us / 1000000),
                      static_cast<long long>(event.time_us % 1000000), unsigned{event.type},
                      unsigned{event.code}, event.value);
  return line;
}

std::int32_t draw_value(Bytes& bytes) {
  switch (bytes.choice(4)) {
    case 0:
      return static_cast<std::int8_t>(bytes.byte());
    case 1:
      return static_cast<std::int16_t>(bytes.word());
    case 2:
      return test::kHighest<std::int32_t>[static_cast<std::size_t>(bytes.choice(2))];
    default:
      return test::kLowest<std::int32_t>[static_cast<std::size_t>(bytes.choice(2))];
  }
}

/// Marks, keys, axes, fingers and anything else, mostly forward in time.
DeviceEvent draw_event(Bytes& bytes, std::int64_t& time_us) {
  constexpr std::uint16_t kMarks[] = {0, 2, 3};                   // report, finger, dropped
  constexpr std::uint16_t kFingers[] = {0x2F, 0x35, 0x36, 0x39};  // slot, x, y, which
  time_us += 16 * std::int64_t{bytes.byte()} - 64;
  time_us = std::max<std::int64_t>(time_us, 0);
  DeviceEvent event{time_us, 0, 0, 0};
  switch (bytes.choice(6)) {
    case 0:
      event.code = kMarks[bytes.choice(3)];
      return event;
    case 1:
      event.type = 1;
      event.code = static_cast<std::uint16_t>(0x100 + bytes.byte());
      break;
    case 2:
      event.type = 2;
      event.code = static_cast<std::uint16_t>(bytes.choice(2));
      break;
    case 3:
      event.type = 3;
      event.code = static_cast<std::uint16_t>(bytes.choice(2));
      break;
    case 4:
      event.type = 3;
      event.code = kFingers[bytes.choice(4)];
      break;
    default:
      event.type = bytes.word();
      event.code = bytes.word();
      break;
  }
  event.value = draw_value(bytes);
  return event;
}

std::string draw_text(Bytes& bytes) {
  std::string text = bytes.flag() ? kDescription : "";
  std::int64_t time_us = std::int64_t{bytes.word()} << bytes.choice(32);
  while (bytes.left() > 0) {
    const DeviceEvent event = draw_event(bytes, time_us);
    const std::string line = line_of(event);
    DeviceEvent read;
    require(host::read_line(line, read) == LineKind::kEvent && read.time_us == event.time_us &&
                read.type == event.type && read.code == event.code && read.value == event.value,
            "what is written is read");
    text += line + "\n";
  }
  return text;
}

void check(Bytes bytes) {
  const bool is_text = bytes.flag();
  std::string text;
  if (is_text) {
    while (bytes.left() > 0) text += static_cast<char>(bytes.byte());
  } else {
    text = draw_text(bytes);
  }
  check_lines(text);
  const LoadedRecording loaded = load(text);
  check_answer(loaded);
  require_same(loaded, load(text), "the same text, the same recording");
  if (!is_text) check_spelling(text, loaded);
}

}  // namespace
}  // namespace batuta::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  batuta::fuzz::check({data, size});
  return 0;
}
