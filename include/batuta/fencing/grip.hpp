// SPDX-License-Identifier: MIT
#pragma once
// A hand that holds a blade, loses it to a blow and catches it again [Kavan §5, eq. 32]. A
// controller (world/controller.hpp). Frames: W world, B the blade's body frame. Mathematics:
// src/fencing/grip.md.

#include "batuta/world/controller.hpp"

namespace batuta::fencing {

/// How the weight of the hand grows from the blow to the time of control, s in [0, 1].
enum class CatchWeight : std::uint8_t {
  kSmooth,  ///< s^2 (3 - 2 s): velocity is continuous, too
  kLinear,  ///< s, as [Kavan eq. 32] has it
};

/// No option of a grip is larger, in its unit.
template <class Scalar>
inline constexpr Scalar kLargestGrip = Scalar(1e9F);

/// How firmly a hand holds, and what beats it. Each is at most kLargestGrip.
template <class Scalar>
struct GripSettings {
  Scalar torque = Scalar(6);          ///< N m, > 0: with which the wrist turns a blade back
  Scalar force = Scalar(60);          ///< N, > 0: with which the arm keeps the hand in its place
  Scalar min_regain = Scalar(0.02F);  ///< s, > 0; shortest t_b - t_a after a blow
  Scalar max_regain = Scalar(0.4F);   ///< s, >= min_regain; longest
  /// s, > 0: time constant in which a blade that was pushed away returns; in no less than a step
  Scalar recover_time = Scalar(0.1F);
  Scalar largest_turn = Scalar(1.2F);  ///< rad, > 0: a wrist gives way no further
  /// m, > 0: a blow so near to the hand does not beat it, however hard: it falls on the forte.
  Scalar forte = Scalar(0.6F);
  /// N m s, > 0: a blow whose moment about the hand is no larger does not beat it
  Scalar composure = Scalar(0.3F);
  Scalar settle_torque =
      Scalar(1);                    ///< N m, > 0: a larger moment costs the hand its excess over it
  Scalar max_lost = Scalar(0.35F);  ///< s, > 0: longest time that a blow costs a hand
  CatchWeight weight = CatchWeight::kSmooth;  ///< of the hand, on the way back to it
};

/// @returns kOk | kInvalidArgument: an option is not positive or beyond kLargestGrip, max_regain <
/// min_regain, or the weight is none
template <class Scalar>
Status validate(const GripSettings<Scalar>& settings);

/// What a hand or a wrist has to take up: lengths and momenta, or angles and their moments.
template <class Scalar>
struct GripLoad {
  Scalar effort = 0;           ///< N or N m, > 0
  Scalar blow = 0;             ///< N s or N m s, >= 0
  Scalar lag = 0;              ///< from where the hand wants it, m or rad, >= 0
  Scalar inverse_inertia = 0;  ///< 1/kg or 1/(kg m^2), >= 0
};

/// t_b - t_a: the longer of blow / effort, in which that effort takes up the blow, and
/// sqrt(6 lag inertia / effort), in which it fetches the blade back; within [min_regain,
/// max_regain], s.
template <class Scalar>
Scalar regain_time(const GripSettings<Scalar>& settings, const GripLoad<Scalar>& load);

/// A blow as the hand feels it.
template <class Scalar>
struct HandBlow {
  Scalar reach = 0;   ///< from the hand to where the blades met, m, >= 0
  Scalar moment = 0;  ///< of the impulse about the hand, N m s, >= 0
};

/// For how long a blow costs a hand its line, s: nothing on the forte or up to the composure;
/// beyond that (moment - composure) / settle_torque, at most max_lost.
template <class Scalar>
Scalar lost_time(const GripSettings<Scalar>& settings, const HandBlow<Scalar>& blow);

/// How a hand has caught its weapon so far: 0 of it is in free flight, 1 is where the hand wants
/// it.
template <class Scalar>
struct Catch {
  Vec3<Scalar> hand_B = batuta::detail::zero<Scalar>();  ///< where the hand holds the weapon, B
  Scalar turn = 0;          ///< share of the hand in the orientation, 0 ... 1
  Scalar place = 0;         ///< share of the hand in the place of hand_B, 0 ... 1
  Scalar largest_turn = 0;  ///< rad: the flight turns no further
};

/// [Kavan eq. 32]: between the free flight P and the hand H, about the place where the hand holds
/// the weapon, in P as in H. Shares of 0: P; of 1: H, to the last bit. The turn is taken back along
/// the way on which the flight made it: it does not jump however far a blade turns.
/// @param flight  from t_a on; @param elapsed  t - t_a, s, >= 0
/// @param hand    pose of B as the hand wants it
template <class Scalar>
Pose<Scalar> caught(const Motion<Scalar>& flight, Scalar elapsed, const Pose<Scalar>& hand,
                    const Catch<Scalar>& state);

/// Who moves the blade.
enum class GripPhase : std::uint8_t {
  kHeld,       ///< the blade follows the hand
  kRegaining,  ///< between free flight and hand
  kBeaten,     ///< the hand has lost its line as well: it follows nothing but what draws it back
};

/// The controller. Where the world kept the blade from going where the plan wants it (separation,
/// holds), it follows the plan from where it is, and the difference fades with recover_time: it
/// never snaps back. A blade in flight that was kept from moving goes on with the share of its
/// velocity that it moved with, and the hand pulls anew. Allocates: never.
template <class Scalar>
class Grip {
 public:
  /// Sets what the hand can do; where it is, stays. @returns kOk | kInvalidArgument (nothing
  /// changed)
  Status configure(const GripSettings<Scalar>& settings);

