// SPDX-License-Identifier: MIT
// What must hold of a duel whatever its sticks say and whenever, as a libFuzzer target: blades are
// somewhere, apart, and held by hands that pull no harder than they may; the same samples make the
// same bout, also where it was saved in between, and whatever the clock showed at the start.

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "batuta/fencing/duel_definitions.hpp"
#include "batuta/haptics/duel_hand.hpp"
#include "batuta/record/duel.hpp"
#include "batuta/record/snapshot.hpp"
#include "bytes.hpp"

namespace batuta::fuzz {
using namespace haptics;
using namespace fencing;
namespace {

constexpr int kMostSteps = 400;
constexpr std::array<Side, 2> kSides = {Side::kLeft, Side::kRight};

using Fencing = DuelScene<>;
/// Blades alone, in hands of any strength: nobody is touched, the bout goes on.
constexpr DuelOptions drill_options() {
  DuelOptions scene = two_fencers();
  scene.grip = false;
  scene.targets = false;
  return scene;
}
using Drill = DuelScene<drill_options>;

/// What the devices bring to a step.
using Samples = std::array<std::optional<InputSample>, 2>;

/// Devices that tell the time, tell it again, are late, lose samples, or talk nonsense.
class Devices {
 public:
  Samples draw(Bytes& bytes, Microseconds now) {
    Samples samples;
    const int which = bytes.choice(4);
    for (const Side side : kSides) {
      const auto i = index_of(side);
      if ((which >> i & 1) != 0) samples[i] = last_[i] = next(bytes, last_[i], now);
    }
    return samples;
  }

 private:
  static InputSample next(Bytes& bytes, InputSample sample, Microseconds now) {
    const int how = bytes.choice(8);
    ++sample.sequence;
    sample.x = how == 4 ? static_cast<float>(bytes.choice(3) - 1) : 2 * bytes.share() - 1;
    sample.y = how == 4 ? static_cast<float>(bytes.choice(3) - 1) : 2 * bytes.share() - 1;
    if (how != 5) sample.time = now;
    if (how == 6) {
      sample.time += static_cast<std::uint32_t>(static_cast<std::int16_t>(bytes.word()));
      sample.sequence += bytes.byte();
    }
    if (how == 7) {
      sample.x = bytes.bits();
      sample.y = bytes.bits();
      sample.time = bytes.word() | std::uint32_t{bytes.word()} << 16;
    }
    return sample;
  }

  std::array<InputSample, 2> last_{};
};

/// The same, as devices say it whose clock and counter began elsewhere.
Samples later(Samples samples) {
  for (auto& sample : samples) {
    if (!sample) continue;
    sample->time += 0xFFFF0000U;
    sample->sequence += 0xFFFFFFF0U;
  }
  return samples;
}

template <class SceneT>
DuelSettings<SceneT> draw_settings(Bytes& bytes) {
  constexpr std::array<std::int32_t, 4> kSteps = {1000, 5000, 100, 20000};
  DuelSettings<SceneT> settings = duel_settings<SceneT>();
  settings.step_us = kSteps[static_cast<std::size_t>(bytes.choice(4))];
  if (bytes.flag()) settings.salle.distance += bytes.share() - 0.25F;
  if (bytes.flag()) settings.stick.max_speed *= 0.5F + 8 * bytes.share();
  return settings;
}

struct Fencers {
  Fencer<float> left;
  Fencer<float> right;
};

Fencers draw_fencers(Bytes& bytes) {
  const int which = bytes.choice(4);
  return {(which & 1) != 0 ? second_fencer<float>() : first_fencer<float>(),
          (which & 2) != 0 ? first_fencer<float>() : second_fencer<float>()};
}

template <class SceneT>
Status step(Duel<SceneT>& duel, const Samples& samples) {
  return duel.step(samples[0] ? &*samples[0] : nullptr, samples[1] ? &*samples[1] : nullptr);
}

bool is_unit(const Quat<float>& q) {
  return std::abs(q.coeffs().cast<double>().norm() - 1) <= 4 * kU;
}

template <class SceneT>
float gap_of(const Duel<SceneT>& duel) {
  return capsule_gap(duel.blade_W(Side::kLeft), duel.blade_W(Side::kRight)).gap;
}

template <class SceneT>
void check_side(const Duel<SceneT>& duel, Side side, float max_speed) {
  const StickTracker<float>& stick = duel.stick(side);
  require(stick.position().cwiseAbs().maxCoeff() <= 1, "a stick keeps to its square");
  // A difference of places over a step: each is rounded, and the quotient.
  const float rounded = 4 * kRoundOff<float> * (max_speed + 1 / duel.dt());
  require(stick.velocity().cwiseAbs().maxCoeff() <= max_speed + rounded, "no faster than it may");
  const KeyedPose<float>& hand = duel.hand(side);
  require(is_finite(hand.X_WH.p_W) && is_unit(hand.X_WH.q_WB), "a hand is somewhere");
  require(is_finite(hand.jacobian), "and its rates are numbers");
  const auto& world = duel.world();
  const auto& body = world.get(world.id_at(static_cast<std::uint16_t>(index_of(side))))->body;
  require(is_finite(body.X_WB.p_W) && is_unit(body.X_WB.q_WB), "a blade is somewhere");
  require(is_finite(body.momentum.linear_W) && is_finite(body.momentum.angular_W),
          "and moves in numbers");
}

template <class SceneT>
void check_touches(const Duel<SceneT>& duel) {
  if constexpr (SceneT::kTargets) {
    const auto& touches = duel.bout().touches;
    require((duel.bout().state == BoutState::kFencing) == (touches.size() == 0), "touched or not");
    for (const auto& touch : touches) {
      require(touch.when.step < duel.steps() && touch.when.in_step >= 0, "a touch has a time");
      require(touch.when.in_step <= duel.dt(), "in its step");
      require(touch.place >= 0 && touch.place <= 1 && is_finite(touch.contact.point_W), "a place");
    }
  }
}

/// A duel and what it is to the hands.
template <class SceneT>
struct Bouts {
  DuelSettings<SceneT> settings;
  Fencers fencers;
  Duel<SceneT> duel;
  Duel<SceneT> late;  ///< by another clock
  Duel<SceneT> copy;  ///< restored from a snapshot now and then
  std::array<HandForce<float>, 2> felt;
  bool apart = false;

