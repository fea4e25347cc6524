// SPDX-License-Identifier: MIT
#include "batuta/fencing/opponent.hpp"

#include "duel_for_c.hpp"
#include "numbers.hpp"

namespace batuta::fencing {
namespace {

struct OpponentForC {
  static constexpr std::uint32_t kMark = file_id("batuta_opponent");

  std::uint32_t mark = kMark;
  Opponent opponent;
};
static_assert(batuta::detail::holds_closely<OpponentForC, batuta_opponent>(),
              "BATUTA_OPPONENT_BYTES, or an alignment");

static_assert(static_cast<int>(Skill::kNovice) == BATUTA_NOVICE &&
                  static_cast<int>(Skill::kClub) == BATUTA_CLUB &&
                  static_cast<int>(Skill::kMaster) == BATUTA_MASTER,
              "the skills of batuta/c/duel.h are the library's");

}  // namespace
}  // namespace batuta::fencing

using batuta::fencing::OpponentForC;

std::size_t batuta_opponent_size() {
  return sizeof(OpponentForC);
}

std::size_t batuta_opponent_align() {
  return alignof(OpponentForC);
}

std::int32_t batuta_opponent_init(batuta_opponent* opponent, std::size_t bytes, std::int32_t skill,
                                  std::uint32_t seed) {
  const bool good = batuta::detail::has_room<OpponentForC>(opponent, bytes) &&
                    skill >= BATUTA_NOVICE && skill <= BATUTA_MASTER;
  if (!good) return BATUTA_INVALID_ARGUMENT;
  if (!batuta::rounds_each_operation<float>()) return BATUTA_UNAVAILABLE;
  OpponentForC& own = *batuta::detail::make_in<OpponentForC>(opponent);
  return batuta::detail::code_of(
      own.opponent.configure(static_cast<batuta::fencing::Skill>(skill), seed));
}

std::int32_t batuta_opponent_look(batuta_opponent* opponent, const batuta_duel* duel,
                                  std::int32_t side, batuta_stick* out) {
  using namespace batuta::fencing;
  auto* const own = batuta::detail::found_in<OpponentForC>(opponent);
  const auto* const seen = bout_in(duel);
  const bool good = own != nullptr && seen != nullptr && out != nullptr && is_side(side);
  if (!good) return BATUTA_INVALID_ARGUMENT;
  const Duel<>& bout = seen->bout.duel();
  const Side own_side = side == BATUTA_LEFT ? Side::kLeft : Side::kRight;
  const StickPlace& place = own->opponent.step(observation_of(bout, own_side), step_us_of(bout));
  *out = {place.blade.x(), place.blade.y(), 0, place.feet};
  return BATUTA_OK;
}
