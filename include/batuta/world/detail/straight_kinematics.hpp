// SPDX-License-Identifier: MIT
#pragma once
// Bodies that do not turn, as a World handles them (without SceneOptions::rotation): the members of
// TurningKinematics, for balls or capsules that fly straight by their momenta.

#include "batuta/detection/sphere_flight.hpp"
#include "batuta/detection/straight_pair.hpp"
#include "batuta/world/detail/turning_kinematics.hpp"

namespace batuta::detail {

/// Roundings in the velocity of a pair of which one or both are carried.
inline constexpr int kLoadRoundings = 16;

/// What an impulse that presses on who is carried takes of his support, as a share of that; 0 where
/// it presses off the support, or nothing is known of it.
template <class Scalar>
Scalar along_support(const Vec3<Scalar>& impulse_W, const Vec3<Scalar>& support_W) {
  const Scalar square = support_W.dot(support_W);
  const Scalar along = impulse_W.dot(support_W);
  return square > Scalar(0) && along > Scalar(0) ? along / square : Scalar(0);
}
/// The part of an impulse that presses on who is carried which its support does not take: what lies
/// across that, or all where it presses off the support; none where nothing is known of that.
template <class Scalar>
Vec3<Scalar> across_support(const Vec3<Scalar>& impulse_W, const Vec3<Scalar>& support_W) {
  const Scalar square = support_W.dot(support_W);
  const Scalar along = impulse_W.dot(support_W);
  if (!(square > Scalar(0))) return zero<Scalar>();
  return along > Scalar(0) ? Vec3<Scalar>(impulse_W - (along / square) * support_W) : impulse_W;
}

template <class SceneT>
struct StraightKinematics {
  using Scalar = typename SceneT::Scalar;
  using Search = typename SceneT::Search;
  using BodyType = StraightBody<Scalar>;
  using MotionType = StraightMotion<Scalar>;
  using ActorType = Actor<SceneT>;
  using GroupType = StraightGroup<Scalar>;
  static constexpr bool kBalls = Search::kForSpheres;

  struct PlanType {
    MotionType motion;
    static constexpr bool by_momentum = true;
  };
  struct StraightQuery {
    static constexpr bool is_early = false;  // see TurningQuery
    Outcome outcome_ = Outcome::kInvalid;
    Scalar t_free_ = 0;
    Scalar t_hit_ = 0;
    std::uint32_t evaluations_ = 0;
    Scalar gap_ = 0;

    Outcome outcome() const { return outcome_; }
    Scalar t_free() const { return t_free_; }
    /// From when on the two are within twice of what counts as contact: they come as far before
    /// t_free as they go after it until they touch.
    Scalar near_after() const { return t_free_ - (t_hit_ - t_free_); }
    std::uint32_t evaluations() const { return evaluations_; }
    /// At the start, m, of two that touch; above zero of others.
    Scalar gap() const { return gap_; }
  };
  using PairQuery = StraightQuery;
  struct Mover {
    const ActorType* actor = nullptr;
    int part = 0;
    MotionType motion;
  };

