// SPDX-License-Identifier: MIT

#include "programs/duel/device/step_answer.hpp"

#include <algorithm>

namespace batuta::host {
namespace {

template <class Message>
std::size_t by_side(const Message& message) {
  return static_cast<std::size_t>(message.side);
}

template <class Message>
std::size_t by_index(const Message& message) {
  return message.index;
}

template <class Places>
int filled(const Places& places) {
  return static_cast<int>(std::count_if(places.begin(), places.end(),
                                        [](const auto& place) { return place.has_value(); }));
}

/// The number of the step that a frame tells of; 0 if it is not of a step.
std::uint32_t step_of(const link::Frame& frame) {
  const auto number = [&](auto message) -> std::uint32_t {
    return link::read_message(frame, message) ? message.step : 0;
  };
  switch (frame.type) {
    case link::MessageType::kPose:
      return number(link::Pose{});
    case link::MessageType::kEvent:
      return number(link::Event{});
    case link::MessageType::kForce:
      return number(link::Force{});
    case link::MessageType::kTouch:
      return number(link::Touch{});
    case link::MessageType::kStickUsed:
      return number(link::StickUsed{});
    case link::MessageType::kStepReport:
      return number(link::StepReport{});
    default:
      return 0;
  }
}

}  // namespace

void StepAnswer::begin(std::uint32_t step) {
  *this = {};
  step_ = step;
}

StepAnswer::Taken StepAnswer::take(const link::Frame& frame) {
  const std::uint32_t step = step_of(frame);
  if (step == 0 || step < step_) return Taken::kNo;
  if (step > step_) return Taken::kLater;
  link::StepReport report;
  if (link::read_message(frame, report)) {
    report_ = report;
    return Taken::kReport;
  }
  const bool kept =
      keep(frame, poses_, by_side<link::Pose>) || keep(frame, forces_, by_side<link::Force>) ||
      keep(frame, used_, by_side<link::StickUsed>) ||
      keep(frame, touches_, by_index<link::Touch>) || keep(frame, events_, by_index<link::Event>);
  return kept ? Taken::kYes : Taken::kNo;
}

template <class Message, std::size_t N>
bool StepAnswer::keep(const link::Frame& frame, std::array<std::optional<Message>, N>& places,
                      std::size_t (*place_of)(const Message&)) {
  Message message;
  if (!link::read_message(frame, message) || place_of(message) >= N) return false;
  places[place_of(message)] = message;
  return true;
}

bool StepAnswer::is_complete() const {
  if (!report_) return false;
  return filled(poses_) + filled(forces_) + filled(used_) + touches() + events() + 1 ==
         report_->frames;
}

int StepAnswer::events() const {
  return filled(events_);
}

int StepAnswer::touches() const {
  return filled(touches_);
}

}  // namespace batuta::host
