// SPDX-License-Identifier: MIT
#pragma once
// Random scenes: 1 to 40 bodies, single or compound, fixed, led or free, apart, touching, piled up
// or jammed, of any mass, with much room or with hardly any.

#include <memory>
#include <type_traits>

#include "batuta/mechanics/compound.hpp"
#include "batuta/world/any_controller.hpp"
#include "choices.hpp"
#include "random_kinds.hpp"
#include "seen_world.hpp"

namespace batuta::test {

template <const RandomKind& kKind>
constexpr SceneOptions random_options() {
  SceneOptions scene;
  const bool settles = kKind.resting == RestingContact::kSettling;
  scene.max_bodies = kKind.bodies;
  scene.capsules_per_body = kKind.parts;
  scene.resting = kKind.resting;
  scene.gravity = kKind.gravity;
  scene.sleep = kKind.sleep;
  scene.rotation = kKind.turns;
  scene.max_events = kKind.is_tight ? 16 : 2048;
  scene.max_contacts = kKind.is_tight ? 3 : 1024;
  if (kKind.is_small) {
    scene.engine = Engine::kSmall;
    scene.max_events = 0;
    return scene;
  }
  const int all = kKind.bodies * kKind.parts * (kKind.bodies * kKind.parts - 1) / 2;
  scene.max_pairs = kKind.is_tight ? kKind.bodies / 2 : all;
  if (kKind.is_tight) scene.budget = 4;
  if (!kKind.turns) return scene;
  if (settles) scene.max_separations = kKind.is_tight ? 1 : 8;
  scene.friction = kKind.resting != RestingContact::kSeparation;
  scene.line_contact = settles;
  scene.rolling_resistance = settles && kKind.sleep;
  return scene;
}

template <class S, bool kIsLed>
using RandomController =
    std::conditional_t<kIsLed, AnyController<S, FreeFlight<S>, Hand<S>, Fixed<S>>, FreeFlight<S>>;
template <class S, const RandomKind& kKind>
using RandomSearch =
    std::conditional_t<kKind.is_small, Spheres<S>,
                       std::conditional_t<kKind.turns, Advancement<S>, Translation<S>>>;
template <class S, const RandomKind& kKind>
using RandomScene =
    Scene<random_options<kKind>, RandomSearch<S, kKind>, RandomController<S, kKind.is_led>>;

/// How bodies stand at the start.
enum class Arrangement { kApart, kRow, kLayers, kJammed, kFork, kCount };

/// A scene of one type, drawn; and what a step of it needs to be told.
template <class SceneT>
class RandomRun {
 public:
  using S = typename SceneT::Scalar;
  using WorldT = World<SceneT>;
  using Vector = Vec3<double>;

  /// @param drift_W  added to the velocity of all that nothing holds
  explicit RandomRun(Choices choices, const Vector& drift_W = Vector::Zero())
      : choices_(choices), drift_W_(drift_W) {
    scale_ = std::pow(10.0, -choices_.of(3));
    dt_ = kSteps[choices_.of(6)];
    origin_W_ = choices_.chance(4) ? Vector(20, -10, 5) : Vector(0, 0, 0);
    settle_settings();
    light_ = choices_.chance(2) ? 3 : choices_.of(3);
    is_closed_ = choices_.of(2) == 0;
    const double speeds[] = {0, 0.01, 0.3, 3, 30};
    speed_ = speeds[choices_.of(5)] * scale_;
    spin_ = choices_.chance(3) ? 2.5 * choices_.share() / dt_ : choices_.of(3) * 5.0;
    bounce_ = choices_.of(4);
    rub_ = choices_.of(4);
    count_ = 1 + choices_.of(SceneT::kMaxBodies);
    arrangement_ = static_cast<Arrangement>(choices_.of(static_cast<int>(Arrangement::kCount)));
    arrange();
  }

  WorldT& world() { return *world_; }
  double dt() const { return static_cast<double>(static_cast<S>(dt_)); }
  Vector gravity() const { return gravity_W_; }
  Arrangement arrangement() const { return arrangement_; }
  double scale() const { return scale_; }
  /// Nothing holds anybody.
  bool is_closed() const { return is_closed_; }

