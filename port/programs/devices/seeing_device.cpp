// SPDX-License-Identifier: MIT

#include "programs/devices/seeing_device.hpp"

#include <array>
#include <charconv>
#include <limits>

namespace batuta::host {
namespace {

constexpr std::array<SeeingScript, 3> kFencers = {{
    {"novice", fencing::Skill::kNovice},
    {"club", fencing::Skill::kClub},
    {"master", fencing::Skill::kMaster},
}};

std::optional<std::uint32_t> number(std::string_view words) {
  std::uint32_t value = 0;
  const char* const end = words.data() + words.size();
  const std::from_chars_result read = std::from_chars(words.data(), end, value);
  if (read.ec != std::errc() || read.ptr != end) return std::nullopt;
  return value;
}

}  // namespace

std::optional<SeeingScript> seeing_script(std::string_view words) {
  const std::size_t at = words.find('@');
  for (SeeingScript fencer : kFencers) {
    if (fencer.name != words.substr(0, at)) continue;
    if (at == std::string_view::npos) return fencer;
    const std::optional<std::uint32_t> seed = number(words.substr(at + 1));
    if (!seed) return std::nullopt;
    fencer.seed = *seed;
    return fencer;
  }
  return std::nullopt;
}

SeeingDevice::SeeingDevice(const SeeingScript& script) : script_(script) {
  rewind();
}

std::string SeeingDevice::description() const {
  return "script " + std::string(script_.name) + ", seed " + std::to_string(script_.seed);
}

double SeeingDevice::duration() const {
  return std::numeric_limits<double>::infinity();
}

void SeeingDevice::rewind() {
  (void)opponent_.configure(script_.skill, script_.seed);
  sequence_ = 0;
}

void SeeingDevice::see(const fencing::Observation& sight, std::int32_t step_us) {
  (void)opponent_.step(sight, step_us);
}

Status SeeingDevice::do_read(Microseconds now, InputSample& sample) {
  const fencing::StickPlace& place = opponent_.place();
  sample = {};
  sample.time = now;
  sample.x = place.blade.x();
  sample.y = place.blade.y();
  sample.feet_y = place.feet;
  sample.sequence = sequence_++;
  return Status::kOk;
}

}  // namespace batuta::host
