// SPDX-License-Identifier: MIT
#include "batuta/record/duel.hpp"
#include "batuta/record/player.hpp"
#include "batuta/record/recorder.hpp"

#include "duel_for_c.hpp"
#include "numbers.hpp"

namespace batuta::fencing {
namespace {

/// Takes what there is room for at the moment.
class TakingSink final : public ByteSink {
 public:
  /// From now on into these bytes.
  void open(std::uint8_t* bytes, std::size_t capacity) {
    bytes_ = bytes;
    left_ = capacity;
  }
  std::size_t left() const { return left_; }

 private:
  int do_write(const std::uint8_t* bytes, int count) override {
    const std::size_t taken = min_of(static_cast<std::size_t>(count), left_);
    if (taken == 0) return 0;
    std::memcpy(bytes_, bytes, taken);
    bytes_ += taken;
    left_ -= taken;
    return static_cast<int>(taken);
  }

  std::uint8_t* bytes_ = nullptr;
  std::size_t left_ = 0;
};

/// Gives the caller's bytes, and more when they come.
class GivenSource final : public ByteSource {
 public:
  void give(const std::uint8_t* bytes, std::size_t count, bool is_all) {
    bytes_ = bytes;
    left_ = count;
    is_all_ = is_all;
  }
  std::size_t left() const { return left_; }
  /// Whether nothing will be given any more.
  bool is_at_end() const { return left_ == 0 && is_all_; }

 private:
  int do_read(std::uint8_t* bytes, int capacity) override {
    if (left_ == 0) return is_all_ ? -1 : 0;
    const std::size_t count = min_of(static_cast<std::size_t>(capacity), left_);
    std::memcpy(bytes, bytes_, count);
    bytes_ += count;
    left_ -= count;
    return static_cast<int>(count);
  }

  const std::uint8_t* bytes_ = nullptr;
  std::size_t left_ = 0;
  bool is_all_ = false;
};

struct RecorderForC {
  static constexpr std::uint32_t kMark = file_id("batuta_recorder");
  static constexpr int kRoom = Recorder::kRoom<Duel<>>;

  std::uint32_t mark = kMark;
  bool has_ended = false;
  std::uint32_t first = 0;  ///< steps of the duel when it began
  TakingSink sink;
  std::array<std::uint8_t, static_cast<std::size_t>(kRoom)> buffer;
  Recorder recorder{sink, buffer.data(), kRoom};

  /// Of the duel that has made the next step to be recorded.
  std::uint32_t next_steps() const { return first + recorder.steps() + recorder.lost() + 1; }
};
static_assert(batuta::detail::holds_closely<RecorderForC, batuta_recorder>(),
              "BATUTA_RECORDER_BYTES, or an alignment");

struct PlayerForC {
  static constexpr std::uint32_t kMark = file_id("batuta_player");
  static constexpr int kRoom = Player::kRoom<Duel<>>;

  std::uint32_t mark = kMark;
  bool has_begun = false;
  bool has_ended = false;
  std::uint32_t first = 0;  ///< steps of the duel when it began
  GivenSource source;
  std::array<std::uint8_t, static_cast<std::size_t>(kRoom)> buffer;
  Player player{source, buffer.data(), kRoom};

