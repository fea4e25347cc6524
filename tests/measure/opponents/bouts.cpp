// SPDX-License-Identifier: MIT
#include "bouts.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <thread>

namespace bouts {
namespace {

using namespace batuta;
using namespace batuta::fencing;

constexpr int kTouches = 5;
constexpr int kThreads = 2;
constexpr std::array<Side, 2> kSides = {Side::kLeft, Side::kRight};

double depth(const Capsule<float>& a, const Capsule<float>& b) {
  return std::max(-static_cast<double>(capsule_gap(a, b).gap), 0.0);
}

/// How deep this side's blade is in the other's guard or hand.
double depth_in_weapon(const Duel<>& duel, Side side, const WeaponBody<float>& weapon) {
  const Pose<float> X_WB = chained(duel.held_hand_W(other(side)), weapon.X_HB);
  const Capsule<float> blade = duel.blade_W(side);
  return std::max(depth(blade, to_world(X_WB, weapon.guard_B)),
                  depth(blade, to_world(X_WB, weapon.hand_B)));
}

/// How deep this side's blade is in the other's trunk or head, and in a limb; the weapon hand is
/// with the weapon.
std::array<double, 2> depths_in_body(const Duel<>& duel, Side side) {
  const Capsule<float> blade = duel.blade_W(side);
  const BodyShape<float>& body = duel.body_W(other(side));
  std::array<double, 2> deepest{};
  for (std::size_t i = 0; i < body.size(); ++i) {
    const auto part = static_cast<BodyPart>(i);
    if (part == BodyPart::kWeaponHand) continue;
    double& in = deepest[part <= BodyPart::kHead ? 0 : 1];
    in = std::max(in, depth(blade, body[i]));
  }
  return deepest;
}

/// One bout, and who moves its sticks.
class Match {
 public:
  /// @param swapped  the first player stands on the right
  Match(Player& first, Player& second, bool swapped)
      : duel_(std::make_unique<Duel<>>()),
        players_{swapped ? &second : &first, swapped ? &first : &second},
        swapped_(swapped) {}

  void play(Tally& tally) {
    begin();
    double deepest = 0;
    while (!duel_->bout().is_over() && duel_->steps() < kMostSteps) {  // Bound: kMostSteps
      step(tally);
      for (const Side side : kSides) {
        deepest = std::max(deepest,
                           depth_in_weapon(*duel_, side, fencers_[index_of(other(side))].weapon));
      }
      note_bodies(tally);
    }
    tally.deepest = std::max(tally.deepest, deepest);
    if (deepest > kSeenDepth) ++tally.in_weapon;
    end(tally);
  }

 private:
  static constexpr std::uint32_t kMostSteps = static_cast<std::uint32_t>(kLongest * 1e6) / kStepUs;

  void begin() {
    DuelSettings<> settings = duel_settings();
    settings.touches = kTouches;
    settings.step_us = kStepUs;
    settings.salle.distance = Opponent::kOnGuard;
    if (duel_->configure(settings, fencers_[0], fencers_[1]) == Status::kOk) return;
    std::fprintf(stderr, "batuta-opponents: no duel\n");
    std::exit(2);
  }

  void step(Tally& tally) {
    std::array<InputSample, 2> samples;
    std::array<float, 2> control{};
    for (const Side side : kSides) {
      const std::size_t i = index_of(side);
      samples[i] = players_[i]->sample(observation_of(*duel_, side), duel_->steps());
      control[i] = duel_->grip(side).control();
    }
    const int before = duel_->bout().exchange == exchange_ ? duel_->bout().touches.size() : 0;
    const bool halted = duel_->bout().state == BoutState::kHalt;
    if (duel_->step(&samples[0], &samples[1]) != Status::kOk) std::exit(2);
    if (!halted && duel_->bout().is_corps_a_corps()) ++tally.corps_a_corps;
    exchange_ = duel_->bout().exchange;
    note_touches(before, control, tally);
  }

  void note_bodies(Tally& tally) const {
    bool is_in = false;
    for (const Side side : kSides) {
      const auto [trunk, limb] = depths_in_body(*duel_, side);
      tally.in_trunk = std::max(tally.in_trunk, trunk);
      tally.in_limb = std::max(tally.in_limb, limb);
      is_in = is_in || std::max(trunk, limb) > kPressed;
    }
    ++tally.steps;
    if (is_in) ++tally.steps_in_body;
  }

  /// @param control  of both hands before the step
  void note_touches(int before, const std::array<float, 2>& control, Tally& tally) const {
    const auto& touches = duel_->bout().touches;
    for (int i = before; i < touches.size(); ++i) {
      const std::size_t by = index_of(touches[i].by);
      ++tally.touches[player_at(by)][static_cast<std::size_t>(players_[by]->intent())];
      const float held = std::max(control[by], duel_->grip(touches[i].by).control());
      if (held < duel_settings().least_control) ++tally.out_of_control;
      if (i == 1) ++tally.doubles;
    }
  }

  void end(Tally& tally) const {
    ++tally.bouts;
    tally.seconds += duel_->steps() * 1e-6 * kStepUs;
    if (duel_->bout().is_over()) ++tally.ended;
    const auto& score = duel_->bout().score;
    const int lead = int{score[player_at(0)]} - int{score[player_at(1)]};
    if (lead > 0) ++tally.won;
    if (lead == 0) ++tally.drawn;
  }

  /// Which player stands there; the same the other way round.
  std::size_t player_at(std::size_t side) const { return swapped_ ? 1 - side : side; }

  std::unique_ptr<Duel<>> duel_;
  std::array<Fencer<float>, 2> fencers_ = {first_fencer<float>(), second_fencer<float>()};
  std::array<Player*, 2> players_;  ///< by side
  bool swapped_;
  std::uint32_t exchange_ = 0;
};

}  // namespace

double Tally::kind(Intent intent) const {
  int all = 0;
  int some = 0;
  for (const auto& by : touches) {
    for (const int count : by) all += count;
    some += by[static_cast<std::size_t>(intent)];
  }
  return all > 0 ? 100.0 * some / all : 0;
}

void Tally::add(const Tally& other) {
  bouts += other.bouts;
  won += other.won;
  drawn += other.drawn;
  ended += other.ended;
  for (std::size_t by = 0; by < 2; ++by) {
    for (std::size_t i = 0; i < kIntents; ++i) touches[by][i] += other.touches[by][i];
  }
  doubles += other.doubles;
  corps_a_corps += other.corps_a_corps;
  seconds += other.seconds;
  in_weapon += other.in_weapon;
  deepest = std::max(deepest, other.deepest);
  in_trunk = std::max(in_trunk, other.in_trunk);
  in_limb = std::max(in_limb, other.in_limb);
  steps += other.steps;
  steps_in_body += other.steps_in_body;
  out_of_control += other.out_of_control;
}

Tally play_pairing(const std::string& first, const std::string& second, int bouts,
                   std::uint32_t seed) {
  std::array<Tally, kThreads> tallies;
  const auto play_share = [&](int thread) {
    Tally own;  // threads keep their hands off each other's cache lines
    for (int i = thread; i < bouts; i += kThreads) {
      const auto drawn = seed + static_cast<std::uint32_t>(i) * 7919U;
      Player one(first, drawn);
      Player two(second, drawn ^ 0x5bd1e995U);
      Match(one, two, i % 4 >= 2).play(own);
    }
    tallies[static_cast<std::size_t>(thread)] = own;
  };
  std::thread other(play_share, 1);
  play_share(0);
  other.join();
  tallies[0].add(tallies[1]);
  return tallies[0];
}

}  // namespace bouts
