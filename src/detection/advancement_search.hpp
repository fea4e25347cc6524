// SPDX-License-Identifier: MIT
#pragma once
// The search by certified advancement, step by step. Derivation and proof:
// advancement.md.

#include "../geometry/scale_window.hpp"
#include "batuta/detection/advancement.hpp"
#include "same_features.hpp"
#include "spin_bound.hpp"
#include "tracking_normal.hpp"

namespace batuta {

/// A search under way, in units of the duration: the pair is proven free on [0,
/// theta].
template <class Scalar>
class AdvancementSearch {
 public:
  /// @param pair  with lengths in the ScaleWindow; it must outlive the search
  /// @param contact_tolerance  in its unit
  /// @param inflation  kInflation; tests try less, to see that it is needed
  // cppcheck-suppress uninitMemberVar ; deviation: search-features
  // NOLINTBEGIN(clang-analyzer-optin.cplusplus.UninitializedObject) deviation: search-features
  AdvancementSearch(const MovingPair<Scalar>& pair, Scalar contact_tolerance, Scalar inflation)
      : pair_(pair),
        radii_(pair.A.radius + pair.B.radius),
        contact_tolerance_(contact_tolerance),
        state_(at_start(pair, inflation)) {}
  // NOLINTEND(clang-analyzer-optin.cplusplus.UninitializedObject) deviation: search-features

  bool is_at_end() const { return theta_ >= Scalar(1); }
  Scalar theta() const { return theta_; }

  /// Puts both axes where they are at this instant.
  void stand_at(Scalar theta) {
    set_state<Scalar>(state_.A, pair_.A, Vec3<Scalar>::Zero(), state_.turn_A.turn * theta);
    set_state<Scalar>(state_.B, pair_.B, state_.travel * theta, state_.turn_B.turn * theta);
  }

  ClosestPoints<Scalar> closest() const { return closest_points(state_.A.axis(), state_.B.axis()); }
  Scalar gap(const ClosestPoints<Scalar>& closest) const { return closest.distance - radii_; }
  bool is_contact(const ClosestPoints<Scalar>& closest) const {
    return !(gap(closest) > contact_tolerance_);
  }

  /// From twice the middle of A's axis to twice that of B's.
  Vec3<Scalar> line_of_middles() const {
    return (state_.B.p[0] + state_.B.p[1]) - (state_.A.p[0] + state_.A.p[1]);
  }

  /// Advances while n, held fixed, proves a gap of more than the contact tolerance, without
  /// a distance evaluation. @pre n is a unit vector, or zero
  void advance_along(const Vec3<Scalar>& n) {
    Clearances<Scalar> f;
    hold(f, n, state_, radii_ + contact_tolerance_);
    advance(unless_spinning(proven_free(f, horizon()), n, radii_ + contact_tolerance_));
  }

  /// Advances as far as the normal of `closest` proves: held fixed or, where
  /// that does not reach the end, moved along, whichever proves more. @pre
  /// `closest` is of this instant, no contact
  void advance_from(const ClosestPoints<Scalar>& closest) {
    const EdgePair<Scalar> edges(closest, state_.A.direction(), state_.B.direction());
    features_ = {closest.s, closest.u, edges.on_A, edges.on_B};
    const Vec3<Scalar> n = sharpened(closest.normal_AB, edges);
    Clearances<Scalar> f;
    hold(f, n, state_, radii_);
    Scalar step = unless_spinning(positive_stretch(f, horizon()), n, radii_);
    step = max_of(sure_step(gap(closest)), step);
    if (theta_ + step < Scalar(1)) {
      const Vec3<Scalar> rate =
          relative_rate(closest.s, closest.u, state_) * (1 / closest.distance);
      if (track(f, n, edges, rate, state_, {radii_, horizon()})) {
        step = max_of(step, proven_free(f, horizon()));
      }
    }
    advance(step);
  }

  /// Whether the features of the last evaluation show contact here; then
  /// `closest` are two points on them: the closest ones if the features still
  /// are, and never closer.
  bool shows_contact(ClosestPoints<Scalar>& closest) {
    if (!follow(features_, state_.A, state_.B, radii_ + contact_tolerance_)) return false;
    const ClosestPoints<Scalar> same = points_at(features_, state_.A.axis(), state_.B.axis());
    if (!is_contact(same) || !(same.distance > Scalar(0))) return false;
    closest = same;
    return true;
  }

