// SPDX-License-Identifier: MIT
// Bouts between opponents with grips and blades of all kinds: a blade that is pressed, held or
// struck gathers no momentum that no hand gave it.
#include "batuta/fencing/duel.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "batuta/fencing/fencer.hpp"
#include "players.hpp"

namespace bouts {
namespace {

using namespace batuta;
using namespace batuta::fencing;

constexpr std::array<Side, 2> kSides = {Side::kLeft, Side::kRight};
constexpr std::uint32_t kSteps = 20000;  // 20 s
/// 0.77 kg carried at 20 m/s, faster than a stick moves the middle of a blade, and 60 N for 0.4 s,
/// the longest time for which a hand fetches its blade.
constexpr double kMostMomentum = 0.77 * 20 + 60 * 0.4;
/// What turns by more in 1 ms, at 100 rad/s, has jumped.
constexpr double kMostTurn = 0.1;

struct Kind {
  const char* name;
  float restitution;
  bool is_soft;  ///< pressed blades do not meet more often in a step than contacts are answered
  void (*change)(GripSettings<float>&);
  /// False: what the hand regains in half a step, a body that stops the blade makes a jump of
  /// (docs/fencing.md, "Known faults").
  bool is_smooth = true;
};
const std::array<Kind, 6> kKinds = {{
    {"library", 0.3F, true, [](GripSettings<float>&) {}},
    {"no_bounce", 0, false, [](GripSettings<float>&) {}},  // where a body holds one of the two
    {"full_bounce", 1, true, [](GripSettings<float>&) {}},
    {"stiff_wrist", 0.3F, false, [](GripSettings<float>& grip) { grip.largest_turn = 0.01F; }},
    {"linear", 0.3F, false, [](GripSettings<float>& grip) { grip.weight = CatchWeight::kLinear; }},
    {"hasty", 0.3F, true, [](GripSettings<float>& grip) { grip.recover_time = 0.0005F; }, false},
}};

class Grips : public testing::TestWithParam<Kind> {
 protected:
  std::unique_ptr<Duel<>> duel = std::make_unique<Duel<>>();
  std::array<Quat<float>, 2> last;
  std::array<double, 2> lag{};  ///< behind the hand that its stick means: what a grip may regain
  std::uint32_t exchange = 0;

  void begin() {
    DuelSettings<> settings = duel_settings();
    settings.touches = 15;
    settings.step_us = kStepUs;
    settings.salle.distance = Opponent::kOnGuard;
    std::array<Fencer<float>, 2> fencers = {first_fencer<float>(), second_fencer<float>()};
    for (auto& fencer : fencers) {
      fencer.weapon.restitution = GetParam().restitution;
      GetParam().change(fencer.grip);
    }
    ASSERT_EQ(duel->configure(settings, fencers[0], fencers[1]), Status::kOk);
    for (const Side side : kSides) last[index_of(side)] = duel->held_hand_W(side).q_WB;
    exchange = 0;
  }
  double momentum(Side side) const {
    const auto id = duel->world().id_at(static_cast<std::uint16_t>(index_of(side)));
    const auto* blade = duel->world().get(id);
    return blade == nullptr ? 0 : static_cast<double>(blade->body.momentum.linear_W.norm());
  }
  void look() {
    const bool is_same = duel->bout().exchange == exchange;
    exchange = duel->bout().exchange;
    for (const Side side : kSides) {
      const Quat<float> q = duel->held_hand_W(side).q_WB;
      const double turn = log_map<float>(q * last[index_of(side)].conjugate()).norm();
      const double lagged = lag[index_of(side)];
      last[index_of(side)] = q;
      lag[index_of(side)] = log_map<float>(duel->hand(side).X_WH.q_WB * q.conjugate()).norm();
      ASSERT_LE(momentum(side), kMostMomentum) << duel->steps();
      ASSERT_LE(is_same && GetParam().is_smooth ? turn : 0, kMostTurn + lagged) << duel->steps();
    }
    ASSERT_TRUE(!GetParam().is_soft || duel->world().report().complete()) << duel->steps();
  }
  void play(const char* left, const char* right, std::uint32_t seed) {
    begin();
    Player one(left, seed);
    Player two(right, seed ^ 0x5bd1e995U);
    while (!duel->bout().is_over() && duel->steps() < kSteps) {  // Bound: kSteps
      const InputSample l = one.sample(observation_of(*duel, Side::kLeft), duel->steps());
      const InputSample r = two.sample(observation_of(*duel, Side::kRight), duel->steps());
      ASSERT_EQ(duel->step(&l, &r), Status::kOk);
      look();
      if (HasFatalFailure()) return;
    }
  }
};

TEST_P(Grips, NoBladeGathersMomentum) {
  for (std::uint32_t seed = 1; seed <= 8; ++seed) {
    play("master", "club", seed);
    play("novice", "master", seed + 100);
  }
}

INSTANTIATE_TEST_SUITE_P(All, Grips, testing::ValuesIn(kKinds),
                         [](const auto& kind) { return std::string(kind.param.name); });

}  // namespace
}  // namespace bouts
