// SPDX-License-Identifier: MIT
#pragma once
// Bodies that turn, as a World handles them (SceneOptions::rotation). StraightKinematics
// (straight_kinematics.hpp) has the same members for bodies that do not.

#include "batuta/response/contact.hpp"
#include "batuta/world/actor.hpp"
#include "batuta/world/detail/group_motion.hpp"

namespace batuta::detail {

/// Where two parts are nearest to each other.
template <class Scalar>
struct Nearest {
  Contact<Scalar> contact;
  Scalar place_A = 0;  ///< on A's axis: 0 at axis.a ... 1 at axis.b
  Scalar place_B = 0;
};

template <class SceneT>
struct TurningKinematics {
  using Scalar = typename SceneT::Scalar;
  using Search = typename SceneT::Search;
  using BodyType = Body<Scalar>;
  using MotionType = Motion<Scalar>;
  using PlanType = PlannedMotion<Scalar>;
  using ActorType = Actor<SceneT>;
  using GroupType = RigidGroup<Scalar>;

  /// What a search saw of a pair.
  struct TurningQuery {
    SearchResult<Scalar> search;
    Vec3<Scalar> origin_W = zero<Scalar>();
    Scalar scale = 0;        ///< S of the pair, m
    Scalar contact_gap = 0;  ///< the search may speak of contact up to this gap, m
    bool is_early = false;   ///< t_free is before the time of what it saw

    Outcome outcome() const { return search.outcome; }
    Scalar t_free() const { return search.t_free; }
    /// From when on the two are within twice of what counts as contact, to first order.
    Scalar near_after() const {
      const bool closes = search.gap_rate < Scalar(0);
      return closes ? search.t_free + contact_gap / search.gap_rate : search.t_free;
    }
    std::uint32_t evaluations() const { return search.evaluations; }
  };
  using PairQuery = TurningQuery;
  /// One side of a pair: a part and how it moves from now on.
  using Mover = MovingCapsule<Scalar>;

