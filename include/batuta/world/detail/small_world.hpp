// SPDX-License-Identifier: MIT
#pragma once
// The world of a few bodies that fly straight: what GeneralWorld promises, in a fraction of its
// flash. With so few, nothing is kept from one contact to the next: every round searches all pairs
// again, from now over the rest of the step, and moves everybody (src/world/detail/small_world.md).
// Frame W, SI units.

#include "batuta/core/arithmetic.hpp"
#include "batuta/core/pool.hpp"
#include "batuta/response/straight_impulse.hpp"
#include "batuta/world/actor.hpp"
#include "batuta/world/detail/straight_kinematics.hpp"
#include "batuta/world/event.hpp"

namespace batuta::detail {

/// Members and statuses are those of GeneralWorld. The scene's max_pairs, sweep_axis and Bound mean
/// nothing here: there is room for all pairs, and there are no boxes.
template <class SceneT>
class SmallWorld {
 public:
  using Scalar = typename SceneT::Scalar;
  using Search = typename SceneT::Search;
  using ActorType = Actor<SceneT>;
  using BodyId = Handle<ActorType>;

  /// Rounds of one step: each ends with a contact (kMaxContacts), with two groups that become one
  /// or that stand (kMaxBodies), or with the step (1).
  static constexpr int kMaxRounds = SceneT::kMaxContacts + SceneT::kMaxBodies + 1;
  /// Most pairs searched in one round: all.
  static constexpr int kPairsPerRound = SceneT::kMaxBodies * (SceneT::kMaxBodies - 1) / 2;

  /// As GeneralWorld. Of balls, only what a compiler's flags are likely to change is looked at:
  /// products that are not rounded; denormals do not matter to them (sphere_flight.md).
  explicit SmallWorld(std::uint16_t number = 0) : actors_(number) {
    BATUTA_ASSERT(Search::kForSpheres ? rounds_products<Scalar>()
                                      : rounds_each_operation<Scalar>());
  }

  Status configure(const WorldSettings<SceneT>& settings) {
    const Status status = validate(settings);
    if (status == Status::kOk) settings_ = settings;
    return status;
  }
  const WorldSettings<SceneT>& settings() const { return settings_; }

  /// Bound: kMaxBodies.
  void restore(const SmallWorld& saved) {
    settings_ = saved.settings_;
    actors_.restore(saved.actors_);
    report_ = saved.report_;
  }

  /// kInvalidArgument as well where the speed is beyond the numbers: GeneralWorld lets such a body
  /// stand, and tells it in each step.
  Result<BodyId> add(const ActorType& actor) {
    const bool is_usable =
        is_inverse(actor.body.inverse_mass) && step_mass(actor) == actor.body.inverse_mass;
    return is_usable ? actors_.make(actor) : failure<BodyId>(Status::kInvalidArgument);
  }
  Status remove(BodyId id) { return actors_.remove(id); }
  ActorType* get(BodyId id) { return actors_.get(id); }
  ActorType* steer(BodyId id) { return actors_.get(id); }
  const ActorType* get(BodyId id) const { return actors_.get(id); }
  BodyId id_at(std::uint16_t slot) const { return actors_.handle_at(slot); }
  int size() const { return actors_.size(); }

  /// Bound: kMaxRounds rounds of at most kPairsPerRound searches of at most kBudget evaluations.
  Status step(Scalar dt);

  const StepReport<Scalar>& report() const { return report_; }
  /// Nobody does.
  bool is_asleep(BodyId /*id*/) const { return false; }

  /// Lists what is saved of a world (record/archive.hpp).
  template <class Archive>
  void archive(Archive& ar) {
    archive_scene<SceneT>(ar);
    ar(settings_, actors_, report_);
  }

 private:
  using Kinematics = StraightKinematics<SceneT>;
  using PairQuery = typename Kinematics::PairQuery;
  static constexpr std::size_t kSlots = static_cast<std::size_t>(SceneT::kMaxBodies);

  /// How a round ends: the pair slot_A kSlots + slot_B, and what its search answered.
  struct Meeting {
    std::size_t pair = 0;
    Outcome outcome = Outcome::kFree;
    Scalar t_free = 0;  ///< s from now
  };

