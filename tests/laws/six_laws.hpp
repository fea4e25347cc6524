// SPDX-License-Identifier: MIT
#pragma once
// The six laws of src/world/world.md, looked at after each step of a scene, from what is seen of it
// before and after. Bounds are those of the world's derivation; u is the scene's rounding.

#include <string>

#include "seen_world.hpp"

namespace batuta::test {

/// What a step was, and what it told.
struct Told {
  Real u = 0;  ///< rounding of the scene's numbers
  Real dt = 0;
  Real3 g = Real3::Zero();
  Real D = 0;          ///< WorldSettings::separation, or 0
  Real tolerance = 0;  ///< contact_tolerance of the search
  bool settles = false;
  bool separates = false;
  /// Angular momentum is a matter of bodies that turn; and of balls that do not, as long as none
  /// goes on together with another: what keeps those from turning takes it (world.md, "Together").
  bool turns = true;
  bool shifts = true;  ///< the world may move apart what is in each other
  int evaluations = 0;
  int impulses = 0;  ///< that were counted
  int separations = 0;
  int overlaps = 0;  ///< that were counted
  int frozen = 0;    ///< pairs that went on together, deeper in each other than the margin or not
  int asleep = 0;
  int events = 0;
  Real deepest = 0;
  Real held = 0;
  bool complete = true;
};

template <class SceneT>
Told told_by(const World<SceneT>& world, double dt, const Vec3<double>& g) {
  const auto& report = world.report();
  Told told;
  told.u = kRoundOff<typename SceneT::Scalar>;
  told.dt = dt;
  told.g = g.template cast<Real>();
  if constexpr (detail::kKnowsRest<SceneT>) {
    told.D = static_cast<Real>(world.settings().separation);
  }
  if constexpr (SceneT::Search::kHasContactTolerance) {
    told.tolerance = static_cast<Real>(world.settings().search.contact_tolerance);
  }
  told.settles = SceneT::kResting == RestingContact::kSettling;
  const bool is_welded = report.time_held > 0;
  told.turns = SceneT::kRotation || (SceneT::Search::kForSpheres && !is_welded);
  told.shifts = SceneT::kRotation;
  told.separates = SceneT::kResting == RestingContact::kSeparation;
  told.evaluations = static_cast<int>(report.evaluations);
  told.impulses = static_cast<int>(report.collisions);
  told.separations = static_cast<int>(report.separations);
  told.overlaps = static_cast<int>(report.overlaps_at_start);
  told.frozen = static_cast<int>(report.frozen);
  told.asleep = static_cast<int>(report.asleep);
  if constexpr (SceneT::kMaxEvents > 0) told.events = world.events().size();
  told.deepest = static_cast<Real>(report.deepest_overlap);
  told.held = static_cast<Real>(report.time_held);
  told.complete = report.complete();
  return told;
}

/// A law that did not hold.
struct Breach {
  std::string law;
  std::string what;
  Real by = 0;  ///< how much it was
  Real may_be = 0;
};

/// Checks one step. @returns what is broken
std::vector<Breach> broken_laws(const Seen& before, const Seen& after, const Told& told);

/// What a step may do that broken_laws() takes for broken all the same: a search that meets each of
/// these scenes asks for them.
struct Terms {
  Real opening = 0;  ///< how far opening and separating may shift somebody, m
  Real closing = 0;  ///< how far contacts that last may close, m
  /// Law 3, where contacts last: m g D of each, where broken_laws() takes what is missing to D / 2,
  /// J.
  Real lifted = 0;
  /// Law 3, where contacts last: m (g T)^2 / 2 of each, J.
  Real struck = 0;
  /// Law 3: what bodies with three unlike moments are off their flight when a blow ends it, J.
  /// Unlike by more than the library makes of equal ones (motion.md), where broken_laws() asks for
  /// more.
  Real off_flight = 0;
  /// What a solution that ends where no visit changes a velocity by more than D / 64 in the step
  /// (world.md, "Contacts that last") may lift what lies on two, J.
  Real left = 0;
  Real turning = 0;  ///< the energy of all turns before the step, J
};
Terms terms_of(const Seen& before, const Seen& after, const Told& told);

/// What two bodies may come nearer than touching in a step: src/world/detail/margin.md.
Real margin_of(const SeenBody& A, const SeenBody& B, const Told& told, Real fastest);

/// The least gap of two bodies' parts, m.
Real gap_between(const SeenBody& A, const SeenBody& B);

}  // namespace batuta::test
