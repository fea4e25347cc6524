// SPDX-License-Identifier: MIT
#pragma once
// The search by certified advancement, step by step. Derivation and proof: advancement.md.

#include "../geometry/scale_window.hpp"
#include "batuta/detection/advancement.hpp"
#include "same_features.hpp"
#include "spin_bound.hpp"
#include "tracking_normal.hpp"

namespace batuta {

/// A search under way, in units of the duration and of 1 / scale metres: the pair is proven free on
/// [0, theta].
template <class Scalar>
class Walk {
 public:
  Walk(const MovingPair<Scalar>& pair, Scalar scale, Scalar slab, Scalar inflation)
      : pair_(in_units(pair, scale)), radii_(pair_.A.radius + pair_.B.radius), slab_(slab * scale) {
    const Scalar travel = length(pair_.B.v);
    state_.bounds = derivative_bounds(pair_, travel, arm(pair_.A), arm(pair_.B));
    state_.magnitudes = derivative_bounds(pair_, travel, pair_.A.reach, pair_.B.reach);
    state_.turn = pair_.A.turn_rate + pair_.B.turn_rate;
    state_.inflation = inflation;
    settle();
  }

  bool is_at_end() const { return theta_ >= Scalar(1); }
  Scalar theta() const { return theta_; }

  ClosestPoints<Scalar> closest() const {
    return closest_points<Scalar>(axis(state_.A), axis(state_.B));
  }
  Scalar gap(const ClosestPoints<Scalar>& closest) const { return closest.distance - radii_; }
  bool is_contact(const ClosestPoints<Scalar>& closest) const { return !(gap(closest) > slab_); }

  /// From twice the middle of A's axis to twice that of B's.
  Vec3<Scalar> line_of_middles() const {
    const auto sum = [](const AxisState<Scalar>& axis) {
      return Vec3<Scalar>(axis.ends[0].p + axis.ends[1].p);
    };
    return sum(state_.B) - sum(state_.A);
  }

  /// Advances while n, held fixed, proves a gap of more than the slab, without a distance
  /// evaluation. @pre n is a unit vector, or zero
  void advance_along(const Vec3<Scalar>& n) {
    advance(step_along(n, heights(n, state_), radii_ + slab_));
  }

  /// Advances as far as the normal of `closest` proves: held fixed or, where that does not reach
  /// the end, moved along, whichever proves more. @pre `closest` is of this instant, no contact
  void advance_from(const ClosestPoints<Scalar>& closest) {
    const EdgePair<Scalar> edges(closest, state_.A.direction(), state_.B.direction());
    features_ = {edges.on_A, edges.on_B, closest.s, closest.u};
    const Vec3<Scalar> n = sharpened(closest.normal_AB, edges);
    const Heights<Scalar> fixed = heights(n, state_);
    Scalar step = max_of(sure_step(gap(closest)), step_along(n, fixed, radii_));
    if (theta_ + step < Scalar(1)) {
      const NormalPath<Scalar> N =
          tracking_path(n, edges, state_, relative_rate(closest, state_), closest.distance);
      if (can_be_followed(N)) step = max_of(step, step_along(N, fixed));
    }
    advance(step);
  }

  /// Points of the axes that are the closest ones here if the features of the last evaluation still
  /// are, and never closer.
  ClosestPoints<Scalar> seen_before() const {
    return on_same_features(features_, state_.A, state_.B);
  }

  /// d gap / d theta.
  Scalar rate(const ClosestPoints<Scalar>& closest) const {
    return closest.normal_AB.dot(relative_rate(closest, state_));
  }

  /// The foreseen instant of contact after theta.
  Scalar foreseen_contact(const ClosestPoints<Scalar>& closest) const {
    const Vec3<Scalar>& n = closest.normal_AB;
    const Vec3<Scalar> sideways = across(relative_rate(closest, state_), n);
    const Vec3<Scalar> relative_bend = state_.B.bend(closest.u) - state_.A.bend(closest.s);
    const Scalar bend = n.dot(relative_bend) + sideways.squaredNorm() / closest.distance;
    return min_of(Scalar(1), theta_ + time_to_contact(gap(closest), rate(closest), bend));
  }

 private:
  /// An upper bound of both arms; rounding has changed them by some u of the reach.
  static Scalar arm(const CapsulePath<Scalar>& path) {
    return path.longest_arm + kInflation<Scalar> * path.reach;
  }
  static Segment<Scalar> axis(const AxisState<Scalar>& state) {
    return {state.ends[0].p, state.ends[1].p};
  }

  /// How far the gap alone proves the pair free, as no two points are faster: little, but always
  /// something, whatever rounding has made of the normal.
  Scalar sure_step(Scalar gap) const {
    const Scalar sure = gap - state_.inflation * state_.magnitudes.length;
    const Scalar rest = 1 - theta_;
    if (sure >= state_.bounds.speed * rest) return rest;
    return kRoundDown<Scalar> * (sure / state_.bounds.speed);
  }

