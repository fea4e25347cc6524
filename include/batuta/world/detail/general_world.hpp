// SPDX-License-Identifier: MIT
#pragma once
// Many bodies, one step: everybody moves to the first contact, the contact is resolved, and so on
// to the end of the step [Kavan §2.1, §3, §4.2]. Only the bodies of a contact are planned, bounded
// and searched anew; the others keep their planned motions (src/world/world.md). One object, placed
// by the caller; its size and the longest step are constants. Frame W, SI units; times within a
// step run from 0 to dt.

#include "batuta/core/arithmetic.hpp"
#include "batuta/core/pool.hpp"
#include "batuta/response/friction.hpp"
#include "batuta/response/line_contact.hpp"
#include "batuta/response/straight_impulse.hpp"
#include "batuta/world/detail/candidate_pair.hpp"
#include "batuta/world/detail/event_book.hpp"
#include "batuta/world/detail/resolution.hpp"
#include "batuta/world/detail/seed_memory.hpp"
#include "batuta/world/detail/sleep_book.hpp"
#include "batuta/world/detail/straight_kinematics.hpp"
#include "batuta/world/detail/sweep.hpp"
#include "batuta/world/detail/turning_kinematics.hpp"

namespace batuta::detail {

/// The scalar of a scene.
template <class SceneT>
using Scalar_of = typename SceneT::Scalar;
/// What bodies of a scene are made of: turning or straight.
template <class SceneT>
using KinematicsOf =
    std::conditional_t<SceneT::kRotation, TurningKinematics<SceneT>, StraightKinematics<SceneT>>;

/// Features are bases, not members: an empty one takes no room.
template <class SceneT>
class GeneralWorld : private SeedsOf<SceneT>,
                     private EventsOf<SceneT>,
                     private RepeatsOf<SceneT>,
                     private SleepOf<SceneT> {
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

  /// Rounds of one step: each ends with a contact (kMaxContacts), with the end of the hold that a
  /// contact caused (kMaxContacts), with a body held for good (kMaxBodies; where nobody is held,
  /// with a pair that is left: kMaxPairs), or with the step (1).
  static constexpr int kMaxRounds =
      2 * SceneT::kMaxContacts + max_of(SceneT::kMaxBodies, SceneT::kMaxPairs) + 1;
  /// Most pairs searched in one round.
  static constexpr int kPairsPerRound = SceneT::kMaxPairs;

  /// @param number  tells this world's ids from those of another world of the same scene
  /// @pre the file that names the scene, and the thread, round every operation
  ///   (core/arithmetic.hpp): contracted or flushed arithmetic voids what the searches prove
  explicit GeneralWorld(std::uint16_t number = 0) : actors_(number) {
    BATUTA_ASSERT(rounds_each_operation<Scalar>());
  }

  /// Sets the tolerances, from the next step on.
  /// @returns kOk | kInvalidArgument (an option out of range; the settings stay as they were)
  Status configure(const WorldSettings<SceneT>& settings) {
    const Status status = validate(settings);
    if (status == Status::kOk) settings_ = settings;
    return status;
  }
  /// What configure() was given, or the scene's own.
  const WorldSettings<SceneT>& settings() const { return settings_; }

  /// Becomes a copy of `saved`, and goes on as that would, to the last bit; ids of one name the
  /// bodies of the other. By name, because a world is large. Bound: kMaxBodies.
  void restore(const GeneralWorld& saved);

  /// Puts a body into the world, in the lowest free slot.
  /// @returns kOk with the id | kPoolFull | kInvalidArgument (not finite, negative radius, no part,
  /// C outside [0, 1], mu negative, or so far from the origin that numbers there are further apart
  /// than the body is large)
  Result<BodyId> add(const ActorType& actor);

  /// Takes a body out; its contacts end without an event. @returns kOk | kStaleHandle
  Status remove(BodyId id);

  /// The body, or null for a stale, foreign or null id.
  /// Who may be changed is looked at again: what only reads, reads a const world.
  ActorType* get(BodyId id) {
    const int slot = actors_.index_of(id);
    if (slot != PoolBase::kNoIndex) states_[static_cast<std::size_t>(slot)].boxed = false;
    return actors_.get(id);
  }
  /// The body to read, or null for a stale, foreign or null id.
  const ActorType* get(BodyId id) const { return actors_.get(id); }
  /// The id of the body in a slot, as events name it; null id if there is none.
  BodyId id_at(std::uint16_t slot) const { return actors_.handle_at(slot); }
  /// Bodies in the world.
  int size() const { return actors_.size(); }

  /// Moves everything by dt. After it, report() and events() tell what happened.
  /// @pre dt > 0 and finite
  /// @returns kOk (also where report().complete() is false: nothing was missed, bodies were held) |
  ///   kInvalidArgument (dt); then nothing has changed
  /// Bound: kMaxRounds rounds of at most kMaxPairs searches of at most kBudget evaluations.
  Status step(Scalar dt);

  /// What the last step did, and what it left out.
  const StepReport<Scalar>& report() const { return report_; }
  /// What happened in the step. Where SceneOptions::max_events is 0, there are none to ask for.
  const EventList& events() const {
    static_assert(SceneT::kMaxEvents > 0, "Scene: events() takes max_events > 0");
    return this->list();
  }
  /// Whether the body sleeps (SceneOptions::sleep); false for a stale id.
  bool is_asleep(BodyId id) const {
    const int slot = actors_.index_of(id);
    return slot != PoolBase::kNoIndex && this->sleeps(static_cast<std::size_t>(slot));
  }

  /// Lists what is saved of a world (record/archive.hpp).
  template <class Archive>
  void archive(Archive& ar);

 private:
  using Kinematics = KinematicsOf<SceneT>;
  using Motion = typename Kinematics::MotionType;
  using PairQuery = typename Kinematics::PairQuery;
  using Slot = std::uint16_t;
  using CandidateType = CandidatePair<Scalar>;
  static constexpr std::size_t kSlots = static_cast<std::size_t>(SceneT::kMaxBodies);
  static constexpr int kParts = SceneT::kCapsulesPerBody;
  static constexpr int kProxies = SceneT::kMaxBodies * kParts;
  /// There may be more pairs than candidates.
  static constexpr bool kCanOverflow = SceneT::kMaxPairs < kProxies * (kProxies - 1) / 2;
  static constexpr bool kSettles = SceneT::kResting == RestingContact::kSettling;
  /// Bodies are held for a time that ends within the step.
  static constexpr bool kReleases = SceneT::kResting == RestingContact::kSeparation;
  /// What has no mass to be pushed by may be led into something (see MovesByMomentumOnly).
  static constexpr bool kLeads =
      SceneT::kRotation && !MovesByMomentumOnly<typename SceneT::Controller>::value;

  /// What the step knows of a body besides the actor.
  struct BodyState {
    typename Kinematics::PlanType plan;
    Scalar start = 0;       ///< in the step, s: the body's own pose is the one of this time
    Scalar held_until = 0;  ///< in the step, s; the body stays where it is until then
    bool present = false;   ///< takes part in the step
    bool changed = false;   ///< it has to be planned anew
    bool fresh = false;     ///< it was planned, its pairs are not collected yet
    bool stands = false;    ///< it was planned to stand still for a whole step, and did
    bool falls = false;     ///< was given its fall of this step
    bool boxed = false;     ///< its boxes are those of its planned motion
  };

  // Plan: general_plan.hpp.
  static bool is_usable(const ActorType& actor) {
    return has_valid_features(actor) && Kinematics::is_usable(actor.body);
  }
  void begin_step(Scalar dt);
  void begin_body(std::size_t slot);
  bool is_disturbed(std::size_t slot) const;
  void refresh();
  void drop_candidates();
  void plan(std::size_t slot, bool is_begin);
  /// Kept apart: what it needs of the stack is free again while pairs are searched.
  [[gnu::noinline]] bool plan_motion(std::size_t slot, bool is_begin);
  void fall(std::size_t slot, Scalar time);
  void leave_out(std::size_t slot);
  void put_boxes(std::size_t slot, bool idle);
  void collect_all();
  void collect_fresh();
  void collect(ProxyPair pair);
  bool may_pair(std::size_t a, std::size_t b) const;
  void search_candidates();
  void search(CandidateType& candidate);
  void search_pair(ProxyPair pair, Scalar until, PairQuery& query);
  SearchResult<Scalar> search_with_seed(ProxyPair pair, const MovingPair<Scalar>& moving_pair);
  bool may_part(ProxyPair pair, const PairQuery& query) const;
  SearchResult<Scalar> search_thinner(const MovingPair<Scalar>& moving_pair, const PairQuery& query,
                                      ProxyPair pair) const;

  // Step: general_step.hpp.
  void begin_life(std::size_t slot);
  void run_round();
  Scalar next_release() const;
  void release(Scalar time);
  void resolve(const CandidateType& candidate, Scalar time);
  PairQuery& seen(ProxyPair pair, bool is_known);
  void advance_to_contact(const CandidateType& candidate, std::size_t slot, bool is_own_time);
  void count_cut(const CandidateType& candidate);
  void advance(std::size_t slot, Scalar elapsed);
  void hold(std::size_t slot, Scalar until);
  void hold_pair(ProxyPair pair, Scalar until);
  void end_step();

  // Contact: general_contact.hpp.
  void look(ProxyPair pair, PairQuery& query);
  void resolve_turning(const CandidateType& candidate, const PairQuery& query);
  void resolve_straight(const CandidateType& candidate);
  void report_only(const CandidateType& candidate);
  bool is_immovable(ProxyPair pair) const;
  void block(const CandidateType& candidate, const PairQuery& query,
             const Nearest<Scalar>& nearest);
  Result<Impulse<Scalar>> impulse_for(ProxyPair pair,
                                      const std::array<ContactSide<Scalar>, 2>& sides,
                                      const Contact<Scalar>& contact, bool is_last) const;
  bool uses_up_resolutions(ProxyPair pair);
  static Scalar opened(const Resolution<Scalar>& resolution);
  void apply_separation_time(ProxyPair pair, const Resolution<Scalar>& resolution, bool freezes);
  void stop_pair(ProxyPair pair);
  ResolutionOptions<Scalar> options_for(Scalar margin) const;
  Scalar margin_of(const PairQuery& query, ProxyPair pair) const;
  ContactSide<Scalar> side(std::size_t slot);
  Contact<Scalar> pressed(ProxyPair pair, const std::array<ContactSide<Scalar>, 2>& sides,
                          const Contact<Scalar>& contact, Scalar slack) const;
  void make_room(ProxyPair pair, const Contact<Scalar>& contact,
                 const ResolutionOptions<Scalar>& options,
                 std::array<ContactSide<Scalar>, 2>& sides) const;
  Scalar room_of(std::size_t slot, std::size_t other, const Vec3<Scalar>& away_W,
                 Scalar shift) const;
  Capsule<Scalar> shape_W(int proxy) const;
  void notify_controller(std::size_t slot, const Resolution<Scalar>& resolution,
                         const Vec3<Scalar>& shift_W);

  // Events: general_events.hpp.
  void record(const CandidateType& candidate, const Nearest<Scalar>& nearest,
              const Resolution<Scalar>& resolution);
  ContactEvent<Scalar> event_of(ProxyPair pair, const Nearest<Scalar>& nearest) const;
  void end_touches();
  void wake_both(ProxyPair pair);
  void take_stand(std::size_t slot, bool stands);
  template <class Archive>
  void check_touches(Archive& ar);
  bool has_part(int proxy) const {
    return is_present(body_of(proxy)) && part_at(proxy) < parts_of(actor_at(body_of(proxy)));
  }
  void put_to_sleep();
  bool has_left(std::size_t slot) const;
  bool is_supported(std::size_t slot) const;
  bool is_slow(std::size_t slot) const;

  ActorType& actor_at(std::size_t slot) { return actors_.at(slot); }
  const ActorType& actor_at(std::size_t slot) const { return actors_.at(slot); }
  bool is_present(std::size_t slot) const { return actors_.at_index(slot) != nullptr; }
  bool is_held(std::size_t slot) const { return states_[slot].held_until > now_; }
  Scalar end_of(std::size_t slot) const { return is_held(slot) ? states_[slot].held_until : dt_; }
  static std::size_t body_of(int proxy) { return static_cast<std::size_t>(proxy / kParts); }
  static int part_at(int proxy) { return proxy % kParts; }
  static Slot proxy_of(std::size_t slot, int part) {
    return static_cast<Slot>(static_cast<int>(slot) * kParts + part);
  }
  typename Kinematics::Mover mover(int proxy, Scalar until) const;
  Nearest<Scalar> nearest(ProxyPair pair) const {
    return Kinematics::nearest(actor_at(body_of(pair.first)), part_at(pair.first),
                               actor_at(body_of(pair.second)), part_at(pair.second));
  }

  WorldSettings<SceneT> settings_;
  Pool<ActorType, SceneT::kMaxBodies> actors_;
  std::array<BodyState, kSlots> states_{};
  SweepList<Scalar, kProxies, SceneT::kSweepAxis> sweep_;
  FixedList<CandidateType, SceneT::kMaxPairs> candidates_;
  EarliestQuery<PairQuery, Scalar, (SceneT::kMaxPairs > 1)> queries_;
  StepReport<Scalar> report_;
  Scalar now_ = 0;  ///< in the step, s
  Scalar dt_ = 0;   ///< length of the step, s
  /// What counts as rest in this step, m/s.
  Scalar rest_speed_ = 0;
  int contacts_resolved_ = 0;
  bool is_begin_ = false;    ///< nobody is planned in this step yet
  bool is_changed_ = false;  ///< somebody has to be planned anew
};

}  // namespace batuta::detail

#include "batuta/world/detail/general_contact.hpp"
#include "batuta/world/detail/general_events.hpp"
#include "batuta/world/detail/general_plan.hpp"
#include "batuta/world/detail/general_step.hpp"
