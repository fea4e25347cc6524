// SPDX-License-Identifier: MIT
#pragma once
// What a type lacks to be the controller of a scene.

#include "batuta/world/controller.hpp"

namespace batuta::detail {

enum class ControllerFault : std::uint8_t { kNone, kScalar, kPlan, kContact, kStepEnd };

template <class ControllerT, class Scalar, class = void>
inline constexpr bool kHasPlan = false;
template <class ControllerT, class Scalar>
inline constexpr bool kHasPlan<
    ControllerT, Scalar,
    std::enable_if_t<std::is_same_v<
        PlannedMotion<Scalar>, decltype(std::declval<const ControllerT&>().plan(
                                   std::declval<const Body<Scalar>&>(), Scalar(), Scalar()))>>> =
    true;

template <class ControllerT, class Scalar, class = void>
inline constexpr bool kHasContact = false;
template <class ControllerT, class Scalar>
inline constexpr bool kHasContact<
    ControllerT, Scalar,
    std::void_t<decltype(std::declval<ControllerT&>().on_contact(
        std::declval<const Body<Scalar>&>(), std::declval<const Feedback<Scalar>&>()))>> = true;

template <class ControllerT, class Scalar, class = void>
inline constexpr bool kHasStepEnd = false;
template <class ControllerT, class Scalar>
inline constexpr bool kHasStepEnd<ControllerT, Scalar,
                                  std::void_t<decltype(std::declval<ControllerT&>().on_step_end(
                                      std::declval<const Body<Scalar>&>(), Scalar()))>> = true;

/// A specialization looks into a controller that is made of controllers.
template <class ControllerT, class Scalar>
struct ControllerCheck {
  using OtherScalar = std::conditional_t<std::is_same_v<Scalar, float>, double, float>;

  static constexpr ControllerFault fault() {
    if constexpr (!kHasPlan<ControllerT, Scalar>) {
      return kHasPlan<ControllerT, OtherScalar> ? ControllerFault::kScalar : ControllerFault::kPlan;
    } else if constexpr (!kHasContact<ControllerT, Scalar>) {
      return ControllerFault::kContact;
    } else {
      return kHasStepEnd<ControllerT, Scalar> ? ControllerFault::kNone : ControllerFault::kStepEnd;
    }
  }
};

}  // namespace batuta::detail
