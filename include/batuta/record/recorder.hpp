// SPDX-License-Identifier: MIT
#pragma once
// Records a run: the state at its start, what each step was given, and now and then a hash of what
// came of it, so that it can be gone through again, here or on another machine, and seen to be the
// same. The state is anything that record/archive.hpp can save: a World, a Duel, the user's own; so
// is the input of a step. Format: src/record/recorder.md.
//   recorder.begin<DuelInput>(duel, 100);
//   for each step { duel.step(...); recorder.step(input, duel); }
//   recorder.end(duel); then flush() until it is done

#include "batuta/port/byte_stream.hpp"
#include "batuta/record/record.hpp"
#include "batuta/record/snapshot.hpp"

namespace batuta {

/// Waits for no sink: what the sink does not take at once stays in the buffer. A step that does not
/// fit there either ends what can be replayed: it and all that follow are counted, and the end mark
/// says how many. Allocates: never. From one context at a time.
class Recorder {
 public:
  /// A buffer of this size holds the start of a run.
  template <class State>
  static constexpr int kRoom = kSnapshotRoom<State> + detail::kRecordHead + 14 + detail::kCheckSum;

  /// Into a sink that outlives the recorder.
  /// @param buffer  of the caller's, used as long as the recorder is; room for `capacity` bytes
  Recorder(ByteSink& sink, std::uint8_t* buffer, int capacity)
      : sink_(sink), buffer_(buffer), capacity_(capacity) {}
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  /// Starts a recording; whatever is left of an earlier one in the buffer is dropped.
  /// @param hash_every  steps between two hashes; 0: only at the end
  /// @returns kOk | kPoolFull (the buffer; kRoom<State> are enough) | kInvalidArgument (a member
  ///   out of its range)
  template <class Input, class State>
  Status begin(const State& state, std::uint32_t hash_every);

  /// A step is over. Before begin() it does nothing.
  /// @param input  what it was given. @param after  what came of it
  /// Bound: the bytes of the input; where a hash is due, those of the state.
  template <class Input, class State>
  void step(const Input& input, const State& after);

  /// The end mark. @returns kOk | kPoolFull (the buffer is full: flush(), then again) |
  /// kUnavailable (nothing was begun)
  template <class State>
  Status end(const State& state);

  /// Hands over what the sink takes. @returns whether nothing is left
  bool flush();

  /// Steps recorded.
  std::uint32_t steps() const { return steps_; }
  /// Steps that are missing, all at the end. 0 in a healthy run.
  std::uint32_t lost() const { return lost_; }

 private:
  template <class Body>
  bool put(detail::RecordKind kind, Body& body);
  bool make_room(int bytes);
  void close(detail::RecordKind kind, int body);
  void start(int bytes);

  ByteSink& sink_;
  std::uint8_t* buffer_;
  int capacity_;
  int filled_ = 0;
  std::uint32_t steps_ = 0;
  std::uint32_t lost_ = 0;
  std::uint32_t hash_every_ = 0;
  bool going_on_ = false;
};

/// The body is written where it is to stay; what does not fit leaves the buffer as it was.
template <class Body>
bool Recorder::put(detail::RecordKind kind, Body& body) {
  if (!make_room(detail::kRecordHead + detail::kCheckSum)) return false;
  const int room = capacity_ - filled_ - detail::kRecordHead - detail::kCheckSum;
  ArchiveWriter writer(buffer_ + filled_ + detail::kRecordHead, min_of(room, detail::kLargestBody));
  writer.look_at(body);
  if (!writer.ok()) return false;
  close(kind, writer.position());
  return true;
}

template <class Input, class State>
Status Recorder::begin(const State& state, std::uint32_t hash_every) {
  going_on_ = false;
  filled_ = 0;
  const Result<int> saved = save(state, buffer_, capacity_);
  if (!saved.ok()) return saved.status;
  start(saved.value);
  detail::RunRecord run;
  run.hash_every = hash_every;
  const Input input{};
  run.input = fingerprint_of(input);
  going_on_ = put(detail::RecordKind::kRun, run);
  hash_every_ = hash_every;
  return going_on_ ? Status::kOk : Status::kPoolFull;
}

template <class Input, class State>
void Recorder::step(const Input& input, const State& after) {
  if (!going_on_) return;
  detail::StepRecord<const Input> body{steps_, input};
  if (lost_ > 0 || !put(detail::RecordKind::kStep, body)) {
    ++lost_;
    return;
  }
  ++steps_;
  if (hash_every_ == 0 || steps_ % hash_every_ != 0) return;
  detail::HashRecord hash{steps_, hash_of(after)};
  (void)put(detail::RecordKind::kHash, hash);  // a hash less is no gap: the next one tells as much
}

template <class State>
Status Recorder::end(const State& state) {
  if (!going_on_) return Status::kUnavailable;
  detail::EndRecord body{{steps_, lost_ == 0 ? hash_of(state) : 0}, lost_};
  if (!put(detail::RecordKind::kEnd, body)) return Status::kPoolFull;
  going_on_ = false;
  return Status::kOk;
}

}  // namespace batuta
