// SPDX-License-Identifier: MIT
#pragma once
// What application.hpp declares: only for a file that instantiates it.

#include "shared/firmware/application.hpp"

#include "shared/firmware/step_messages.hpp"

namespace batuta::firmware {
using namespace haptics;
using namespace fencing;

using link::MessageType;
using link::Mode;
using link::Refusal;

namespace detail {

/// In 16 bits: the line has little room, and the first few are what matters.
inline std::uint16_t saturated(std::uint32_t count) {
  return static_cast<std::uint16_t>(count < 0xFFFFU ? count : 0xFFFFU);
}

}  // namespace detail

template <class RivalT>
Status ApplicationOf<RivalT>::start(const ApplicationSettings& settings) {
  if (settings.pause <= 0) return Status::kInvalidArgument;
  const Status status = bout_.start(settings.bout);  // what it refuses changes nothing
  if (status != Status::kOk) return status;
  settings_ = settings;
  report_ = {};
  session_ = 0;
  mode_ = Mode::kFree;
  prepare();
  past_silences_ = 0;
  watch_.start(settings.bout.step_us);
  return Status::kOk;
}

template <class RivalT>
void ApplicationOf<RivalT>::tick(std::uint32_t tick) {
  watch_.begin(tick, board_.clock.now());
  Order order;
  read_stick(order);
  listen(order);
  const bool stepped = step_is_due(order) && make_step(order);
  if (stepped) tell_step(false);
  if (bout_.is_over()) wait_after_bout();
  command_force(stepped);
  (void)sender_.pump(board_.stream);
  watch_.end(board_.clock.now());
}

/// The latest sample wins, whether it is the board's or the host's.
template <class RivalT>
void ApplicationOf<RivalT>::read_stick(Order& order) {
  if (board_.stick == nullptr || mode_ != Mode::kFree) return;
  InputSample sample;
  const Status status = board_.stick->read(watch_.begun(), sample);
  if (status == Status::kOk) order.keep(settings_.own_side, sample);
  if (status == Status::kInvalidArgument) ++report_.stick_invalid;
}

template <class RivalT>
void ApplicationOf<RivalT>::listen(Order& order) {
  reader_.begin_tick();
  for (int i = 0; i < kFramesPerTick; ++i) {  // Bound: kFramesPerTick
    const link::Frame* frame = reader_.next(board_.stream);
    if (frame == nullptr || !obey(*frame, order)) return;
  }
}

/// @returns whether another frame may be obeyed in this tick
template <class RivalT>
bool ApplicationOf<RivalT>::obey(const link::Frame& frame, Order& order) {
  link::Hello hello;
  link::Step step;
  link::StickSample sample;
  if (link::read_message(frame, step)) return take(step, order);
  if (link::read_message(frame, sample)) take(sample, order);
  if (link::read_message(frame, hello)) open(hello, order);
  return true;
}

template <class RivalT>
void ApplicationOf<RivalT>::open(const link::Hello& hello, Order& order) {
  const bool again =
      hello.session == session_ && hello.mode == mode_ && hello.touches == settings_.bout.touches;
  if (!again) {
    settings_.bout.touches = hello.touches;
    order = {};
    if (restart() != Status::kOk) return refuse(Refusal::kNotReady, MessageType::kHello, 0);
    session_ = hello.session;
    mode_ = hello.mode;
  }
  welcome();
}

template <class RivalT>
void ApplicationOf<RivalT>::welcome() {
  link::Welcome message;
  message.session = session_;
  message.mode = mode_;
  message.step_us = static_cast<std::uint32_t>(settings_.bout.step_us);
  message.fault_code = last_fault_.code;
  message.fault_detail = last_fault_.detail;
  message.step = bout_.steps();
  (void)sender_.send(message);  // without room it is counted, and the host asks again
}

/// A new bout, with no force on the stick.
template <class RivalT>
Status ApplicationOf<RivalT>::restart() {
  past_silences_ = silences();
  prepare();
  return bout_.start(settings_.bout);
}

/// What is beside the bout, with no force on the stick. @pre bout_ takes the settings
template <class RivalT>
void ApplicationOf<RivalT>::prepare() {
  paused_ = 0;
  const float dt = static_cast<float>(settings_.bout.step_us) * kSecondsPerUs<float>;
  (void)stage_.configure(stage_settings(settings_.bout.force, dt));  // takes what the bout does
  if constexpr (RivalT::kPlays) this->rewind();
  (void)stage_.enable();  // unless stopped: a new bout ends no emergency stop
}

/// The next step, or the last one once more; at most one of them is answered in a tick.
template <class RivalT>
bool ApplicationOf<RivalT>::take(const link::Step& step, Order& order) {
  if (session_ == 0) {
    refuse(Refusal::kNoSession, MessageType::kStep, step.step);
  } else if (mode_ != Mode::kPaced) {
    refuse(Refusal::kWrongMode, MessageType::kStep, step.step);
  } else if (step.step == bout_.steps() && step.step > 0) {
    tell_step(true);
    return false;
  } else if (step.step != bout_.steps() + 1) {
    refuse(Refusal::kWrongStep, MessageType::kStep, step.step);
  } else if (bout_.is_over()) {
    refuse(Refusal::kBoutOver, MessageType::kStep, step.step);
  } else {
    order = {true, {step.has_left, step.has_right}, {step.left, step.right}};
    return false;
  }
  return true;
}

template <class RivalT>
void ApplicationOf<RivalT>::take(const link::StickSample& sample, Order& order) {
  if (session_ == 0) return refuse(Refusal::kNoSession, MessageType::kStickSample, 0);
  if (mode_ != Mode::kFree) return refuse(Refusal::kWrongMode, MessageType::kStickSample, 0);
  const Side side = sample.side == link::LinkSide::kLeft ? Side::kLeft : Side::kRight;
  if constexpr (RivalT::kPlays) {
    if (side != settings_.own_side) {
      return refuse(Refusal::kWrongMode, MessageType::kStickSample, 0);
    }
  }
  order.keep(side, sample.sample);
}

template <class RivalT>
void ApplicationOf<RivalT>::refuse(Refusal why, MessageType what, std::uint32_t step) {
  ++report_.steps_refused;
  (void)sender_.send(link::Refused{why, what, step, bout_.steps()});
}

template <class RivalT>
bool ApplicationOf<RivalT>::step_is_due(const Order& order) const {
  return mode_ == Mode::kFree ? !bout_.is_over() : order.make;
}

template <class RivalT>
bool ApplicationOf<RivalT>::make_step(Order& order) {
  if constexpr (RivalT::kPlays) {
    const Side side = other(settings_.own_side);
    if (mode_ == Mode::kFree) {
      order.keep(side, this->play(bout_.duel(), side, settings_.bout.step_us));
    }
  }
  return bout_.step(order.sample(Side::kLeft), order.sample(Side::kRight)) == Status::kOk;
}

/// Alone the next bout begins by itself; a host would not know what its own bout has to do then.
template <class RivalT>
void ApplicationOf<RivalT>::wait_after_bout() {
  if (session_ != 0) return;
  if (++paused_ < settings_.pause) return;
  (void)restart();  // as valid as it was in start()
}

template <class RivalT>
void ApplicationOf<RivalT>::tell_step(bool repeated) {
  const DuelType& duel = bout_.duel();
  for (const Side side : {Side::kLeft, Side::kRight}) {  // Bound: 2
    if (mode_ == Mode::kFree && bout_.used(side) != nullptr) {
      (void)sender_.send(used_message(bout_, side));
    }
    (void)sender_.send(pose_message(duel, side));
    (void)sender_.send(force_message(bout_, side));
  }
  for (int i = 0; i < duel.world().events().size(); ++i) {  // Bound: DuelScene::kMaxEvents
    (void)sender_.send(event_message(duel, i));
  }
  const int touches = duel.bout().touches.size();
  for (int i = touches - new_touches(duel); i < touches; ++i) {  // Bound: 2
    (void)sender_.send(touch_message(duel, i));
  }
  send_report(repeated);
}

template <class RivalT>
void ApplicationOf<RivalT>::send_report(bool repeated) {
  link::StepReport message = report_message(bout_);
  message.frames = static_cast<std::uint8_t>(frames_of(bout_, mode_ == Mode::kFree));
  message.repeated = repeated;
  message.overruns = ticks().overruns;
  message.skipped = ticks().skipped;
  message.silences = silences();
  message.rejected = link().rejected();
  message.lost = link().lost;
  message.unsent = unsent();
  message.session = static_cast<std::uint16_t>(session_);  // its low half
  message.force_failures = detail::saturated(report_.force_failures);
  message.stick_invalid = detail::saturated(report_.stick_invalid);
  message.spent_us = static_cast<std::uint32_t>(elapsed_us(watch_.begun(), board_.clock.now()));
  (void)sender_.send(message);
}

/// The force of a step is for one step's length: the motor gets it in the tick that made the step,
/// once, and nothing in a tick without a step, nor after the bout: so a pulse keeps its area. What
/// comes back after a silence comes slowly.
template <class RivalT>
void ApplicationOf<RivalT>::command_force(bool stepped) {
  const Side own = settings_.own_side;
  const auto& stick = bout_.duel().stick(own);
  const haptics::StickForce& force = bout_.forces().of(own);
  StageInput input;
  input.time = watch_.begun();
  input.position = stick.position();
  if (stepped) input.velocity = stick.velocity();
  if (stepped && !bout_.is_over()) {
    input.demanded = force.demanded;
    input.clipped = force.limited;
    input.excess = force.excess;
  }
  input.allowed = force.allowed;
  input.fresh_sample = stepped && bout_.is_alive(own);
  input.fresh_command = stepped;
  if (stage_.step(input) != Status::kOk) ++report_.force_failures;
}

}  // namespace batuta::firmware