  /// Makes one step; whoever leads bodies says where they go.
  Status step() {
    if constexpr (kIsLed) {
      for (const Lead& lead : leads_) {
        auto* actor = world_->get(lead.id);
        auto* hand = actor->controller.template as<Hand<S>>();
        if (hand == nullptr) continue;
        hand->step = static_cast<S>(dt_);
        hand->target_W = actor->body.X_WB;
        const Vector way = dt_ * lead.velocity * std::cos(time_ * lead.rate);
        hand->target_W.p_W += way.template cast<S>();
        hand->target_W.q_WB =
            renewed<S>(exp_map<S>((dt_ * lead.spin).template cast<S>()) * hand->target_W.q_WB);
      }
    }
    time_ += dt_;
    return world_->step(static_cast<S>(dt_));
  }

  Seen seen() const {
    Seen all;
    const WorldT& world = *world_;
    for (int i = 0; i < SceneT::kMaxBodies; ++i) {
      const auto id = world.id_at(static_cast<std::uint16_t>(i));
      const Actor<SceneT>* const actor = world.get(id);
      if (actor == nullptr) continue;
      all.push_back(see(*actor));
      SeenBody& one = all.back();
      one.slot = i;
      if constexpr (SceneT::kSleep) one.asleep = world.is_asleep(id);
      if constexpr (kIsLed) {
        for (const Lead& lead : leads_) {
          if (world.id_at(static_cast<std::uint16_t>(i)) == lead.id) {
            one.led = true;
            one.moves = lead.moves;
          }
        }
      }
    }
    return all;
  }

 private:
  static constexpr bool kIsLed = !std::is_same_v<typename SceneT::Controller, FreeFlight<S>>;
  static constexpr double kSteps[] = {1e-4, 1e-3, 1e-3, 1e-2, 1.0 / 60, 1.0 / 30};

  struct Lead {
    Handle<Actor<SceneT>> id;
    bool moves = false;
    Vector velocity = Vector::Zero();
    Vector spin = Vector::Zero();
    double rate = 0;
  };

  void settle_settings() {
    WorldSettings<SceneT> settings;
    if constexpr (SceneT::kGravity) {
      gravity_W_ = Vector(0, 0, choices_.chance(6) ? 0 : -9.81);
      settings.gravity_W = gravity_W_.template cast<S>();
    }
    if constexpr (detail::kKnowsRest<SceneT>) {
      settings.separation = static_cast<S>(1e-4 * (choices_.chance(3) ? scale_ : 1));
    }
    if (world_->configure(settings) != Status::kOk) std::abort();
  }

  double density() { return 1000 * std::pow(10.0, light_ * choices_.signed_share()); }
  double radius() { return scale_ * (0.02 + 0.06 * choices_.of(8) / 8); }

  CapsulePart<S> part(const Vector& a, const Vector& b, double r, double rho) {
    return {{{a.template cast<S>(), b.template cast<S>()}, static_cast<S>(r)}, static_cast<S>(rho)};
  }

  /// A ball, a rod along z or a compound about it; its mass with it.
  Actor<SceneT> make(double length, double r) {
    constexpr int kMost = SceneT::kCapsulesPerBody;
    const double rho = density();
    const Vector end(0, 0, length / 2);
    Actor<SceneT> actor;
    if constexpr (!SceneT::kRotation) {
      const double mass = rho * (4.19 * r * r * r + 3.14 * r * r * length);
      actor.body = make_straight_body<S>(Vec3<S>::Zero(), static_cast<S>(mass)).value;
      if constexpr (SceneT::Search::kForSpheres) {
        actor.radius = static_cast<S>(r);
      } else {
        actor.capsule_B = part(-end, end, r, rho).capsule_S;
      }
    } else {
      CapsulePart<S> parts[kMost] = {part(-end, end, r, rho)};
      const int count = length > 0 ? 1 + choices_.of(kMost) : 1;
      for (int i = 1; i < count; ++i) {
        const Vector from(0, 0, length / 2 * choices_.signed_share());
        parts[i] = part(from, from + 0.6 * length * choices_.in_cube(), r * 0.8, rho);
      }
      const auto made = make_compound<kMost>(&parts[0], count, Pose<S>{});
      if (!made.ok()) std::abort();
      actor.body = made.value.body;
      for (const auto& shape : made.value.capsules_B) add_shape(actor, shape);
    }
    rub(actor);
    return actor;
  }
  static void add_shape(Actor<SceneT>& actor, const Capsule<S>& shape) {
    if constexpr (SceneT::kCapsulesPerBody == 1) {
      actor.capsule_B = shape;
    } else {
      (void)actor.capsules_B.push(shape);
    }
  }
  void rub(Actor<SceneT>& actor) {
    const double any = choices_.share();
    const double bounces[] = {0, 1, 0.5, any};
    const double rubs[] = {0, 0.5, 3, any};
    if constexpr (SceneT::kRestitution) actor.restitution = static_cast<S>(bounces[bounce_]);
    if constexpr (SceneT::kFriction) actor.friction = static_cast<S>(rubs[rub_]);
    if constexpr (SceneT::kRollingResistance) {
      actor.rolling_resistance = choices_.chance(4) ? static_cast<S>(3e-4 * scale_) : S(0);
    }
  }

