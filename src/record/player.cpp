// SPDX-License-Identifier: MIT
#include "batuta/record/player.hpp"

namespace batuta {
namespace {

Playback playback_of(Restored restored) {
  switch (restored) {
    case Restored::kOk:
      return Playback::kReady;
    case Restored::kForeign:
      return Playback::kForeign;
    case Restored::kOtherVersion:
      return Playback::kOtherVersion;
    case Restored::kOtherScalar:
      return Playback::kOtherScalar;
    case Restored::kOtherScene:
      return Playback::kOtherScene;
    case Restored::kDamaged:
    case Restored::kOutOfRange:
      break;
  }
  return Playback::kDamaged;
}

}  // namespace

Playback Player::stop(Playback end) {
  stage_ = Stage::kOver;
  end_ = end;
  return end;
}

// What fetch() was asked for: nothing ever stands behind it.
void Player::drop() {
  filled_ = 0;
}

// One read of the source a call: it answers, or gives nothing, or is at its end.
Playback Player::fetch(int bytes) {
  if (filled_ >= bytes) return Playback::kReady;
  if (bytes > capacity_) return stop(Playback::kTooLarge);
  const int count = source_.read(buffer_ + filled_, bytes - filled_);
  if (count < 0) return stop(Playback::kCut);
  filled_ += count;
  return filled_ >= bytes ? Playback::kReady : Playback::kWaiting;
}

Playback Player::fetch_record() {
  Playback fetched = fetch(detail::kRecordHead);
  if (fetched != Playback::kReady) return fetched;
  const int size = detail::kRecordHead + body_size() + detail::kCheckSum;
  fetched = fetch(size);
  if (fetched != Playback::kReady) return fetched;
  return detail::is_sealed(buffer_, size) ? Playback::kReady : stop(Playback::kDamaged);
}

Playback Player::fetch_state(detail::SnapshotHead& head) {
  const Playback fetched = fetch(detail::kSnapshotHead);
  if (fetched != Playback::kReady) return fetched;
  const Playback known = playback_of(detail::read_head(buffer_, filled_, head));
  if (known != Playback::kForeign) state_version_ = head.version;
  if (known == Playback::kOtherScene) {
    stage_ = Stage::kOtherState;
    passing_ = std::uint64_t{head.length} + detail::kCheckSum;
    drop();
    return pass_other_state();
  }
  if (known != Playback::kReady) return stop(known);
  const int room = capacity_ - detail::kSnapshotHead - detail::kCheckSum;
  if (room < 0 || head.length > static_cast<std::uint32_t>(room)) return stop(Playback::kTooLarge);
  return fetch(detail::kSnapshotHead + static_cast<int>(head.length) + detail::kCheckSum);
}

// What follows tells whether a state is of another type because the recording is of another
// version.
Playback Player::pass_other_state() {
  while (passing_ > 0) {  // Bound: the bytes of the state
    const auto room = static_cast<std::uint64_t>(capacity_);
    const int count = static_cast<int>(passing_ < room ? passing_ : room);
    const Playback fetched = fetch(count);
    if (fetched != Playback::kReady) return end_of_other(fetched);
    drop();
    passing_ -= static_cast<std::uint64_t>(count);
  }
  const Playback fetched = fetch_record();
  if (fetched != Playback::kReady) return end_of_other(fetched);
  detail::RunRecord run;
  const bool good = kind() == detail::RecordKind::kRun && take(run);
  if (good) version_ = run.version;
  const bool other = good && run.version != detail::kRecordingVersion;
  return stop(other ? Playback::kOtherVersion : Playback::kOtherScene);
}

// Whatever is wrong there, the state was of another type.
Playback Player::end_of_other(Playback fetched) {
  return fetched == Playback::kWaiting ? fetched : stop(Playback::kOtherScene);
}

Playback Player::read_run(std::uint64_t input) {
  const Playback fetched = fetch_record();
  if (fetched != Playback::kReady) return fetched;
  detail::RunRecord run;
  const bool good = kind() == detail::RecordKind::kRun && take(run);
  if (!good) return stop(Playback::kDamaged);
  version_ = run.version;
  if (run.version != detail::kRecordingVersion) return stop(Playback::kOtherVersion);
  if (run.input != input) return stop(Playback::kOtherScene);
  stage_ = Stage::kSteps;
  end_ = Playback::kReady;
  return Playback::kReady;
}

Playback Player::compare(const detail::HashRecord& record, std::uint64_t hash) {
  if (record.steps != steps_ || compared_) return stop(Playback::kDamaged);
  if (record.hash != hash) return stop(Playback::kParted);
  compared_ = true;
  ++agreed_;
  return Playback::kReady;
}

}  // namespace batuta