  void begin() {
    for (auto* one : {&duel, &late, &copy}) {
      require(one->configure(settings, fencers.left, fencers.right) == Status::kOk, "on guard");
    }
    for (auto& hand : felt) require(hand.configure({}) == Status::kOk, "a hand can feel");
    apart = gap_of<SceneT>(duel) > 0;
  }

  void reload() {
    std::vector<std::uint8_t> room(kSnapshotRoom<Duel<SceneT>>);
    const Result<int> size = save(duel, room.data(), static_cast<int>(room.size()));
    require(size.ok(), "a bout can be saved");
    require(restore(copy, room.data(), size.value) == Restored::kOk, "and restored");
  }

  void check_alike() {
    require(hash_of(copy) == hash_of(duel), "the same samples, the same bout");
    for (const Side side : kSides) {
      require(late.stick(side).position() == duel.stick(side).position() &&
                  late.blade_W(side).axis.a == duel.blade_W(side).axis.a &&
                  late.blade_W(side).axis.b == duel.blade_W(side).axis.b,
              "no clock has a zero that counts");
      const StickReport& here = duel.stick(side).report();
      const StickReport& there = late.stick(side).report();
      require(here.used == there.used && here.lost == there.lost &&
                  here.backward == there.backward && here.repeated == there.repeated,
              "nor a counter");
    }
  }

  void check_step() {
    require(duel.report().searches_invalid == 0, "every search can be asked");
    require(!apart || gap_of<SceneT>(duel) > 0, "blades stay apart");
    check_touches<SceneT>(duel);
    require(hand_state(duel, Side::kLeft).blow.linear_W ==
                -hand_state(duel, Side::kRight).blow.linear_W,
            "each hand feels the other's blow");
    for (const Side side : kSides) {
      check_side<SceneT>(duel, side, settings.stick.max_speed);
      HandForce<float>& hand = felt[index_of(side)];
      const Vec2<float> force = hand.advance(hand_state(duel, side), duel.dt());
      require(force.cwiseAbs().maxCoeff() <= hand.transient().max_force(), "no harder than it may");
      require(is_finite(force) && hand.stored() >= 0, "in numbers");
    }
  }

  /// What is over stays as it is, until the next bout.
  void end() {
    const std::uint64_t before = hash_of(duel);
    require(step<SceneT>(duel, {}) == Status::kUnavailable, "what is over is over");
    require(hash_of(duel) == before, "and stays so");
    begin();
  }
};

template <class SceneT>
void check(Bytes bytes) {
  const auto all = std::make_unique<Bouts<SceneT>>();
  Bouts<SceneT>& bouts = *all;
  bouts.settings = draw_settings<SceneT>(bytes);
  bouts.fencers = draw_fencers(bytes);
  bouts.begin();
  Devices devices;
  Microseconds now = 0;
  for (int steps = 0; steps < kMostSteps && bytes.left() > 0;) {
    if (bytes.choice(8) == 7) bouts.reload();
    Samples samples = devices.draw(bytes, now);
    const int most = 1 + bytes.choice(32);
    for (int i = 0; i < most && !bouts.duel.bout().is_over(); ++i, ++steps) {
      require(step<SceneT>(bouts.duel, samples) == Status::kOk, "the bout goes on");
      (void)step<SceneT>(bouts.copy, samples);
      (void)step<SceneT>(bouts.late, later(samples));
      bouts.check_step();
      now += static_cast<Microseconds>(bouts.settings.step_us);
      samples = {};
    }
    bouts.check_alike();
    if (bouts.duel.bout().is_over()) bouts.end();
  }
}

}  // namespace
}  // namespace batuta::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  batuta::fuzz::Bytes bytes(data, size);
  if (bytes.flag()) {
    batuta::fuzz::check<batuta::fuzz::Drill>(bytes);
  } else {
    batuta::fuzz::check<batuta::fuzz::Fencing>(bytes);
  }
  return 0;
}
