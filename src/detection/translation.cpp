// SPDX-License-Identifier: MIT
#include "batuta/detection/translation.hpp"

#include "../geometry/scale_window.hpp"
#include "edge_pair.hpp"
#include "expansion.hpp"
#include "rounded_parallelogram.hpp"

namespace batuta {

namespace {

/// Share of the contact tolerance at which the entry is predicted: inside it by more than a
/// prediction errs, and far enough from contact for the judge (translation.md).
template <class Scalar>
constexpr Scalar kAim = Scalar(0.75);

/// kInflation where nothing turns: without arms and without polynomials (translation.md).
template <class Scalar>
constexpr Scalar kSteadyInflation = 48 * kRoundOff<Scalar>;

/// A search under way, in units of the duration and of 1 / scale metres: proven free on [0, theta].
template <class Scalar>
class TranslationSearch {
 public:
  TranslationSearch(const MovingPair<Scalar>& pair, Scalar scale, Scalar contact_tolerance)
      : unit_(in_units(pair, scale)),
        contact_tolerance_(contact_tolerance * scale),
        radii_(unit_.A.radius + unit_.B.radius),
        epsilon_(kSteadyInflation<Scalar> * unit_.scale) {}

  bool is_at_end() const { return theta_ >= Scalar(1); }
  Scalar theta() const { return theta_; }

  ClosestPoints<Scalar> closest_at(Scalar theta) const {
    return closest_points<Scalar>(axis_A(), axis_B(theta));
  }
  bool is_contact(const ClosestPoints<Scalar>& closest) const {
    return !(closest.distance - radii_ > contact_tolerance_);
  }

  /// The instant worth a look: where the pair enters the contact tolerance, or else where the
  /// middles are closest.
  Scalar instant_to_look_at() const {
    const Scalar rho = radii_ + kAim<Scalar> * contact_tolerance_;
    const Scalar entry = first_entry<Scalar>({axis_A(), axis_B(Scalar(0)), unit_.B.v, rho});
    if (entry > theta_ && entry <= Scalar(1)) return entry;
    const Scalar square = unit_.B.v.squaredNorm();
    if (!(square > std::numeric_limits<Scalar>::min())) return theta_;
    const Scalar closest = -line_of_middles().dot(unit_.B.v) / (2 * square);
    return clamp(closest, theta_, Scalar(1));
  }

  /// Advances while the line between the middles proves a gap of more than the contact tolerance,
  /// without a distance evaluation; returns its direction.
  Vec3<Scalar> advance_along_middles() {
    Vec3<Scalar> n = line_of_middles();
    if (!(detail::largest_component(n) > Scalar(0))) return n;
    n = unit(n);
    (void)advance_along(n, contact_tolerance_, Scalar(1));
    return n;
  }

  /// Extends the proof by the normal of `closest`, taken at `instant` >= theta.
  /// @returns whether [0, instant] is proven
  bool advance_by(const ClosestPoints<Scalar>& closest, Scalar instant) {
    const EdgePair<Scalar> edges(closest, axis_A().direction(), axis_B(Scalar(0)).direction());
    const Vec3<Scalar> n = sharpened(closest.normal_AB, edges);
    if (instant > theta_) return advance_along(n, least_here(), instant);
    if (is_contact(closest)) return true;
    const Scalar sure = theta_ + sure_step(closest);
    (void)advance_along(n, Scalar(0), instant);
    theta_ = clamp(sure, theta_, Scalar(1));
    return true;
  }

  /// @pre [0, instant] is proven
  void stop_at(Scalar instant) { theta_ = instant; }

  /// The foreseen instant of contact after theta.
  Scalar foreseen_contact(const ClosestPoints<Scalar>& closest) const {
    const Scalar rate = closest.normal_AB.dot(unit_.B.v);
    const Vec3<Scalar> sideways = unit_.B.v - closest.normal_AB * rate;
    const Scalar bend = sideways.squaredNorm() / closest.distance;
    return min_of(Scalar(1), theta_ + time_to_contact(closest.distance - radii_, rate, bend));
  }

 private:
  /// How far the gap alone proves the pair free: nothing is faster than the travel.
  Scalar sure_step(const ClosestPoints<Scalar>& closest) const {
    const Scalar sure = closest.distance - (radii_ + epsilon_);
    const Scalar speed = length(unit_.B.v);
    return sure >= speed ? Scalar(1) : kRoundDown<Scalar> * (sure / speed);
  }

