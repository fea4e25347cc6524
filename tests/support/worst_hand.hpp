// SPDX-License-Identifier: MIT
#pragma once
// The hand for which a sampled spring and damper shake first, searched for among masses on springs
// and among elastic lines. Onsets are stiffnesses over the advisor's bound. Double.

#include "loop_matrix.hpp"
#include "sampled_loop.hpp"

namespace batuta::test {

/// A device whose encoder and force do not matter.
inline haptics::DeviceProfile<double> plain_device(double period, double damping, int delay = 0) {
  haptics::DeviceProfile<double> profile;
  profile.period = period;
  profile.delay = delay;
  profile.damping = damping;
  profile.force_limit = 1;
  profile.travel = 1;
  return profile;
}

/// The advisor's. @pre the profile is valid
inline double stiffness_bound(const haptics::DeviceProfile<double>& profile, double damping) {
  const auto limit = haptics::largest_stiffness(profile, damping);
  BATUTA_ASSERT(limit.status == Status::kOk);
  return limit.value.largest;
}

/// Where a mass without a hand shakes, in simulated time: a push, and whether what is stored grows.
/// @param slow  periods in which growth 1 % above the onset is seen, in units of mass / (b T)
inline double mass_onset_in_time(const haptics::DeviceProfile<double>& profile, double mass,
                                 double slow) {
  LoopSettings loop;
  loop.axis.period = profile.period;
  loop.axis.mass = mass;
  loop.axis.damping = profile.damping;
  loop.delay = profile.delay;
  const double bound = stiffness_bound(profile, 0);
  const int steps = static_cast<int>(slow * mass / (profile.damping * profile.period));
  return onset(0.8, 1.2, [&](double share) {
    loop.gains.stiffness = share * bound;
    return grows(loop, steps);
  });
}

/// The same by the spectral radius of the exact discrete system.
inline double mass_onset_by_radius(const haptics::DeviceProfile<double>& profile, double mass) {
  const double bound = stiffness_bound(profile, 0);
  return onset(0.8, 1.2, [&](double share) {
    const auto A =
        loop_around({mass, profile.damping, 0}, {share * bound, 0}, profile.period, profile.delay);
    return spectral_radius(A) > 1;
  });
}

inline constexpr double kNoOnset = 20;     ///< times the bound: no hand is searched further
inline constexpr double kWellBelow = 0.9;  ///< times the bound

/// The lowest onset of masses from 10 g to 10 kg, free or on springs with which they swing by up to
/// half a turn in a period; 0 if one shakes well below the bound.
inline double lowest_mass_onset(const haptics::DeviceProfile<double>& profile, double damping) {
  constexpr double kPi = 3.14159265358979323846;
  constexpr int kTurns = 20;
  const double bound = stiffness_bound(profile, damping);
  double lowest = kNoOnset;
  for (const double mass : {0.01, 0.1, 1.0, 10.0}) {
    for (int i = 0; i < kTurns; ++i) {
      const double turn = kPi * i / kTurns / profile.period;
      if (i > 0 && profile.damping >= mass * turn) continue;  // beyond critical damping
      const Mass hand{mass, profile.damping, mass * turn * turn};
      const auto shakes = [&](double share) {
        const haptics::Gains<double> gains{share * bound, damping};
        return spectral_radius(loop_around(hand, gains, profile.period, profile.delay)) > 1;
      };
      if (!shakes(lowest)) continue;
      lowest = shakes(kWellBelow) ? 0 : onset(kWellBelow, lowest, shakes);
    }
  }
  return lowest;
}

/// The share of some gains at which a hand like an elastic line shakes.
/// @param gains_at  the gains of a share
template <class GainsAt>
double line_onset(const haptics::DeviceProfile<double>& profile, double impedance,
                  const GainsAt& gains_at) {
  return onset(kWellBelow / 2, kNoOnset, [&](double share) {
    const auto A = loop_around_line(impedance, profile.damping, gains_at(share), profile.period,
                                    profile.delay);
    return spectral_radius(A) > 1;
  });
}

}  // namespace batuta::test