  /// d gap / dt of `pair`, the same query in metres and seconds.
  Scalar rate(const ClosestPoints<Scalar>& closest, const MovingPair<Scalar>& pair,
              Scalar scale) const {
    const Vec3<Scalar>& n = closest.normal_AB;
    const Scalar side_A = n.dot(between(state_.A.side, closest.s)) / scale;
    const Scalar side_B = n.dot(between(state_.B.side, closest.u)) / scale;
    return n.dot(pair.B.v) + (pair.B.turn_rate * side_B - pair.A.turn_rate * side_A);
  }

  /// The foreseen instant of contact after theta.
  Scalar foreseen_contact(const ClosestPoints<Scalar>& closest) const {
    const Vec3<Scalar>& n = closest.normal_AB;
    const Vec3<Scalar> parting = relative_rate(closest.s, closest.u, state_);
    const Vec3<Scalar> sideways = across(parting, n);
    const Scalar bend = 2 * (state_.turn_A.half_square * n.dot(between(state_.A.arm, closest.s)) -
                             state_.turn_B.half_square * n.dot(between(state_.B.arm, closest.u))) +
                        sideways.squaredNorm() / closest.distance;
    return min_of(Scalar(1), theta_ + time_to_contact(gap(closest), n.dot(parting), bend));
  }

 private:
  /// An upper bound of both arms; rounding has changed them by some u of the
  /// bounding radius.
  static Scalar arm(const detail::CapsulePath<Scalar>& path) {
    return path.longest_arm + detail::kInflation<Scalar> * path.bounding_radius;
  }

  static PairState<Scalar> at_start(const MovingPair<Scalar>& pair, Scalar inflation) {
    const Vec3<Scalar> travel = pair.B.v * pair.duration;
    const Scalar way = length(travel);
    const TurnPowers<Scalar> A(pair.A.turn_rate * pair.duration);
    const TurnPowers<Scalar> B(pair.B.turn_rate * pair.duration);
    return {state_at_start(pair.A),
            state_at_start(pair.B),
            travel,
            A,
            B,
            term_bounds<Scalar>(pair.scale, way, {A.turn, arm(pair.A)}, {B.turn, arm(pair.B)}),
            inflated(term_bounds<Scalar>(pair.scale, way, {A.turn, pair.A.bounding_radius},
                                         {B.turn, pair.B.bounding_radius}),
                     inflation)};
  }

  static TermBounds<Scalar> inflated(const TermBounds<Scalar>& size, Scalar inflation) {
    return {inflation * size.length, inflation * size.speed, inflation * size.half_second,
            inflation * size.sixth_third, inflation * size.last_fourth};
  }

  Scalar rest() const { return 1 - theta_; }
  Scalar horizon() const { return horizon_of(state_, rest()); }

  /// How far the gap alone proves the pair free, as no two points are faster:
  /// little, but always something, whatever rounding has made of the normal.
  Scalar sure_step(Scalar gap) const {
    const Scalar sure = gap - state_.magnitudes.length;
    if (sure >= state_.bounds.speed * rest()) return rest();
    return kRoundDown<Scalar> * (sure / state_.bounds.speed);
  }

  /// `step`, as far as n, held fixed, proves the axes further apart than R by
  /// the polynomials; or what the bound for fast spin proves, where they do not
  /// see to the end.
  Scalar unless_spinning(Scalar step, const Vec3<Scalar>& n, Scalar R) const {
    if (!(horizon() < rest()) || !(step > Scalar(0))) return step;
    const Scalar least = R + state_.magnitudes.length;
    return max_of(step, free_until_by_spin(pair_, state_.travel, n, least, theta_) - theta_);
  }

  void advance(Scalar step) {
    if (!(step > Scalar(0))) return;  // nor if it is no number
    theta_ = min_of(Scalar(1), theta_ + step);
    if (!is_at_end()) stand_at(theta_);
  }

