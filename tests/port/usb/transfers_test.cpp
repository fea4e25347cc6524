// SPDX-License-Identifier: MIT
// Control transfers: what is answered, what stalls, what is refused and counted.

#include <gtest/gtest.h>

#include "rig.hpp"

namespace batuta::usb::test {
namespace {

class Transfers : public ::testing::Test {
 protected:
  Transfers() { EXPECT_TRUE(rig.bus.enumerate()); }
  bool stalls(const batuta::test::Setup& setup) { return !rig.bus.control(setup, {}).has_value(); }
  std::uint32_t refused() { return rig.stick.effects().counters().refused(); }
  Rig rig;
};

TEST_F(Transfers, Enumeration_GivesAddressAndConfiguration) {
  EXPECT_EQ(rig.bus.address(), 5);
  EXPECT_EQ(rig.bus.control({0x80, 8, 0, 0, 1}, {}), UsbBytes{1});
  EXPECT_EQ(rig.bus.control({0x81, 10, 0, 0, 1}, {}), UsbBytes{0});
}

TEST_F(Transfers, UnknownRequests_Stall) {
  EXPECT_TRUE(stalls({0x80, 6, 0x0600, 0, 10})) << "device qualifier: full speed only";
  EXPECT_TRUE(stalls({0x80, 6, 0x0F00, 0, 5})) << "capabilities: USB 2.0 has none";
  EXPECT_TRUE(stalls({0x80, 6, 0x03EE, 0, 18})) << "a string that there is not";
  EXPECT_TRUE(stalls({0x80, 6, 0x0304, 0x0409, 255}));
  EXPECT_TRUE(stalls({0x80, 77, 0, 0, 1}));
  EXPECT_TRUE(stalls({0xC0, 1, 0, 0, 1})) << "vendor";
  EXPECT_TRUE(stalls({0xA1, 1, 0x0301, 1, 8})) << "another interface";
  EXPECT_TRUE(stalls({0xA1, 99, 0, 0, 8}));
  EXPECT_TRUE(stalls({0x81, 6, 0x2300, 0, 8})) << "physical descriptor";
  EXPECT_TRUE(stalls({0x01, 11, 1, 0, 0})) << "an alternative setting";
  EXPECT_TRUE(stalls({0x00, 9, 7, 0, 0})) << "another configuration";
  EXPECT_TRUE(stalls({0x80, 6, 0x0201, 0, 9})) << "its descriptor";
  EXPECT_TRUE(stalls({0x82, 0, 0, 0x82, 2})) << "another endpoint";
  EXPECT_TRUE(stalls({0x83, 0, 0, 0, 2})) << "no recipient";
}

TEST_F(Transfers, GetReport_OfEachKind) {
  EXPECT_EQ(rig.get_report(3, 0x23)->size(), 5U) << "pool";
  EXPECT_EQ((*rig.get_report(3, 0x23))[3], kBlocks);
  EXPECT_EQ(rig.get_report(1, 0x01)->size(), 7U);
  EXPECT_EQ(rig.get_report(1, 0x02)->size(), 3U);
  EXPECT_EQ(rig.get_report(3, 0x23, 3), (UsbBytes{0x23})) << "no room for it";
  // What there is not: TinyUSB sends the number alone, and stalls only where none was named.
  EXPECT_EQ(rig.get_report(3, 0x44), (UsbBytes{0x44}));
  EXPECT_EQ(rig.get_report(2, 0x15), (UsbBytes{0x15}));
  EXPECT_EQ(rig.get_report(0, 0x23), (UsbBytes{0x23})) << "a type that HID has not";
  EXPECT_EQ(rig.get_report(4, 0x23), (UsbBytes{0x23}));
  EXPECT_EQ(rig.get_report(3, 0x44, 1), std::nullopt) << "no room for a number alone";
  EXPECT_EQ(rig.get_report(3, 0x00), std::nullopt);
}

TEST_F(Transfers, SetReport_WithAndWithoutItsNumberInTheData) {
  ASSERT_EQ(rig.create(1), 1);
  // Without: the third byte of the setup has it.
  EXPECT_TRUE(rig.bus.control({0x21, 9, 0x0321, 0, 3}, {1, 0, 0}).has_value());
  EXPECT_EQ((*rig.get_report(3, 0x22))[1], 2);
  EXPECT_TRUE(rig.set_report(2, {0x1A, 1, 1, 1}));  // output, by control
  EXPECT_EQ(rig.stick.effects().playing(), 1);
  EXPECT_EQ(refused(), 0U);
}

// Number 0 is what TinyUSB calls a packet of the OUT endpoint: of no other type.
TEST_F(Transfers, SetReportOfNumberZero_IsAnOutputOrNothing) {
  ASSERT_EQ(rig.create(1), 1);
  for (const int type : {1, 3, 4}) {
    const std::uint32_t before = refused();
    const auto value = static_cast<std::uint16_t>(type << 8);
    EXPECT_TRUE(rig.bus.control({0x21, 9, value, 0, 4}, {0x1A, 1, 1, 1}).has_value());
    EXPECT_EQ(refused(), before + 1) << type;
  }
  EXPECT_EQ(rig.stick.effects().playing(), 0);
  EXPECT_TRUE(rig.bus.control({0x21, 9, 0x0200, 0, 4}, {0x1A, 1, 1, 1}).has_value());
  EXPECT_EQ(rig.stick.effects().playing(), 1);
}

TEST_F(Transfers, WhatIsWrong_IsRefusedAndCounted) {
  std::uint32_t expected = 0;
  EXPECT_TRUE(rig.set_report(2, {0x55, 1, 2}));
  EXPECT_EQ(refused(), ++expected) << "no such report";
  EXPECT_TRUE(rig.set_report(2, {0x15, 1, 0, 0}));
  EXPECT_EQ(refused(), ++expected) << "no such effect";
  EXPECT_TRUE(rig.bus.out({0x1A, 1}));
  EXPECT_EQ(refused(), ++expected) << "too short";
  EXPECT_TRUE(rig.bus.out({}));
  EXPECT_EQ(refused(), ++expected) << "nothing at all";
  EXPECT_TRUE(rig.bus.out(UsbBytes(64, 0xFF)));
  EXPECT_EQ(refused(), ++expected);
  EXPECT_FALSE(rig.set_report(2, UsbBytes(65, 0x1A))) << "longer than a packet: stalls";
  EXPECT_EQ(refused(), expected);
  EXPECT_TRUE(rig.set_report(3, {0x21, 99, 0, 0}));
  EXPECT_EQ(refused(), ++expected) << "no such type";
  EXPECT_EQ((*rig.get_report(3, 0x22))[2], 3) << "block load: error";
}

TEST_F(Transfers, FullPool_IsTold) {
  for (int block = 1; block <= kBlocks; ++block) ASSERT_EQ(rig.create(1), block);
  EXPECT_EQ(rig.create(1), -1);
  EXPECT_EQ((*rig.get_report(3, 0x22))[2], 2) << "full";
  EXPECT_TRUE(rig.bus.out({0x1B, 7}));
  EXPECT_EQ(rig.create(1), 7);
}

TEST_F(Transfers, HaltedEndpoints_TakeAndGiveNothing) {
  rig.run(1);
  for (const std::uint16_t endpoint : {std::uint16_t{0x81}, std::uint16_t{0x01}}) {
    EXPECT_TRUE(rig.bus.control({0x02, 3, 0, endpoint, 0}, {}).has_value());
    EXPECT_EQ(rig.bus.control({0x82, 0, 0, endpoint, 2}, {}), (UsbBytes{1, 0}));
  }
  EXPECT_FALSE(rig.bus.in().has_value());
  EXPECT_FALSE(rig.bus.out({0x1C, 1}));
  for (const std::uint16_t endpoint : {std::uint16_t{0x81}, std::uint16_t{0x01}}) {
    EXPECT_TRUE(rig.bus.control({0x02, 1, 0, endpoint, 0}, {}).has_value());
  }
  EXPECT_TRUE(rig.bus.in().has_value());
  EXPECT_TRUE(rig.bus.out({0x1C, 1}));
}

TEST_F(Transfers, IdleAndProtocol_AreKept) {
  EXPECT_TRUE(rig.bus.control({0x21, 10, 0x1200, 0, 0}, {}).has_value());
  EXPECT_EQ(rig.bus.control({0xA1, 2, 0, 0, 1}, {}), UsbBytes{0x12});
  EXPECT_EQ(rig.bus.control({0xA1, 3, 0, 0, 1}, {}), UsbBytes{1});
}

TEST(Disconnected, CallbacksWithoutAStick_RefuseAll) {
  FakeUsb bus;
  connect(nullptr);
  ASSERT_TRUE(bus.enumerate());
  EXPECT_EQ(bus.control({0xA1, 1, 0x0323, 0, 64}, {}), UsbBytes{0x23});
  EXPECT_TRUE(bus.out({0x1C, 4}));
  bus.suspend();
  bus.unplug();
}

TEST(Disconnected, BeforeTheBus_NothingIsAnswered) {
  Rig rig;
  EXPECT_EQ(rig.get_report(3, 0x23), std::nullopt);
  EXPECT_FALSE(rig.bus.out({0x1C, 4}));
  rig.run(3);
  EXPECT_FALSE(rig.bus.in().has_value());
  rig.bus.plug();
  EXPECT_EQ(rig.get_report(3, 0x23), std::nullopt) << "not configured yet";
}

}  // namespace
}  // namespace batuta::usb::test