  static bool is_usable(const BodyType& body) {
    Scalar zero = body.inverse_mass - body.inverse_mass;
    for (int i = 0; i < 3; ++i) {  // Bound: 3
      zero += (body.p_W[i] - body.p_W[i]) + (body.momentum_W[i] - body.momentum_W[i]);
    }
    return zero == Scalar(0) && body.inverse_mass >= Scalar(0);  // NaN where one is not finite
  }
  static bool is_addable(const BodyType& body) {
    return is_inverse(body.inverse_mass) && is_usable(body);
  }
  static void make_unit(const BodyType& /*body*/) {}
  static bool may_turn(const BodyType& /*body*/) { return true; }
  static bool may_come(const ActorType& /*actor*/) { return true; }
  static void prepare(const ActorType& /*actor*/, BodyType& /*body*/) {}
  static void ask(const ActorType& actor, Scalar /*t*/, Scalar duration, PlanType& plan) {
    plan.motion = {actor.body.p_W, velocity_of(actor.body), duration};
  }
  static MotionType standing(const BodyType& body, Scalar duration) {
    return {body.p_W, Vec3<Scalar>::Zero(), duration};
  }
  static bool is_immovable(const BodyType& body) { return body.inverse_mass == Scalar(0); }
  static void drop_held(BodyType&) {}
  static bool is_still(const MotionType& motion) { return is_zero(motion.v_W); }
  static bool is_at_start(const BodyType& body, const MotionType& motion) {
    return is_same(body.p_W, motion.p_W);
  }
  static void move(BodyType& body, const MotionType& motion, Scalar t) {
    body.p_W = position_at(motion, t);
  }
  static void skip(MotionType& motion, Scalar t, Scalar duration) {
    motion.p_W = position_at(motion, t);
    motion.duration = duration;
  }
  static void restart(MotionType& motion, const BodyType& body, Scalar duration) {
    motion.p_W = body.p_W;
    motion.duration = duration;
  }
  static MotionType standing_at(const Vec3<Scalar>& center_W, Scalar duration) {
    return {center_W, Vec3<Scalar>::Zero(), duration};
  }
  static MotionType turned_about(const BodyType& leader, const MotionType& motion,
                                 Scalar duration) {
    return {leader.p_W, motion.v_W, duration};
  }
  static MotionType seat(const MotionType& group, const BodyType& body) {
    return {body.p_W, group.v_W, group.duration};
  }
  static const Vec3<Scalar>& velocity(const MotionType& motion) { return motion.v_W; }
  static void set_velocity(MotionType& motion, const Vec3<Scalar>& v_W) { motion.v_W = v_W; }
  static void add_velocity(Vec3<Scalar>& v_W, const Vec3<Scalar>& change_W) { v_W += change_W; }
  static void add_momentum(BodyType& body, const Vec3<Scalar>& change_W) {
    body.momentum_W += change_W;
  }
  static Vec3<Scalar> momentum_velocity(const BodyType& body) { return velocity_of(body); }
  static Vec3<Scalar> twist_at(const BodyType& body, const PlanType& /*plan*/) {
    return velocity_of(body);
  }

  static Mover mover(const ActorType& actor, int part, const MotionType& motion) {
    return {&actor, part, motion};
  }
  /// Each has its own place, and all the same velocity.
  static void put_in_group(Mover& /*mover*/, const ActorType& /*actor*/,
                           const MotionType& /*whole*/) {}
  static Aabb<Scalar> bound(const Mover& mover) {
    if constexpr (kBalls) {
      return sphere_aabb(mover.motion, mover.actor->radius);
    } else {
      return straight_aabb(part_of(*mover.actor, mover.part), mover.motion);
    }
  }

  /// What the components of velocities may be rounded by depends on, m/s: their sizes, added up.
  static Scalar pace_of(const Mover& mover) {
    const StraightBody<Scalar>& body = mover.actor->body;
    Scalar pace = 0;
    for (int i = 0; i < 3; ++i) {  // Bound: 3
      pace += std::abs(mover.motion.v_W[i]);
      // Gravity is what a course is off the momentum.
      if constexpr (SceneT::kGravity) pace += std::abs(body.inverse_mass * body.momentum_W[i]);
    }
    return pace;
  }
  /// How far two that touch may come closer and count as parting, m: what rounding makes of their
  /// velocities, and no more than half of their gap. Convex bodies that do not turn have a distance
  /// that is a convex function of time: the other half is left (world.md, "Touching and parting").
  /// @param way  of both together, m
  static Scalar slack(Scalar gap, Scalar way) {
    constexpr Scalar kRoundings = 16;  // seven of the search, nine of the blow before it
    const Scalar noise = kRoundings * kRoundOff<Scalar> * way;
    return max_of(min_of(noise, gap / 2), Scalar(0));
  }

