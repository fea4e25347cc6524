// SPDX-License-Identifier: MIT
// The example of pid.md: it is what stands there, and it brings a host's effect to the motor, as
// TinyUSB calls it: SET_REPORT without the id, the OUT endpoint with it and number 0.

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <string>
#include <vector>

#include "batuta/haptics/output_stage.hpp"
#include "shared/hid_pid/tinyusb.hpp"
#include "tusb.h"

extern batuta::pid::Device<16> effects;
void tick(batuta::haptics::OutputStage& stage, const batuta::InputSample& sample,
          const batuta::Vec2<float>& velocity, batuta::Microseconds now);

namespace {

struct Sent {
  std::uint8_t id;
  std::vector<std::uint8_t> bytes;
};
std::vector<Sent>& sent() {
  static std::vector<Sent> all;
  return all;
}

}  // namespace

bool tud_hid_n_ready(std::uint8_t /*instance*/) {
  return true;
}
bool tud_hid_n_report(std::uint8_t /*instance*/, std::uint8_t report_id, void const* report,
                      std::uint16_t len) {
  const auto* const bytes = static_cast<const std::uint8_t*>(report);
  sent().push_back({report_id, {bytes, bytes + len}});
  return true;
}

namespace batuta::pid::test {
using namespace haptics;
namespace {

using Bytes = std::vector<std::uint8_t>;

class Motor final : public ForceDevice {
 public:
  ForceCommand last;

