// SPDX-License-Identifier: MIT
#pragma once
// One axis of a stick with a hand on it, for tests and examples: a mass with viscous and Coulomb
// friction that a held force and a hand move. Exact between the events of stick and slip; double.
// Units as in haptics/gain_advisor.hpp. Mathematics: port/shared/simulated/simulated.md.

#include <limits>

#include "batuta/core/status.hpp"
#include "batuta/core/types.hpp"

namespace batuta::port_simulated {

/// M q'' = force - b q' - f_c sgn q' + k_h (hand - q) + b_h (hand' - q'),  M = mass + hand_mass.
struct AxisSettings {
  double period = 1e-3;       ///< T, s, > 0: a force is held that long
  double mass = 0.05;         ///< of the mechanism, J s^2/u^2, > 0
  double damping = 0;         ///< b, J s/u^2, >= 0
  double friction = 0;        ///< f_c, J/u, >= 0
  double hand_mass = 0;       ///< J s^2/u^2, >= 0: of what holds the stick, moving with it
  double hand_stiffness = 0;  ///< k_h, J/u^2, >= 0: by which the hand follows its will
  double hand_damping = 0;    ///< b_h, J s/u^2, >= 0
  /// u, > 0: a stop at either side that takes all speed, met at the end of a substep.
  double travel = std::numeric_limits<double>::infinity();
};

/// The least part of a period that is looked at for stick and slip: 1 / kMostSubsteps.
inline constexpr int kMostSubsteps = 64;

/// @returns kOk | kInvalidArgument: out of range, not finite, or with friction so stiff that
/// kMostSubsteps do not resolve it: sqrt(k_h / M) T > kMostSubsteps / 4; or, even without, stiffer
/// than kStiffestSpan of transition.hpp over a period
Status validate(const AxisSettings& settings);

/// What happens within a span, linear in the state at its beginning and in the force.
using Transition = Eigen::Matrix<double, 2, 4>;

class SimulatedAxis {
 public:
  /// Also places it at 0, still, the hand with it.
  /// @returns kOk | kInvalidArgument (nothing changed)
  Status configure(const AxisSettings& settings);

  /// Puts stick and hand somewhere. @pre finite
  void place(double position, double velocity, double hand);

  /// One period under a held force, while the hand's will goes evenly to `hand_end`.
  /// @param force  J/u  @param hand_end  u  @pre finite
  /// Bound: kMostSubsteps, with kMostEvents each.
  void advance(double force, double hand_end);

  double position() const { return position_; }  ///< u
  double velocity() const { return velocity_; }  ///< u/s
  double hand() const { return hand_; }          ///< where the hand wants the stick, u
  /// Kinetic, and of the hand's spring, J.
  double energy() const;
  /// What Coulomb friction has taken, J.
  double rubbed() const { return rubbed_; }
  const AxisSettings& settings() const { return settings_; }

 private:
  /// What pushes over a span, without the hold of the hand's spring on the stick.
  struct Push {
    double start = 0;   ///< J/u
    double growth = 0;  ///< J/u/s
    double length = 0;  ///< s
  };

  double mass() const { return settings_.mass + settings_.hand_mass; }
  void pass(const Push& push);
  double stay(const Push& push, double from) const;
  double slide(const Push& push, double from);
  Eigen::Vector2d after(const Eigen::Vector4d& state, double span) const;
  void stop();

  AxisSettings settings_;
  int substeps_ = 1;
  Transition whole_ = Transition::Zero();  ///< of a substep
  double position_ = 0;
  double velocity_ = 0;
  double hand_ = 0;
  double rubbed_ = 0;
};

}  // namespace batuta::port_simulated
