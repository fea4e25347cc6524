// SPDX-License-Identifier: MIT
#pragma once
// A host for tests: knows the device by its report descriptor alone, and finds a field by its usage
// and that of the collection around it. Shares no code with the device's reports.

#include <map>
#include <optional>
#include <vector>

#include "descriptor_parser.hpp"
#include "shared/hid_pid/device.hpp"

namespace batuta::pid::test {

using Bytes = std::vector<std::uint8_t>;

/// A usage of page 0x0F.
constexpr UsageCode pid_usage(unsigned number) {
  return 0x0F0000U | number;
}

/// Values by usage; what is not named is 0, or the lowest value where that is above 0.
using Values = std::map<UsageCode, std::int64_t>;

class Host {
 public:
  Host(const std::uint8_t* descriptor, std::size_t size) : descriptor_(parse(descriptor, size)) {}

  const Descriptor& descriptor() const { return descriptor_; }
  /// The report whose collection, or the collection around that, has the usage; throws if none has.
  int report(char way, UsageCode collection) const;
  /// A report's bytes behind its id. An array is named by its collection.
  Bytes pack(char way, int report, const Values& values) const;
  /// The values of a report's bytes.
  Values unpack(char way, int report, const Bytes& bytes) const;

 private:
  Descriptor descriptor_;
};

/// A host with its device, as a driver and a game use it. Angles in degrees, levels of 1.
class Session {
 public:
  static constexpr int kBlocks = 4;
  Session();

  Host host;
  Device<kBlocks> device;

  Status send(UsageCode collection, const Values& values);
  Status create(EffectType type);
  Values get(UsageCode collection) const;
  /// A new effect. @returns its block. Fails the test if there is none.
  std::int64_t made(EffectType type);
  Status set_effect(std::int64_t block, const Values& changed = {});
  Status start(std::int64_t block, int loops = 1);
  Status stop(std::int64_t block);
  Status control(int what) { return send(pid_usage(0x96), {{pid_usage(0x96), what}}); }
  Status condition(std::int64_t block, int axis, const Values& values);
  /// Time goes by, then the force.
  Vec2<float> force(const Stick& stick = {}, std::uint32_t step_us = 0);

  Microseconds now = 0xFFFFF000U;  ///< wraps soon
};

/// A device's field counts of a level, 0 ... 1 or -1 ... 1.
constexpr std::int64_t level(double share) {
  return static_cast<std::int64_t>(share * 10000.0 + (share < 0 ? -0.5 : 0.5));
}
/// And of an angle.
constexpr std::int64_t degrees(double angle) {
  return static_cast<std::int64_t>(angle * 50.0 + 0.5);
}

}  // namespace batuta::pid::test
