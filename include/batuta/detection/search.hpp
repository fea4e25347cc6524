// SPDX-License-Identifier: MIT
#pragma once
// The searches behind one shape. A scene names one of these types; what it does not name is not
// linked. Members of each:
//   Options, options(budget, contact tolerance)   its options for a budget of distance evaluations;
//   a contact tolerance of 0:
//                                    its own default
//   most_evaluations(options)        bound of one search
//   kDefaultBudget                   suits its default options
//   kHasContactTolerance                         a gap within a contact tolerance counts as
//   contact; else a gap <= 0 does contact_gap(pair, options)       the largest gap, m, at which it
//   may speak of contact kUsesSeed                        a normal from an earlier search of the
//   same pair helps kNumber                          tells it from the others in what is saved
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
  using Scalar = ScalarT;
  using Options = SteppingOptions<Scalar>;
  static constexpr std::uint32_t kNumber = 1;
  static constexpr bool kUsesSeed = false;
  static constexpr bool kForStraightFlight = false;
  static constexpr bool kForSpheres = false;
  static constexpr bool kHasContactTolerance = false;
  static constexpr std::uint32_t kDefaultBudget = 4096;

  /// What the halvings and the start leave of the budget goes into steps.
  static constexpr Options options(std::uint32_t budget, Scalar /*contact_tolerance*/) {
    Options options;
    const std::uint32_t rest = static_cast<std::uint32_t>(options.halvings) + 1;
    options.max_steps = budget > rest ? budget - rest : 0;
    return options;
  }
  static constexpr std::uint64_t most_evaluations(const Options& options) {
    return std::uint64_t{options.max_steps} + static_cast<std::uint64_t>(options.halvings) + 1;
  }
  static Scalar contact_gap(const MovingPair<Scalar>& /*pair*/, const Options& /*options*/) {
    return Scalar(0);
  }
  static SearchResult<Scalar> search(const MovingPair<Scalar>& pair, const Options& options,
                                     const Vec3<Scalar>& /*seed_AB*/) {
    return search_stepping(pair, options);
  }
};

/// What the searches that never miss have in common: a contact tolerance and a budget.
template <class ScalarT>
struct Certified {
  using Scalar = ScalarT;
  using Options = AdvancementOptions<Scalar>;
  static constexpr bool kHasContactTolerance = true;
  static constexpr bool kForSpheres = false;
  static constexpr std::uint32_t kDefaultBudget = Options{}.budget;

  static constexpr Options options(std::uint32_t budget, Scalar contact_tolerance) {
    Options options;
    options.budget = budget;
    if (contact_tolerance > Scalar(0)) options.contact_tolerance = contact_tolerance;
    return options;
  }
  static constexpr std::uint64_t most_evaluations(const Options& options) { return options.budget; }
  static Scalar contact_gap(const MovingPair<Scalar>& pair, const Options& options) {
    return contact_tolerance_of(pair, options) + inflation_of(pair);
  }
};

/// Never misses, rotation included.
template <class ScalarT>
struct Advancement : Certified<ScalarT> {
  using Scalar = ScalarT;
  static constexpr std::uint32_t kNumber = 2;
  static constexpr bool kUsesSeed = true;
  static constexpr bool kForStraightFlight = false;

  static SearchResult<Scalar> search(const MovingPair<Scalar>& pair,
                                     const AdvancementOptions<Scalar>& options,
                                     const Vec3<Scalar>& seed_AB) {
    return search_advancement(pair, options, seed_AB);
  }
};

/// Never misses; for scenes in which nothing turns. What turns is answered with kInvalid.
template <class ScalarT>
struct Translation : Certified<ScalarT> {
  using Scalar = ScalarT;
  static constexpr std::uint32_t kNumber = 3;
  static constexpr bool kUsesSeed = false;
  static constexpr bool kForStraightFlight = true;

  static SearchResult<Scalar> search(const MovingPair<Scalar>& pair,
                                     const AdvancementOptions<Scalar>& options,
                                     const Vec3<Scalar>& /*seed_AB*/) {
    return search_translation(pair, options);
  }
};

/// Never misses; for spheres that fly straight, on bodies that do not turn. The smallest of them.
template <class ScalarT>
struct Spheres {
  using Scalar = ScalarT;
  struct Options {
    Scalar contact_tolerance =
        0;  ///< m, >= 0: a gap that counts as contact; raised to what can be resolved
  };
  static constexpr std::uint32_t kNumber = 4;
  static constexpr bool kUsesSeed = false;
  static constexpr bool kForStraightFlight = true;
  static constexpr bool kForSpheres = true;
  static constexpr bool kHasContactTolerance = false;
  static constexpr std::uint32_t kDefaultBudget = 1;

  static constexpr Options options(std::uint32_t /*budget*/, Scalar contact_tolerance) {
    return {contact_tolerance};
  }
  static constexpr std::uint64_t most_evaluations(const Options& /*options*/) { return 1; }
  static SphereResult<Scalar> search(const SphereFlight<Scalar>& flight, const Options& options) {
    return search_spheres(flight, options.contact_tolerance);
  }
  friend Status validate(const Options& options) {
    const bool good =
        is_finite(options.contact_tolerance) && options.contact_tolerance >= Scalar(0);
    return good ? Status::kOk : Status::kInvalidArgument;
  }
};

}  // namespace batuta
