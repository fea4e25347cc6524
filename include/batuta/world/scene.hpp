// SPDX-License-Identifier: MIT
#pragma once
// A scene is a type: what it holds and what it answers are constants of it, so that memory and the
// longest step are known when it is compiled. Derive, and hide what is different:
//   struct MyScene : batuta::Scene { static constexpr int kMaxBodies = 8; };

#include "batuta/detection/stepping.hpp"
#include "batuta/world/driver.hpp"

namespace batuta {

struct Scene {
  using Scalar = float;
  /// Who moves a body; see driver.hpp.
  using Driver = FreeFlight<float>;
  /// Bodies at the same time, 2 ... 1024.
  static constexpr int kMaxBodies = 2;
  /// Pairs whose swept volumes may meet at the same time. Where more do, the bodies of the surplus
  /// pairs are held for the rest of the step, and counted.
  static constexpr int kMaxPairs = 1;
  /// Contacts answered in one step. Where more happen, the bodies concerned are held for the rest
  /// of it, and counted.
  static constexpr int kMaxContacts = 8;
  /// Events kept for reading after a step; a surplus is counted.
  static constexpr int kMaxEvents = 16;
};

/// Restitution of a pair from those of its bodies: the bouncier one decides, as a scene may.
template <class Scalar>
constexpr Scalar pair_restitution(Scalar a, Scalar b) {
  return max_of(a, b);
}

/// The tolerances of a world, SI units, all relative to what the scene's user knows.
template <class Scalar>
struct WorldSettings {
  SteppingOptions<Scalar> search;    ///< epsilon, steps, halvings
  Scalar rest_speed = Scalar(0.01);  ///< eps_r [Kavan §4], m/s, > 0
  Scalar separation = Scalar(1e-4);  ///< D [Kavan §4.2], m, > 0; a contact ends beyond 2 D
  Scalar min_separation_time = Scalar(1e-4);  ///< least f(D), s, > 0
};

/// @returns kOk | kInvalidArgument: an option out of its range
template <class Scalar>
Status validate(const WorldSettings<Scalar>& settings);

}  // namespace batuta
