// SPDX-License-Identifier: MIT
#pragma once
// Many bodies, one step: everybody moves to the first contact, the contact is answered, and so on
// to the end of the step [Kavan §2.1, §3, §4.2]. One object, placed by the caller; its size and the
// longest step are constants. Frame W, SI units; times within a step run from 0 to dt.

#include "batuta/core/arithmetic.hpp"
#include "batuta/core/pool.hpp"
#include "batuta/world/broadphase.hpp"
#include "batuta/world/encounter.hpp"
#include "batuta/world/event.hpp"
#include "batuta/world/scene.hpp"
#include "batuta/world/seed_memory.hpp"

namespace batuta {

/// A body in a world, as the caller describes it and may read or change it between steps. What
/// becomes unusable (not finite) is left out of the steps, and counted in
/// StepReport::courses_invalid.
template <class SceneT>
struct Actor {
  using Scalar = typename SceneT::Scalar;

  Body<Scalar> body;
  Capsule<Scalar> capsule_B;         ///< its shape
  typename SceneT::Driver driver{};  ///< who moves it
  Scalar restitution = 0;            ///< C, in [0, 1]; a pair takes pair_restitution() of its two
  std::uint16_t owner = 0;           ///< bodies of one owner other than 0 never meet
};

/// What a world keeps for its searches; empty where they take no seed.
template <class SceneT>
using SeedsOf = std::conditional_t<SceneT::Search::kUsesSeed,
                                   SeedMemory<typename SceneT::Scalar, SceneT::kMaxPairs>, NoSeeds>;

/// A base, not a member: an empty one takes no room.
template <class SceneT>
class World : private SeedsOf<SceneT> {
 public:
  using Scalar = typename SceneT::Scalar;
  using Search = typename SceneT::Search;
  using ActorType = Actor<SceneT>;
  using BodyId = Handle<ActorType>;
  using EventList = FixedList<ContactEvent<Scalar>, SceneT::kMaxEvents>;

  static_assert(kIsScalar<Scalar>, "Scene::Scalar: choose float or double");
  static_assert(SceneT::kMaxBodies >= 2 && SceneT::kMaxBodies <= 1024,
                "Scene::kMaxBodies: choose 2 ... 1024");
  static_assert(SceneT::kMaxPairs >= 1, "Scene::kMaxPairs: at least 1");
  static_assert(SceneT::kMaxContacts >= 1, "Scene::kMaxContacts: at least 1");
  static_assert(SceneT::kMaxEvents >= 1, "Scene::kMaxEvents: at least 1");

  /// Rounds of one step: each ends with a contact (kMaxContacts), with the end of the hold that a
  /// contact caused (kMaxContacts), with a body held for good (kMaxBodies), or with the step (1).
  static constexpr int kMaxRounds = 2 * SceneT::kMaxContacts + SceneT::kMaxBodies + 1;

  /// @param number  tells this world's ids from those of another world of the same scene
  /// @pre the file that names the scene, and the thread, round every operation
  ///   (core/arithmetic.hpp): contracted or flushed arithmetic voids what the searches prove
  explicit World(std::uint16_t number = 0) : actors_(number) {
    BATUTA_ASSERT(rounds_each_operation<Scalar>());
  }

  /// @returns kOk | kInvalidArgument (an option out of range; the settings stay as they were)
  Status configure(const WorldSettings<SceneT>& settings) {
    const Status status = validate(settings);
    if (status == Status::kOk) settings_ = settings;
    return status;
  }

  /// Becomes a copy of `saved`, and goes on as that would, to the last bit; ids of one name the
  /// bodies of the other. By name, because a world is large. Bound: kMaxBodies.
  void restore(const World& saved);

  /// @returns kOk with the id | kPoolFull | kInvalidArgument (not finite, negative radius, C
  /// outside [0, 1])
  Result<BodyId> add(const ActorType& actor) {
    if (!is_usable(actor)) return failure<BodyId>(Status::kInvalidArgument);
    ActorType added = actor;
    added.body.X_WB.q_WB = renewed(actor.body.X_WB.q_WB);
    added.body.spin_shows = !hides_spin(actor.body, actor.capsule_B);
    return actors_.make(added);
  }

  /// Takes a body out; its contacts end without an event. @returns kOk | kStaleHandle
  Status remove(BodyId id);

  /// The body, or null for a stale, foreign or null id.
  ActorType* get(BodyId id) { return actors_.get(id); }
  const ActorType* get(BodyId id) const { return actors_.get(id); }
  /// The id of the body in a slot, as events name it; null id if there is none.
  BodyId id_at(std::uint16_t slot) const { return actors_.handle_at(slot); }
  int size() const { return actors_.size(); }