  const MovingPair<Scalar>& pair_;
  Scalar radii_;
  Scalar contact_tolerance_;
  Scalar theta_ = 0;
  Features<Scalar> features_;  ///< of the last evaluation
  PairState<Scalar> state_;    ///< at theta
};

/// The unit vector along the seed or, where that has no direction, along the
/// other; or zero.
template <class Scalar>
Vec3<Scalar> direction_of(const Vec3<Scalar>& seed, const Vec3<Scalar>& other) {
  const bool seeded = is_finite(seed) && detail::largest_component(seed) > Scalar(0);
  const Vec3<Scalar>& line = seeded ? seed : other;
  return detail::largest_component(line) > Scalar(0) ? unit(line) : line;
}

/// How a search ended, and its last witness.
template <class Scalar>
struct AdvancementEnd {
  Outcome outcome = Outcome::kBudget;
  std::uint32_t evaluations = 0;
  Scalar theta = 0;  ///< of the witness
  ClosestPoints<Scalar> closest;
};

/// Searches until contact, the end, or the end of the budget.
template <class Scalar>
AdvancementEnd<Scalar> search_on(AdvancementSearch<Scalar>& advancement, std::uint32_t budget) {
  AdvancementEnd<Scalar> end;
  for (std::uint32_t i = 0; i < budget && !advancement.is_at_end(); ++i) {  // Bound: kMaxBudget
    end.theta = advancement.theta();
    end.closest = advancement.closest();
    ++end.evaluations;
    if (!is_finite(end.closest.distance)) {
      end.outcome = Outcome::kInvalid;
      return end;
    }
    if (advancement.is_contact(end.closest)) {
      end.outcome = end.theta > Scalar(0) ? Outcome::kContact : Outcome::kTouching;
      return end;
    }
    advancement.advance_from(end.closest);
    if (advancement.is_at_end()) break;
    if (advancement.shows_contact(end.closest)) {
      end.theta = advancement.theta();
      end.outcome = Outcome::kContact;
      return end;
    }
  }
  if (advancement.is_at_end()) end.outcome = Outcome::kFree;
  return end;
}

/// The answer to `pair`, from a search over the same in units of 1 / scale metres.
/// @param first  the direction that was tried without an evaluation
template <class Scalar>
SearchResult<Scalar> result_of(const MovingPair<Scalar>& pair,
                               AdvancementSearch<Scalar>& advancement, Scalar scale,
                               const AdvancementEnd<Scalar>& end, const Vec3<Scalar>& first) {
  if (end.evaluations == 0) {
    SearchResult<Scalar> result;
    result.outcome = end.outcome;
    result.t_free = advancement.theta() * pair.duration;
    result.t_hit = pair.duration;
    result.witness.axes.normal_AB = first;
    return result;
  }
  const bool hits = end.outcome == Outcome::kContact || end.outcome == Outcome::kTouching;
  if (end.outcome == Outcome::kBudget) advancement.stand_at(end.theta);
  return {end.outcome,
          advancement.theta() * pair.duration,
          hits ? advancement.foreseen_contact(end.closest) * pair.duration : pair.duration,
          gap_at(pair, in_metres(end.closest, scale), end.theta * pair.duration),
          advancement.rate(end.closest, pair, scale),
          end.evaluations};
}

/// search_advancement() with any inflation. @pre the options are valid, all
/// lengths finite
template <class Scalar>
SearchResult<Scalar> search_inflated(const MovingPair<Scalar>& pair,
                                     const AdvancementOptions<Scalar>& options,
                                     const Vec3<Scalar>& seed_AB, Scalar inflation) {
  const Scalar scale = window_scale(query_length(pair));
  const auto search = [&](const MovingPair<Scalar>& unit) {
    AdvancementSearch<Scalar> advancement(unit, contact_tolerance_of(pair, options) * scale,
                                          inflation);
    const Vec3<Scalar> first = direction_of(seed_AB, advancement.line_of_middles());
    advancement.advance_along(first);
    return result_of(pair, advancement, scale, search_on(advancement, options.budget), first);
  };
  return scale == Scalar(1) ? search(pair) : search(in_units(pair, scale));
}

}  // namespace batuta
