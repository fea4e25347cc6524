// SPDX-License-Identifier: MIT
#pragma once
// The two ways to answer a contact with friction, behind one shape, and what is said of an answer.

#include <array>
#include <string>

#include "newton_contact.hpp"

namespace batuta::report {

/// A law of contact and how it is computed.
struct Law {
  FrictionLaw<double> friction;
  int rounds = 0;  ///< of the iterated Newton restitution; 0: the closed form
};

/// Ways of computing: the closed form, then what engines do with few, some and many rounds.
inline constexpr std::array<int, 4> kRounds = {0, 4, 10, 50};

/// "closed form", or "Newton 4" for 4 rounds.
std::string name_of(int rounds);

/// @pre the bodies approach, and something gives way
/// @returns the twists after
test::TwistPair answer(const test::Strike& strike, const Law& law);

/// What a contact did.
struct Effect {
  double gain = 0;           ///< (energy after - before) / before
  double rebound_error = 0;  ///< |n.v+ + C n.v-| / |n.v-|, v the relative velocity of the points
  double normal = 0;         ///< n . impulse on A, N s
  double tangential = 0;     ///< |impulse across n|, N s
};

/// @pre as for answer(), and A has a finite mass
Effect effect_of(const test::Strike& strike, const Law& law, const test::TwistPair& after);

/// n . (velocity of A's point - velocity of B's), m/s; negative: approaching.
double normal_velocity(const test::Strike& strike, const test::TwistPair& twists);

}  // namespace batuta::report
