// SPDX-License-Identifier: MIT
#pragma once
// Many bodies, one step (src/world/world.md). What lasts is solved before anybody moves; then
// everybody moves to the first contact, it is answered, and so on to the end of the step [Kavan
// §2.1, §3, §4.2]. Five collaborators, each with a header of its own: bodies and their clocks;
// pairs; contact groups; touches and events; sleep. One object, placed by the caller; its size and
// the longest step are constants. Frame W, SI units; times within a step run from 0 to dt.

#include "batuta/core/arithmetic.hpp"
#include "batuta/response/friction.hpp"
#include "batuta/response/line_contact.hpp"
#include "batuta/response/separation.hpp"
#include "batuta/response/straight_impulse.hpp"
#include "batuta/world/detail/bent_course.hpp"
#include "batuta/world/detail/sleep.hpp"
#include "batuta/world/detail/touches.hpp"

namespace batuta::detail {

/// The world of every scene that SmallWorld is not for (SceneOptions::engine). A base counts the
/// answers of a pair that repeat: where the scene asks for no count, it takes no room.
template <class SceneT>
class GeneralWorld : private RepeatsOf<SceneT> {
 public:
  /// The scene's.
  using Scalar = typename SceneT::Scalar;
  /// How contacts are found.
  using Search = typename SceneT::Search;
  /// A body with what the scene's features ask of it.
  using ActorType = Actor<SceneT>;
  /// Names a body of this world.
  using BodyId = Handle<ActorType>;
  /// A FixedList of ContactEvent.
  using EventList = typename EventsOf<SceneT>::EventList;

  /// Courses that end early before a contact, and groups that part before one, for one contact.
  static constexpr int kCutsPerContact = detail::kCuts<SceneT> ? 2 : 0;
  /// Ends of rounds that one contact accounts for: the third is that of a course cut short after
  /// it; those before it end a round when they are cut and when they end.
  static constexpr int kEndsPerContact =
      2 + static_cast<int>(detail::kBends<SceneT>) + 2 * kCutsPerContact;

  /// Rounds of one step: each ends with a contact (kMaxContacts), with the end of the time that a
  /// separation takes (kMaxContacts), with two groups that become one or a group that comes to
  /// stand (2 kMaxBodies; where nobody answers contacts, with a pair that is left: kMaxPairs), with
  /// the end of a course that a contact has cut short (kMaxContacts), with a course that is to end
  /// where a contact was found, and its end (2 kCutsPerContact kMaxContacts), or with the step (1).
  static constexpr int kMaxRounds = kEndsPerContact * SceneT::kMaxContacts +
                                    max_of(2 * SceneT::kMaxBodies, SceneT::kMaxPairs) + 1;
  /// Most pairs searched in one round.
  static constexpr int kPairsPerRound = SceneT::kMaxPairs;

  /// @param number  tells this world's ids from those of another world of the same scene
  /// @pre the file that names the scene, and the thread, round every operation
  ///   (core/arithmetic.hpp): contracted or flushed arithmetic voids what the searches prove
  explicit GeneralWorld(std::uint16_t number = 0) : bodies_(number) {
    BATUTA_ASSERT(rounds_each_operation<Scalar>());
  }

  /// Sets the tolerances, from the next step on. Another gravity wakes all bodies.
  /// @returns kOk | kInvalidArgument (an option out of range; the settings stay as they were)
  Status configure(const WorldSettings<SceneT>& settings);
  /// What configure() was given, or the scene's own.
  const WorldSettings<SceneT>& settings() const { return bodies_.settings; }

  /// Becomes a copy of `saved`, and goes on as that would, to the last bit; ids of one name the
  /// bodies of the other. By name, because a world is large. Bound: kMaxBodies.
  void restore(const GeneralWorld& saved);

  /// Puts a body into the world, in the lowest free slot.
  /// @returns kOk with the id | kPoolFull | kInvalidArgument (not finite, negative radius, no part,
  /// C outside [0, 1], mu negative, an orientation of 0, an inverse mass or moment so small that
  /// its own inverse is not finite, a turn that is bent in a scene without bent_turns, or so far
  /// from the origin that numbers there are further apart than the body is large)
  // Kept apart: its copy of the body is not there while its caller calls others.
  [[gnu::noinline]] Result<BodyId> add(const ActorType& actor);

  /// Takes a body out; its contacts end without an event. @returns kOk | kStaleHandle
  Status remove(BodyId id);

