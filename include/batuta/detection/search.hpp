// SPDX-License-Identifier: MIT
#pragma once
// The searches behind one shape. A scene names one of these types; what it does not name is not
// linked. Members of each:
//   Options                          what one search needs to know
//   options(budget, tolerance)       those for a budget of distance evaluations and a contact
//                                    tolerance; 0: its own default
//   most_evaluations(options)        bound of one search
//   kDefaultBudget                   suits its default options
//   kHasContactTolerance             a gap within a contact tolerance counts as contact; else a
//                                    gap <= 0 does
//   contact_gap(pair, options)       the largest gap, m, at which it may speak of contact
//   kUsesSeed                        a normal from an earlier search of the same pair helps
//   kNumber                          tells it from the others in what is saved
//   kForStraightFlight               serves scenes in which nothing turns
//   kForSpheres                      of these, one whose only shape is the sphere
//   search(pair, options, seed_AB)   first contact in [0, duration]; seed_AB zero: none

#include "batuta/detection/sphere_flight.hpp"
#include "batuta/detection/stepping.hpp"
#include "batuta/detection/translation.hpp"

namespace batuta {

/// The paper's [Kavan §3]: equal steps, then bisection. Passes over touches shallower than epsilon.
template <class ScalarT>
struct Stepping {
  /// Of lengths and times.
  using Scalar = ScalarT;
  /// What one search needs to know.
  using Options = SteppingOptions<Scalar>;
  /// Tells this search from the others in what is saved.
  static constexpr std::uint32_t kNumber = 1;
  /// A seed is not looked at.
  static constexpr bool kUsesSeed = false;
  /// Serves scenes in which bodies turn.
  static constexpr bool kForStraightFlight = false;
  /// Serves capsules.
  static constexpr bool kForSpheres = false;
  /// A gap <= 0 counts as contact.
  static constexpr bool kHasContactTolerance = false;
  /// Suits the default options.
  static constexpr std::uint32_t kDefaultBudget = 4096;
  /// One step, the halvings and the start.
  static constexpr std::uint32_t kLeastBudget = static_cast<std::uint32_t>(Options{}.halvings) + 2;

  /// What the halvings and the start leave of the budget goes into steps.
  static constexpr Options options(std::uint32_t budget, Scalar /*contact_tolerance*/) {
    Options options;
    const std::uint32_t rest = static_cast<std::uint32_t>(options.halvings) + 1;
    options.max_steps = budget > rest ? budget - rest : 0;
    return options;
  }
  /// Most distance evaluations of one search.
  static constexpr std::uint64_t most_evaluations(const Options& options) {
    return std::uint64_t{options.max_steps} + static_cast<std::uint64_t>(options.halvings) + 1;
  }
  /// The largest gap, m, at which it may speak of contact: 0.
  static Scalar contact_gap(const MovingPair<Scalar>& /*pair*/, const Options& /*options*/) {
    return Scalar(0);
  }
  /// search_stepping(); the seed is not looked at.
  static SearchResult<Scalar> search(const MovingPair<Scalar>& pair, const Options& options,
                                     const Vec3<Scalar>& /*seed_AB*/) {
    return search_stepping(pair, options);
  }
};

namespace detail {

/// What the searches that never miss have in common: a contact tolerance and a budget.
template <class ScalarT>
struct Certified {
  /// Of lengths and times.
  using Scalar = ScalarT;
  /// What one search needs to know.
  using Options = AdvancementOptions<Scalar>;
  /// A gap of at most the contact tolerance counts as contact.
  static constexpr bool kHasContactTolerance = true;
  /// Serves capsules.
  static constexpr bool kForSpheres = false;
  /// Suits the default options.
  static constexpr std::uint32_t kDefaultBudget = Options{}.budget;
  /// With one evaluation it says what is free, at least.
  static constexpr std::uint32_t kLeastBudget = 1;