  /// Puts it where its frame was made, turned.
  void place(Actor<SceneT>& actor, const Vector& at, const Quat<double>& turn) {
    const Vector x = origin_W_ + at;
    if constexpr (SceneT::kRotation) {
      auto& X_WB = actor.body.X_WB;
      const Vector centre = turn * X_WB.p_W.template cast<double>();
      X_WB.p_W = (x + centre).template cast<S>();
      X_WB.q_WB = renewed<S>((turn * X_WB.q_WB.template cast<double>()).template cast<S>());
    } else {
      actor.body.p_W = x.template cast<S>();
    }
  }
  void throw_it(Actor<SceneT>& actor, const Vector& v) {
    const Vector u = v + drift_W_;
    if constexpr (SceneT::kRotation) {
      const Vector w = spin_ * choices_.in_cube() / std::sqrt(3.0);
      actor.body.momentum =
          momentum_of(actor.body, Twist<S>{u.template cast<S>(), w.template cast<S>()});
    } else {
      actor.body.momentum_W = u.template cast<S>() / actor.body.inverse_mass;
    }
  }
  void fix(Actor<SceneT>& actor) {
    actor.body.inverse_mass = 0;
    if constexpr (SceneT::kRotation) {
      actor.body.inverse_moments.setZero();
      actor.body.momentum = {};
    } else {
      actor.body.momentum_W.setZero();
    }
  }

  void add(Actor<SceneT> actor, const Vector& at, const Quat<double>& turn, const Vector& v,
           bool fixed = false) {
    place(actor, at, turn);
    throw_it(actor, v);
    if (fixed) fix(actor);
    Lead lead;
    const bool is_led = kIsLed && !is_closed_ && choices_.chance(4);
    if constexpr (kIsLed) {
      if (is_led) {
        lead.moves = !choices_.chance(3);
        if (choices_.chance(2)) fix(actor);
        if (lead.moves) {
          actor.controller = Hand<S>{};
        } else {
          actor.controller = Fixed<S>{};
        }
        lead.velocity = choices_.of(3) * scale_ * choices_.in_cube();
        lead.spin = choices_.of(3) * 2.0 * choices_.in_cube();
        lead.rate = choices_.of(3) * 20.0;
      }
    }
    const auto id = world_->add(actor);
    if (!id.ok()) return;
    lead.id = id.value;
    if (is_led) leads_.push_back(lead);
  }
  bool is_pinned() { return !is_closed_ && choices_.chance(5); }

  void arrange() {
    switch (arrangement_) {
      case Arrangement::kRow:
        return make_row();
      case Arrangement::kLayers:
        return make_layers();
      case Arrangement::kFork:
        return make_fork();
      default:
        return make_crowd(arrangement_ == Arrangement::kJammed ? 0.55 : 1.3);
    }
  }

  Quat<double> any_turn() {
    if constexpr (SceneT::kRotation) return choices_.rotation();
    return Quat<double>::Identity();
  }

