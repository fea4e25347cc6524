// SPDX-License-Identifier: MIT
#pragma once
// What a device says of itself in an evemu description, read by libevemu.

#include <optional>
#include <string>

struct evemu_device;

namespace batuta::host {

/// The counts that an absolute axis reports.
struct AxisRange {
  int min = 0;
  int max = 0;
  int flat = 0;
};

/// A device description; move-only because it owns libevemu's object.
class Description {
 public:
  /// @param text  the description's lines (N: I: P: B: A: ...), with or without comments
  /// @returns nothing if libevemu cannot read it, and has said why on standard error
  static std::optional<Description> parse(const std::string& text);

  Description(Description&& other) noexcept;
  Description& operator=(Description&& other) noexcept;
  Description(const Description&) = delete;
  Description& operator=(const Description&) = delete;
  ~Description();

  std::string name() const;
  /// The range of absolute axis `code`; nothing if the device has no such axis or says that it is
  /// empty.
  std::optional<AxisRange> range(int code) const;

 private:
  Description() = default;
  evemu_device* device_ = nullptr;
};

}  // namespace batuta::host
