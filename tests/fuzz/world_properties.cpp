// SPDX-License-Identifier: MIT
// What must hold of a world whatever stands in it, as a libFuzzer target: scenes of several types
// are drawn, stepped, pushed, emptied and filled again.

#include <algorithm>
#include <vector>

#include "batuta/record/snapshot.hpp"
#include "batuta/record/world.hpp"
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
      actor->body.momentum.linear_W += impulse;
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

/// A body as it flies while nothing happens to it and it does not turn.
Motion<float> flight_of(const Body<float>& body, float dt) {
  return {body.X_WB, {body.inverse_mass * body.momentum.linear_W, Vec3<float>(0, 0, 0)}, dt};
}
Motion<float> flight_of(const StraightBody<float>& body, float dt) {
  const Pose<float> X_WB = {body.p_W, Quat<float>::Identity()};
  return {X_WB, {body.inverse_mass * body.momentum_W, Vec3<float>(0, 0, 0)}, dt};
}
double sharpest(const Body<float>& body) {
  return static_cast<double>(body.inverse_moments.maxCoeff());
}
double sharpest(const StraightBody<float>& /*body*/) {
  return 0;
}
bool turns(const Body<float>& body) {
  return !body.momentum.angular_W.isZero(0);
}
bool turns(const StraightBody<float>& /*body*/) {
  return false;
}

template <class BodyT>
bool stays(const BodyT& body) {
  return body.inverse_mass == 0 && sharpest(body) == 0;
}

/// What two bodies may come closer than they should in a step: twice the margin that keeps them
/// apart (src/world/detail/margin.md), at the speeds that their energy allows.
template <class BodyT>
double margin_of(const BodyT& A, const BodyT& B, double reaches, double energy, double dt,
                 double contact_tolerance) {
  const auto speed = [&](const BodyT& body) {
    const double v = std::sqrt(2 * energy * static_cast<double>(body.inverse_mass));
    return v + std::sqrt(2 * energy * sharpest(body)) * reaches;
  };
  const double places = flight_of(A, 0).X_WB.p_W.template cast<double>().norm() +
                        flight_of(B, 0).X_WB.p_W.template cast<double>().norm();
  const double L = places + reaches + (speed(A) + speed(B)) * dt;
  const double contact =
      std::max(contact_tolerance, static_cast<double>(detail::kLeastContactTolerance<float>)) * L +
      static_cast<double>(detail::kInflation<float>) * L;
  return 2 * (2 * contact + 64 * kU * (places + L));
}

/// Two parts of bodies that may meet, and how deep they may be in each other for rounding alone, m.
struct Meeting {
  RealPair real;
  double allowed;
  bool turns;
};

/// All that may happen in a step.
template <class SceneT>
std::vector<Meeting> meetings_of(const World<SceneT>& world, double energy, float dt) {
  std::vector<Meeting> meetings;
  double contact_tolerance = 0;
  if constexpr (SceneT::Search::kHasContactTolerance)
    contact_tolerance = static_cast<double>(world.settings().search.contact_tolerance);
  for (int pair = 0; pair < SceneT::kMaxBodies * SceneT::kMaxBodies; ++pair) {
    const auto a = static_cast<std::uint16_t>(pair / SceneT::kMaxBodies);
    const auto b = static_cast<std::uint16_t>(pair % SceneT::kMaxBodies);
    const Actor<SceneT>* const A = world.get(world.id_at(a));
    const Actor<SceneT>* const B = world.get(world.id_at(b));
    if (a >= b || A == nullptr || B == nullptr || !detail::may_meet(*A, *B)) continue;
    if (stays(A->body) && stays(B->body)) continue;
    const double allowed =
        margin_of(A->body, B->body, bounding_radius_of(*A) + bounding_radius_of(*B), energy,
                  static_cast<double>(dt), contact_tolerance);
    for (int i = 0; i < parts_of(*A) * parts_of(*B); ++i) {
      const RealPair real({shape_of(*A, i / parts_of(*B)), flight_of(A->body, dt)},
                          {shape_of(*B, i % parts_of(*B)), flight_of(B->body, dt)});
      meetings.push_back({real, allowed, turns(A->body) || turns(B->body)});
    }
  }
  return meetings;
}