  /// What the player answers. Where nothing is given any more it does not wait: what is cut is
  /// said.
  template <class Ask>
  Playback ask(const Ask& ask) {
    Playback playback = ask(player);
    if (playback == Playback::kWaiting && source.is_at_end()) playback = ask(player);
    has_ended = playback != Playback::kReady && playback != Playback::kStep &&
                playback != Playback::kWaiting;
    return playback;
  }
};
static_assert(batuta::detail::holds_closely<PlayerForC, batuta_player>(),
              "BATUTA_PLAYER_BYTES, or an alignment");

constexpr std::int32_t code_of(Playback playback) {
  return static_cast<std::int32_t>(playback);
}
static_assert(code_of(Playback::kReady) == BATUTA_PLAYBACK_READY &&
                  code_of(Playback::kStep) == BATUTA_PLAYBACK_STEP &&
                  code_of(Playback::kEnd) == BATUTA_PLAYBACK_END &&
                  code_of(Playback::kWaiting) == BATUTA_PLAYBACK_WAITING &&
                  code_of(Playback::kParted) == BATUTA_PLAYBACK_PARTED &&
                  code_of(Playback::kGap) == BATUTA_PLAYBACK_GAP &&
                  code_of(Playback::kCut) == BATUTA_PLAYBACK_CUT &&
                  code_of(Playback::kDamaged) == BATUTA_PLAYBACK_DAMAGED &&
                  code_of(Playback::kForeign) == BATUTA_PLAYBACK_FOREIGN &&
                  code_of(Playback::kOtherVersion) == BATUTA_PLAYBACK_OTHER_VERSION &&
                  code_of(Playback::kOtherScalar) == BATUTA_PLAYBACK_OTHER_SCALAR &&
                  code_of(Playback::kOtherScene) == BATUTA_PLAYBACK_OTHER_SCENE &&
                  code_of(Playback::kTooLarge) == BATUTA_PLAYBACK_TOO_LARGE,
              "the answers of batuta/c/duel.h are the library's");

/// What the last step was given.
DuelInput input_of(const haptics::SteppedBout& bout) {
  DuelInput input;
  for (const Side side : {Side::kLeft, Side::kRight}) input.set(side, bout.used(side));  // Bound: 2
  return input;
}

/// The start of a recording goes into a duel; one that is not configured is none.
Playback begin_play(Player& player, DuelForC& played) {
  Playback result{};
  bool is_put = false;
  (void)played.bout.restore({}, [&](Duel<>& state) {
    result = player.begin<DuelInput>(state);
    if (result == Playback::kReady && state.dt() == 0.0F) result = Playback::kDamaged;
    is_put = result == Playback::kReady || result == Playback::kDamaged;
    return is_put;
  });
  played.is_played = played.is_played || is_put;
  return result;
}

Playback play_step(Player& player, haptics::SteppedBout& bout) {
  DuelInput input;
  const Playback result = player.next(input, bout.duel());
  if (result == Playback::kStep) {
    // What the duel says to a step is part of its state, and compared with it.
    static_cast<void>(bout.step(input.at(Side::kLeft), input.at(Side::kRight)));
  }
  return result;
}

}  // namespace
}  // namespace batuta::fencing

using batuta::fencing::DuelForC;
using batuta::fencing::PlayerForC;
using batuta::fencing::RecorderForC;

std::size_t batuta_recorder_size() {
  return sizeof(RecorderForC);
}

std::size_t batuta_recorder_align() {
  return alignof(RecorderForC);
}

std::int32_t batuta_recorder_init(batuta_recorder* recorder, std::size_t bytes,
                                  const batuta_duel* duel, std::uint32_t hash_every) {
  const auto* const seen = batuta::fencing::bout_in(duel);
  const bool good = seen != nullptr && batuta::detail::has_room<RecorderForC>(recorder, bytes);
  if (!good) return BATUTA_INVALID_ARGUMENT;
  RecorderForC& own = *batuta::detail::make_in<RecorderForC>(recorder);
  own.first = seen->bout.steps();
  return batuta::detail::code_of(
      own.recorder.begin<batuta::fencing::DuelInput>(seen->bout.duel(), hash_every));
}

std::int32_t batuta_recorder_step(batuta_recorder* recorder, const batuta_duel* duel) {
  auto* const own = batuta::detail::found_in<RecorderForC>(recorder);
  const auto* const seen = batuta::fencing::bout_in(duel);
  if (own == nullptr || seen == nullptr) return BATUTA_INVALID_ARGUMENT;
  if (own->has_ended) return BATUTA_UNAVAILABLE;
  if (seen->bout.steps() != own->next_steps()) return BATUTA_INVALID_ARGUMENT;
  own->recorder.step(batuta::fencing::input_of(seen->bout), seen->bout.duel());
  return own->recorder.lost() == 0 ? BATUTA_OK : BATUTA_POOL_FULL;
}

