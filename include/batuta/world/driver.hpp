// SPDX-License-Identifier: MIT
#pragma once
// Drivers: the paper's black box [Kavan §2.1]. A driver says where its body goes during the rest of
// a step, and is told what a contact did to it. A scene names one type, Scene::Driver, with the
// members of FreeFlight below; a scene with several kinds names AnyDriver<...>. No virtual calls:
// the compiler sees the whole step.

#include <variant>

#include "batuta/mechanics/motion.hpp"

namespace batuta {

/// What a driver answers.
template <class Scalar>
struct Course {
  Motion<Scalar> motion;     ///< of the geometry, over the rest of the step
  bool by_momentum = false;  ///< true: the body's momentum says how fast its matter moves (free
                             ///< flight); false: motion.twist does, whatever momentum the body had
};

/// What a driver is told after a contact; the body's pose and momentum are already the new ones.
template <class Scalar>
struct Feedback {
  Scalar time = 0;                              ///< in the step, s
  Scalar impulse = 0;                           ///< j, N s; 0 after a pure separation
  Vec3<Scalar> shift_W = Vec3<Scalar>::Zero();  ///< by separation, m
};

/// A body that nobody moves.
template <class Scalar>
struct Fixed {
  /// The course over [t, t + duration] of the step. @pre 0 <= t, 0 <= duration
  Course<Scalar> course(const Body<Scalar>& body, Scalar t, Scalar duration) const;
  /// Tells what a contact did.
  void on_contact(const Body<Scalar>& body, const Feedback<Scalar>& feedback);
  /// The step of length dt is over; the body is where it is.
  void on_step_end(const Body<Scalar>& body, Scalar dt);
};

/// A body that flies by its momenta.
template <class Scalar>
struct FreeFlight {
  Course<Scalar> course(const Body<Scalar>& body, Scalar t, Scalar duration) const;
  void on_contact(const Body<Scalar>& body, const Feedback<Scalar>& feedback);
  void on_step_end(const Body<Scalar>& body, Scalar dt);
};

/// A course towards a place is aimed at least this share of a step ahead: a body that was pushed
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

  Course<Scalar> course(const Body<Scalar>& body, Scalar t, Scalar duration) const;
  void on_contact(const Body<Scalar>& body, const Feedback<Scalar>& feedback);
  void on_step_end(const Body<Scalar>& body, Scalar dt);
};

/// One of several drivers, chosen at run time.
/// Bound: one comparison for each type.
template <class Scalar, class First, class... Others>
class AnyDriver {
 public:
  AnyDriver() = default;
  template <class Driver>
  // cppcheck-suppress noExplicitConstructor ; deviation: any-driver
  AnyDriver(const Driver& driver) : driver_(driver) {}

  /// The driver if it is a `Driver` at present, else null.
  template <class Driver>
  Driver* as() {
    return std::get_if<Driver>(&driver_);
  }

  Course<Scalar> course(const Body<Scalar>& body, Scalar t, Scalar duration) const {
    return course_of<First, Others...>(body, t, duration);
  }
  void on_contact(const Body<Scalar>& body, const Feedback<Scalar>& feedback) {
    for_current([&](auto& driver) { driver.on_contact(body, feedback); });
  }
  void on_step_end(const Body<Scalar>& body, Scalar dt) {
    for_current([&](auto& driver) { driver.on_step_end(body, dt); });
  }

  /// Which driver it is, and that driver's state, for core/archive.hpp.
  /// Bound: one comparison for each type.
  template <class ArchiveT>
  void archive(ArchiveT& ar) {
    constexpr int kOthers = sizeof...(Others);
    const int kind = ar.count(static_cast<int>(driver_.index()), kOthers);
    if (ar.shaping()) return shape_of<First, Others...>(ar);
    if (ar.reading()) become<First, Others...>(kind);
    for_current([&ar](auto& driver) { ar(driver); });
  }

 private:
  template <class... Drivers, class ArchiveT>
  static void shape_of(ArchiveT& ar) {
    const auto shape = [&ar](auto driver) { ar(driver); };
    (shape(Drivers{}), ...);
  }
  template <class... Drivers>
  void become(int kind) {
    int place = 0;
    ((place++ == kind ? void(driver_ = Drivers{}) : void()), ...);
  }

  template <class Driver, class... Rest>
  Course<Scalar> course_of(const Body<Scalar>& body, Scalar t, Scalar duration) const {
    if (const Driver* driver = std::get_if<Driver>(&driver_))
      return driver->course(body, t, duration);
    if constexpr (sizeof...(Rest) > 0) {
      return course_of<Rest...>(body, t, duration);
    } else {
      return {still(body.X_WB, duration), false};
    }
  }

  // std::visit would link the exception of a valueless variant; drivers are plain data and never
  // leave one.
  template <class Call>
  void for_current(const Call& call) {
    call_if<First>(call);
    (call_if<Others>(call), ...);
  }
  template <class Driver, class Call>
  void call_if(const Call& call) {
    if (Driver* driver = std::get_if<Driver>(&driver_)) call(*driver);
  }

  static_assert(std::is_trivially_destructible_v<First> &&
                    (std::is_trivially_destructible_v<Others> && ...),
                "AnyDriver: a driver must be plain data");
  std::variant<First, Others...> driver_;
};

/// Whether a driver moves nothing but by its momentum: what has no mass to be pushed by then stands
/// still, and no two such bodies are ever led into each other.
template <class Driver>
struct MovesByMomentumOnly : std::false_type {};
template <class Scalar>
struct MovesByMomentumOnly<FreeFlight<Scalar>> : std::true_type {};
template <class Scalar>
struct MovesByMomentumOnly<Fixed<Scalar>> : std::true_type {};
template <class Scalar, class First, class... Others>
struct MovesByMomentumOnly<AnyDriver<Scalar, First, Others...>>
    : std::conjunction<MovesByMomentumOnly<First>, MovesByMomentumOnly<Others>...> {};

}  // namespace batuta
