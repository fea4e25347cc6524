// SPDX-License-Identifier: MIT
#pragma once
// Sticks, pads, mice and tablets as the Linux input stack tells of them, read by libevdev. Absolute
// axes bring their own range and dead zone; the movements of a relative one are summed up.

#include <memory>
#include <optional>
#include <string>

#include "programs/devices/event_decoder.hpp"
#include "programs/live/claim.hpp"
#include "programs/live/evdev_node.hpp"
#include "programs/live/feed.hpp"

struct input_event;

namespace batuta::host {

class EvdevFeed final : public Feed {
 public:
  /// @param path  stays the device's, however often it is plugged in; one below
  ///   /dev/input/by-id does so whatever else is plugged in
  /// @param claim  of the fencer, for as long as the device is open; not null
  explicit EvdevFeed(std::string path, std::shared_ptr<Claim> claim = std::make_shared<Claim>())
      : path_(std::move(path)), claim_(std::move(claim)) {}

  /// @returns empty | why not, in a few words
  std::string open();

  std::string name() const override { return name_; }
  void wait() override;
  /// Where events were lost, libevdev asks the device for its state, and that is the sample.
  /// Bound: kMostEvents; what is left is read by the next call.
  News look(InputSample& sample) override;
  bool reopen() override { return open().empty(); }
  std::uint32_t losses() const override { return losses_; }

 private:
  /// More than any device reports between two looks; a flood does not hold the thread.
  static constexpr int kMostEvents = 1024;

  void close();
  void tell_state(const MotionAxes& axes);
  News next_event(InputSample& sample);
  bool decode(const input_event& event, InputSample& sample);

  std::string path_;
  std::shared_ptr<Claim> claim_;
  std::string name_;
  EvdevNode node_;
  std::optional<EventDecoder> decoder_;
  std::optional<InputSample> first_;  ///< the state on opening, not handed out yet
  bool syncing_ = false;              ///< libevdev is telling what was lost
  bool drained_ = false;
  std::uint32_t losses_ = 0;
};

}  // namespace batuta::host
