// SPDX-License-Identifier: MIT
// One call into each part that is linked by its own name, with an answer that needs no program to
// know. The number that main() returns is that of the first part that is wrong.
#include <cstring>

#include "batuta/c.h"
#include "batuta/control/stick.hpp"
#include "batuta/haptics/slew_limiter.hpp"
#include "batuta/record/snapshot.hpp"
#include "shared/firmware/tick_watch.hpp"
#include "shared/hid_pid/reports.hpp"
#include "shared/simulated/axis.hpp"
#include "shared/usb_stick/descriptors.hpp"

namespace {

struct Pair {
  std::int32_t a = 0;
  std::int32_t b = 0;

  template <class ArchiveT>
  void archive(ArchiveT& ar) {
    ar(a, b);
  }
};

/// Two parallel capsules, 2 m apart, of 0.5 m radius.
bool c_is_right() {
  const float A[] = {0, 0, 0, 0, 0, 1, 0.5F};
  const float B[] = {2, 0, 0, 2, 0, 1, 0.5F};
  batuta_closest_f out;
  return batuta_closest_points_f(A, B, &out) == BATUTA_OK && out.gap == 1.0F;
}

bool record_is_right() {
  std::uint8_t bytes[batuta::kSnapshotRoom<Pair>];
  const auto size = batuta::save(Pair{3, -4}, bytes, static_cast<int>(sizeof bytes));
  Pair again;
  return size.ok() && batuta::restore(again, bytes, size.value) == batuta::Restored::kOk &&
         again.a == 3 && again.b == -4;
}

bool control_is_right() {
  batuta::StickTracker<float> tracker;
  return tracker.configure({}) == batuta::Status::kOk && tracker.position().norm() == 0.0F;
}

bool haptics_is_right() {
  batuta::haptics::SlewLimiter limiter;
  return limiter.configure(0.25F) == batuta::Status::kOk && limiter.towards(1.0F) == 0.25F;
}

/// Ticks 1 and 2 go by unused.
bool firmware_is_right() {
  batuta::firmware::TickWatch watch;
  watch.start(1000);
  watch.begin(0, 0);
  watch.end(10);
  watch.begin(3, 3000);
  return watch.report().skipped == 2;
}

/// hid_pid.md: report 0x15, block 1, 5000 in little endian.
bool pid_is_right() {
  batuta::pid::SetConstant report;
  report.block = 1;
  report.magnitude = 5000;
  const std::uint8_t expected[] = {0x01, 0x88, 0x13};
  std::uint8_t bytes[3] = {};
  return batuta::pid::encode(report, bytes, 3) == 3 && std::memcmp(bytes, expected, 3) == 0;
}

/// The first word of a string descriptor is its type, 3, and its size.
bool usb_stick_is_right() {
  batuta::usb::Identity identity;
  identity.serial = "ab";
  batuta::usb::StringDescriptor text{};
  return batuta::usb::write_string(identity, 3, text) && text[0] == 0x0306 && text[2] == 'b';
}

/// 50 g under 1 N for a millisecond: 0.02 m/s.
bool simulated_is_right() {
  batuta::port_simulated::SimulatedAxis axis;
  if (axis.configure({}) != batuta::Status::kOk) return false;
  axis.advance(1.0, 0.0);
  return axis.velocity() > 0.0199 && axis.velocity() < 0.0201;
}

}  // namespace

int main() {
  bool (*const parts[])() = {c_is_right,         record_is_right,   control_is_right,
                             haptics_is_right,   firmware_is_right, pid_is_right,
                             usb_stick_is_right, simulated_is_right};
  int number = 0;
  for (const auto part : parts) {
    ++number;
    if (!part()) return number;
  }
  return 0;
}
