// SPDX-License-Identifier: MIT

#include "programs/duel/device/device_link.hpp"

#include <algorithm>
#include <cmath>
#include <random>

namespace batuta::host {
namespace {

/// Two runs of the program should not begin with the same session.
std::uint32_t random_session() {
  return std::random_device{}();
}

/// What a StepReport tells of a session.
std::uint16_t low_half(std::uint32_t session) {
  return static_cast<std::uint16_t>(session);
}

const char* reason_of(link::Refusal why) {
  switch (why) {
    case link::Refusal::kNoSession:
      return "it knows of no session; was it reset?";
    case link::Refusal::kWrongMode:
      return "it is in the other mode";
    case link::Refusal::kWrongStep:
      return "it is at another step";
    case link::Refusal::kBoutOver:
      return "its bout is over";
    case link::Refusal::kNotReady:
      break;
  }
  return "it could not put the fencers on guard";
}

}  // namespace

Patience patience_of(double seconds) {
  Patience patience;
  patience.tries = static_cast<int>(std::ceil(seconds * 1000 / patience.resend_after_ms));
  patience.greetings = std::max(patience.greetings, patience.tries);
  return patience;
}

DeviceLink::DeviceLink(const Line& line, const Patience& patience)
    : line_(line), patience_(patience), session_(random_session()) {}

Microseconds DeviceLink::deadline_after(int milliseconds) {
  return line_.clock.now() + static_cast<Microseconds>(milliseconds) * 1000U;
}

/// The next frame from the device, or null when the time is over or the line is gone.
const link::Frame* DeviceLink::next_frame(Microseconds deadline) {
  while (true) {  // Bound: the time until the deadline
    (void)sender_.pump(line_.stream);
    reader_.begin_tick();
    const link::Frame* frame = reader_.next(line_.stream);
    if (frame != nullptr || reader_.is_gone()) return frame;
    const std::int32_t left_us = elapsed_us(line_.clock.now(), deadline);
    if (left_us <= 0) return nullptr;
    if (reader_.holds_bytes()) continue;  // the line may have nothing more to wait for
    line_.wait(std::min(left_us / 1000 + 1, sender_.pending() > 0 ? 1 : 1000));
  }
}

bool DeviceLink::open(link::Mode mode, int touches) {
  problem_.clear();
  ++session_;
  if (low_half(session_) == 0) ++session_;  // the device's word for "alone"
  ++sums_.sessions;
  const link::Hello hello{session_, mode, static_cast<std::uint8_t>(touches)};
  for (int i = 0; i < patience_.greetings && !reader_.is_gone(); ++i) {  // Bound: greetings
    if (i > 0) ++sums_.resends;
    if (greet(hello)) return judge_welcome();
    if (!problem_.empty()) return false;
  }
  problem_ = silence("no answer to Hello", patience_.greetings);
  return false;
}

bool DeviceLink::greet(const link::Hello& hello) {
  tell(hello);
  const Microseconds deadline = deadline_after(patience_.resend_after_ms);
  while (const link::Frame* frame = next_frame(deadline)) {  // Bound: the time
    link::Welcome welcome;
    if (link::read_message(*frame, welcome) && welcome.session == hello.session) {
      welcome_ = welcome;
      return true;
    }
    link::Refused refused;
    if (link::read_message(*frame, refused) && refused.what == link::MessageType::kHello) {
      problem_ = std::string("the device refuses the session: ") + reason_of(refused.why);
      return false;
    }
  }
  return false;
}

bool DeviceLink::judge_welcome() {
  if (welcome_.step_us == 1000) return true;
  problem_ = "the device makes steps of " + std::to_string(welcome_.step_us) + " us, not 1000";
  return false;
}

bool DeviceLink::ask(const link::Step& order, StepAnswer& answer) {
  problem_.clear();
  answer.begin(order.step);
  for (int i = 0; i < patience_.tries && !reader_.is_gone(); ++i) {  // Bound: tries
    if (i > 0) ++sums_.resends;
    tell(order);
    if (collect(order.step, answer)) return true;
    if (!problem_.empty()) return false;
  }
  problem_ = silence("no whole answer to step " + std::to_string(order.step), patience_.tries);
  return false;
}

/// Until the answer is complete, has ended with something missing, or the time is over.
bool DeviceLink::collect(std::uint32_t step, StepAnswer& answer) {
  const Microseconds deadline = deadline_after(patience_.resend_after_ms);
  while (const link::Frame* frame = next_frame(deadline)) {  // Bound: the time
    if (is_of_other_session(*frame)) return false;
    const StepAnswer::Taken taken = answer.take(*frame);
    if (answer.is_complete()) return true;
    if (taken == StepAnswer::Taken::kReport || is_final(*frame, step)) return false;
  }
  return false;
}

/// A report of a step, this one or not, from a bout that this side knows nothing of. Nothing of an
/// older session comes after the Welcome: the line keeps the order.
bool DeviceLink::is_of_other_session(const link::Frame& frame) {
  link::StepReport report;
  if (!link::read_message(frame, report) || report.session == low_half(session_)) return false;
  problem_ = "the device is in another session (" + std::to_string(report.session) + ", not " +
             std::to_string(low_half(session_)) + "); was it reset?";
  return true;
}

/// A refusal of this very step: asking again cannot help.
bool DeviceLink::is_final(const link::Frame& frame, std::uint32_t step) {
  link::Refused refused;
  if (!link::read_message(frame, refused)) return false;
  ++sums_.refusals;
  if (refused.what != link::MessageType::kStep || refused.step != step) return false;
  problem_ = "the device refuses step " + std::to_string(step) + ": " + reason_of(refused.why) +
             " (steps over: " + std::to_string(refused.steps_over) + ")";
  return true;
}

DeviceLink::Heard DeviceLink::listen(std::uint32_t step, StepAnswer& answer) {
  problem_.clear();
  answer.begin(step);
  const std::uint32_t old = counters().count(link::Rejection::kOld);
  const Microseconds deadline = deadline_after(patience_.tries * patience_.resend_after_ms);
  while (const link::Frame* frame = next_frame(deadline)) {  // Bound: the time
    if (is_of_other_session(*frame)) return Heard::kOtherSession;
    const StepAnswer::Taken taken = answer.take(*frame);
    if (answer.is_complete()) return Heard::kStep;
    const bool ended = taken == StepAnswer::Taken::kReport || taken == StepAnswer::Taken::kLater;
    if (ended) return Heard::kLost;
  }
  if (counters().count(link::Rejection::kOld) != old) {
    problem_ = "the device numbers its frames anew; was it reset?";
    return Heard::kOtherSession;
  }
  problem_ = silence("nothing came of step " + std::to_string(step), patience_.tries);
  return Heard::kSilence;
}

std::string DeviceLink::silence(const std::string& what, int tries) const {
  if (reader_.is_gone()) return what + ": the line is gone";
  const int waited_ms = tries * patience_.resend_after_ms;
  std::string words = what + " within " + std::to_string(waited_ms) + " ms";
  if (counters().count(link::Rejection::kVersion) > 0) {
    return words + ": the device speaks version " + std::to_string(reader_.other_version()) +
           " of the protocol; this program speaks version " +
           std::to_string(link::kProtocolVersion);
  }
  return words + ": is the device running, and the cable in place?";
}

}  // namespace batuta::host
