// SPDX-License-Identifier: MIT
// What must hold of a force-feedback stick for any reports whatever, as a libFuzzer target. An
// input is a row of records [what, how much, bytes...]. Two devices live through it: one hears
// every report, the other only those that the first has taken. They must never be told apart.

#include <algorithm>
#include <cstring>

#include "bytes.hpp"
#include "shared/hid_pid/device.hpp"

namespace batuta::pid {
namespace {

using fuzz::require;
using Sticks = Device<4>;

/// A report that was read is written again as the very same bytes.
template <class Report>
bool same_again(std::uint8_t id, const std::uint8_t* bytes, int size) {
  Report report;
  if (id != static_cast<std::uint8_t>(Report::kId) || !decode(bytes, size, report)) return false;
  std::uint8_t again[Report::kSize] = {};
  require(encode(report, again, Report::kSize) == size, "a report has one length");
  require(std::equal(again, again + size, bytes), "decode, then encode: the same report");
  return true;
}

template <class... Reports>
bool one_of(std::uint8_t id, const std::uint8_t* bytes, int size) {
  const int read = (0 + ... + (same_again<Reports>(id, bytes, size) ? 1 : 0));
  require(read <= 1, "a report is one report");
  return read == 1;
}

bool is_report(std::uint8_t id, const std::uint8_t* bytes, int size) {
  return one_of<SetEffect, SetEnvelope, SetCondition, SetPeriodic, SetConstant, SetRamp,
                EffectOperation, BlockFree, DeviceControl, DeviceGain, CreateNewEffect>(id, bytes,
                                                                                        size);
}

class Pair {
 public:
  void report(ReportType type, std::uint8_t id, const std::uint8_t* bytes, int size) {
    const Status status = all_.receive(type, id, bytes, size);
    ++reports_;
    bool well_formed = is_report(id, bytes, size);
    for (int whole = size - 1; whole > 0 && !well_formed && bytes[whole] == 0; --whole) {
      well_formed = is_report(id, bytes, whole);  // and zeros behind it
    }
    require(well_formed || status == Status::kInvalidArgument, "only what can be read is taken");
    if (status == Status::kOk) {
      require(good_.receive(type, id, bytes, size) == Status::kOk, "what one takes, so the other");
      ++taken_;
    } else {
      load_answered_ =
          load_answered_ && id != static_cast<std::uint8_t>(ReportId::kCreateNewEffect);
    }
    if (status == Status::kOk && id == static_cast<std::uint8_t>(ReportId::kCreateNewEffect)) {
      load_answered_ = true;
    }
    check_counters();
  }

  void step(const Stick& stick, std::uint32_t step_us) {
    now_ += step_us;
    const Vec2<float> force = all_.force(stick, now_);
    for (const float share : {force.x(), force.y()}) {
      require(share >= -1.0F && share <= 1.0F, "a force is within its range, and a number");
    }
    const Vec2<float> other = good_.force(stick, now_);
    require(std::memcmp(force.data(), other.data(), sizeof(float[2])) == 0,
            "a refused report changes no force");
    require(all_.playing() == good_.playing(), "a refused report starts and ends nothing");
  }

  void look() {
    check_answer(ReportId::kPool);
    if (load_answered_) check_answer(ReportId::kBlockLoad);
    PidState state;
    PidState other;
    int told = 0;
    while (all_.next_state(state)) {
      require(good_.next_state(other), "a refused report is no change");
      require(state.block == other.block && state.playing == other.playing &&
                  state.paused == other.paused &&
                  state.actuators_enabled == other.actuators_enabled,
              "a refused report changes no state");
      require(++told <= all_.blocks() + 1, "changes come to an end");
    }
    require(!good_.next_state(other), "a refused report hides no change");
  }

  void unplug() {
    all_.reset();
    good_.reset();
    load_answered_ = true;
  }

 private:
  void check_counters() {
    require(all_.counters().count(Verdict::kTaken) == taken_ &&
                all_.counters().refused() == reports_ - taken_,
            "the counters add up");
    require(good_.counters().refused() == 0, "the other device refuses nothing");
  }

  void check_answer(ReportId id) {
    std::uint8_t bytes[2][4] = {};
    require(all_.answer(static_cast<std::uint8_t>(id), bytes[0], 4) == 4, "an answer is complete");
    require(good_.answer(static_cast<std::uint8_t>(id), bytes[1], 4) == 4, "an answer is complete");
    require(std::memcmp(bytes[0], bytes[1], 4) == 0, "a refused report changes no answer");
  }

  Sticks all_;
  Sticks good_;
  Microseconds now_ = 0xFFF00000U;  ///< wraps after a second
  std::uint32_t reports_ = 0;
  std::uint32_t taken_ = 0;
  bool load_answered_ = true;  ///< the last creation was not refused
};

Vec2<float> any_vector(fuzz::Bytes& bytes) {
  const float x = bytes.bits();
  return {x, bytes.bits()};
}

/// Time goes by, and the stick is anywhere.
void step(Pair& pair, fuzz::Bytes bytes) {
  const std::uint32_t low = bytes.word();
  const std::uint32_t step_us = low | std::uint32_t{bytes.word()} << 16U;
  Stick stick;
  stick.position = any_vector(bytes);
  stick.velocity = any_vector(bytes);
  stick.acceleration = any_vector(bytes);
  pair.step(stick, step_us);
}

void live_through(Pair& pair, std::uint8_t what, const std::uint8_t* bytes, std::size_t size) {
  switch (what) {
    case 0:
      return step(pair, {bytes, size});
    case 1:
      return pair.look();
    case 2:
      return pair.unplug();
    default:
      // 3 ... 0x7F: an output report; from 0x80: a feature report.
      pair.report(what < 0x80 ? ReportType::kOutput : ReportType::kFeature,
                  static_cast<std::uint8_t>(what % 0x80U), bytes, static_cast<int>(size));
  }
}

}  // namespace
}  // namespace batuta::pid

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace batuta::pid;
  Pair pair;
  std::size_t at = 0;
  while (size - at >= 2) {
    const std::uint8_t what = data[at];
    const std::size_t length = std::min(std::size_t{data[at + 1]}, size - at - 2);
    live_through(pair, what, data + at + 2, length);
    pair.step({}, 1000);
    at += 2 + length;
  }
  pair.look();
  return 0;
}
