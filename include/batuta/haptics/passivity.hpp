// SPDX-License-Identifier: MIT
#pragma once
// Books the energy that the force on the stick hands out, exactly, and takes back by damping what
// was handed out unpaid [Hannaford & Ryu 2002]. Both axes have one book: a coupling through the key
// poses moves energy from one axis to the other without making any.
// Units as in gain_advisor.hpp. Mathematics: src/haptics/passivity.md.

#include "batuta/core/status.hpp"
#include "batuta/core/types.hpp"

namespace batuta::haptics {

/// What the book has to know of the device, and how much it lets pass.
template <class Scalar>
struct PassivitySettings {
  Scalar period = 0;          ///< T, s, > 0
  Scalar device_damping = 0;  ///< b, J s/u^2, >= 0: what the mechanism takes for sure, on each axis
  Scalar encoder_step = 0;    ///< Delta, u, >= 0
  /// J, >= 0: what was paid in beyond what the coupling stores counts up to this; more would let it
  /// pay for trouble much later. To a user who does not tell what is stored, the most that ever is.
  Scalar most_credit = 0;
  /// J, > 0: what may stay handed out unpaid before the controller says that it cannot.
  Scalar most_debt = 0;
  /// J s/u^2, >= 0: of the damper that the controller adds; passive by itself up to b, which is
  /// largest_damping() of gain_advisor.hpp at no stiffness.
  Scalar largest_damping = 0;
  Scalar largest_force = 0;  ///< J/u, > 0: of the two axes together
};

/// @returns kOk | kInvalidArgument: a number is not finite or out of range
template <class Scalar>
Status validate(const PassivitySettings<Scalar>& settings);

/// What is owed of the energy that was handed out.
enum class Passivity : std::uint8_t {
  kPassive,      ///< nothing is owed
  kDissipating,  ///< something is owed, and is being taken back
  kCannot,       ///< more than most_debt was owed: the rest is written off, the stick got it
};

/// The book. Allocates: never.
template <class Scalar>
class PassivityObserver {
 public:
  /// Also empties the book. @returns kOk | kInvalidArgument (nothing changed)
  Status configure(const PassivitySettings<Scalar>& settings);

  /// The stick is at another place without having gone there: nothing is booked for the way, and
  /// what is stored there is granted. The first observe() after configure() does the same.
  /// @param stored  as of observe()
  /// @returns kOk | kInvalidArgument: not finite, or stored < 0 (nothing changed)
  Status restart(const Vec2<Scalar>& position, Scalar stored = 0);

  /// Books work that the simulated world did on the coupling and that the hand may have: what an
  /// opponent's blow pays is not made up.
  /// @param work  J, >= 0
  /// @returns kOk | kInvalidArgument (nothing changed)
  Status supply(Scalar work);

  /// Books one period. The work of a held force is held . (position - position before), exactly,
  /// whatever the stick did in between. No loop bound: two axes.
  /// @param held      the force that was held over the period that ends now, J/u; as the actuator
  ///                  had it: clipped, delayed, damped
  /// @param position  u
  /// @param stored    J, >= 0: what the coupling's springs hold at that position. 0 where it is not
  ///                  known: trouble then shows only once they have let go, which is late
  /// @returns kOk | kInvalidArgument: not finite, or stored < 0 (nothing changed) | kUnavailable:
  /// not configured
  Status observe(const Vec2<Scalar>& held, const Vec2<Scalar>& position, Scalar stored = 0);

  /// What may still be handed out beyond what is stored, J, in [-most_debt, most_credit]; negative:
  /// what is owed.
  Scalar credit() const { return credit_; }
  /// Of the last period. kCannot: the debt was cut to most_debt.
  Passivity state() const { return state_; }
  /// Periods that ended in kCannot since configure(); stays at the largest number.
  std::uint32_t cannot_count() const { return cannot_count_; }
  /// position - position before, of the last period, u
  const Vec2<Scalar>& moved() const { return moved_; }
  /// What configure() was given.
  const PassivitySettings<Scalar>& settings() const { return settings_; }

 private:
  void book(Scalar credit);

  PassivitySettings<Scalar> settings_;
  Vec2<Scalar> position_ = Vec2<Scalar>::Zero();
  Vec2<Scalar> moved_ = Vec2<Scalar>::Zero();
  Scalar credit_ = 0;
  Scalar stored_ = 0;
  std::uint32_t cannot_count_ = 0;
  Passivity state_ = Passivity::kPassive;
  bool is_placed_ = false;  ///< it is known where the stick was a period ago
};

/// The damping that takes back what is owed within the next period if the stick goes on as it goes,
/// but no more than largest_damping; 0 where nothing is owed. Nothing is divided by a motion that
/// is too small for its debt: such a debt waits. J s/u^2.
template <class Scalar>
Scalar owed_damping(const PassivityObserver<Scalar>& observer);

/// What may be held.
template <class Scalar>
struct PassiveForce {
  Vec2<Scalar> force = Vec2<Scalar>::Zero();  ///< J/u
  Scalar excess = 0;  ///< by how much the sum was beyond largest_force, in these; 0: it fits
};

/// The demanded force with owed_damping() against the last motion, cut to largest_force with its
/// direction kept. To be told to the observer as held once it was.
/// @returns kOk | kInvalidArgument, with a force of zero: not finite, or the length of the sum is
/// beyond Scalar
template <class Scalar>
Result<PassiveForce<Scalar>> passive_force(const PassivityObserver<Scalar>& observer,
                                           const Vec2<Scalar>& demanded);

}  // namespace batuta::haptics