bool all_apart(const std::vector<Meeting>& meetings) {
  return std::all_of(meetings.begin(), meetings.end(), [](const Meeting& meeting) {
    return meeting.real.gap(0) >= -meeting.allowed;
  });
}

/// Nothing happened: then nobody has flown through anybody.
void check_passages(const std::vector<Meeting>& meetings, float dt) {
  for (const Meeting& meeting : meetings) {
    require(meeting.turns || meeting.real.least_gap(static_cast<double>(dt)) >= -meeting.allowed,
            "nobody flies through another");
  }
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
      require(event.kind == EventKind::kEnd || detail::may_meet(*A, *B), "of bodies that may meet");
      require(event.impulse >= 0 && is_finite(event.contact.point_W), "with a place and a force");
      require(event.place_A >= 0 && event.place_A <= 1 && event.place_B >= 0 && event.place_B <= 1,
              "on both axes");
    }
  }
}

template <class ReportT>
bool moves_all(const ReportT& report) {
  return report.complete() && report.frozen == 0 && report.time_held == 0;
}
/// Who is told to be in another at the start may be so thin that nothing of it is left to search
/// for (src/world/detail/margin.md): such a pair may go on through each other.
template <class ReportT>
bool is_free(const ReportT& report) {
  return moves_all(report) && report.overlaps_at_start == 0 &&
         report.collisions + report.separations == 0;
}

/// Nothing pulls: energy does not grow and momentum stays, also about the origin where nobody was
/// moved apart but by the margin after a blow; where all bounce back and nobody rubs, energy stays.
/// A blow, and a flight, rounds some tens of times; what a lever's rounding does grows with the
/// sharpness (impulse.md, "Conditioning").
template <class SceneT>
void check_conserved(const World<SceneT>& world, const Load& before, float dt, double margin) {
  if constexpr (!SceneT::kGravity) {
    const auto& report = world.report();
    const Load after = load_of(world);
    const double blows = 1 + report.collisions + report.separations;
    const double slack = 64 * kU * blows * after.sharpness * std::max(before.soft, after.soft);
    require(after.energy <= before.energy + slack, "energy does not grow");
    if (!moves_all(report)) return;
    // Where contacts last, a light body that comes back at once to one that struck it does not
    // bounce once more.
    constexpr bool kLasts = SceneT::kResting == RestingContact::kSettling;
    if (before.lossless && report.separations == 0 && !kLasts) {
      require(after.energy >= before.energy - slack, "what bounces loses no energy");
    }
    if (after.fixed > 0) return;
    const double most = std::max(before.largest, after.largest);
    const double loss = (after.momentum - before.momentum).norm();
    require(loss <= 8 * kU * blows * most, "momentum stays, to 4 ulp of a blow");
    if (!SceneT::kRotation || report.separations > 0) return;
    // The way of the fastest is in the arm; a blow is at most the sum of two momenta.
    const double arm = std::max(before.arm, after.arm) + before.fastest() * static_cast<double>(dt);
    const double turning = 2 * most * arm + std::max(before.turning, after.turning);
    // Where contacts last, what opens gaps shifts each body by 64 D at most, and as far as two are
    // in each other (world.md, "Opening").
    double opened = 0;
    if constexpr (SceneT::kResting == RestingContact::kSettling) {
      const double D = std::max(2 * margin, static_cast<double>(world.settings().separation));
      opened = SceneT::kMaxBodies * (64 * D + static_cast<double>(report.deepest_overlap)) * most;
    }
    const double turned = blows * (16 * kU * turning + margin * most);
    require((after.angular - before.angular).norm() <= turned + opened, "so does its moment");
  }
}