  /// Where the hand holds the weapon, B. @pre finite
  void hold_at(const Vec3<Scalar>& hand_B) { hand_B_ = hand_B; }
  /// Puts the hand somewhere, still, and closes it.
  void place(const Pose<Scalar>& X_WB);

  /// Where the hand wants B at the end of the coming step. @pre pose finite; step > 0, s
  void command(const Pose<Scalar>& X_WB, Scalar step);

  /// Hand, or the way back to it [Kavan eq. 32], over [t, t + duration] of the step.
  /// @pre 0 <= t, 0 <= duration
  PlannedMotion<Scalar> plan(const Body<Scalar>& body, Scalar t, Scalar duration) const;
  /// A blow loosens the hold for regain_time(), and may cost the hand lost_time().
  void on_contact(const Body<Scalar>& body, const Feedback<Scalar>& feedback);
  /// The step of length dt is over; the body is where it is.
  void on_step_end(const Body<Scalar>& body, Scalar dt);

  /// Who moves the blade at present.
  GripPhase phase() const;
  /// t of [Kavan eq. 32] at the end of the last step: 0 free or beaten ... 1 held.
  Scalar control() const;
  /// Where the hand holds the weapon, B.
  const Vec3<Scalar>& hand_B() const { return hand_B_; }
  /// The hand at the end of the last commanded step.
  const Pose<Scalar>& hand() const { return target_; }

  /// Its state, for record/archive.hpp. What is read must have settings that configure() takes;
  /// else it has the default ones.
  template <class ArchiveT>
  void archive(ArchiveT& ar) {
    auto& [settings, hand_B, hand, target, step, flight, flown, pulled, turn, place, lost] = *this;
    ar(settings, hand_B, hand, target, step, flight, flown, pulled, turn, place, lost);
    if (!ar.reading() || validate(settings_) == Status::kOk) return;
    ar.require(false);
    settings_ = {};
  }

 private:
  bool is_held() const { return !(turn_regain_ > Scalar(0)); }
  Pose<Scalar> hand_at(Scalar t) const;
  Pose<Scalar> planned_at(Scalar t) const;
  Catch<Scalar> catch_at(Scalar t) const;
  void start_flight(const Motion<Scalar>& flight, Scalar time);
  void set_regain(const HandBlow<Scalar>& blow, Scalar impulse, const Body<Scalar>& body,
                  const Pose<Scalar>& hand);
  void go_on_from(const Body<Scalar>& body, Scalar share, Scalar dt);
  Scalar share_made(const Pose<Scalar>& X_WB, Scalar dt) const;

  GripSettings<Scalar> settings_;
  Vec3<Scalar> hand_B_ = batuta::detail::zero<Scalar>();
  Motion<Scalar> hand_;    ///< of the hand over the current step
  Pose<Scalar> target_;    ///< at its end
  Scalar step_ = 0;        ///< s; 0: nothing commanded
  Motion<Scalar> flight_;  ///< P, from t_a
  /// t_a on the clock of the current step, s: <= 0 after the step in which it happened
  Scalar flight_start_ = 0;
  /// On the same clock, s: from when the hand pulls, the end of the step in which it happened
  Scalar pull_start_ = 0;
  Scalar turn_regain_ = 0;   ///< t_b - t_p of the wrist, s; 0: the blade is held
  Scalar place_regain_ = 0;  ///< t_b - t_p of the arm, s
  Scalar lost_ = 0;          ///< from t_a until a beaten hand finds its line, s
};

}  // namespace batuta::fencing
