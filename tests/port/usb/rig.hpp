// SPDX-License-Identifier: MIT
#pragma once
// A stick with its motor on a bus, and a host that knows the reports' bytes.

#include <gtest/gtest.h>

#include "fake_tinyusb.hpp"
#include "shared/usb_stick/tinyusb_device.hpp"

namespace batuta::usb::test {

using batuta::test::FakeUsb;
using batuta::test::Setup;
using batuta::test::UsbBytes;

class Motor final : public ForceDevice {
 public:
  ForceCommand last;
  bool gone = false;

 private:
  Status do_write(const ForceCommand& command) override {
    last = command;
    return gone ? Status::kUnavailable : Status::kOk;
  }
};

inline std::uint8_t byte_of(int number) {
  return static_cast<std::uint8_t>(number & 0xFF);
}

/// Counts of a level, as two bytes.
inline UsbBytes word(int number) {
  return {byte_of(number), byte_of(number >> 8)};
}

class Rig {
 public:
  explicit Rig(const UsbStickSettings& settings = {}) : stick(motor, settings) {
    EXPECT_EQ(stick.start(), Status::kOk);
    connect(&stick);
  }
  ~Rig() { connect(nullptr); }
  Rig(const Rig&) = delete;
  Rig& operator=(const Rig&) = delete;
  Rig(Rig&&) = delete;
  Rig& operator=(Rig&&) = delete;

  /// Milliseconds, with a sample in each.
  void run(int milliseconds) {
    for (int i = 0; i < milliseconds; ++i) {
      now += 1000;
      sample.time = now;
      ++sample.sequence;
      batuta::usb::run(stick, &sample, now);
    }
  }

  bool set_report(int type, const UsbBytes& bytes) {
    const auto value = static_cast<std::uint16_t>(type << 8 | bytes[0]);
    return bus.control({0x21, 9, value, 0, static_cast<std::uint16_t>(bytes.size())}, bytes)
        .has_value();
  }
  std::optional<UsbBytes> get_report(int type, int id, int length = 64) {
    return bus.control({0xA1, 1, static_cast<std::uint16_t>(type << 8 | id), 0,
                        static_cast<std::uint16_t>(length)},
                       {});
  }

  /// A new effect of this type. @returns its block, by the host's own questions
  int create(int type) {
    EXPECT_TRUE(set_report(3, {0x21, byte_of(type), 0, 0}));
    const auto load = get_report(3, 0x22);
    if (!load.has_value() || load->size() != 5 || (*load)[0] != 0x22) return -1;
    return (*load)[2] == 1 ? (*load)[1] : -1;
  }
  /// An endless constant force of `level` shares, from an angle in degrees.
  int constant(float level, int degrees) {
    const int block = create(1);
    const UsbBytes angle = word(degrees * 50);
    EXPECT_TRUE(bus.out(
        {0x11, byte_of(block), 1, 0, 0, 0, 0, 0, 0, 0, 0, 0xFF, 0, 4, angle[0], angle[1], 0, 0}));
    const UsbBytes size = word(static_cast<int>(level * 10000.0F));
    EXPECT_TRUE(bus.out({0x15, byte_of(block), size[0], size[1]}));
    return block;
  }
  void start(int block) { EXPECT_TRUE(bus.out({0x1A, byte_of(block), 1, 1})); }

  Motor motor;
  FakeUsb bus;
  UsbStick stick;
  InputSample sample;
  Microseconds now = 0;
};

/// Long enough for the stage's fade and slew.
inline constexpr int kFadedIn = 600;

}  // namespace batuta::usb::test
