// SPDX-License-Identifier: MIT
// What must hold of a world whatever stands in it, as a libFuzzer target: scenes of several types
// are drawn, stepped, pushed, emptied and filled again.

#include <vector>

#include "batuta/core/snapshot.hpp"
#include "batuta/world/archive.hpp"
#include "world_draws.hpp"

namespace batuta::fuzz {
namespace {

constexpr int kMostSteps = 8;
/// Those of the twin that every world has.
constexpr Units kOtherUnits{0x1p5F, 0x1p-3F, 0x1p4F};

/// A world and the bytes that it is made of.
template <class SceneT>
struct Run {
  World<SceneT> world;
  Bytes bytes;
  Units units;

  Run(const Bytes& from, const Units& in) : bytes(from), units(in) {
    require(world.configure(settings_in<SceneT>(units)) == Status::kOk, "any units will do");
    const int bodies = 2 + bytes.choice(SceneT::kMaxBodies - 1);
    for (int i = 0; i < bodies; ++i) add();
  }

  void add() {
    const bool has_room = world.size() < SceneT::kMaxBodies;
    const auto id = world.add(draw_actor<SceneT>(bytes, units));
    require(id.status == (has_room ? Status::kOk : Status::kPoolFull), "there is room or not");
  }

  /// @returns the length of the step to come, s
  float act() {
    const auto id = world.id_at(static_cast<std::uint16_t>(bytes.choice(SceneT::kMaxBodies)));
    switch (bytes.choice(6)) {
      case 0:
        push(world.get(id));
        break;
      case 1:
        require((world.remove(id) == Status::kOk) == (id != Handle<Actor<SceneT>>{}),
                "who is there can be removed");
        break;
      case 2:
        add();
        break;
      default:
        break;
    }
    return std::ldexp(units.time, -1 - bytes.choice(12));
  }

