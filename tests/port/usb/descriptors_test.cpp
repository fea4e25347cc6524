// SPDX-License-Identifier: MIT
// The descriptors as a host reads them, byte by byte: USB 2.0, section 9.6.

#include "shared/usb_stick/descriptors.hpp"

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "rig.hpp"

namespace batuta::usb::test {
namespace {

int word_at(const UsbBytes& bytes, std::size_t at) {
  return bytes[at] + 256 * bytes[at + 1];
}

/// By type, in their order; a size that does not fit fails.
std::multimap<int, UsbBytes> parts_of(const UsbBytes& all) {
  std::multimap<int, UsbBytes> parts;
  std::size_t at = 0;
  while (at < all.size()) {
    const std::size_t size = all[at];
    if (size < 2 || at + size > all.size()) {
      ADD_FAILURE() << "a descriptor of " << size << " bytes at " << at;
      return parts;
    }
    const auto begin = all.begin() + static_cast<std::ptrdiff_t>(at);
    parts.emplace(all[at + 1], UsbBytes(begin, begin + static_cast<std::ptrdiff_t>(size)));
    at += size;
  }
  return parts;
}

class Descriptors : public ::testing::Test {
 protected:
  Descriptors() { EXPECT_TRUE(rig.bus.enumerate()); }
  UsbBytes get(int type, int index, int length = 4096) {
    const auto recipient = static_cast<std::uint8_t>(type < 0x20 ? 0x80 : 0x81);
    const auto bytes = rig.bus.control({recipient, 6, static_cast<std::uint16_t>(type << 8 | index),
                                        0, static_cast<std::uint16_t>(length)},
                                       {});
    EXPECT_TRUE(bytes.has_value());
    return bytes.value_or(UsbBytes());
  }
  std::string text(int index) {
    const UsbBytes bytes = get(3, index);
    EXPECT_EQ(bytes[0], bytes.size());
    EXPECT_EQ(bytes[1], 3);
    std::string letters;
    for (std::size_t i = 2; i < bytes.size(); i += 2) {
      EXPECT_EQ(bytes[i + 1], 0);
      letters += static_cast<char>(bytes[i]);
    }
    return letters;
  }
  Rig rig;
};

TEST_F(Descriptors, Device_SaysWhoItIs) {
  const UsbBytes device = get(1, 0);
  ASSERT_EQ(device.size(), 18U);
  EXPECT_EQ(device[0], 18);
  EXPECT_EQ(device[1], 1);
  EXPECT_EQ(word_at(device, 2), 0x0200);
  EXPECT_EQ(device[7], 64) << "endpoint 0 as tusb_config.h has it";
  EXPECT_EQ(word_at(device, 8), kVendor);
  EXPECT_EQ(word_at(device, 10), kProduct);
  EXPECT_EQ(device[17], 1) << "configurations";
  EXPECT_EQ(text(device[14]), Identity().manufacturer);
  EXPECT_EQ(text(device[15]), Identity().product);
  EXPECT_EQ(text(device[16]), Identity().serial);
}

TEST_F(Descriptors, Configuration_AddsUp) {
  const UsbBytes all = get(2, 0);
  EXPECT_EQ(word_at(all, 2), static_cast<int>(all.size()));
  EXPECT_EQ(get(2, 0, 9), UsbBytes(all.begin(), all.begin() + 9)) << "first the head alone";
  const auto parts = parts_of(all);
  ASSERT_EQ(parts.size(), 5U);
  const UsbBytes& head = parts.find(2)->second;
  EXPECT_EQ(head[4], 1) << "interfaces";
  EXPECT_EQ(head[5], 1) << "SET_CONFIGURATION takes this number";
  EXPECT_EQ(head[7], 0xC0) << "self-powered, no remote wake-up";
  EXPECT_LE(head[8] * 2, 500) << "mA";
  const UsbBytes& interface = parts.find(4)->second;
  EXPECT_EQ(interface[2], 0);
  EXPECT_EQ(interface[4], 2) << "endpoints";
  EXPECT_EQ(interface[5], 3) << "HID";
}

TEST_F(Descriptors, Hid_HasTheSizeOfItsReportDescriptor) {
  const auto parts = parts_of(get(2, 0));
  const UsbBytes& hid = parts.find(0x21)->second;
  ASSERT_EQ(hid.size(), 9U);
  EXPECT_EQ(word_at(hid, 2), 0x0111);
  EXPECT_EQ(hid[5], 1);
  EXPECT_EQ(hid[6], 0x22);
  EXPECT_EQ(get(0x21, 0), hid);
  const UsbBytes report = get(0x22, 0);
  EXPECT_EQ(word_at(hid, 7), static_cast<int>(report.size()));
  const auto& truth = PidDevice::report_descriptor();
  EXPECT_EQ(report, UsbBytes(truth.begin(), truth.end()));
}

TEST_F(Descriptors, Endpoints_OneEachWayEveryMillisecond) {
  const auto parts = parts_of(get(2, 0));
  std::vector<int> addresses;
  for (auto [at, end] = parts.equal_range(5); at != end; ++at) {
    const UsbBytes& endpoint = at->second;
    ASSERT_EQ(endpoint.size(), 7U);
    addresses.push_back(endpoint[2]);
    EXPECT_EQ(endpoint[3], 3) << "interrupt";
    EXPECT_EQ(word_at(endpoint, 4), 64);
    EXPECT_EQ(endpoint[6], 1);
  }
  EXPECT_EQ(addresses, (std::vector<int>{0x81, 0x01}));
}

TEST_F(Descriptors, Strings_InEnglish) {
  EXPECT_EQ(get(3, 0), (UsbBytes{4, 3, 0x09, 0x04}));
}

TEST(DescriptorStrings, LongOne_IsCutOff) {
  const std::string letters(100, 'x');
  Identity identity;
  identity.serial = letters.c_str();
  StringDescriptor string{};
  ASSERT_TRUE(write_string(identity, kSerial, string));
  EXPECT_EQ(string[0] & 0xFF, 2 + 2 * kLongestString);
  EXPECT_EQ(string.back(), 'x');
  identity.serial = "";
  ASSERT_TRUE(write_string(identity, kSerial, string));
  EXPECT_EQ(string[0] & 0xFF, 2);
  EXPECT_FALSE(write_string(identity, 4, string));
  EXPECT_FALSE(write_string(identity, -1, string));
}

}  // namespace
}  // namespace batuta::usb::test