  /// The body, or null for a stale, foreign or null id.
  /// The next step looks at the body again: to read only, read a const world; to change it, call
  /// this again after each step.
  ActorType* get(BodyId id) {
    const int slot = bodies_.actors.index_of(id);
    if (slot != PoolBase::kNoIndex) bodies_.look_again(static_cast<std::size_t>(slot));
    return bodies_.actors.get(id);
  }
  /// As get(), to change pose, momenta and controller alone, in each step: a body that stands where
  /// it stood is not compared with others that do.
  ActorType* steer(BodyId id) {
    const int slot = bodies_.actors.index_of(id);
    if (slot != PoolBase::kNoIndex) bodies_.states[static_cast<std::size_t>(slot)].boxed = false;
    return bodies_.actors.get(id);
  }
  /// The body to read, or null for a stale, foreign or null id.
  const ActorType* get(BodyId id) const { return bodies_.actors.get(id); }
  /// The id of the body in a slot, as events name it; null id if there is none.
  BodyId id_at(std::uint16_t slot) const { return bodies_.actors.handle_at(slot); }
  /// Bodies in the world.
  int size() const { return bodies_.actors.size(); }

  /// Moves everything by dt. After it, report() and events() tell what happened.
  /// @pre dt > 0 and finite
  /// @returns kOk (also where report().complete() is false: nothing was missed, bodies went on
  ///   together) | kInvalidArgument (dt); then nothing has changed
  /// Bound: kMaxRounds rounds of at most kMaxPairs searches of at most kBudget evaluations.
  Status step(Scalar dt);

  /// What the last step did, and what it left out.
  const StepReport<Scalar>& report() const { return bodies_.report; }
  /// What happened in the step. Where SceneOptions::max_events is 0, there are none to ask for.
  const EventList& events() const {
    static_assert(SceneT::kMaxEvents > 0, "Scene: events() takes max_events > 0");
    return touches_.events();
  }
  /// Whether the body sleeps (SceneOptions::sleep); false for a stale id.
  bool is_asleep(BodyId id) const {
    const int slot = bodies_.actors.index_of(id);
    return slot != PoolBase::kNoIndex && bodies_.states[static_cast<std::size_t>(slot)].asleep;
  }

  /// Lists what is saved of a world (record/archive.hpp).
  template <class Archive>
  void archive(Archive& ar);

 private:
  using BodiesT = Bodies<SceneT>;
  using PairsT = Pairs<SceneT>;
  using Kinematics = typename BodiesT::Kinematics;
  using PairQuery = typename PairsT::PairQuery;
  using CandidateType = typename PairsT::CandidateType;
  using BodyType = decltype(ActorType::body);
  static constexpr std::size_t kSlots = BodiesT::kSlots;
  static constexpr bool kSolves = kLasts<SceneT>;
  static constexpr int kTies = 32;  ///< most contacts that are answered in one round
  static constexpr bool kSeparates = SceneT::kResting == RestingContact::kSeparation;

  /// What a blow that is passed on asks of the world.
  struct Passing {
    GeneralWorld& world;
    void blow(ProxyPair pair) const { world.strike_neighbour(pair); }
    void wake(std::size_t slot) const { world.wake_with_all(slot); }
  };
  /// What a blow sees of two bodies.
  struct Sides {
    Collider<Scalar> A;
    Collider<Scalar> B;
  };

  // The step: general_step.hpp.
  void begin_step(Scalar dt);
  void begin_bodies();
  void solve_lasting();
  void wake_touched();
  void plan_solved(std::size_t slot);
  void run_round();
  bool cut_courses(const CandidateType& candidate, Scalar time);
  bool cut_course(std::size_t slot, Scalar time);
  Vec3<Scalar> parts_along(ProxyPair pair) const;
  Scalar next_release() const;
  void end_courses(Scalar time);
  void release(Scalar time);
  void end_step();
  void take_stand(std::size_t slot, bool stands, bool asleep);

