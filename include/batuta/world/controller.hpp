// SPDX-License-Identifier: MIT
#pragma once
// Controllers: the paper's black box [Kavan §2.1]. A controller says where its body goes during the
// rest of a step, and is told what a contact did to it. A scene names one type, its Controller,
// with the members of FreeFlight below; a scene with several kinds names AnyController<...>
// (any_controller.hpp). No virtual calls: the compiler sees the whole step. A body that nothing can
// push (is_fixed()) is asked once a step: contacts do not change its course.

#include "batuta/mechanics/motion.hpp"

namespace batuta {

/// Where a body goes, as its controller plans it.
template <class Scalar>
struct PlannedMotion {
  Motion<Scalar> motion;     ///< of the geometry, over the rest of the step
  bool by_momentum = false;  ///< true: the body's momentum says how fast its matter moves (free
                             ///< flight); false: motion.twist does, whatever momentum the body had
};

/// What a controller is told after a contact; the body's pose and momentum are already the new
/// ones.
template <class Scalar>
struct Feedback {
  Scalar time = 0;                                ///< in the step, s
  Scalar impulse = 0;                             ///< j, N s; 0 after a pure separation
  Vec3<Scalar> shift_W = detail::zero<Scalar>();  ///< by separation, m
  /// J that the body was given at point_W, N s; its part along the normal is `impulse` long.
  Vec3<Scalar> impulse_W = detail::zero<Scalar>();
  Vec3<Scalar> point_W = detail::zero<Scalar>();  ///< where the bodies met, m
};

/// A body that nobody moves.
template <class Scalar>
struct Fixed {
  /// Over [t, t + duration] of the step it stays where it is. @pre 0 <= t, 0 <= duration
  PlannedMotion<Scalar> plan(const Body<Scalar>& body, Scalar t, Scalar duration) const;
  /// Nothing to do.
  void on_contact(const Body<Scalar>& body, const Feedback<Scalar>& feedback);
  /// Nothing to do.
  void on_step_end(const Body<Scalar>& body, Scalar dt);
};

/// A body that flies by its momenta.
template <class Scalar>
struct FreeFlight {
  /// Free flight over [t, t + duration] of the step. @pre 0 <= t, 0 <= duration
  PlannedMotion<Scalar> plan(const Body<Scalar>& body, Scalar t, Scalar duration) const;
  /// The contact has changed the momenta; there is nothing else to do.
  void on_contact(const Body<Scalar>& body, const Feedback<Scalar>& feedback);
  /// Nothing to do.
  void on_step_end(const Body<Scalar>& body, Scalar dt);
};

/// A plan towards a place is aimed at least this share of a step ahead: a body that was pushed
/// aside late in the step comes late rather than fast, and its velocity is a difference over a time
/// in which rounding does not show.
template <class Scalar>
inline constexpr Scalar kLeastHorizon = Scalar(0.125);

/// A body that a hand carries to `target_W` by the end of the step, whatever it weighs. A blow
/// takes it out of the hand for the rest of the step; in the next one the hand fetches it, at
/// whatever speed that takes. A hand of limited strength is Grip (fencing/grip.hpp).
template <class Scalar>
struct Hand {
  Pose<Scalar> target_W;  ///< of the body's frame at the end of the coming step
  Scalar step = 0;        ///< length of that step, s, > 0
  bool struck = false;    ///< a blow came in this step

  /// Straight to the target, to be there at the end of the step, or at the pace of kLeastHorizon of
  /// a step where less is left; free flight where a blow came in the step.
  /// @pre 0 <= t, 0 <= duration
  PlannedMotion<Scalar> plan(const Body<Scalar>& body, Scalar t, Scalar duration) const;
  /// A blow takes a body that can be moved out of the hand for the rest of the step.
  void on_contact(const Body<Scalar>& body, const Feedback<Scalar>& feedback);
  /// The hand takes the body back.
  void on_step_end(const Body<Scalar>& body, Scalar dt);
};

/// Whether a controller moves nothing but by its momentum: what has no mass to be pushed by then
/// stands still, and no two such bodies are ever led into each other.
template <class Controller>
struct MovesByMomentumOnly : std::false_type {};
/// Free flight is by momentum.
template <class Scalar>
struct MovesByMomentumOnly<FreeFlight<Scalar>> : std::true_type {};
/// What is fixed does not move.
template <class Scalar>
struct MovesByMomentumOnly<Fixed<Scalar>> : std::true_type {};

}  // namespace batuta