  /// As search(), for balls.
  /// @param pace  of both, m/s
  static StraightQuery search_flight(const SphereFlight<Scalar>& flight, Scalar pace,
                                     const typename Search::Options& options) {
    const SphereResult<Scalar> resolution = Search::search(flight, options);
    // The way along the line of centres is `closing` by their distance, which is more than `radii`
    // where the gap is above zero.
    const Scalar most = slack(resolution.gap, pace * flight.duration) * flight.radii;
    const bool parts = resolution.outcome == Outcome::kTouching && !(resolution.closing > most);
    return {parts ? Outcome::kFree : resolution.outcome, resolution.t_free, resolution.t_hit, 1,
            resolution.gap};
  }
  /// Bodies that touch and part never meet, however near they are or deep in each other.
  static StraightQuery search(const Mover& A, const Mover& B,
                              const typename Search::Options& options) {
    const Scalar duration = A.motion.duration;
    const Scalar pace = pace_of(A) + pace_of(B);
    if constexpr (kBalls) {
      const SphereFlight<Scalar> flight = {B.motion.p_W - A.motion.p_W, B.motion.v_W - A.motion.v_W,
                                           A.actor->radius + B.actor->radius, duration};
      return search_flight(flight, pace, options);
    } else {
      const auto pair = make_straight_pair(part_of(*A.actor, A.part), A.motion,
                                           part_of(*B.actor, B.part), B.motion);
      if (!pair.ok()) return {};
      const SearchResult<Scalar> result =
          Search::search(pair.value, options, Vec3<Scalar>::Zero().eval());
      const Scalar gap = result.witness.gap;
      const Scalar most = slack(gap, pace * duration);
      const bool parts =
          result.outcome == Outcome::kTouching && !(-result.gap_rate * duration > most);
      return {parts ? Outcome::kFree : result.outcome, result.t_free, result.t_hit,
              result.evaluations, gap};
    }
  }

  /// The contact normal of two of one part each: all that a blow asks for. Of balls that approach
  /// and so have their centres apart.
  static Vec3<Scalar> normal_BA(const ActorType& A, const ActorType& B) {
    if constexpr (kBalls) {
      Vec3<Scalar> normal_W;
      Scalar square = 0;
      for (int i = 0; i < 3; ++i) {  // Bound: 3; by component: expressions double the code
        normal_W[i] = A.body.p_W[i] - B.body.p_W[i];
        square += normal_W[i] * normal_W[i];
      }
      const Scalar distance = std::sqrt(square);
      for (int i = 0; i < 3; ++i) normal_W[i] /= distance;  // Bound: 3
      return normal_W;
    } else {
      return nearest(A, 0, B, 0).contact.normal_BA_W;
    }
  }

  static Nearest<Scalar> nearest(const ActorType& A, int part_A, const ActorType& B, int part_B) {
    if constexpr (kBalls) {
      const Vec3<Scalar> to_A = A.body.p_W - B.body.p_W;
      const Scalar distance = to_A.norm();
      Nearest<Scalar> nearest;
      if (distance > Scalar(0)) nearest.contact.normal_BA_W = to_A / distance;
      nearest.contact.gap = distance - (A.radius + B.radius);
      nearest.contact.point_W =
          B.body.p_W + (B.radius + nearest.contact.gap / 2) * nearest.contact.normal_BA_W;
      return nearest;
    } else {
      const CapsuleGap<Scalar> gap = capsule_gap(shifted(part_of(A, part_A), A.body.p_W),
                                                 shifted(part_of(B, part_B), B.body.p_W));
      return {contact_from(gap, Vec3<Scalar>::Zero().eval()), gap.axes.s, gap.axes.u};
    }
  }

 private:
  static Capsule<Scalar> shifted(const Capsule<Scalar>& capsule_B, const Vec3<Scalar>& p_W) {
    return {{p_W + capsule_B.axis.a, p_W + capsule_B.axis.b}, capsule_B.radius};
  }
};

}  // namespace batuta::detail
