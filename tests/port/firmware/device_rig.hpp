// SPDX-License-Identifier: MIT
#pragma once
// The application on a board of memory: a cable, a clock that the test moves, a stick and a motor.

#include <gtest/gtest.h>

#include <memory>
#include <utility>
#include <vector>

#include "cable.hpp"
#include "shared/firmware/application.hpp"

namespace batuta::test {

class RigStick final : public InputDevice {
 public:
  std::vector<InputSample> samples;  ///< the next one first
  std::size_t next = 0;

 private:
  Status do_read(Microseconds /*now*/, InputSample& sample) override {
    if (next == samples.size()) return Status::kUnavailable;
    sample = samples[next++];
    return Status::kOk;
  }
};

class RigMotor final : public ForceDevice {
 public:
  ForceCommand last;
  int commands = 0;
  bool broken = false;

 private:
  Status do_write(const ForceCommand& command) override {
    if (broken) return Status::kUnavailable;
    last = command;
    ++commands;
    return Status::kOk;
  }
};

/// @tparam RivalT  as ApplicationOf
template <class RivalT = firmware::NoRival>
struct DeviceRigOf {
  Cable cable;
  HandClock clock;
  std::uint32_t ticks = 0;  ///< of the timer
  RigStick stick;
  RigMotor motor;
  firmware::ApplicationSettings settings;
  typename RivalT::Settings rival;
  std::unique_ptr<firmware::ApplicationOf<RivalT>> device =
      std::make_unique<firmware::ApplicationOf<RivalT>>(
          firmware::Board{clock, cable.device, &stick, &motor}, firmware::LastFault{});

  void start() { ASSERT_EQ(device->start(settings, rival), Status::kOk); }
  /// So many milliseconds, each with its tick.
  void run(int milliseconds) {
    for (int i = 0; i < milliseconds; ++i) {
      clock.time += 1000;
      device->tick(++ticks);
    }
  }
};

using DeviceRig = DeviceRigOf<>;

/// The host's end, as plain as it can be: whole frames out, whole frames in.
class PlainHost {
 public:
  explicit PlainHost(Cable& cable) : cable_(cable) {}

  template <class Message>
  void send(const Message& message) {
    std::array<std::uint8_t, link::kMaxWireFrame> wire{};
    const int count = encoder_.encode(message, wire.data(), static_cast<int>(wire.size()));
    ASSERT_GT(count, 0);
    ASSERT_EQ(cable_.host.write(wire.data(), count), count);
  }
  void send_raw(const std::vector<std::uint8_t>& bytes) {
    (void)cable_.host.write(bytes.data(), static_cast<int>(bytes.size()));
  }

  /// Everything of one kind that has come; the other kinds are lost.
  template <class Message>
  std::vector<Message> received() {
    std::vector<Message> messages;
    std::uint8_t byte = 0;
    while (cable_.host.read(&byte, 1) == 1) {
      if (decoder_.push(byte) != link::Arrival::kFrame) continue;
      Message message;
      if (link::read_message(decoder_.frame(), message)) messages.push_back(message);
      types_.push_back(decoder_.frame().type);
    }
    return messages;
  }
  /// The types of all frames that came since the last call.
  std::vector<link::MessageType> types() { return std::exchange(types_, {}); }
  const link::LinkCounters& counters() const { return decoder_.counters(); }

 private:
  Cable& cable_;
  link::FrameEncoder encoder_;
  link::HostDecoder decoder_;
  std::vector<link::MessageType> types_;
};

}  // namespace batuta::test
