// SPDX-License-Identifier: MIT
#pragma once
// A controller for scenes with several kinds of bodies: each has one of a few controllers.

#include <variant>

#include "batuta/world/detail/controller_check.hpp"

namespace batuta {

/// One of several controllers, chosen at run time.
/// Bound: one comparison for each type.
template <class Scalar, class First, class... Others>
class AnyController {
 public:
  /// The first type, as it is made without arguments.
  AnyController() = default;
  /// Becomes a copy of one of the types.
  template <class Controller>
  // cppcheck-suppress noExplicitConstructor ; deviation: any-controller
  AnyController(const Controller& controller) : controller_(controller) {}

  /// The controller if it is a `Controller` at present, else null.
  template <class Controller>
  Controller* as() {
    return std::get_if<Controller>(&controller_);
  }

  /// The plan of the controller that it is at present. @pre 0 <= t, 0 <= duration
  PlannedMotion<Scalar> plan(const Body<Scalar>& body, Scalar t, Scalar duration) const {
    return plan_of<First, Others...>(body, t, duration);
  }
  /// Tells the controller that it is at present.
  void on_contact(const Body<Scalar>& body, const Feedback<Scalar>& feedback) {
    for_current([&](auto& controller) { controller.on_contact(body, feedback); });
  }
  /// Tells the controller that it is at present.
  void on_step_end(const Body<Scalar>& body, Scalar dt) {
    for_current([&](auto& controller) { controller.on_step_end(body, dt); });
  }

  /// Which controller it is, and that controller's state, for record/archive.hpp.
  /// Bound: one comparison for each type.
  template <class ArchiveT>
  void archive(ArchiveT& ar) {
    constexpr int kOthers = sizeof...(Others);
    const int kind = ar.count(static_cast<int>(controller_.index()), kOthers);
    if (ar.shaping()) return shape_of<First, Others...>(ar);
    if (ar.reading()) become<First, Others...>(kind);
    for_current([&ar](auto& controller) { ar(controller); });
  }

 private:
  template <class... Controllers, class ArchiveT>
  static void shape_of(ArchiveT& ar) {
    const auto shape = [&ar](auto controller) { ar(controller); };
    (shape(Controllers{}), ...);
  }
  template <class... Controllers>
  void become(int kind) {
    int place = 0;
    ((place++ == kind ? void(controller_ = Controllers{}) : void()), ...);
  }

  template <class Controller, class... Rest>
  PlannedMotion<Scalar> plan_of(const Body<Scalar>& body, Scalar t, Scalar duration) const {
    if (const Controller* controller = std::get_if<Controller>(&controller_))
      return controller->plan(body, t, duration);
    if constexpr (sizeof...(Rest) > 0) {
      return plan_of<Rest...>(body, t, duration);
    } else {
      return {still(body.X_WB, duration), false};
    }
  }

  // std::visit would link the exception of a valueless variant; controllers are plain data and
  // never leave one.
  template <class Call>
  void for_current(const Call& call) {
    call_if<First>(call);
    (call_if<Others>(call), ...);
  }
  template <class Controller, class Call>
  void call_if(const Call& call) {
    if (Controller* controller = std::get_if<Controller>(&controller_)) call(*controller);
  }

  static_assert(std::is_trivially_destructible_v<First> &&
                    (std::is_trivially_destructible_v<Others> && ...),
                "AnyController: a controller must be plain data");
  std::variant<First, Others...> controller_;
};

/// One of several, where all of them do.
template <class Scalar, class First, class... Others>
struct MovesByMomentumOnly<AnyController<Scalar, First, Others...>>
    : std::conjunction<MovesByMomentumOnly<First>, MovesByMomentumOnly<Others>...> {};

namespace detail {

/// It lacks what the first of its controllers lacks.
template <class ControllerScalar, class... Controllers, class Scalar>
struct ControllerCheck<AnyController<ControllerScalar, Controllers...>, Scalar> {
  static constexpr ControllerFault fault() {
    ControllerFault first = std::is_same_v<ControllerScalar, Scalar> ? ControllerFault::kNone
                                                                     : ControllerFault::kScalar;
    ((first =
          first == ControllerFault::kNone ? ControllerCheck<Controllers, Scalar>::fault() : first),
     ...);
    return first;
  }
};

}  // namespace detail

}  // namespace batuta