  /// Kept apart: some calls, and no copies.
  [[gnu::noinline]] static bool is_usable(const BodyType& body) {
    const Scalar pose = nan_unless_finite(body.X_WB.p_W) + nan_unless_finite(body.X_WB.q_WB);
    const Scalar momenta =
        nan_unless_finite(body.momentum.linear_W) + nan_unless_finite(body.momentum.angular_W);
    const Scalar moments = nan_unless_finite(body.inverse_moments);
    return is_finite(body.inverse_mass) && body.inverse_mass >= Scalar(0) &&
           pose + momenta + moments == Scalar(0) && body.inverse_moments.x() >= Scalar(0) &&
           body.inverse_moments.y() >= Scalar(0) && body.inverse_moments.z() >= Scalar(0);
  }
  /// What a caller has put in place of its orientation may be off unit length by more than
  /// rounding: no search knows of a capsule that a turn makes longer.
  static void make_unit(BodyType& body) {
    const Scalar off = off_unit(body.X_WB.q_WB);
    if (off > kUnitRounding<Scalar> && off <= kUnitWithin<Scalar>) {
      body.X_WB.q_WB = renewed(body.X_WB.q_WB);
    }
  }
  /// Whether the scene has what its turn asks for.
  static bool may_turn(const BodyType& body) { return SceneT::kBentTurns || !flies_bent(body); }
  /// The same of one that comes new: an orientation that is one, and masses that are finite.
  [[gnu::cold]] static bool is_addable(const BodyType& body) {
    bool has_inverses = is_inverse(body.inverse_mass);
    for (int i = 0; i < 3; ++i) {  // Bound: 3
      has_inverses = has_inverses && is_inverse(body.inverse_moments[i]);
    }
    return points(body.X_WB.q_WB) && has_inverses && is_usable(body);
  }
  /// Whether one that comes new may turn as it will.
  [[gnu::cold]] static bool may_come([[maybe_unused]] const ActorType& actor) {
    if constexpr (SceneT::kBentTurns) return true;
    BodyType body = actor.body;
    prepare(actor, body);
    return may_turn(body);
  }
  /// The body of an actor as the caller gave it, made ready. Bound: the parts.
  static void prepare(const ActorType& actor, BodyType& body) {
    body.X_WB.q_WB = renewed(body.X_WB.q_WB);
    body.spin_shows = false;
    for (int i = 0; i < parts_of(actor); ++i) {  // Bound: kCapsulesPerBody
      body.spin_shows = body.spin_shows || !hides_spin(body, part_of(actor, i));
    }
  }
  /// No valid one where the caller, or bytes that were restored, spoiled the orientation: a
  /// controller may take it for one.
  static void ask(const ActorType& actor, Scalar t, Scalar duration, PlanType& plan) {
    if (is_turn(actor.body.X_WB.q_WB)) {
      plan = planned(actor, t, duration);
    } else {
      plan.by_momentum = false;
      plan.motion.duration = std::numeric_limits<Scalar>::quiet_NaN();
    }
  }
  /// What the controller says. Who flies by its momenta does so without the code of bent flights
  /// where the scene has none.
  static PlanType planned(const ActorType& actor, [[maybe_unused]] Scalar t, Scalar duration) {
    constexpr bool kFlies = std::is_same_v<typename SceneT::Controller, FreeFlight<Scalar>>;
    if constexpr (kFlies && !SceneT::kBentTurns) {
      return {steady_flight(actor.body, duration), true};
    } else {
      return actor.controller.plan(actor.body, t, duration);
    }
  }
  static MotionType standing(const BodyType& body, Scalar duration) {
    return still(body.X_WB, duration);
  }
  static bool is_immovable(const BodyType& body) { return is_fixed(body); }
  /// What a bearing has taken is none of the body's.
  static void drop_held(BodyType& body) {
    if (body.inverse_mass == Scalar(0) && !is_fixed(body)) detail::drop_held(body);
  }
  [[gnu::noinline]] static bool is_still(const MotionType& motion) {
    return is_zero(motion.twist.v_W) && is_zero(motion.twist.w_W);
  }
  /// Whether the body is where the motion begins.
  static bool is_at_start(const BodyType& body, const MotionType& motion) {
    return is_same(body.X_WB.p_W, motion.X_WB.p_W) && is_same(body.X_WB.q_WB, motion.X_WB.q_WB);
  }
  static void move(BodyType& body, const MotionType& motion, Scalar t) {
    if constexpr (SceneT::kBentTurns) {
      move_along(body, motion, t);
    } else {
      body.X_WB = pose_at(motion, t);
    }
  }
  /// What is left of a motion after t of it. @pre t <= duration
  static void skip(MotionType& motion, Scalar t, Scalar duration) {
    if (t > Scalar(0)) motion.X_WB = pose_at(motion, t);
    motion.duration = duration;
  }
  /// The motion goes on from where the body is now.
  static void restart(MotionType& motion, const BodyType& body, Scalar duration) {
    motion.X_WB = body.X_WB;
    motion.duration = duration;
  }
  /// How a body that its momenta move would go if nothing touched it, to first order.
  static MotionType free_motion(const BodyType& body, Scalar duration) {
    return {body.X_WB, twist_of(body), duration};
  }
  static const Vec3<Scalar>& velocity(const MotionType& motion) { return motion.twist.v_W; }
  static void set_velocity(MotionType& motion, const Vec3<Scalar>& v_W) { motion.twist.v_W = v_W; }
  static void add_velocity(Twist<Scalar>& twist, const Vec3<Scalar>& change_W) {
    twist.v_W += change_W;
  }
  static void add_momentum(BodyType& body, const Vec3<Scalar>& change_W) {
    body.momentum.linear_W += change_W;
  }
  static Vec3<Scalar> momentum_velocity(const BodyType& body) { return velocity_of(body); }
  static MotionType standing_at(const Vec3<Scalar>& center_W, Scalar duration) {
    return still<Scalar>({center_W, Quat<Scalar>(1, 0, 0, 0)}, duration);
  }
  /// The motion of what a body takes along.
  static MotionType turned_about(const BodyType& leader, const MotionType& motion,
                                 Scalar duration) {
    return {{leader.X_WB.p_W, Quat<Scalar>(1, 0, 0, 0)}, motion.twist, duration};
  }
  /// The motion of a group for one of its bodies.
  static const MotionType& seat(const MotionType& group, const BodyType& /*body*/) { return group; }
  /// Of its matter.
  static Twist<Scalar> twist_at(const BodyType& body, const PlanType& plan) {
    return plan.by_momentum ? twist_of(body) : plan.motion.twist;
  }

  static Mover mover(const ActorType& actor, int part, const MotionType& motion) {
    return {part_of(actor, part), motion};
  }
  /// Of a body in a group, whose frame is at the group's centre with axes of W when it was made.
  /// @param whole  the motion of the group from then on; the body is where it was then
  static void put_in_group(Mover& mover, const ActorType& actor, const MotionType& whole) {
    const Pose<Scalar>& X_WB = actor.body.X_WB;
    const Pose<Scalar> X_GB = {X_WB.p_W - whole.X_WB.p_W, X_WB.q_WB};
    mover.capsule_B = to_world(X_GB, mover.capsule_B);
  }
  static Aabb<Scalar> bound(const Mover& mover) { return SceneT::Bound::of(mover); }

  static Nearest<Scalar> nearest(const ActorType& A, int part_A, const ActorType& B, int part_B) {
    const CapsuleGap<Scalar> gap = capsule_gap(to_world(A.body.X_WB, part_of(A, part_A)),
                                               to_world(B.body.X_WB, part_of(B, part_B)));
    return {contact_from(gap, zero<Scalar>()), gap.axes.s, gap.axes.u};
  }
};

}  // namespace batuta::detail
