// SPDX-License-Identifier: MIT
#pragma once
// Goes through a recording again, and says whether the same came of it, to the last bit.
//   if (player.begin<DuelInput>(duel) != Playback::kReady) ...
//   while ((answer = player.next(input, duel)) == Playback::kStep) duel.step(...)

#include "batuta/port/byte_stream.hpp"
#include "batuta/record/record.hpp"
#include "batuta/record/snapshot.hpp"

namespace batuta {

/// How the playing of a recording goes on, or ended.
enum class [[nodiscard]] Playback : std::uint8_t{
    kReady,    ///< begin(): the state is that of the start
    kStep,     ///< next(): make this step
    kEnd,      ///< all steps are made, and every hash agreed
    kWaiting,  ///< for more bytes of the source: call again
    // What follows is the end as well, and the answer from then on.
    kParted,        ///< the state after steps() steps is another than the recorded one
    kGap,           ///< steps are missing from here on: the recorder's sink was too slow
    kCut,           ///< the source ended before the end mark
    kDamaged,       ///< a check sum, a number or an order is wrong
    kForeign,       ///< no recording
    kOtherVersion,  ///< of the format of state or recording
    kOtherScalar,   ///< float here and double there
    kOtherScene,    ///< members, capacities or constants of state or input are others
    kTooLarge,      ///< a record is larger than the buffer
};

/// Nothing of the source is believed. Allocates: never. From one context at a time.
class Player {
 public:
  /// A buffer of this size takes the start of a run, and inputs of 11 bytes less: number and check
  /// sum go with them.
  template <class State>
  static constexpr int kRoom = kSnapshotRoom<State>;

  /// From a source that outlives the player.
  /// @param buffer  of the caller's, used as long as the player is; room for `capacity` bytes
  Player(ByteSource& source, std::uint8_t* buffer, int capacity)
      : source_(source), buffer_(buffer), capacity_(capacity) {}
  Player(const Player&) = delete;
  Player& operator=(const Player&) = delete;

  /// Reads the state at the start, and then what comes behind it: call it with one state until it
  /// answers something else than kWaiting. @returns kReady | kWaiting | one of the ends. The state
  /// is that of the start as soon as that was read, whatever the answer; it was not changed where
  /// the answer is kForeign, or speaks of the state itself but for kOutOfRange of restore(), which
  /// is kDamaged here
  template <class Input, class State>
  Playback begin(State& state);

  /// What the next step is given.
  /// @param state  after the last step; compared where the recording says what it was
  /// @returns kStep | kEnd | kWaiting | one of the other ends
  /// Bound: two records.
  template <class Input, class State>
  Playback next(Input& input, const State& state);

  /// Steps given out by next() so far.
  std::uint32_t steps() const { return steps_; }
  /// Hashes that agreed so far.
  std::uint32_t agreed() const { return agreed_; }
  /// Of the recording's format, once begin() has answered kReady, kOtherVersion or kOtherScene; 0:
  /// it could not be read.
  int version() const { return version_; }
  /// Of the format of the state at the start, once begin() has answered; 0: it could not be read.
  int state_version() const { return state_version_; }
  /// Steps of which the end mark says that they are missing.
  std::uint32_t lost() const { return lost_; }

 private:
  enum class Stage : std::uint8_t { kState, kOtherState, kRun, kSteps, kOver };

  Playback stop(Playback end);
  /// Sees to it that the buffer holds `bytes` bytes. @returns kReady | kWaiting | kCut | kTooLarge
  Playback fetch(int bytes);
  /// The same for the next record, whose check sum is then good.
  Playback fetch_record();
  Playback fetch_state(detail::SnapshotHead& head);
  Playback pass_other_state();
  Playback end_of_other(Playback fetched);
  void drop();
  detail::RecordKind kind() const { return static_cast<detail::RecordKind>(buffer_[0]); }
  int body_size() const { return buffer_[1] | buffer_[2] << 8; }
  /// Reads and drops the record. @returns whether its body is one of this type
  template <class Body>
  bool take(Body& body);
  Playback read_run(std::uint64_t input);
  Playback compare(const detail::HashRecord& record, std::uint64_t hash);
  template <class State>
  Playback judge(const State& state);

  ByteSource& source_;
  std::uint8_t* buffer_;
  int capacity_;
  int filled_ = 0;
  std::uint32_t steps_ = 0;
  std::uint32_t agreed_ = 0;
  std::uint32_t lost_ = 0;
  std::uint64_t passing_ = 0;  ///< bytes of a state of another type that are still to come
  std::uint16_t version_ = 0;
  std::uint16_t state_version_ = 0;
  Playback end_ = Playback::kWaiting;
  Stage stage_ = Stage::kState;
  bool compared_ = false;  ///< the state after steps() steps
};

template <class Body>
bool Player::take(Body& body) {
  const int size = body_size();
  ArchiveReader reader(buffer_ + detail::kRecordHead, size);
  reader(body);
  drop();
  return reader.is_done(size);
}

template <class Input, class State>
Playback Player::begin(State& state) {
  if (stage_ == Stage::kOtherState) return pass_other_state();
  if (stage_ == Stage::kState) {
    detail::SnapshotHead head = detail::head_for(state);
    const Playback fetched = fetch_state(head);
    if (fetched != Playback::kReady) return fetched;
    const int size = detail::kSnapshotHead + static_cast<int>(head.length) + detail::kCheckSum;
    if (restore(state, buffer_, size) != Restored::kOk) return stop(Playback::kDamaged);
    drop();
    stage_ = Stage::kRun;
  }
  const Input input{};
  return stage_ == Stage::kRun ? read_run(fingerprint_of(input)) : end_;
}

/// A hash or the end mark. @returns kReady: there is more
template <class State>
Playback Player::judge(const State& state) {
  if (kind() == detail::RecordKind::kHash) {
    detail::HashRecord record;
    if (!take(record)) return stop(Playback::kDamaged);
    return compare(record, hash_of(state));
  }
  detail::EndRecord record;
  if (kind() != detail::RecordKind::kEnd || !take(record)) return stop(Playback::kDamaged);
  lost_ = record.lost;
  if (lost_ > 0) return stop(Playback::kGap);
  compared_ = false;  // the end mark may repeat what a hash has said
  const Playback compared = compare(record.last, hash_of(state));
  return stop(compared == Playback::kReady ? Playback::kEnd : compared);
}

template <class Input, class State>
Playback Player::next(Input& input, const State& state) {
  if (stage_ != Stage::kSteps) return end_;
  for (int i = 0; i < 2; ++i) {  // Bound: 2: a hash, and what follows it
    const Playback fetched = fetch_record();
    if (fetched != Playback::kReady) return fetched;
    if (kind() == detail::RecordKind::kStep) {
      detail::StepRecord<Input> record{0, input};
      const bool good = take(record) && record.step == steps_;
      if (!good) return stop(Playback::kDamaged);
      ++steps_;
      compared_ = false;
      return Playback::kStep;
    }
    const Playback judged = judge(state);
    if (judged != Playback::kReady) return judged;
  }
  return stop(Playback::kDamaged);
}

}  // namespace batuta