  /// On a grid, each towards the middle, more or less.
  void make_crowd(double apart) {
    const int side = static_cast<int>(std::ceil(std::cbrt(static_cast<double>(count_))));
    const double length = SceneT::Search::kForSpheres ? 0 : 0.2 * scale_ * choices_.of(4);
    const double cell = apart * (length + 0.16 * scale_);
    for (int i = 0; i < count_; ++i) {
      const Vector node(i % side, i / side % side, i / side / side);
      const Vector middle = Vector::Constant((side - 1) / 2.0);
      const Vector at = cell * (node - middle) + 0.1 * cell * choices_.in_cube();
      const Vector v = speed_ * (choices_.in_cube() - (node - middle) / side);
      const double r = radius();
      add(make(length, r), at, any_turn(), v, is_pinned());
    }
  }
  /// One touches the next.
  void make_row() {
    const double gaps[] = {0, 5e-5, 1e-5, 1e-3 * scale_};
    const double gap = gaps[choices_.of(4)];
    const double r = radius();
    const double length = SceneT::Search::kForSpheres ? 0 : 0.3 * scale_ * choices_.of(3);
    double z = 0;
    for (int i = 0; i < count_; ++i) {
      const double own = choices_.chance(3) ? r : radius();
      z += i == 0 ? 0 : gap + own;
      const Vector across = speed_ * 0.1 * choices_.in_cube();
      const Vector v = across - Vector(0, 0, i == count_ - 1 ? speed_ : speed_ * 0.02 * i);
      add(make(length, own), {0, 0, z}, lying(i % 2 == 0), v, i == 0 ? is_pinned() : false);
      z += own;
    }
  }
  /// Across or along x.
  static Quat<double> lying(bool across) {
    const double half = std::acos(-1.0) / 4;
    if (!SceneT::kRotation) return Quat<double>::Identity();
    return across ? Quat<double>(std::cos(half), 0, std::sin(half), 0)
                  : Quat<double>(std::cos(half), std::sin(half), 0, 0);
  }
  /// Crossed rods, two or three to a layer, on rods that stand where the set is not closed.
  void make_layers() {
    const double r = radius();
    const double length = SceneT::Search::kForSpheres ? 0 : 0.5 * scale_;
    const int wide = 2 + choices_.of(2);
    const double gap = choices_.of(3) * 5e-5;
    for (int i = 0; i < count_; ++i) {
      const int layer = i / wide;
      const double aside = 0.4 * scale_ * (i % wide - (wide - 1) / 2.0) / wide;
      const bool across = layer % 2 == 0;
      const Vector at(across ? 0 : aside, across ? aside : 0, layer * (2 * r + gap));
      add(make(length, r), at, lying(across), 0.1 * speed_ * choices_.in_cube(),
          layer == 0 && !is_closed_);
    }
  }
  /// Something between two others, with too little room.
  void make_fork() {
    const double r = radius();
    const double length = SceneT::Search::kForSpheres ? 0 : 0.4 * scale_;
    const double room = choices_.signed_share() * 1e-3 * scale_;
    for (int i = 0; i + 2 < count_ || i == 0; i += 3) {
      const Vector at(0, 0, i * scale_ / 3);
      const double side = 2 * r + room / 2;
      const bool pinned = is_pinned();
      const Vector push = speed_ * choices_.in_cube();
      add(make(length, r), at + Vector(-side, 0, 0), lying(false), push, pinned);
      add(make(length, r), at + Vector(side, 0, 0), lying(false), -push, pinned);
      add(make(length, r), at, any_turn(), speed_ * choices_.in_cube());
    }
  }

  std::unique_ptr<WorldT> world_ = std::make_unique<WorldT>();
  Choices choices_;
  Vector drift_W_;
  Vector gravity_W_ = Vector::Zero();
  Vector origin_W_ = Vector::Zero();
  double scale_ = 1;
  double dt_ = 0;
  double time_ = 0;
  double speed_ = 0;
  double spin_ = 0;
  int light_ = 0;
  int bounce_ = 0;
  int rub_ = 0;
  int count_ = 0;
  bool is_closed_ = false;
  Arrangement arrangement_ = Arrangement::kApart;
  std::vector<Lead> leads_;
};

}  // namespace batuta::test