  /// Moves everything by dt. After it, report() and events() tell what happened.
  /// @pre dt > 0 and finite
  /// @returns kOk (also where report().complete() is false: nothing was missed, bodies were held) |
  ///   kInvalidArgument (dt); then nothing has changed
  /// Bound: kMaxRounds rounds of at most kMaxPairs searches of at most kBudget evaluations.
  Status step(Scalar dt);

  const StepReport<Scalar>& report() const { return report_; }
  const EventList& events() const { return events_; }

 private:
  static constexpr std::size_t kSlots = static_cast<std::size_t>(SceneT::kMaxBodies);

  /// What the step knows of a body besides the actor.
  struct Track {
    Course<Scalar> course;
    Scalar held_until = 0;  ///< in the step, s; the body stays where it is until then
  };
  /// The first thing that ends the round early.
  struct Hit {
    bool any = false;
    BodyPair pair;
    SearchResult<Scalar> search;
    Vec3<Scalar> origin_W = Vec3<Scalar>::Zero();
    Scalar scale = 0;        ///< S of the pair, m
    Scalar contact_gap = 0;  ///< the search may speak of contact up to this gap, m
  };
  static bool is_usable(const ActorType& actor);
  ActorType& actor_at(std::size_t slot) { return *actors_.at_index(slot); }
  const ActorType& actor_at(std::size_t slot) const { return *actors_.at_index(slot); }
  bool is_present(std::size_t slot) const { return actors_.at_index(slot) != nullptr; }
  bool takes_part(std::size_t slot) const { return proxies_[slot].present; }
  bool is_held(std::size_t slot) const { return tracks_[slot].held_until > now_; }
  MovingCapsule<Scalar> moving(std::size_t slot) {
    return {actor_at(slot).capsule_B, tracks_[slot].course.motion};
  }

  void begin_step(Scalar dt);
  void run_round();
  Scalar end_of_round() const;
  void plan(Scalar until);
  void plan_course(std::size_t slot, Scalar duration);
  void find_pairs();
  Hit first_hit();
  Hit search(BodyPair pair);
  SearchResult<Scalar> search_with_seed(BodyPair pair, const MovingPair<Scalar>& moving_pair);
  SearchResult<Scalar> let_go(const MovingPair<Scalar>& moving_pair, const Hit& hit) const;
  void advance(Scalar duration);
  void hold(std::size_t slot, Scalar until);
  void hold_pair(BodyPair pair, Scalar until);
  void answer(const Hit& hit);
  void answer_contact_of(const Hit& hit);
  bool is_immovable(BodyPair pair) const;
  void block(const Hit& hit, const Contact<Scalar>& contact);
  EncounterOptions<Scalar> options_for(const Hit& hit) const;
  Scalar margin_of(const Hit& hit) const;
  Party<Scalar> party(std::size_t slot, std::size_t other, const Vec3<Scalar>& away_W);
  Scalar room_of(std::size_t slot, std::size_t other, const Vec3<Scalar>& away_W);
  void tell_driver(std::size_t slot, const EncounterAnswer<Scalar>& answer,
                   const Vec3<Scalar>& shift_W);
  void record(const Hit& hit, const Contact<Scalar>& contact,
              const EncounterAnswer<Scalar>& answer);
  EventKind follow(const ContactEvent<Scalar>& event);
  void push(const ContactEvent<Scalar>& event);
  void end_step();
  void end_touches();
  bool has_opened(BodyPair pair, CapsuleGap<Scalar>& gap);
  Capsule<Scalar> shape_W(std::size_t slot) {
    return to_world(actor_at(slot).body.X_WB, actor_at(slot).capsule_B);
  }

  WorldSettings<SceneT> settings_;
  Pool<ActorType, SceneT::kMaxBodies> actors_;
  std::array<Track, kSlots> tracks_{};
  std::array<Proxy<Scalar>, kSlots> proxies_{};
  FixedList<BodyPair, SceneT::kMaxPairs> pairs_;
  FixedList<BodyPair, SceneT::kMaxPairs> touching_;  ///< between their begin and end events
  EventList events_;
  StepReport<Scalar> report_;
  Scalar now_ = 0;  ///< in the step, s
  Scalar dt_ = 0;   ///< length of the step, s
  int contacts_answered_ = 0;
};

}  // namespace batuta

#include "batuta/world/world_contact.hpp"
#include "batuta/world/world_step.hpp"
