// SPDX-License-Identifier: MIT
#pragma once
// The contact solver of most engines, as a baseline: impulses applied row by row, normal then
// tangents, Newton's restitution as a target of the normal row, Coulomb's friction as a clamp,
// repeated. And what it does to energy, against the closed form.

#include "batuta/response/friction.hpp"

namespace batuta::test {

/// Two capsules about to collide, or parting.
struct Strike {
  Collider<double> A;
  Collider<double> B;
  Contact<double> contact;
};

/// Solid capsules of random size, slenderness, density, pose and twist, touching at random places
/// of their axes. A function of (seed, index) alone.
Strike random_strike(std::uint64_t seed, std::uint64_t index);

struct TwistPair {
  Twist<double> A;
  Twist<double> B;
};

/// Twists after `rounds` rounds. The tangential target is 0, the friction of each of the two
/// tangents is clamped by itself.
/// @pre the bodies approach, and something gives way
TwistPair newton_contact(const Strike& strike, double restitution, double friction, int rounds);

/// Of what has a finite mass, J.
double kinetic_energy(const Collider<double>& body, const Twist<double>& twist);

/// (energy after - energy before) / energy before
double relative_gain(const Strike& strike, const TwistPair& after);

/// Above rounding: a gain counts from here on.
inline constexpr double kGain = 1e-12;

struct EnergyTally {
  int cases = 0;          ///< that collided
  int gains = 0;          ///< of them, with more energy than before
  double worst_gain = 0;  ///< relative; negative if no case reached the energy before
};

EnergyTally tally_newton(double restitution, double friction, int rounds, int count,
                         std::uint64_t seed);
EnergyTally tally_closed_form(const FrictionLaw<double>& law, int count, std::uint64_t seed);

}  // namespace batuta::test