  /// From twice the middle of A's axis to twice that of B's, at the start.
  Vec3<Scalar> line_of_middles() const {
    return (unit_.B.ends[0].start + unit_.B.ends[1].start) -
           (unit_.A.ends[0].start + unit_.A.ends[1].start);
  }
  Segment<Scalar> axis_A() const { return {unit_.A.ends[0].start, unit_.A.ends[1].start}; }
  Segment<Scalar> axis_B(Scalar theta) const {
    const Vec3<Scalar> travel = unit_.B.v * theta;
    return {unit_.B.ends[0].start + travel, unit_.B.ends[1].start + travel};
  }

  /// Extends the proof along n, if at theta it proves a clearance of more than `least`, as far as
  /// it goes. @returns whether that is as far as `until`. @pre n is a unit vector
  bool advance_along(const Vec3<Scalar>& n, Scalar least, Scalar until) {
    const Scalar slope = n.dot(unit_.B.v);
    const Scalar now = clearance_at_start(n) + slope * theta_;
    if (!(now > least)) return false;
    const bool to_the_end = now + slope * (1 - theta_) > Scalar(0);
    const Scalar reach = to_the_end ? Scalar(1) : theta_ - kRoundDown<Scalar> * (now / slope);
    theta_ = clamp(reach, theta_, Scalar(1));
    return theta_ >= until;
  }

  /// What a proof that begins at theta has to exceed: at the start a gap within the contact
  /// tolerance is a touch.
  Scalar least_here() const { return theta_ > Scalar(0) ? Scalar(0) : contact_tolerance_; }

  /// Lower bound of the gap along n at the start, less what rounding can do.
  Scalar clearance_at_start(const Vec3<Scalar>& n) const {
    const Segment<Scalar> A = axis_A();
    const Segment<Scalar> B = axis_B(Scalar(0));
    return (min_of(n.dot(B.a), n.dot(B.b)) - max_of(n.dot(A.a), n.dot(A.b))) - (radii_ + epsilon_);
  }

  MovingPair<Scalar> unit_;
  Scalar contact_tolerance_;
  Scalar radii_;
  Scalar epsilon_;
  Scalar theta_ = 0;
};

/// A ball about its centre of mass may: nobody sees it.
template <class Scalar>
bool turns(const detail::CapsulePath<Scalar>& path) {
  return path.turn_rate > Scalar(0) && path.bounding_radius > Scalar(0);
}

template <class Scalar>
SearchResult<Scalar> search_on(TranslationSearch<Scalar>& search, const MovingPair<Scalar>& pair,
                               Scalar scale, std::uint32_t budget) {
  SearchResult<Scalar> result;
  result.outcome = Outcome::kBudget;
  Scalar instant = search.instant_to_look_at();
  for (std::uint32_t i = 0; i < budget && !search.is_at_end(); ++i) {  // Bound: kMaxBudget
    const ClosestPoints<Scalar> closest = search.closest_at(instant);
    if (!is_finite(closest.distance)) return {};
    const Scalar t = instant * pair.duration;
    ++result.evaluations;
    result.witness = gap_at(pair, in_metres(closest, scale), t);
    result.gap_rate = closest.normal_AB.dot(pair.B.v);
    if (search.advance_by(closest, instant) && search.is_contact(closest)) {
      search.stop_at(instant);
      result.outcome = instant > Scalar(0) ? Outcome::kContact : Outcome::kTouching;
      result.t_hit = search.foreseen_contact(closest) * pair.duration;
      break;
    }
    instant = search.theta();
  }
  return result;
}

}  // namespace

template <class Scalar>
SearchResult<Scalar> search_translation(const MovingPair<Scalar>& pair,
                                        const AdvancementOptions<Scalar>& options) {
  if (!can_be_searched(pair, options) || turns(pair.A) || turns(pair.B)) return {};
  const Scalar scale = window_scale(pair.scale);
  TranslationSearch<Scalar> search(pair, scale, contact_tolerance_of(pair, options));
  const Vec3<Scalar> first = search.advance_along_middles();
  SearchResult<Scalar> result;
  result.outcome = Outcome::kBudget;
  if (!search.is_at_end()) result = search_on(search, pair, scale, options.budget);
  if (result.evaluations == 0) result.witness.axes.normal_AB = first;
  result.t_free = search.theta() * pair.duration;
  if (result.outcome != Outcome::kBudget) return result;
  if (search.is_at_end()) result.outcome = Outcome::kFree;
  result.t_hit = pair.duration;
  return result;
}

#define BATUTA_INSTANTIATE(S) \
  template SearchResult<S> search_translation(const MovingPair<S>&, const AdvancementOptions<S>&);
BATUTA_FOR_EACH_SCALAR(BATUTA_INSTANTIATE)
#undef BATUTA_INSTANTIATE

}  // namespace batuta