template <class SceneT>
void step(World<SceneT>& world, float dt) {
  const Load before = load_of(world);
  std::vector<Meeting> meetings;
  if constexpr (!SceneT::kGravity) meetings = meetings_of(world, before.energy, dt);
  require(world.step(dt) == Status::kOk, "a step is made");
  check_events(world, dt);
  double margin = 0;  // twice the widest
  for (const Meeting& meeting : meetings) margin = std::max(margin, meeting.allowed);
  check_conserved(world, before, dt, margin);
  if (SceneT::kGravity || !all_apart(meetings)) return;
  if (is_free(world.report())) check_passages(meetings, dt);
  require(all_apart(meetings_of(world, before.energy, dt)), "nobody gets into another");
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

/// Squares of what is below 2^-63 vanish in one system of units and not in the other: with the root
/// of the sharpest yield, 2^12, at a lever of 2^3 and for 2^2 units of time, m.
constexpr float kVanishing = 0x1p-46F;

/// Whether somebody who does not turn has a momentum of which the square vanishes: what a blow
/// takes of it vanishes in one system of units and not in the other.
template <class SceneT>
bool has_vanishing(const World<SceneT>& world) {
  constexpr float kLeast = 0x1p-63F;
  bool has = false;
  if constexpr (!SceneT::kRotation) {
    for (std::uint16_t slot = 0; slot < SceneT::kMaxBodies; ++slot) {
      const Actor<SceneT>* const actor = world.get(world.id_at(slot));
      for (int i = 0; actor != nullptr && i < 3; ++i) {
        const float p = std::abs(actor->body.momentum_W[i]);
        has = has || (p > 0 && p < kLeast);
      }
    }
  }
  return has;
}

template <class SceneT>
std::uint32_t asleep_in(const World<SceneT>& world) {
  if constexpr (SceneT::kSleep) return world.report().asleep;
  return 0;
}

/// @returns whether the twin is the same in every bit
template <class SceneT>
bool is_twin(const World<SceneT>& world, const World<SceneT>& twin) {
  const bool same_cost = world.report().evaluations == twin.report().evaluations;
  // A normal that vanishes in one of them leads to other searches, and to other nearest points
  // where axes are parallel: from there on each is a world of its own.
  if (SceneT::kRotation && !same_cost) return false;
  if (has_vanishing(world) || has_vanishing(twin)) return false;
  // The time until somebody sleeps is the scene's own, in seconds, whatever the units are.
  if (asleep_in(world) + asleep_in(twin) > 0) return false;
  // Open: where bodies jam, a blow was answered 23 times here and 20 times there, once. From there
  // on each is a world of its own.
  if (world.report().frozen > 0 && twin.report().frozen > 0) return false;
  require(same_cost && world.report().collisions == twin.report().collisions,
          "in other units the same happens");
  bool same = true;
  for (std::uint16_t slot = 0; slot < SceneT::kMaxBodies; ++slot) {
    const Actor<SceneT>* const one = world.get(world.id_at(slot));
    const Actor<SceneT>* const other = twin.get(twin.id_at(slot));
    require((one == nullptr) == (other == nullptr), "to the same bodies");
    if (one == nullptr) continue;
    const Vec3<float> off = place_of(*one) - place_of(*other) / kOtherUnits.length;
    require(off.cwiseAbs().maxCoeff() <= kVanishing, "in the same places, to the last bit");
    same = same && off.isZero(0);
  }
  return same;
}

template <class SceneT>
void check(const Bytes& bytes) {
  Run<SceneT> run(bytes, Units{});
  Run<SceneT> twin(bytes, kOtherUnits);
  bool same = true;
  for (int i = 0; i < kMostSteps && run.bytes.left() > 0; ++i) {
    const float dt = run.act();
    World<SceneT> copy;
    check_copy(run.world, copy);
    step(run.world, dt);
    require(copy.step(dt) == Status::kOk && hash_of(copy) == hash_of(run.world),
            "what was restored goes on alike");
    if (!same) continue;
    (void)twin.world.step(twin.act());
    same = is_twin(run.world, twin.world);
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
