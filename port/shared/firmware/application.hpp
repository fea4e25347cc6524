// SPDX-License-Identifier: MIT
#pragma once
// The fencing firmware without a board: a tick reads the stick and the link, makes at most one step
// of the bout, and sends force and telemetry. A board's main waits for the tick, calls tick(), and
// feeds its watchdog.
//
// It starts in free mode, alone: the own stick fences against a fencer that stands on guard, and
// after a bout the next one begins. Where the application names a rival, that one plays the other
// side in free mode. A host's Hello opens a session: a new bout, paced or free. In a session the
// device waits after the bout until the host opens another one.

#include "batuta/haptics/stepped_bout.hpp"
#include "shared/firmware/frame_reader.hpp"
#include "shared/firmware/rival.hpp"
#include "shared/firmware/stage_settings.hpp"
#include "shared/firmware/tick_watch.hpp"
#include "shared/link/sender.hpp"

namespace batuta::firmware {

/// What a board gives the application. Everything outlives it.
struct Board {
  Clock& clock;
  link::ByteStream& stream;
  InputDevice* stick = nullptr;  ///< of the own side; null: samples come over the link only
  ForceDevice* force = nullptr;  ///< of the own side; null: forces are told over the link only
};

/// Why the device was reset, as the board has kept it; 0: no fault.
struct LastFault {
  std::uint32_t code = 0;
  std::array<std::uint32_t, 2> detail{};
};

struct ApplicationSettings {
  haptics::BoutSettings bout;  ///< touches: of bouts alone, until a session says another number
  fencing::Side own_side = fencing::Side::kLeft;  ///< whose stick and force the board has
  /// Alone: ticks from the end of a bout to the next one, > 0.
  std::int32_t pause = 2000;
};

/// What happened since start(), beside what the link and the ticks count.
struct ApplicationReport {
  std::uint32_t steps_refused = 0;   ///< Step and StickSample that were not obeyed
  std::uint32_t stick_invalid = 0;   ///< samples of the own stick outside its square
  std::uint32_t force_failures = 0;  ///< ticks in which the force device took no command: it is
                                     ///< gone, or the emergency stop is on
};

/// One object, placed by main. RAM: sizeof; nothing beside it. Allocates: never. From one context.
/// Built for NoRival and for SeeingRival; a program links the one that it names.
/// @tparam RivalT  who plays the other side in free mode: what it is not is absent
template <class RivalT = NoRival>
class ApplicationOf : private RivalT {
 public:
  /// A whole step's telemetry, with room for what is still on its way.
  static constexpr int kSendBytes = 2048;
  /// The most that is obeyed in one tick; more waits for the next one.
  static constexpr int kFramesPerTick = 4;

  ApplicationOf(const Board& board, const LastFault& last_fault)
      : board_(board), last_fault_(last_fault), stage_(motor_of(board_)) {}
  ApplicationOf(const ApplicationOf&) = delete;
  ApplicationOf& operator=(const ApplicationOf&) = delete;

  /// Puts the fencers on guard; the rival, if there is one, is the one of the last start().
  /// @returns kOk | kInvalidArgument: settings out of range (nothing changed: what was started goes
  ///   on)
  Status start(const ApplicationSettings& settings);
  /// The same. @param rival  who it is, in each bout as if it had never fenced before
  Status start(const ApplicationSettings& settings,
               [[maybe_unused]] const typename RivalT::Settings& rival) {
    if constexpr (RivalT::kPlays) {
      if (RivalT::validate(rival) != Status::kOk) return Status::kInvalidArgument;
    }
    const Status status = start(settings);
    if constexpr (RivalT::kPlays) {
      if (status == Status::kOk) (void)this->configure(rival);  // valid
    }
    return status;
  }

  /// The work of one tick. Never blocks; never makes two steps. @pre a start() was kOk
  /// @param tick  number of the board's timer tick, one every step_us, modulo 2^32: numbers that
  ///   are left out are counted as skipped; @pre not the last call's
  /// Bound: FrameReader::kBytesPerTick bytes in, kFramesPerTick frames obeyed, one step,
  /// link::kMaxStepFrames frames out.
  void tick(std::uint32_t tick);

  const haptics::SteppedBout& bout() const { return bout_; }
  const TickReport& ticks() const { return watch_.report(); }
  const ApplicationReport& report() const { return report_; }
  const link::LinkCounters& link() const { return reader_.counters(); }
  std::uint32_t unsent() const { return sender_.refused() + sender_.invalid(); }
  link::Mode mode() const { return mode_; }
  /// 0: alone.
  std::uint32_t session() const { return session_; }
  /// What the force device was told last.
  const ForceCommand& force() const { return stage_.last_command(); }
  /// The own side's way to the motor: counts since the bout began, and what held the force back.
  const haptics::OutputStage& stage() const { return stage_; }
  /// Emergency stop: no force from now on, whatever a host does. May interrupt tick() where the
  /// motor's driver allows it, see OutputStage::stop().
  void stop_force(Microseconds now) { stage_.stop(now); }
  /// Ends it: the force fades in. @returns kOk | kInvalidArgument: not started
  Status release_force() {
    stage_.reset();
    return stage_.enable();
  }
  /// Times that the force was taken back, since start(): no sample, or no step, for too long.
  std::uint32_t silences() const {
    return past_silences_ + bout_.forces().silences() + stage_.report().command_silences;
  }

 private:
  /// What the tick's step is to be made with.
  struct Order {
    bool make = false;
    std::array<bool, 2> has{};
    std::array<InputSample, 2> samples{};

    void keep(fencing::Side side, const InputSample& sample) {
      samples[index_of(side)] = sample;
      has[index_of(side)] = true;
    }
    const InputSample* sample(fencing::Side side) const {
      return has[index_of(side)] ? &samples[index_of(side)] : nullptr;
    }
  };

  /// Where a board has no motor.
  class NoMotor final : public ForceDevice {
    Status do_write(const ForceCommand& /*command*/) override { return Status::kOk; }
  };

  ForceDevice& motor_of(const Board& board) {
    if (board.force != nullptr) return *board.force;
    return no_motor_;
  }
  void listen(Order& order);
  bool obey(const link::Frame& frame, Order& order);
  void open(const link::Hello& hello, Order& order);
  void welcome();
  bool take(const link::Step& step, Order& order);
  void take(const link::StickSample& sample, Order& order);
  void refuse(link::Refusal why, link::MessageType what, std::uint32_t step);
  [[gnu::noinline]] Status restart();  // called from three places
  void prepare();
  void read_stick(Order& order);
  bool step_is_due(const Order& order) const;
  bool make_step(Order& order);
  void wait_after_bout();
  void tell_step(bool repeated);
  void send_report(bool repeated);
  void command_force(bool stepped);

  NoMotor no_motor_;
  Board board_;
  LastFault last_fault_;
  haptics::OutputStage stage_;  ///< by ticks
  ApplicationSettings settings_;
  ApplicationReport report_;
  haptics::SteppedBout bout_;
  FrameReader<link::End::kDevice> reader_;
  link::Sender<kSendBytes> sender_;
  TickWatch watch_;
  std::uint32_t session_ = 0;
  link::Mode mode_ = link::Mode::kFree;
  std::int32_t paused_ = 0;          ///< ticks since the bout was over
  std::uint32_t past_silences_ = 0;  ///< of the bouts before this one
};

/// Without a rival.
using Application = ApplicationOf<>;

}  // namespace batuta::firmware