  /// Options for so many distance evaluations, <= kMaxBudget. @param contact_tolerance  over S, <=
  /// 1; 0 or less: the default
  static constexpr Options options(std::uint32_t budget, Scalar contact_tolerance) {
    Options options;
    options.budget = budget;
    if (contact_tolerance > Scalar(0)) options.contact_tolerance = contact_tolerance;
    return options;
  }
  /// Most distance evaluations of one search.
  static constexpr std::uint64_t most_evaluations(const Options& options) { return options.budget; }
  /// The largest gap, m, at which it may speak of contact: contact_tolerance_of() + inflation_of().
  static Scalar contact_gap(const MovingPair<Scalar>& pair, const Options& options) {
    return contact_tolerance_of(pair, options) + inflation_of(pair);
  }
};

}  // namespace detail

/// Never misses, rotation included.
template <class ScalarT>
struct Advancement : detail::Certified<ScalarT> {
  /// Of lengths and times.
  using Scalar = ScalarT;
  /// Tells this search from the others in what is saved.
  static constexpr std::uint32_t kNumber = 2;
  /// A normal from an earlier search of the same pair helps.
  static constexpr bool kUsesSeed = true;
  /// Serves scenes in which bodies turn.
  static constexpr bool kForStraightFlight = false;

  /// search_advancement().
  static SearchResult<Scalar> search(const MovingPair<Scalar>& pair,
                                     const AdvancementOptions<Scalar>& options,
                                     const Vec3<Scalar>& seed_AB) {
    return search_advancement(pair, options, seed_AB);
  }
};

/// Never misses; for scenes in which nothing turns. What turns is answered with kInvalid.
template <class ScalarT>
struct Translation : detail::Certified<ScalarT> {
  /// Of lengths and times.
  using Scalar = ScalarT;
  /// Tells this search from the others in what is saved.
  static constexpr std::uint32_t kNumber = 3;
  /// A seed is not looked at.
  static constexpr bool kUsesSeed = false;
  /// Serves scenes in which nothing turns.
  static constexpr bool kForStraightFlight = true;

  /// search_translation(); the seed is not looked at.
  static SearchResult<Scalar> search(const MovingPair<Scalar>& pair,
                                     const AdvancementOptions<Scalar>& options,
                                     const Vec3<Scalar>& /*seed_AB*/) {
    return search_translation(pair, options);
  }
};

/// Never misses; for spheres that fly straight, on bodies that do not turn. The smallest of them.
template <class ScalarT>
struct Spheres {
  /// Of lengths and times.
  using Scalar = ScalarT;
  /// What one search needs to know.
  struct Options {
    /// m, >= 0: a gap that counts as contact; raised to what can be resolved
    Scalar contact_tolerance = 0;
  };
  /// Tells this search from the others in what is saved.
  static constexpr std::uint32_t kNumber = 4;
  /// There is no seed.
  static constexpr bool kUsesSeed = false;
  /// Serves scenes in which nothing turns.
  static constexpr bool kForStraightFlight = true;
  /// The only shape is the sphere.
  static constexpr bool kForSpheres = true;
  /// A scene states no contact tolerance; what can be resolved counts as contact.
  static constexpr bool kHasContactTolerance = false;
  /// It takes one evaluation, whatever happens.
  static constexpr std::uint32_t kDefaultBudget = 1;
  /// The same.
  static constexpr std::uint32_t kLeastBudget = 1;

  /// Options with this contact tolerance, m, >= 0; the budget is always one evaluation.
  static constexpr Options options(std::uint32_t /*budget*/, Scalar contact_tolerance) {
    return {contact_tolerance};
  }
  /// Most distance evaluations of one search: 1.
  static constexpr std::uint64_t most_evaluations(const Options& /*options*/) { return 1; }
  /// search_spheres().
  static SphereResult<Scalar> search(const SphereFlight<Scalar>& flight, const Options& options) {
    return search_spheres(flight, options.contact_tolerance);
  }
  /// @returns kOk | kInvalidArgument: a contact tolerance that is negative or not finite
  friend Status validate(const Options& options) {
    const bool good =
        is_finite(options.contact_tolerance) && options.contact_tolerance >= Scalar(0);
    return good ? Status::kOk : Status::kInvalidArgument;
  }
};

}  // namespace batuta
