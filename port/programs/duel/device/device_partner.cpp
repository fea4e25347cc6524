// SPDX-License-Identifier: MIT

#include "programs/duel/device/device_partner.hpp"

#include "programs/duel/device/step_difference.hpp"
#include "shared/firmware/step_messages.hpp"

namespace batuta::host {
using namespace fencing;

bool DevicePartner::open(int touches) {
  session_ = Session::kGoingOn;
  problem_.clear();
  do_open();
  return link_.open(mode(), touches) || fail(link_.problem());
}

bool DevicePartner::after_step(const DuelRunner& runner) {
  if (!do_after_step(runner)) return false;
  report_ = *answer_.report();  // complete: it has one
  const std::string difference = first_difference(*runner.bout().on_board(), answer_);
  if (!difference.empty()) return fail(difference);
  ++compared_;
  for (std::size_t side = 0; side < 2; ++side) {  // Bound: 2; complete: both are there
    const link::Force& force = *answer_.force(side);
    if (force.x != 0 || force.y != 0) ++forces_not_zero_;
  }
  return true;
}

bool DevicePartner::fail(const std::string& problem) {
  session_ = Session::kFailed;
  problem_ = problem;
  return false;
}

bool DevicePartner::lose(const std::string& problem) {
  session_ = Session::kLost;
  problem_ = problem;
  ++lost_sessions_;
  return false;
}

bool PacedPartner::do_after_step(const DuelRunner& runner) {
  const PlayedBout& bout = runner.bout();
  link::Step order;
  order.step = bout.steps();
  if (const InputSample* left = bout.used(Side::kLeft)) {
    order.has_left = true;
    order.left = *left;
  }
  if (const InputSample* right = bout.used(Side::kRight)) {
    order.has_right = true;
    order.right = *right;
  }
  return line().ask(order, answer()) || fail(line().problem());
}

/// What a session before this one has left over is of no step.
void FreePartner::do_open() {
  for (ReportedStick* face : faces_) face->tell(std::nullopt);  // Bound: 2
}

bool FreePartner::do_before_step(const DuelRunner& runner) {
  const std::uint32_t steps = runner.bout().steps();
  tell_locals();
  switch (line().listen(steps + 1, answer())) {
    case DeviceLink::Heard::kLost:
      return lose("telemetry of step " + std::to_string(steps + 1) + " was lost");
    case DeviceLink::Heard::kOtherSession:
      return lose(line().problem());
    case DeviceLink::Heard::kSilence:
      return fail(line().problem());
    case DeviceLink::Heard::kStep:
      break;
  }
  for (std::size_t side = 0; side < 2; ++side) {  // Bound: 2
    const auto& used = answer().used(side);
    faces_[side]->tell(used ? std::optional<InputSample>(used->sample) : std::nullopt);
  }
  return true;
}

/// The device takes them for one of its next steps, and then says for which.
void FreePartner::tell_locals() {
  for (const Side side : {Side::kLeft, Side::kRight}) {  // Bound: 2
    Source* source = locals_[index_of(side)];
    InputSample sample;
    if (source == nullptr || source->read(now_, sample) != Status::kOk) continue;
    line().tell(link::StickSample{firmware::link_side(side), sample});
  }
  now_ += DuelRunner::kStep_us;
}

}  // namespace batuta::host