  // A contact: general_contact.hpp; a blow: general_blow.hpp.
  void resolve(const CandidateType& candidate, Scalar time);
  void resolve_contact(const CandidateType& candidate, bool is_own_time);
  void answer_turning(const CandidateType& candidate, const PairQuery& query);
  bool strike_turning(ProxyPair pair, const Sides& sides, const Contact<Scalar>& contact,
                      bool is_loads, Answer<Scalar>& result);
  void finish_turning(ProxyPair pair, const PairQuery& query, const Contact<Scalar>& contact,
                      const Answer<Scalar>& result);
  void finish_lasting(ProxyPair pair, const PairQuery& query, const Contact<Scalar>& contact,
                      const Answer<Scalar>& result);
  void answer_straight(const CandidateType& candidate);
  void report_only(const CandidateType& candidate);
  void wake_now(std::size_t slot);
  void wake_with_all(std::size_t slot);
  void cut(const CandidateType& candidate);
  void block(const CandidateType& candidate, const PairQuery& query,
             const Nearest<Scalar>& nearest);
  void advance_to_now(const CandidateType& candidate, std::size_t slot, bool is_own_time);
  bool uses_up_answers(ProxyPair pair);
  Scalar rest_speed() const;
  Scalar restitution_of(ProxyPair pair) const;
  // Kept apart: some calls, and no copies.
  [[gnu::noinline]] Sides sides_of(ProxyPair pair) const;
  [[gnu::noinline]] void push(int proxy, const Collider<Scalar>& side,
                              const Momentum<Scalar>& change);
  // Who carries what falls: general_load.hpp.
  static constexpr int kNobody = -1;
  bool is_blow(ProxyPair pair, const Contact<Scalar>& contact);
  int takes_load(ProxyPair pair, const Contact<Scalar>& contact);
  Sides sides_of_load(ProxyPair pair, int carried) const;
  Scalar load_straight(ProxyPair pair, const Contact<Scalar>& contact, Scalar pressed);
  void note_supports(ProxyPair pair, const Momentum<Scalar>& on_A, const Momentum<Scalar>& on_B);
  void note_support(ProxyPair carried_by, const Momentum<Scalar>& impulse,
                    const Momentum<Scalar>& on_carrier);
  void note_reaction(std::size_t slot, std::size_t carrier, const Momentum<Scalar>& on_carrier,
                     Scalar rest);
  bool is_lost_below(std::size_t carrier, const Vec3<Scalar>& load_W) const;
  void give_way(std::size_t carried, std::size_t carrier, const Vec3<Scalar>& towards_W,
                Scalar speed, Momentum<Scalar>& on_carried, Momentum<Scalar>& on_carrier);
  void press(ProxyPair pair, const Contact<Scalar>& contact, int carried, Answer<Scalar>& result);
  void give_reactions(std::size_t slot, Scalar times);
  void drop_reactions(std::size_t slot);
  Momentum<Scalar> release(std::size_t slot);
  void restore(std::size_t slot, const BodyType& body, const Momentum<Scalar>& support);
  Scalar speeds_at(std::size_t slot, const Vec3<Scalar>& point_W) const;
  StraightHit<Scalar> strike_straight(std::size_t a, std::size_t b, const Vec3<Scalar>& normal_BA_W,
                                      Scalar restitution);
  Result<Impulse<Scalar>> strike(ProxyPair pair, const Sides& sides, const Contact<Scalar>& contact,
                                 Scalar restitution);
  void strike_neighbour(ProxyPair pair);
  static Scalar velocity_between(const Sides& sides, const Contact<Scalar>& contact) {
    return relative_velocity(contact, sides.A.X_WB, sides.A.twist, sides.B.X_WB, sides.B.twist);
  }
  Scalar velocity_between(ProxyPair pair, const Contact<Scalar>& contact) const;
  bool is_due(ProxyPair pair);
  void answer_ties(ProxyPair last);
  void pass_on();
  void leave_share(std::size_t a, std::size_t b, const SeparationOptions<Scalar>& options,
                   Scalar shift, Scalar& soft_A, Scalar& soft_B) const;
  bool stays_deep(const Contact<Scalar>& contact, const Separation<Scalar>& made,
                  Scalar margin) const;
  SeparationOptions<Scalar> separation_options(Scalar margin, bool is_charged) const;
  void separate_pair(ProxyPair pair, const PairQuery& query, const Contact<Scalar>& contact,
                     const Answer<Scalar>& result, bool is_resting);
  void apply_separation_time(ProxyPair pair, const Contact<Scalar>& contact,
                             const Separation<Scalar>& made, Scalar distance);
  bool rests(ProxyPair pair) const;
  bool holds_one(ProxyPair pair) const;
  void hold(ProxyPair pair, Scalar until);
  void stop_both(ProxyPair pair);
  Scalar room_of(std::size_t slot, ProxyPair pair, const Vec3<Scalar>& away_W, Scalar shift) const;
  void tell_controllers(ProxyPair pair, const Contact<Scalar>& contact,
                        const Answer<Scalar>& result, const Separation<Scalar>& made);

  BodiesT bodies_;
  PairsT pairs_;
  Touches<SceneT> touches_;
  std::conditional_t<kSolves, ContactGroups<SceneT>, NoCollaborator<0>> groups_;
  std::conditional_t<SceneT::kSleep, Sleep<SceneT>, NoCollaborator<1>> sleep_;
  /// Where contacts last: those that were answered in this round.
  std::conditional_t<kSolves, FixedList<StruckPair<Scalar>, kTies>, NoCollaborator<2>> struck_;
  bool is_begin_ = false;  ///< nobody is planned in this step yet
  bool is_moved_ = false;  ///< where contacts last: the last one answered was moved apart
  std::uint16_t answers_of_pair_ = 0;  ///< where contacts last: of the pair that is answered
  int contacts_answered_ = 0;
  int cuts_made_ = 0;  ///< before contacts
};

}  // namespace batuta::detail

#include "batuta/world/detail/general_contact.hpp"
#include "batuta/world/detail/general_step.hpp"
#include "batuta/world/detail/general_ties.hpp"