  void push(Actor<SceneT>* actor) {
    const Vec3<float> impulse = units.mass * units.speed() * bytes.vector(Numbers::kGrid);
    if (actor == nullptr) return;
    if constexpr (SceneT::kRotation) {
      actor->body.momentum.p_W += impulse;
    } else {
      actor->body.momentum_W += impulse;
    }
  }
};

template <class SceneT>
Capsule<float> shape_of(const Actor<SceneT>& actor, int part) {
  if constexpr (SceneT::Search::kForSpheres) {
    return Capsule<float>::sphere({0, 0, 0}, actor.radius);
  } else {
    return part_of(actor, part);
  }
}

/// What two bodies may come closer than they should in a step: twice the margin that keeps them
/// apart (src/world/encounter.md), at the speeds that their energy allows.
double margin_of(const Body<float>& A, const Body<float>& B, double reaches, double energy,
                 double dt, double slab) {
  const auto speed = [&](const Body<float>& body) {
    const double v = std::sqrt(2 * energy * static_cast<double>(body.inverse_mass));
    const double w = std::sqrt(2 * energy * static_cast<double>(body.inverse_moments.maxCoeff()));
    return v + w * reaches;
  };
  const double places = A.X_WB.p_W.cast<double>().norm() + B.X_WB.p_W.cast<double>().norm();
  const double L = places + reaches + (speed(A) + speed(B)) * dt;
  const double contact = std::max(slab, static_cast<double>(kLeastSlab<float>)) * L +
                         static_cast<double>(kInflation<float>) * L;
  return 2 * (2 * contact + 64 * kU * (places + L));
}

/// The deepest overlap of two bodies that may meet, less what rounding may make of it, m.
template <class SceneT>
double deepest(const World<SceneT>& world, double energy, double dt) {
  double worst = 0;
  for (int pair = 0; pair < SceneT::kMaxBodies * SceneT::kMaxBodies; ++pair) {
    const auto a = static_cast<std::uint16_t>(pair / SceneT::kMaxBodies);
    const auto b = static_cast<std::uint16_t>(pair % SceneT::kMaxBodies);
    const Actor<SceneT>* const A = world.get(world.id_at(a));
    const Actor<SceneT>* const B = world.get(world.id_at(b));
    if (a >= b || A == nullptr || B == nullptr || !may_meet(*A, *B)) continue;
    if (is_fixed(A->body) && is_fixed(B->body)) continue;
    const double allowed = margin_of(A->body, B->body, reach_of(*A) + reach_of(*B), energy, dt,
                                     static_cast<double>(world.settings().search.slab));
    for (int i = 0; i < parts_of(*A) * parts_of(*B); ++i) {
      const RealPair real({shape_of(*A, i / parts_of(*B)), {A->body.X_WB, {}, 0}},
                          {shape_of(*B, i % parts_of(*B)), {B->body.X_WB, {}, 0}});
      worst = std::max(worst, -real.gap(0) - allowed);
    }
  }
  return worst;
}

template <class SceneT>
void check_events(const World<SceneT>& world, float dt) {
  if constexpr (SceneT::kMaxEvents > 0) {
    for (const auto& event : world.events()) {
      const auto* const A = world.get(world.id_at(event.body_A));
      const auto* const B = world.get(world.id_at(event.body_B));
      require(A != nullptr && B != nullptr && event.body_A < event.body_B, "an event names bodies");
      require(event.part_A < parts_of(*A) && event.part_B < parts_of(*B), "and parts of them");
      require(event.time >= 0 && event.time <= dt, "it happens in the step");
      require(event.kind == EventKind::kEnd || may_meet(*A, *B), "of bodies that may meet");
      require(event.impulse >= 0 && is_finite(event.contact.point_W), "with a place and a force");
      require(event.place_A >= 0 && event.place_A <= 1 && event.place_B >= 0 && event.place_B <= 1,
              "on both axes");
    }
  }
}

/// Nothing pulls: energy does not grow and momentum stays. A blow, and a flight, rounds some tens
/// of times; what a lever's rounding does grows with the sharpness (impulse.md, "Conditioning").
template <class SceneT>
void check_conserved(const World<SceneT>& world, const Load& before) {
  if constexpr (!SceneT::kGravity) {
    const auto& report = world.report();
    const Load after = load_of(world);
    const double blows = 1 + report.collisions + report.separations;
    const double slack = 64 * kU * blows * after.sharpness * std::max(before.soft, after.soft);
    require(after.energy <= before.energy + slack, "energy does not grow");
    bool moves_all = report.complete() && report.frozen == 0 && report.time_held == 0;
    for (std::uint16_t slot = 0; slot < SceneT::kMaxBodies; ++slot) {
      const auto* const actor = world.get(world.id_at(slot));
      moves_all = moves_all && (actor == nullptr || actor->body.inverse_mass > 0);
    }
    if (!moves_all) return;
    const double most = std::max(before.largest, after.largest);
    const double loss = (after.momentum - before.momentum).norm();
    require(loss <= 8 * kU * blows * most, "momentum stays, to 4 ulp of a blow");
  }
}

template <class SceneT>
void step(World<SceneT>& world, float dt) {
  const Load before = load_of(world);
  double deep = 1;
  if constexpr (SceneT::kRotation && !SceneT::kGravity) {
    deep = deepest(world, before.energy, static_cast<double>(dt));
  }
  require(world.step(dt) == Status::kOk, "a step is made");
  check_events(world, dt);
  check_conserved(world, before);
  if constexpr (SceneT::kRotation && !SceneT::kGravity) {
    if (deep > 0) return;
    require(deepest(world, before.energy, static_cast<double>(dt)) <= 0,
            "nobody gets into another");
  }
}

/// A world that was saved goes on as this one.
template <class SceneT>
void check_copy(const World<SceneT>& world, World<SceneT>& copy) {
  std::vector<std::uint8_t> room(kSnapshotRoom<World<SceneT>>);
  const Result<int> size = save(world, room.data(), static_cast<int>(room.size()));
  require(size.ok(), "a world can be saved");
  require(restore(copy, room.data(), size.value) == Restored::kOk, "and restored");
  require(hash_of(copy) == hash_of(world), "to the same state");
}

template <class SceneT>
Vec3<float> place_of(const Actor<SceneT>& actor) {
  if constexpr (SceneT::kRotation) {
    return actor.body.X_WB.p_W;
  } else {
    return actor.body.p_W;
  }
}

template <class SceneT>
void check_twin(const World<SceneT>& world, const World<SceneT>& twin) {
  require(world.report().collisions == twin.report().collisions &&
              world.report().evaluations == twin.report().evaluations,
          "in other units the same happens");
  for (std::uint16_t slot = 0; slot < SceneT::kMaxBodies; ++slot) {
    const Actor<SceneT>* const one = world.get(world.id_at(slot));
    const Actor<SceneT>* const other = twin.get(twin.id_at(slot));
    require((one == nullptr) == (other == nullptr), "to the same bodies");
    if (one == nullptr) continue;
    const Vec3<float> place = kOtherUnits.length * place_of(*one);
    require(place == place_of(*other), "in the same places, to the last bit");
  }
}

template <class SceneT>
void check(const Bytes& bytes) {
  Run<SceneT> run(bytes, Units{});
  Run<SceneT> twin(bytes, kOtherUnits);
  for (int i = 0; i < kMostSteps && run.bytes.left() > 0; ++i) {
    const float dt = run.act();
    World<SceneT> copy;
    check_copy(run.world, copy);
    step(run.world, dt);
    require(copy.step(dt) == Status::kOk && hash_of(copy) == hash_of(run.world),
            "what was restored goes on alike");
    (void)twin.world.step(twin.act());
    check_twin(run.world, twin.world);
  }
}

}  // namespace
}  // namespace batuta::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace batuta;
  fuzz::Bytes bytes(data, size);
  switch (bytes.choice(5)) {
    case 0:
      fuzz::check<fuzz::Rods>(bytes);
      break;
    case 1:
      fuzz::check<fuzz::Heap>(bytes);
      break;
    case 2:
      fuzz::check<fuzz::Sliders>(bytes);
      break;
    case 3:
      fuzz::check<TwoBlades>(bytes);
      break;
    default:
      fuzz::check<StraightSpheres>(bytes);
      break;
  }
  return 0;
}
