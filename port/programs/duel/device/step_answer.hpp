// SPDX-License-Identifier: MIT
#pragma once
// What a device tells of one step, collected frame by frame. Frames of two answers to the same
// order may be mixed: they say the same.

#include <array>
#include <bitset>
#include <optional>

#include "shared/link/frame.hpp"

namespace batuta::host {

class StepAnswer {
 public:
  static constexpr std::size_t kMaxEvents = link::kMaxStepFrames;

  /// Forgets everything; collects for this step from now on.
  void begin(std::uint32_t step);

  enum class Taken : std::uint8_t {
    kNo,      ///< not of a step, or of an earlier one
    kYes,     ///< of this step
    kReport,  ///< of this step, and the last frame of an answer
    kLater,   ///< of a later step
  };
  Taken take(const link::Frame& frame);

  /// The report and as many frames as it counts are there.
  bool is_complete() const;

  std::uint32_t step() const { return step_; }
  /// @pre is_complete(): where there is a frame, it is of this step
  const std::optional<link::Pose>& pose(std::size_t side) const { return poses_[side]; }
  const std::optional<link::Force>& force(std::size_t side) const { return forces_[side]; }
  const std::optional<link::StickUsed>& used(std::size_t side) const { return used_[side]; }
  const std::optional<link::Touch>& touch(std::size_t index) const { return touches_[index]; }
  const std::optional<link::Event>& event(std::size_t index) const { return events_[index]; }
  const std::optional<link::StepReport>& report() const { return report_; }
  int events() const;
  int touches() const;

 private:
  template <class Message, std::size_t N>
  bool keep(const link::Frame& frame, std::array<std::optional<Message>, N>& places,
            std::size_t (*place_of)(const Message&));

  std::uint32_t step_ = 0;
  std::array<std::optional<link::Pose>, 2> poses_;
  std::array<std::optional<link::Force>, 2> forces_;
  std::array<std::optional<link::StickUsed>, 2> used_;
  std::array<std::optional<link::Touch>, 2> touches_;
  std::array<std::optional<link::Event>, kMaxEvents> events_;
  std::optional<link::StepReport> report_;
};

}  // namespace batuta::host
