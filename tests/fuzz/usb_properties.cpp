// SPDX-License-Identifier: MIT
// What must hold of a USB force-feedback stick for any transfers whatever, as a libFuzzer target.
// An input is a row of records [what, how much, bytes...]: control transfers, packets of the
// endpoints, a bus that comes and goes, time.

#include <algorithm>
#include <cmath>

#include "bytes.hpp"
#include "fake_tinyusb.hpp"
#include "shared/usb_stick/tinyusb_device.hpp"

namespace batuta::usb {
namespace {

using fuzz::require;
using test::Setup;
using test::UsbBytes;

class Motor final : public ForceDevice {
 public:
  ForceCommand last;

 private:
  Status do_write(const ForceCommand& command) override {
    for (const float share : {command.x, command.y}) {
      require(share >= -1.0F && share <= 1.0F, "a force is within its range, and a number");
    }
    last = command;
    return Status::kOk;
  }
};

/// A SET_REPORT to the one interface: HID 1.11, 7.2.2.
bool sets_report(const Setup& setup) {
  return (setup.request_type & 0x7F) == 0x21 && setup.request == 9;
}

class Life {
 public:
  Life() : stick_(motor_) {
    require(stick_.start() == Status::kOk, "the default settings are valid");
    connect(&stick_);
    require(bus_.enumerate(), "a host comes to know the stick");
  }
  ~Life() { connect(nullptr); }
  Life(const Life&) = delete;
  Life& operator=(const Life&) = delete;
  Life(Life&&) = delete;
  Life& operator=(Life&&) = delete;

  void control(fuzz::Bytes bytes) {
    Setup setup;
    setup.request_type = bytes.byte();
    setup.request = bytes.byte();
    setup.value = bytes.word();
    setup.index = bytes.word();
    setup.length = bytes.word();
    UsbBytes out;
    while (bytes.left() > 0) out.push_back(bytes.byte());
    const std::uint32_t before = heard();
    const auto answer = bus_.control(setup, out);
    const bool is_read = (setup.request_type & 0x80) != 0;
    if (answer.has_value()) {
      require(answer->size() <= setup.length, "no answer is longer than asked for");
      require(is_read || answer->empty(), "a host that writes reads nothing");
    }
    const bool counted = answer.has_value() && sets_report(setup);
    require(heard() == before + (counted ? 1U : 0U), "each report is taken or refused, once");
  }

  void out(fuzz::Bytes bytes) {
    UsbBytes packet;
    while (bytes.left() > 0) packet.push_back(bytes.byte());
    const std::uint32_t before = heard();
    const bool took = bus_.out(packet);
    require(!took || awake(), "an endpoint takes nothing without a host");
    require(heard() == before + (took ? 1U : 0U), "each packet is taken or refused, once");
  }

  void in() {
    const auto packet = bus_.in();
    if (!packet.has_value()) return;
    require((*packet)[0] == 1 || (*packet)[0] == 2, "there are two input reports");
    require(packet->size() == ((*packet)[0] == 1 ? 7U : 3U), "a report has one length");
  }

  void bus(int what) {
    switch (what % 5) {
      case 0:
        bus_.plug();
        break;
      case 1:
        bus_.unplug();
        require(stick_.effects().playing() == 0, "nothing plays without a host");
        break;
      case 2:
        bus_.suspend();
        break;
      case 3:
        bus_.resume();
        break;
      default:
        require(bus_.enumerate(), "the stick can always be known again");
    }
    if (!awake()) require(silent() || what % 5 == 0, "no force when the host has gone");
  }

  /// Milliseconds with the stick anywhere, or none at all.
  void time(fuzz::Bytes bytes) {
    const int count = bytes.byte();
    const bool speaks = bytes.flag();
    InputSample sample;
    sample.x = 2 * bytes.share() - 1;
    sample.y = 2 * bytes.share() - 1;
    sample.buttons = bytes.word();
    for (int i = 0; i < count; ++i) tick(speaks ? &sample : nullptr);
  }

  void tick(InputSample* sample) {
    now_ += 1000;
    if (sample != nullptr) sample->time = now_;
    run(stick_, sample, now_);
    require(awake() || silent(), "no force without a host that is awake");
    require(awake() || stick_.effects().playing() == 0, "and nothing that plays");
  }

 private:
  bool awake() const { return bus_.configured() && !bus_.suspended(); }
  bool silent() const {
    return motor_.last.x == 0.0F && motor_.last.y == 0.0F && motor_.last.own == 0.0F;
  }
  std::uint32_t heard() {
    const pid::Counters& counters = stick_.effects().counters();
    return counters.refused() + counters.count(pid::Verdict::kTaken);
  }

  test::FakeUsb bus_;
  Motor motor_;
  UsbStick stick_;
  Microseconds now_ = 0xFFF00000U;  ///< wraps after a second
};

void live_through(Life& life, std::uint8_t what, fuzz::Bytes bytes) {
  switch (what % 5) {
    case 0:
      return life.control(bytes);
    case 1:
      return life.out(bytes);
    case 2:
      return life.time(bytes);
    case 3:
      return life.bus(bytes.byte());
    default:
      return life.in();
  }
}

}  // namespace
}  // namespace batuta::usb

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace batuta;
  usb::Life life;
  std::size_t at = 0;
  while (size - at >= 2) {
    const std::uint8_t what = data[at];
    const std::size_t length = std::min(std::size_t{data[at + 1]}, size - at - 2);
    usb::live_through(life, what, {data + at + 2, length});
    InputSample sample;
    life.tick(&sample);
    at += 2 + length;
  }
  return 0;
}
