// SPDX-License-Identifier: MIT
#pragma once
// How stiff and how damped a coupling may be on a given device, whoever holds the stick: pure
// functions from what the device is to what it can render without giving energy away.
// Proofs: src/haptics/gain_advisor.md. Measured: tests/stability/haptic_*_test.cpp.
//
// Units: u is the unit of the coordinate, so that force times coordinate is work in J. For the
// stick of keyframes.hpp u = 1 (centre to rim) and a force is N m for each unit of the stick; for a
// device measured in metres u = m and a force is N. Stiffness: J/u^2, damping: J s/u^2.

#include "batuta/core/status.hpp"
#include "batuta/core/types.hpp"

namespace batuta::haptics {

/// One axis of a device whose force is held from sample to sample.
template <class Scalar>
struct DeviceProfile {
  Scalar period = 0;        ///< T, s, > 0
  int delay = 0;            ///< n >= 0: whole periods from a sample until its force is held
  Scalar damping = 0;       ///< b, J s/u^2, >= 0: viscous, of the mechanism by itself
  Scalar friction = 0;      ///< f_c, J/u, >= 0: Coulomb, of the mechanism by itself
  Scalar encoder_step = 0;  ///< Delta, u, >= 0; 0: as fine as the numbers are
  Scalar force_limit = 0;   ///< J/u, > 0: the most that the actuator does
  Scalar travel = 0;        ///< u, > 0: from the centre to the rim
};

/// f = -stiffness (q - q_0) - damping (q - q of the sample before) / T.
template <class Scalar>
struct Gains {
  Scalar stiffness = 0;  ///< K, J/u^2, >= 0
  Scalar damping = 0;    ///< B, J s/u^2; a negative one costs as much as a positive one
};

/// @returns kOk | kInvalidArgument: a number is not finite or out of the range stated above, or the
/// age of a force, T (n + 1/2), is beyond Scalar
template <class Scalar>
Status validate(const DeviceProfile<Scalar>& profile);

/// What keeps a gain from being larger.
enum class GainBound : std::uint8_t {
  kSampling,  ///< K T (n + 1/2) + |B| <= b [Colgate & Schenkel 1997 for n = 0]
  kEncoder,   ///< Delta (K / 2 + |B| / T) <= f_c [Abbott & Okamura 2005 for B = 0]
};

/// The largest gain, and what keeps it from being larger.
template <class Scalar>
struct GainLimit {
  Scalar largest = 0;                      ///< 0 also where not even 0 is inside, see check()
  GainBound bound = GainBound::kSampling;  ///< the one that is reached first
};

/// The largest K beside the damping B; 0 also where B alone is beyond a bound: ask check(). No
/// loop.
/// @returns kOk | kInvalidArgument: the profile is not valid, B is not finite, or the answer is
/// beyond Scalar
template <class Scalar>
Result<GainLimit<Scalar>> largest_stiffness(const DeviceProfile<Scalar>& profile, Scalar damping);

/// The largest B beside the stiffness K; 0 also where K alone is beyond a bound: ask check(). No
/// loop.
/// @returns kOk | kInvalidArgument: the profile is not valid, K is negative or not finite, or the
/// answer is beyond Scalar
template <class Scalar>
Result<GainLimit<Scalar>> largest_damping(const DeviceProfile<Scalar>& profile, Scalar stiffness);

/// Whether a device may be driven with these gains, and if not, why.
enum class [[nodiscard]] GainVerdict : std::uint8_t{
    kInside,          ///< may be driven: no energy is given away
    kInvalidProfile,  ///< validate() says no
    kInvalidGains,    ///< not finite, or a negative stiffness
    kBeyondSampling,  ///< GainBound::kSampling is broken: too stiff or damped for period and delay
    kBeyondEncoder,   ///< GainBound::kEncoder is broken: the stick would buzz at rest
};

/// Both bounds, the first one that is broken. What largest_stiffness() and largest_damping() give
/// is inside, but where a term of a bound overflows or is subnormal, and where it is 0: the other
/// gain may be beyond by itself, and only this function says so. No loop.
template <class Scalar>
GainVerdict check(const DeviceProfile<Scalar>& profile, const Gains<Scalar>& gains);

/// The stiffness whose force over the whole travel is the actuator's limit, J/u^2. Not a bound of
/// stability: a stiffer coupling saturates before the rim and is no less passive for it.
/// @returns kOk | kInvalidArgument: the profile is not valid, or the answer is beyond Scalar
template <class Scalar>
Result<Scalar> unsaturated_stiffness(const DeviceProfile<Scalar>& profile);

}  // namespace batuta::haptics
