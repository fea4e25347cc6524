// SPDX-License-Identifier: MIT
#pragma once
// Reads a HID report descriptor as a host does, by HID 1.11 section 6.2.2 and from the bytes alone:
// shares nothing with the code that makes them. For tests: throws std::runtime_error at whatever a
// host would refuse.

#include <cstdint>
#include <string>
#include <vector>

namespace batuta::pid::test {

/// Usage page in the upper half, usage in the lower.
using UsageCode = std::uint32_t;

struct ParsedCollection {
  int type = 0;  ///< 1 application, 2 logical
  UsageCode usage = 0;
  int parent = -1;
};

struct ParsedField {
  char way = '?';  ///< i, o or f
  int report = 0;
  int collection = -1;  ///< the innermost
  std::vector<UsageCode> usages;
  std::int64_t low = 0;
  std::int64_t high = 0;
  std::int64_t physical_low = 0;
  std::int64_t physical_high = 0;
  int unit = 0;
  int exponent = 0;
  int bits = 0;    ///< of one value
  int count = 0;   ///< values
  int at_bit = 0;  ///< of the first value, behind the id
  bool constant = false;
  bool variable = false;
};

struct Descriptor {
  std::vector<ParsedCollection> collections;
  std::vector<ParsedField> fields;

  /// Bits of a report behind its id.
  int bits_of(char way, int report) const;
  /// Reports of a way, in the order in which they appear.
  std::vector<int> reports(char way) const;
};

Descriptor parse(const std::uint8_t* bytes, std::size_t size);

}  // namespace batuta::pid::test