 private:
  Status do_write(const ForceCommand& command) override {
    last = command;
    return Status::kOk;
  }
};

/// A stick at its centre, its stage, and a clock.
class Firmware {
 public:
  Firmware() {
    effects.reset();
    sent().clear();
    StageSettings settings;
    settings.gain = {1.0F, 1.0F};
    EXPECT_EQ(stage.configure(settings), Status::kOk);
    EXPECT_EQ(stage.enable(), Status::kOk);
  }
  /// The stick gets faster to the right by so much in each millisecond.
  void accelerate(int milliseconds, float by) {
    for (int i = 0; i < milliseconds; ++i) {
      velocity.x() += by;
      tick(stage, {}, velocity, now += 1000);
    }
  }
  void run(int milliseconds) {
    for (int i = 0; i < milliseconds; ++i) tick(stage, {}, velocity, now += 1000);
  }
  Motor motor;
  OutputStage stage{motor};
  Vec2<float> velocity = Vec2<float>::Zero();
  Microseconds now = 0;
};

void set_feature(std::uint8_t id, const Bytes& bytes) {
  tud_hid_set_report_cb(0, id, HID_REPORT_TYPE_FEATURE, bytes.data(),
                        static_cast<std::uint16_t>(bytes.size()));
}
void out_endpoint(const Bytes& bytes) {
  tud_hid_set_report_cb(0, 0, HID_REPORT_TYPE_OUTPUT, bytes.data(),
                        static_cast<std::uint16_t>(bytes.size()));
}

TEST(PidExample, HostsEffect_ComesToTheMotorAndGoes) {
  Firmware firmware;
  set_feature(0x21, {0x01, 0x00, 0x00});
  out_endpoint({0x11, 0x01, 0x01, 0, 0, 0, 0, 0, 0, 0, 0, 0xFF, 0, 0x04, 0x94, 0x11, 0, 0});
  out_endpoint({0x15, 0x01, 0x88, 0x13});  // half, from the east
  out_endpoint({0x1A, 0x01, 0x01, 0x01});
  firmware.run(1000);
  EXPECT_FLOAT_EQ(firmware.motor.last.x, -0.5F);
  EXPECT_EQ(firmware.motor.last.y, 0.0F);
  tud_umount_cb();
  firmware.run(10);
  EXPECT_EQ(firmware.motor.last.x, 0.0F);
  const auto state = std::find_if(sent().begin(), sent().end(), [](const Sent& report) {
    return report.id == 0x02 && report.bytes == Bytes{0x02, 0x03};  // enabled; block 1 plays
  });
  EXPECT_NE(state, sent().end());
  EXPECT_EQ(sent().back().id, 0x01);
  EXPECT_EQ(sent().back().bytes.size(), 6U);
}

TEST(PidExample, ControlRequests_ReachTheDevice) {
  Firmware firmware;
  const auto& descriptor = kReportDescriptor<16>;
  EXPECT_TRUE(std::equal(descriptor.begin(), descriptor.end(), tud_hid_descriptor_report_cb(0)));
  set_feature(0x21, {0x01, 0x00, 0x00});
  std::uint8_t load[8] = {};
  ASSERT_EQ(tud_hid_get_report_cb(0, 0x22, HID_REPORT_TYPE_FEATURE, load, 8), 4);
  EXPECT_EQ(load[0], 1);
  EXPECT_EQ(load[1], 1);
  const Bytes start = {0x01, 0x01, 0x01};
  tud_hid_set_report_cb(0, 0x1A, HID_REPORT_TYPE_OUTPUT, start.data(), 3);
  EXPECT_EQ(effects.playing(), 1);
  const Bytes stop_by_endpoint = {0x1A, 0x01, 0x03, 0x00};
  tud_hid_set_report_cb(0, 0, HID_REPORT_TYPE_INVALID, stop_by_endpoint.data(), 4);
  EXPECT_EQ(effects.playing(), 0);
  tud_hid_set_report_cb(0, 0x1A, HID_REPORT_TYPE_OUTPUT, start.data(), 3);
  tud_suspend_cb(false);
  EXPECT_EQ(effects.playing(), 0);
  tud_hid_set_report_cb(0, 0x1A, HID_REPORT_TYPE_OUTPUT, start.data(), 3);
  EXPECT_EQ(effects.playing(), 1) << "the host wakes with its effects where they were";
  tud_umount_cb();
  EXPECT_EQ(tud_hid_get_report_cb(0, 0x22, HID_REPORT_TYPE_FEATURE, load, 8), 4);
  EXPECT_EQ(load[0], 0) << "forgotten";
}

// The page's tick tells the acceleration: by 0.01 in a millisecond it is 10, a tenth of the full
// scale, and a coefficient of 1 pushes against it by a tenth of the range.
TEST(PidExample, Inertia_PushesAgainstTheAcceleration) {
  ASSERT_EQ(Scales{}.acceleration, 100.0F);
  Firmware firmware;
  set_feature(0x21, {0x0A, 0x00, 0x00});
  out_endpoint({0x11, 0x01, 0x0A, 0, 0, 0, 0, 0, 0, 0, 0, 0xFF, 0, 0x01, 0, 0, 0, 0});
  out_endpoint({0x13, 0x01, 0x00, 0, 0, 0x10, 0x27, 0x10, 0x27, 0x10, 0x27, 0x10, 0x27, 0, 0});
  out_endpoint({0x1A, 0x01, 0x01, 0x01});
  firmware.run(1000);
  EXPECT_EQ(firmware.motor.last.x, 0.0F) << "at rest";
  firmware.accelerate(100, 0.01F);
  EXPECT_NEAR(firmware.motor.last.x, -0.1F, 1e-5F);
  EXPECT_EQ(firmware.motor.last.y, 0.0F);
  firmware.run(10);
  EXPECT_EQ(firmware.motor.last.x, 0.0F) << "fast, and no faster";
  firmware.accelerate(100, -0.01F);
  EXPECT_NEAR(firmware.motor.last.x, 0.1F, 1e-5F);
  tud_umount_cb();
}

// HID 1.11, section 7.2.1: GET_REPORT is mandatory.
TEST(PidExample, HostThatAsks_GetsInputsAndTheLastCreation) {
  Firmware firmware;
  tick(firmware.stage, {0, 1.0F, -1.0F, 0, 0, 5, 0}, Vec2<float>(0.0F, 0.0F), 1000);
  std::uint8_t answer[8] = {};
  ASSERT_EQ(tud_hid_get_report_cb(0, 0x01, HID_REPORT_TYPE_INPUT, answer, 8), 6);
  EXPECT_EQ(Bytes(answer, answer + 6), (Bytes{5, 0, 0xFF, 0x7F, 0xFF, 0x7F}));
  ASSERT_EQ(tud_hid_get_report_cb(0, 0x02, HID_REPORT_TYPE_INPUT, answer, 8), 2);
  EXPECT_EQ(Bytes(answer, answer + 2), (Bytes{0x02, 0x02})) << "enabled; block 1 is silent";
  set_feature(0x21, {0x09, 0x00, 0x00});
  ASSERT_EQ(tud_hid_get_report_cb(0, 0x21, HID_REPORT_TYPE_FEATURE, answer, 8), 3);
  EXPECT_EQ(answer[0], 0x09);
}

TEST(PidExample, WrongTypesAndNothing_AreRefused) {
  Firmware firmware;
  const Bytes bytes = {0x21, 0x01, 0x00, 0x00};
  const std::uint32_t before = effects.counters().refused();
  tud_hid_set_report_cb(0, 0x21, HID_REPORT_TYPE_OUTPUT, bytes.data() + 1, 3);
  tud_hid_set_report_cb(0, 0x1C, HID_REPORT_TYPE_FEATURE, bytes.data() + 1, 1);
  tud_hid_set_report_cb(0, 0x1C, HID_REPORT_TYPE_INPUT, bytes.data() + 1, 1);
  tud_hid_set_report_cb(0, 0, HID_REPORT_TYPE_OUTPUT, bytes.data(), 4);
  tud_hid_set_report_cb(0, 0, HID_REPORT_TYPE_OUTPUT, nullptr, 0);
  EXPECT_EQ(effects.counters().refused(), before + 5);
  std::uint8_t answer[8] = {};
  EXPECT_EQ(tud_hid_get_report_cb(0, 0x22, HID_REPORT_TYPE_INPUT, answer, 8), 0);
  EXPECT_EQ(tud_hid_get_report_cb(0, 0x15, HID_REPORT_TYPE_OUTPUT, answer, 8), 0);
  EXPECT_EQ(tud_hid_get_report_cb(0, 0x01, HID_REPORT_TYPE_INPUT, answer, 5), 0);
  EXPECT_EQ(tud_hid_get_report_cb(0, 0x23, HID_REPORT_TYPE_FEATURE, answer, 3), 0);
  EXPECT_EQ(tud_hid_get_report_cb(0, 0x23, HID_REPORT_TYPE_FEATURE, answer, 4), 4);
}

std::vector<std::string> between(const std::string& path, const std::string& begin,
                                 const std::string& end) {
  std::ifstream file(path);
  std::vector<std::string> lines;
  bool inside = false;
  for (std::string line; std::getline(file, line);) {
    if (line == end) inside = false;
    if (inside) lines.push_back(line);
    if (line == begin) inside = true;
  }
  return lines;
}

TEST(PidExample, Document_HasThisVeryCode) {
  const std::vector<std::string> code = between(BATUTA_PID_EXAMPLE, "// begin", "// end");
  ASSERT_GT(code.size(), 40U);
  EXPECT_EQ(between(BATUTA_PID_DOCUMENT, "```cpp", "```"), code);
}

}  // namespace
}  // namespace batuta::pid::test
