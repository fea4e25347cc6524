// SPDX-License-Identifier: MIT
#pragma once
// The host's end of the cable: opens a session, asks for steps or listens to them, asks again where
// nothing or not everything came, and gives up after a bounded time with a reason.

#include <functional>
#include <string>

#include "programs/duel/device/step_answer.hpp"
#include "shared/firmware/frame_reader.hpp"
#include "shared/link/sender.hpp"

namespace batuta::host {

/// A line to a device and a way to wait for it.
struct Line {
  link::ByteStream& stream;
  Clock& clock;
  /// Returns when something may be read, or after so many milliseconds.
  std::function<void(int timeout_ms)> wait;
};

struct Patience {
  int resend_after_ms = 50;  ///< > 0
  int tries = 40;            ///< > 0, of a step; of silence in free mode, so many times that
  int greetings = 100;       ///< > 0: a device that has just been switched on takes its time
};

/// One that waits for so much silence, s, > 0: for a step, in free mode, and for the Welcome, if
/// that is not given longer anyway.
Patience patience_of(double seconds);

/// Sums since the start, beside those of the decoder.
struct LinkSums {
  std::uint32_t sessions = 0;  ///< begun, or tried to
  std::uint32_t resends = 0;   ///< questions asked once more
  std::uint32_t refusals = 0;  ///< Refused received
};

class DeviceLink {
 public:
  explicit DeviceLink(const Line& line, const Patience& patience = {});

  /// @param touches  to which the bout goes
  /// Says Hello until the device answers; a new bout begins there. All of them carry one session,
  /// which is new with each call, so that one that comes late begins nothing. @returns false:
  /// problem() Bound: greetings times resend_after_ms.
  bool open(link::Mode mode, int touches = 1);

  /// Paced: has a step made, and collects everything that the device tells of it.
  /// @returns false: problem()
  /// Bound: tries times resend_after_ms.
  bool ask(const link::Step& order, StepAnswer& answer);

  enum class Heard : std::uint8_t { kStep, kLost, kOtherSession, kSilence };
  /// Free: collects what the device tells of a step.
  /// @returns kStep | kLost: frames of it never came, and never will | kOtherSession:
  ///   problem() | kSilence: problem()
  Heard listen(std::uint32_t step, StepAnswer& answer);

  /// Sends without an answer. What finds no room is dropped.
  template <class Message>
  void tell(const Message& message) {
    (void)sender_.send(message);
    (void)sender_.pump(line_.stream);
  }

  /// Why the last call failed, in one line; empty: nothing did.
  const std::string& problem() const { return problem_; }
  const link::Welcome& welcome() const { return welcome_; }
  const LinkSums& sums() const { return sums_; }
  const link::LinkCounters& counters() const { return reader_.counters(); }
  std::uint32_t sent() const { return sender_.sent(); }

 private:
  const link::Frame* next_frame(Microseconds deadline);
  Microseconds deadline_after(int milliseconds);
  bool greet(const link::Hello& hello);
  bool judge_welcome();
  bool collect(std::uint32_t step, StepAnswer& answer);
  bool is_of_other_session(const link::Frame& frame);
  bool is_final(const link::Frame& frame, std::uint32_t step);
  std::string silence(const std::string& what, int tries) const;

  Line line_;
  Patience patience_;
  firmware::FrameReader<link::End::kHost> reader_;
  link::Sender<1024> sender_;
  link::Welcome welcome_;
  LinkSums sums_;
  std::uint32_t session_;  ///< of the last Hello
  std::string problem_;
};

}  // namespace batuta::host