  /// Of bodies that fall: how far the chord is behind the parabola, times 1 / g, s^2; and which of
  /// them are carried for the rest of the step.
  struct Falls {
    std::array<Scalar, kSlots> lag{};
    std::array<bool, kSlots> loaded{};
    std::array<Vec3<Scalar>, kSlots> support_W;  ///< as CarriedState
    /// What that takes of who is carried itself, by the last such carrier, N; and this one's slot.
    std::array<Vec3<Scalar>, kSlots> reaction_W;
    std::array<std::uint8_t, kSlots> carrier{};
  };

  /// Of a group that falls: lag times mass.
  struct SmallFallSums {
    Scalar lag = 0;
    bool loaded = false;
  };

  /// A set of bodies: a bit of each slot. There are eight at most (SceneRule::kSmallBodies).
  using Slots = std::uint8_t;
  static constexpr Slots alone(std::size_t slot) { return static_cast<Slots>(1U << slot); }

  /// Equals nothing, and no sum with it is above zero.
  static constexpr Scalar kAbsent = std::numeric_limits<Scalar>::quiet_NaN();

  /// Kept apart: some calls, and no copies.
  [[gnu::noinline]] static Scalar step_mass(const ActorType& actor);
  static bool is_of_contact(Outcome outcome) {
    return outcome == Outcome::kContact || outcome == Outcome::kTouching;
  }
  void begin_body(std::size_t slot);
  void run_round(bool is_begin);
  void move(std::size_t slot, Scalar t);
  Meeting first_meeting(bool is_begin);
  bool may_pair(std::size_t a, std::size_t b) const;
  PairQuery search(std::size_t a, std::size_t b) const;
  void resolve(const Meeting& meeting);
  void weld(std::size_t a, std::size_t b);
  /// Whether a body is one of a set, and can be moved.
  bool is_in(Slots group, std::size_t slot) const {
    return (group & alone(slot)) != 0 && inverse_mass_[slot] > Scalar(0);
  }
  void take_in(std::size_t slot, Scalar mass, const Vec3<Scalar>& sum_W, const SmallFallSums& fall);
  void hit(std::size_t a, std::size_t b);
  Scalar speed(std::size_t slot, int i) const;
  Vec3<Scalar> velocity(std::size_t slot) const {
    return {speed(slot, 0), speed(slot, 1), speed(slot, 2)};
  }
  StraightHit<Scalar> strike(std::size_t a, std::size_t b, const Vec3<Scalar>& normal_W,
                             Scalar restitution);
  // With gravity alone; as in Bodies.
  bool falls(std::size_t slot) const {
    return inverse_mass_[slot] > Scalar(0) && !falls_.loaded[slot];
  }
  void lag(std::size_t slot, Scalar elapsed);
  Vec3<Scalar> velocity_now(std::size_t slot) const;
  bool is_blow(std::size_t a, std::size_t b, const Vec3<Scalar>& normal_W);
  Scalar take_load(std::size_t a, std::size_t b, const Vec3<Scalar>& normal_W);
  void note_support(std::size_t slot, const Vec3<Scalar>& impulse_W);
  bool is_lost_below(std::size_t carrier, const Vec3<Scalar>& load_W) const;
  void give_way(std::size_t carried, std::size_t carrier, const Vec3<Scalar>& towards_W,
                Scalar speed, Vec3<Scalar>& on_carried_W);
  void give_reaction(std::size_t slot, Scalar times);
  Vec3<Scalar> release(std::size_t slot);
  void restore(std::size_t slot, const Vec3<Scalar>& momentum_W, const Vec3<Scalar>& support_W);

