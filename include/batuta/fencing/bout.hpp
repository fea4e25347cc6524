// SPDX-License-Identifier: MIT
#pragma once
// What a bout comes to: touches, and sums over its steps. Frame W (salle), SI units. Time is a
// count of steps and a time within the step, so that it is as fine after an hour as at the start.

#include "batuta/core/fixed_list.hpp"
#include "batuta/fencing/fencer.hpp"
#include "batuta/port/clock.hpp"
#include "batuta/response/contact.hpp"

namespace batuta::fencing {

/// An instant of a bout.
template <class Scalar>
struct Moment {
  std::uint32_t step = 0;  ///< steps that were over
  Scalar in_step = 0;      ///< s
};

/// us since the start of the bout: exact to the step, the rest rounded.
/// @pre moment of a bout with such steps: 0 <= in_step, at most a step
template <class Scalar>
std::uint64_t time_us(const Moment<Scalar>& moment, std::int32_t step_us) {
  // 32 bits are plenty for a step; to 64, a target without double converts by way of double.
  const auto in_step =
      static_cast<std::uint32_t>(moment.in_step / kSecondsPerUs<Scalar> + Scalar(0.5F));
  return std::uint64_t{moment.step} * static_cast<std::uint64_t>(step_us) + in_step;
}

namespace detail {

/// A time in whole steps, of which the last one may end a little later. @pre 0 <= us; 0 < step_us;
/// their sum is in range
constexpr std::uint32_t whole_steps(std::int32_t us, std::int32_t step_us) {
  return static_cast<std::uint32_t>((us + step_us - 1) / step_us);
}

}  // namespace detail

/// How far a bout is. An exchange begins on guard and ends with a touch, with two, or without one
/// where bodies stand against each other (Strip::corps_a_corps_us); then there is a halt, and the
/// next exchange, until a fencer has as many touches as the bout goes to.
enum class BoutState : std::uint8_t {
  kFencing,  ///< nobody is touched in this exchange yet
  kLockout,  ///< somebody is touched; the other may still touch within the window
  kTouched,  ///< over: the last exchange brought one touch
  kDouble,   ///< over: it brought two within the window
  kHalt,     ///< an exchange is over: nobody scores until both are on guard again
};

/// Most touches that a bout can go to.
inline constexpr int kMostTouches = 99;

/// A touch of a blade on the other fencer's body.
template <class Scalar>
struct Touch {
  Side by = Side::kLeft;              ///< whose blade
  BodyPart part = BodyPart::kPelvis;  ///< where on the other
  /// the instant at which blade and body are still apart: TouchSearch::t_free
  Moment<Scalar> when;
  Contact<Scalar> contact;  ///< the normal points out of the one who is touched
  Scalar place = 0;         ///< on the blade: 0 guard ... 1 tip
  /// False: a search ended without an answer at an earlier time; it may not be the first. In a step
  /// in which a blade was held, `when` is known to within StepReport::time_held, for the hold is
  /// spread over the blade's way between two corners.
  bool certain = true;
};

/// A bout as it stands.
template <class Scalar>
struct Bout {
  BoutState state = BoutState::kFencing;  ///< how far it is
  /// The touches of this exchange do not count: two at once, where one was missing to either fencer
  bool annulled = false;
  /// Touches that count, of the exchanges that are over, by index_of(side)
  std::array<std::uint8_t, 2> score{};
  /// Of this exchange, in the order of time; they stay until both are on guard again
  FixedList<Touch<Scalar>, 2> touches;
  std::uint32_t exchange = 1;    ///< the number of this one
  std::uint32_t halt_steps = 0;  ///< steps of the halt that are still to come

  /// Whether the bout is decided.
  bool is_over() const { return state == BoutState::kTouched || state == BoutState::kDouble; }
  /// Whether the next step puts both on guard again.
  bool is_halt_over() const { return state == BoutState::kHalt && halt_steps == 0; }
  /// Whether there is a halt because the fencers stood body to body.
  bool is_corps_a_corps() const { return state == BoutState::kHalt && touches.size() == 0; }
};

/// The bout of a scene without targets: nobody can be touched, it never ends.
struct OpenBout {
  /// It goes on for ever.
  static constexpr BoutState state = BoutState::kFencing;
  /// Never.
  static constexpr bool is_over() { return false; }
};

/// Sums over the bout. The lower half is zero in a healthy bout.
struct DuelReport {
  std::uint32_t blows = 0;        ///< colliding contacts of the blades
  std::uint32_t rests = 0;        ///< resting contacts: blades leaning on each other
  std::uint64_t evaluations = 0;  ///< distance evaluations of all searches
  /// Body parts that the hierarchy could not rule out; 0 in a scene without targets.
  std::uint32_t touch_searches = 0;
  std::uint32_t incomplete_steps = 0;  ///< the world's report was not complete(): blades were held
  std::uint32_t budget_outs = 0;       ///< searches that ran out of their budget, blade or touch
  std::uint32_t searches_invalid = 0;  ///< searches that could not be asked, blade or touch
};

}  // namespace batuta::fencing