  /// How far n, held fixed, proves the axes further apart than R.
  Scalar step_along(const Vec3<Scalar>& n, const Heights<Scalar>& heights, Scalar R) const {
    const Scalar rest = 1 - theta_;
    const Scalar step = proven_free(clearances(heights, toll(state_, R)), horizon_of(state_, rest));
    const bool spins = state_.turn * rest > kHorizonTurn<Scalar>;
    if (!spins || !(step > Scalar(0))) return step;
    const Scalar least = R + state_.inflation * state_.magnitudes.length;
    return max_of(step, free_until_by_spin(pair_, n, least, theta_) - theta_);
  }

  /// How far N proves the pair free. @param fixed  the heights along N.n
  Scalar step_along(const NormalPath<Scalar>& N, const Heights<Scalar>& fixed) const {
    const Scalar horizon = horizon_of(state_, 1 - theta_);
    const Quartic<Scalar> off = toll(toll(state_, radii_), N, state_, radii_, horizon);
    return proven_free(clearances(moved(fixed, N, state_), off), horizon);
  }

  void advance(Scalar step) {
    if (!(step > Scalar(0))) return;  // nor if it is no number
    theta_ = min_of(Scalar(1), theta_ + step);
    if (!is_at_end()) settle();
  }

  void settle() {
    state_.A = state_at(pair_.A, theta_);
    state_.B = state_at(pair_.B, theta_);
  }

  MovingPair<Scalar> pair_;
  Scalar radii_;
  Scalar slab_;
  Scalar theta_ = 0;
  Features<Scalar> features_;  ///< of the last evaluation
  PairState<Scalar> state_;    ///< at theta
};

/// The unit vector along the seed or, where that has no direction, along the other; or zero.
template <class Scalar>
Vec3<Scalar> direction_of(const Vec3<Scalar>& seed, const Vec3<Scalar>& other) {
  const bool seeded = is_finite(seed) && largest_component(seed) > Scalar(0);
  const Vec3<Scalar>& line = seeded ? seed : other;
  return largest_component(line) > Scalar(0) ? unit(line) : line;
}

/// How a walk ended, and its last witness.
template <class Scalar>
struct WalkEnd {
  Outcome outcome = Outcome::kBudget;
  std::uint32_t evaluations = 0;
  Scalar theta = 0;  ///< of the witness
  Scalar rate = 0;   ///< there
  ClosestPoints<Scalar> closest;
};

template <class Scalar>
void set_witness(WalkEnd<Scalar>& end, const Walk<Scalar>& walk,
                 const ClosestPoints<Scalar>& closest) {
  end.theta = walk.theta();
  end.closest = closest;
  end.rate = walk.rate(closest);
}

/// Walks until contact, the end, or the end of the budget.
template <class Scalar>
WalkEnd<Scalar> walk_on(Walk<Scalar>& walk, std::uint32_t budget) {
  WalkEnd<Scalar> end;
  for (std::uint32_t i = 0; i < budget && !walk.is_at_end(); ++i) {  // Bound: kMaxBudget
    set_witness(end, walk, walk.closest());
    ++end.evaluations;
    if (!is_finite(end.closest.distance)) {
      end.outcome = Outcome::kInvalid;
      return end;
    }
    if (walk.is_contact(end.closest)) {
      end.outcome = end.theta > Scalar(0) ? Outcome::kContact : Outcome::kTouching;
      return end;
    }
    walk.advance_from(end.closest);
    if (walk.is_at_end()) break;
    const ClosestPoints<Scalar> same = walk.seen_before();
    if (walk.is_contact(same) && same.distance > Scalar(0)) {
      set_witness(end, walk, same);
      end.outcome = Outcome::kContact;
      return end;
    }
  }
  if (walk.is_at_end()) end.outcome = Outcome::kFree;
  return end;
}

/// search_advancement() with any inflation. @pre the options are valid, all lengths finite
template <class Scalar>
SearchResult<Scalar> search_inflated(const MovingPair<Scalar>& pair,
                                     const AdvancementOptions<Scalar>& options,
                                     const Vec3<Scalar>& seed_AB, Scalar inflation) {
  const Scalar scale = window_scale(query_length(pair));
  Walk<Scalar> walk(pair, scale, slab_of(pair, options), inflation);
  const Vec3<Scalar> first = direction_of(seed_AB, walk.line_of_middles());
  walk.advance_along(first);
  const WalkEnd<Scalar> end = walk_on(walk, options.budget);

  SearchResult<Scalar> result;
  result.outcome = end.outcome;
  result.evaluations = end.evaluations;
  result.t_free = walk.theta() * pair.duration;
  result.t_hit = pair.duration;
  result.witness.axes.normal_AB = first;
  if (end.evaluations > 0) {
    const Scalar t = end.theta * pair.duration;
    result.witness = gap_at(pair, in_metres(end.closest, scale), t);
    result.gap_rate = pair.duration > Scalar(0) ? end.rate / scale / pair.duration
                                                : gap_rate_at(pair, result.witness, t);
  }
  if (end.outcome == Outcome::kContact || end.outcome == Outcome::kTouching) {
    result.t_hit = walk.foreseen_contact(end.closest) * pair.duration;
  }
  return result;
}

}  // namespace batuta
