// SPDX-License-Identifier: MIT
#pragma once
// A body in a world, as the caller describes it. Each feature of the scene is a base; one that the
// scene leaves out is an empty base, which takes no room.

#include "batuta/core/fixed_list.hpp"
#include "batuta/mechanics/straight.hpp"
#include "batuta/world/world_settings.hpp"

namespace batuta {

/// Who may meet whom: two bodies meet where each is in a group that the other one meets.
struct Filter {
  std::uint16_t groups = 1;      ///< a bit for each group that the body is in
  std::uint16_t meets = 0xFFFF;  ///< a bit for each group that it meets
};

namespace detail {

/// The shape of an actor whose scene has spheres alone.
template <class Scalar>
struct BallShape {
  Scalar radius = 0;  ///< m, >= 0; about the body's own point
};
/// The shape of an actor of one capsule.
template <class Scalar>
struct CapsuleShape {
  /// In the body's frame B; where nothing turns, in axes of W, about the body's own point.
  Capsule<Scalar> capsule_B;
};
/// The shape of an actor of several capsules.
template <class Scalar, int N>
struct CapsulesShape {
  /// Its parts, at least one; they never meet each other
  FixedList<Capsule<Scalar>, N> capsules_B;
};
/// Of an actor whose body turns.
template <class Controller>
struct Controlled {
  Controller controller{};  ///< who moves it
};
/// Of an actor in a scene with restitution.
template <class Scalar>
struct Bouncy {
  Scalar restitution = 0;  ///< C, in [0, 1]; a pair takes pair_restitution() of its two
};
/// Of an actor in a scene with friction.
template <class Scalar>
struct Rough {
  Scalar friction = 0;  ///< mu, >= 0; a pair takes pair_friction() of its two
};
/// Of an actor in a scene with rolling resistance.
template <class Scalar>
struct Rolling {
  /// The lever of the load that resists turning, m, >= 0; a pair takes pair_rolling() of its two
  Scalar rolling_resistance = 0;
};
/// Of an actor in a scene with owners.
struct Owned {
  std::uint16_t owner = 0;  ///< bodies of one owner other than 0 never meet
};
/// Of an actor in a scene with filters.
struct Filtered {
  Filter filter;  ///< who it may meet
};

/// The shape that a scene gives its actors.
template <class SceneT>
using ShapeOf = std::conditional_t<
    SceneT::Search::kForSpheres, BallShape<typename SceneT::Scalar>,
    std::conditional_t<SceneT::kCapsulesPerBody == 1, CapsuleShape<typename SceneT::Scalar>,
                       CapsulesShape<typename SceneT::Scalar, SceneT::kCapsulesPerBody>>>;
/// The body that a scene gives its actors.
template <class SceneT>
using BodyOf = std::conditional_t<SceneT::kRotation, Body<typename SceneT::Scalar>,
                                  StraightBody<typename SceneT::Scalar>>;
/// A feature's members where the scene has it, else nothing.
template <bool kIsOn, class Feature, int kNumber>
using FeatureIf = std::conditional_t<kIsOn, Feature, Absent<kNumber>>;

}  // namespace detail

/// A body of a scene with all that the scene's features ask of it; World::add() takes it.
/// The caller may read or change it between steps. Call World::get() again after each step: what is
/// changed through a pointer that was kept is not noticed. What becomes unusable (not finite, or
/// too far away to hold its size) is left out of the steps, and counted in
/// StepReport::plans_invalid. An orientation whose length is off 1 by more than rounding is renewed
/// at the start of a step; by more than a thousandth, it is none.
template <class SceneT>
struct Actor
    : detail::ShapeOf<typename detail::SceneVerdict<SceneT>::Seen>,
      detail::FeatureIf<detail::SceneFor<SceneT>::kRotation,
                        detail::Controlled<typename detail::SceneFor<SceneT>::Controller>, 0>,
      detail::FeatureIf<detail::SceneFor<SceneT>::kRestitution,
                        detail::Bouncy<detail::ScalarFor<SceneT>>, 1>,
      detail::FeatureIf<detail::SceneFor<SceneT>::kFriction,
                        detail::Rough<detail::ScalarFor<SceneT>>, 2>,
      detail::FeatureIf<detail::SceneFor<SceneT>::kRollingResistance,
                        detail::Rolling<detail::ScalarFor<SceneT>>, 5>,
      detail::FeatureIf<detail::SceneFor<SceneT>::kOwners, detail::Owned, 3>,
      detail::FeatureIf<detail::SceneFor<SceneT>::kFilters, detail::Filtered, 4> {
  /// The scene's.
  using Scalar = detail::ScalarFor<SceneT>;

  /// Mass, place and momenta: Body, or StraightBody where the scene has no rotation.
  detail::BodyOf<detail::SceneFor<SceneT>> body;
};

/// The parts of an actor: one, unless the scene says otherwise.
template <class SceneT>
int parts_of(const Actor<SceneT>& actor) {
  if constexpr (SceneT::kCapsulesPerBody == 1) {
    return 1;
  } else {
    return actor.capsules_B.size();
  }
}

/// A capsule of an actor. @pre 0 <= part < parts_of(actor)
template <class SceneT>
const Capsule<typename SceneT::Scalar>& part_of(const Actor<SceneT>& actor, int part) {
  if constexpr (SceneT::kCapsulesPerBody == 1) {
    return actor.capsule_B;
  } else {
    return actor.capsules_B[part];
  }
}

/// Restitution of a pair from those of its bodies: the bouncier one decides, as a scene may.
template <class Scalar>
constexpr Scalar pair_restitution(Scalar a, Scalar b) {
  return max_of(a, b);
}

/// Friction of a pair: the smoother one decides; oil on one of two is oil between them.
template <class Scalar>
constexpr Scalar pair_friction(Scalar a, Scalar b) {
  return min_of(a, b);
}

/// Rolling resistance of a pair: the softer one decides.
template <class Scalar>
constexpr Scalar pair_rolling(Scalar a, Scalar b) {
  return max_of(a, b);
}

/// Where an actor's own point is, m.
template <class SceneT>
const Vec3<typename SceneT::Scalar>& position_of(const Actor<SceneT>& actor) {
  if constexpr (SceneT::kRotation) {
    return actor.body.X_WB.p_W;
  } else {
    return actor.body.p_W;
  }
}

namespace detail {

/// Whether what the features add to an actor is in range, and its parts where they are. Bound: the
/// parts.
template <class SceneT>
bool has_valid_features(const Actor<SceneT>& actor) {
  using Scalar = typename SceneT::Scalar;
  bool good = true;
  if constexpr (SceneT::kRestitution) {
    good = good && actor.restitution >= Scalar(0) && actor.restitution <= Scalar(1);
  }
  if constexpr (SceneT::kFriction) {
    good = good && is_finite(actor.friction) && actor.friction >= Scalar(0);
  }
  if constexpr (SceneT::kRollingResistance) {
    good = good && is_finite(actor.rolling_resistance) && actor.rolling_resistance >= Scalar(0);
  }
  if constexpr (SceneT::Search::kForSpheres) {
    good = good && is_finite(actor.radius) && actor.radius >= Scalar(0) &&
           can_hold(position_of(actor), actor.radius);
  } else {
    good = good && parts_of(actor) > 0;
    for (int i = 0; i < parts_of(actor); ++i) {  // Bound: kCapsulesPerBody
      const auto& part = part_of(actor, i);
      good = good && is_valid(part) && can_hold(position_of(actor), part);
    }
  }
  return good;
}

/// Whether owners and filters let two actors meet.
template <class SceneT>
bool may_meet(const Actor<SceneT>& A, const Actor<SceneT>& B) {
  bool may = true;
  if constexpr (SceneT::kOwners) may = A.owner == 0 || A.owner != B.owner;
  if constexpr (SceneT::kFilters) {
    may = may && (A.filter.groups & B.filter.meets) != 0 && (B.filter.groups & A.filter.meets) != 0;
  }
  return may;
}

}  // namespace detail

}  // namespace batuta