std::int32_t batuta_recorder_end(batuta_recorder* recorder, const batuta_duel* duel) {
  auto* const own = batuta::detail::found_in<RecorderForC>(recorder);
  const auto* const seen = batuta::fencing::bout_in(duel);
  if (own == nullptr || seen == nullptr) return BATUTA_INVALID_ARGUMENT;
  if (!own->has_ended && seen->bout.steps() + 1 != own->next_steps())
    return BATUTA_INVALID_ARGUMENT;
  const batuta::Status status = own->recorder.end(seen->bout.duel());
  own->has_ended = own->has_ended || status == batuta::Status::kOk;
  return batuta::detail::code_of(status);
}

std::size_t batuta_recorder_take(batuta_recorder* recorder, std::uint8_t* out,
                                 std::size_t capacity) {
  auto* const own = batuta::detail::found_in<RecorderForC>(recorder);
  if (own == nullptr || out == nullptr) return 0;
  own->sink.open(out, capacity);
  static_cast<void>(own->recorder.flush());
  const std::size_t left = own->sink.left();
  own->sink.open(nullptr, 0);
  return capacity - left;
}

std::size_t batuta_player_size() {
  return sizeof(PlayerForC);
}

std::size_t batuta_player_align() {
  return alignof(PlayerForC);
}

std::int32_t batuta_player_init(batuta_player* player, std::size_t bytes) {
  if (!batuta::detail::has_room<PlayerForC>(player, bytes)) return BATUTA_INVALID_ARGUMENT;
  if (!batuta::rounds_each_operation<float>()) return BATUTA_UNAVAILABLE;
  static_cast<void>(batuta::detail::make_in<PlayerForC>(player));
  return BATUTA_OK;
}

std::int32_t batuta_player_give(batuta_player* player, const std::uint8_t* bytes, std::size_t count,
                                std::int32_t is_all) {
  auto* const own = batuta::detail::found_in<PlayerForC>(player);
  if (own == nullptr || bytes == nullptr) return BATUTA_INVALID_ARGUMENT;
  own->source.give(bytes, count, is_all != 0);
  return BATUTA_OK;
}

std::size_t batuta_player_unread(const batuta_player* player) {
  const auto* const own = batuta::detail::found_in<PlayerForC>(player);
  return own != nullptr ? own->source.left() : 0;
}

std::uint32_t batuta_player_agreed(const batuta_player* player) {
  const auto* const own = batuta::detail::found_in<PlayerForC>(player);
  return own != nullptr ? own->player.agreed() : 0;
}

std::int32_t batuta_player_begin(batuta_player* player, batuta_duel* duel, std::int32_t* playback) {
  using namespace batuta::fencing;
  auto* const own = batuta::detail::found_in<PlayerForC>(player);
  auto* const played = batuta::detail::found_in<DuelForC>(duel);
  if (own == nullptr || played == nullptr || playback == nullptr) return BATUTA_INVALID_ARGUMENT;
  if (own->has_begun) return BATUTA_INVALID_ARGUMENT;
  *playback = code_of(
      own->ask([&](batuta::Player& own_player) { return begin_play(own_player, *played); }));
  own->has_begun = *playback == BATUTA_PLAYBACK_READY;
  own->first = played->bout.steps();
  return BATUTA_OK;
}

std::int32_t batuta_player_next(batuta_player* player, batuta_duel* duel, std::int32_t* playback) {
  using namespace batuta::fencing;
  auto* const own = batuta::detail::found_in<PlayerForC>(player);
  auto* const played = bout_in(duel);
  if (own == nullptr || played == nullptr || playback == nullptr) return BATUTA_INVALID_ARGUMENT;
  if (!own->has_begun) return BATUTA_INVALID_ARGUMENT;
  const bool is_its = played->bout.steps() == own->first + own->player.steps();
  if (!is_its && !own->has_ended) return BATUTA_INVALID_ARGUMENT;
  *playback = code_of(
      own->ask([&](batuta::Player& own_player) { return play_step(own_player, played->bout); }));
  return BATUTA_OK;
}