  // What is used most comes first: small offsets make short instructions.
  Scalar left_ = 0;  ///< of the step, s
  int contacts_resolved_ = 0;
  StepReport<Scalar> report_;
  WorldSettings<SceneT> settings_;
  /// 1/kg, as the step uses it: 0 for what is fixed or stands, kAbsent for what takes no part.
  std::array<Scalar, kSlots> inverse_mass_{};
  std::array<Slots, kSlots> group_{};  ///< who goes on together: each has the whole set
  Pool<ActorType, SceneT::kMaxBodies> actors_;
  FeatureIf<SceneT::kGravity, Falls, 6> falls_;
};

template <class SceneT>
Status SmallWorld<SceneT>::step(Scalar dt) {
  if (!is_positive(dt)) return Status::kInvalidArgument;
  report_ = {};
  left_ = dt;
  contacts_resolved_ = 0;
  for (std::size_t slot = 0; slot < kSlots; ++slot) begin_body(slot);      // Bound: kMaxBodies
  for (int round = 0; round < kMaxRounds && left_ > Scalar(0); ++round) {  // Bound: kMaxRounds
    run_round(round == 0);
  }
  BATUTA_INVARIANT(!(left_ > Scalar(0)));
  return Status::kOk;
}

/// The body's own inverse mass where it can take part; 0 where its speed is beyond the numbers, so
/// that it is held; else kAbsent.
template <class SceneT>
typename SmallWorld<SceneT>::Scalar SmallWorld<SceneT>::step_mass(const ActorType& actor) {
  const StraightBody<Scalar>& body = actor.body;
  const Scalar inverse_mass = body.inverse_mass;
  Scalar zero = inverse_mass - inverse_mass;  // NaN where one is not finite
  Scalar standing = 0;
  for (int i = 0; i < 3; ++i) {  // Bound: 3; by component: expressions double the code
    const Scalar v = inverse_mass * body.momentum_W[i];
    zero += (body.p_W[i] - body.p_W[i]) + (body.momentum_W[i] - body.momentum_W[i]);
    standing += v - v;
  }
  const bool is_usable =
      zero == Scalar(0) && inverse_mass >= Scalar(0) && has_valid_features(actor);
  if (!is_usable) return kAbsent;
  return standing == Scalar(0) ? inverse_mass : Scalar(0);
}

/// What gravity makes too fast stands still with the momentum that it had.
template <class SceneT>
void SmallWorld<SceneT>::begin_body(std::size_t slot) {
  inverse_mass_[slot] = kAbsent;
  group_[slot] = alone(slot);
  if constexpr (SceneT::kGravity) {
    falls_.lag[slot] = 0;
    falls_.loaded[slot] = false;
    falls_.support_W[slot].setZero();
    falls_.reaction_W[slot].setZero();
  }
  ActorType* const actor = actors_.at_index(slot);
  if (actor == nullptr) return;
  StraightBody<Scalar>& body = actor->body;
  [[maybe_unused]] const Vec3<Scalar> before = body.momentum_W;
  if constexpr (SceneT::kGravity) {
    if (body.inverse_mass > Scalar(0)) {
      body.momentum_W += (left_ / body.inverse_mass) * settings_.gravity_W;
    }
  }
  Scalar mass = step_mass(*actor);
  if (mass != body.inverse_mass) {
    ++report_.plans_invalid;
    if constexpr (SceneT::kGravity) {
      body.momentum_W = before;
      mass = step_mass(*actor) >= Scalar(0) ? Scalar(0) : kAbsent;
    }
    if (mass == Scalar(0)) report_.time_held = left_;
  }
  inverse_mass_[slot] = mass;
}

/// To the first contact, the first search without an answer, or the end of the step.
template <class SceneT>
void SmallWorld<SceneT>::run_round(bool is_begin) {
  const Meeting meeting = first_meeting(is_begin);
  // No time, no way: a blow may have left a speed beyond the numbers, whose search is refused.
  const bool moves = meeting.t_free > Scalar(0);
  for (std::size_t slot = 0; moves && slot < kSlots; ++slot) {  // Bound: kMaxBodies
    if (inverse_mass_[slot] > Scalar(0)) move(slot, meeting.t_free);
  }
  if constexpr (SceneT::kGravity) {
    for (std::size_t slot = 0; slot < kSlots; ++slot) {  // Bound: kMaxBodies
      lag(slot, meeting.t_free);
    }
  }
  left_ -= meeting.t_free;
  if (meeting.outcome != Outcome::kFree) resolve(meeting);
}

/// Along an axis, of its course: what falls goes along the chord of the rest of its parabola
/// (world.md, "The fall").
template <class SceneT>
typename SmallWorld<SceneT>::Scalar SmallWorld<SceneT>::speed(std::size_t slot, int i) const {
  Scalar v = inverse_mass_[slot] * actors_.at(slot).body.momentum_W[i];
  if constexpr (SceneT::kGravity) {
    if (inverse_mass_[slot] > Scalar(0)) {
      const Scalar behind =
          falls_.lag[slot] / left_ + (falls_.loaded[slot] ? Scalar(0) : left_ / 2);
      v -= behind * settings_.gravity_W[i];
    }
  }
  return v;
}

template <class SceneT>
void SmallWorld<SceneT>::lag(std::size_t slot, Scalar elapsed) {
  falls_.lag[slot] *= 1 - elapsed / left_;
  if (falls(slot)) falls_.lag[slot] += elapsed * (left_ - elapsed) / 2;
}

template <class SceneT>
void SmallWorld<SceneT>::move(std::size_t slot, Scalar t) {
  StraightBody<Scalar>& body = actors_.at(slot).body;
  for (int i = 0; i < 3; ++i) {  // Bound: 3
    body.p_W[i] += speed(slot, i) * t;
  }
}

/// The pair that is proven free for the shortest time; of contacts that are near already,
/// the lowest, at that time (src/world/world.md, "Order").
/// @param is_begin  the step begins: who is in each other is told, whether they approach or part
template <class SceneT>
typename SmallWorld<SceneT>::Meeting SmallWorld<SceneT>::first_meeting(bool is_begin) {
  std::array<Scalar, kSlots * kSlots> near_after;
  Meeting first;
  first.t_free = left_;
  for (std::size_t pair = 0; pair < kSlots * kSlots; ++pair) {  // Bound: kMaxBodies^2
    near_after[pair] = std::numeric_limits<Scalar>::max();
    if (!may_pair(pair / kSlots, pair % kSlots)) continue;
    const PairQuery query = search(pair / kSlots, pair % kSlots);
    ++report_.pairs;
    report_.evaluations += query.evaluations();
    if (is_begin && query.gap() < Scalar(0)) {
      ++report_.overlaps_at_start;
      report_.deepest_overlap = max_of(report_.deepest_overlap, -query.gap());
    }
    if (is_of_contact(query.outcome())) near_after[pair] = query.near_after();
    if (query.outcome() != Outcome::kFree && query.t_free() < first.t_free) {
      first = {pair, query.outcome(), query.t_free()};
    }
  }
  if (is_of_contact(first.outcome)) {
    first.pair = 0;
    while (first.t_free < near_after[first.pair]) ++first.pair;  // Bound: kMaxBodies^2
  }
  return first;
}

/// Two that stand still, or go on together, stay as they are, apart or not; and no sum with kAbsent
/// is above zero.
template <class SceneT>
bool SmallWorld<SceneT>::may_pair(std::size_t a, std::size_t b) const {
  return a < b && inverse_mass_[a] + inverse_mass_[b] > Scalar(0) && (group_[a] & alone(b)) == 0 &&
         may_meet(actors_.at(a), actors_.at(b));
}

template <class SceneT>
typename SmallWorld<SceneT>::PairQuery SmallWorld<SceneT>::search(std::size_t a,
                                                                  std::size_t b) const {
  const ActorType& A = actors_.at(a);
  const ActorType& B = actors_.at(b);
  if constexpr (Search::kForSpheres) {
    SphereFlight<Scalar> flight;
    Scalar pace = 0;               // as Kinematics::pace_of()
    for (int i = 0; i < 3; ++i) {  // Bound: 3
      const Scalar v_A = speed(a, i);
      const Scalar v_B = speed(b, i);
      flight.between[i] = B.body.p_W[i] - A.body.p_W[i];
      flight.v[i] = v_B - v_A;
      pace += std::abs(v_A) + std::abs(v_B);
      if constexpr (SceneT::kGravity) {
        pace += std::abs(inverse_mass_[a] * A.body.momentum_W[i]) +
                std::abs(inverse_mass_[b] * B.body.momentum_W[i]);
      }
    }
    flight.radii = A.radius + B.radius;
    flight.duration = left_;
    return Kinematics::search_flight(flight, pace, settings_.search);
  } else {
    return Kinematics::search(Kinematics::mover(A, 0, {A.body.p_W, velocity(a), left_}),
                              Kinematics::mover(B, 0, {B.body.p_W, velocity(b), left_}),
                              settings_.search);
  }
}

}  // namespace batuta::detail

#include "batuta/world/detail/small_contact.hpp"
