// SPDX-License-Identifier: MIT
#pragma once
// The members of a world's state, for record/archive.hpp.

#include "batuta/record/detail/response.hpp"
#include "batuta/world/world.hpp"

namespace batuta {

namespace detail {

/// Stands for the value of any base or member.
struct Nothing {
  template <class T>
  operator T() const;  // never called
};

template <class T, class Void, class... Items>
struct CanTake : std::false_type {};
template <class T, class... Items>
struct CanTake<T, std::void_t<decltype(T{Items{}...})>, Items...> : std::true_type {};

/// Whether an aggregate has at least as many bases and members as there are items.
template <class T, class... Items>
constexpr bool takes() {
  return CanTake<T, void, Items...>::value;
}

}  // namespace detail

constexpr EventKind last_of(EventKind) {
  return EventKind::kEnd;
}

template <class Scalar>
void archive(Archive& ar, Fixed<Scalar>& /*controller*/) {
  ar.constant(1);  // which FreeFlight has not
}

template <class Scalar>
void archive(Archive& /*ar*/, FreeFlight<Scalar>& /*controller*/) {}

template <class Scalar>
void archive(Archive& ar, Hand<Scalar>& hand) {
  auto& [target_W, step, struck] = hand;
  ar(target_W, step, struck);
}

template <class Scalar>
void archive(Archive& ar, StraightBody<Scalar>& body) {
  auto& [p_W, momentum_W, inverse_mass] = body;
  ar(p_W, momentum_W, inverse_mass);
}

inline void archive(Archive& ar, detail::ProxyPair& pair);
/// Where it was, and how hard it pressed.
template <class Traits>
void archive(Archive& ar, detail::ContactPoint<Traits>& point) {
  ar(point.normal_W, point.normal);
  if constexpr (Traits::kFriction) ar(point.along, point.across);
  if constexpr (Traits::kRolling) ar(point.rolling_W);
  if constexpr (Traits::kLine) ar(point.place);
}
template <class Traits>
void archive(Archive& ar, detail::LastingContact<Traits>& contact) {
  ar(contact.pair, contact.count, contact.is_solved, contact.is_told, contact.rest_gap);
  if constexpr (Traits::kFriction) ar(contact.friction);
  if constexpr (Traits::kRolling) ar(contact.rolling);
  for (auto& point : contact.points) ar(point);  // Bound: 2
}

inline void archive(Archive& ar, detail::ProxyPair& pair) {
  auto& [first, second] = pair;
  ar(first, second);
}

template <class Scalar>
void archive(Archive& ar, ContactEvent<Scalar>& event) {
  auto& [kind, contact_kind, body_A, body_B, part_A, part_B, time, contact, v_rel, impulse, place_A,
         place_B] = event;
  ar(kind, contact_kind, body_A, body_B, part_A, part_B, time, contact, v_rel, impulse, place_A,
     place_B);
}

template <class Scalar>
void archive(Archive& ar, StepReport<Scalar>& report) {
  auto& [evaluations, pairs, collisions, separations, blocked, overlaps_at_start, deepest_overlap,
         asleep, frozen, pairs_dropped, contacts_dropped, searches_cut, searches_invalid,
         resolutions_invalid, plans_invalid, events_dropped, contacts_untracked, time_held] =
      report;
  ar(evaluations, pairs, collisions, separations, blocked, overlaps_at_start, deepest_overlap,
     asleep, frozen, pairs_dropped, contacts_dropped, searches_cut, searches_invalid,
     resolutions_invalid, plans_invalid, events_dropped, contacts_untracked, time_held);
}

// Features of a scene: what is left out takes no bytes.
template <int kNumber>
void archive(Archive& ar, detail::Absent<kNumber>& /*feature*/) {
  ar.constant(0);
}
template <class Scalar>
void archive(Archive& ar, detail::BallShape<Scalar>& shape) {
  auto& [radius] = shape;
  ar(radius);
}
template <class Scalar>
void archive(Archive& ar, detail::CapsuleShape<Scalar>& shape) {
  auto& [capsule_B] = shape;
  ar(capsule_B);
}
template <class Scalar, int N>
void archive(Archive& ar, detail::CapsulesShape<Scalar, N>& shape) {
  auto& [capsules_B] = shape;
  ar(capsules_B);
}
template <class Controller>
void archive(Archive& ar, detail::Controlled<Controller>& controlled) {
  auto& [controller] = controlled;
  ar(controller);
}
template <class Scalar>
void archive(Archive& ar, detail::Bouncy<Scalar>& bouncy) {
  auto& [restitution] = bouncy;
  ar(restitution);
}
template <class Scalar>
void archive(Archive& ar, detail::Rough<Scalar>& rough) {
  auto& [friction] = rough;
  ar(friction);
}
template <class Scalar>
void archive(Archive& ar, detail::Rolling<Scalar>& rolling) {
  auto& [rolling_resistance] = rolling;
  ar(rolling_resistance);
}
inline void archive(Archive& ar, detail::Owned& owned) {
  auto& [owner] = owned;
  ar(owner);
}
inline void archive(Archive& ar, Filter& filter) {
  auto& [groups, meets] = filter;
  ar(groups, meets);
}
inline void archive(Archive& ar, detail::Filtered& filtered) {
  auto& [filter] = filtered;
  ar(filter);
}
template <class Scalar>
void archive(Archive& ar, detail::RestSettings<Scalar>& settings) {
  auto& [rest_speed, separation, min_separation_time] = settings;
  ar(rest_speed, separation, min_separation_time);
}
template <class Scalar>
void archive(Archive& ar, detail::GravitySettings<Scalar>& settings) {
  auto& [gravity_W] = settings;
  ar(gravity_W);
}

template <class SceneT>
void archive(Archive& ar, Actor<SceneT>& actor) {
  using Scalar = typename SceneT::Scalar;
  using A = Actor<SceneT>;
  using detail::Nothing;
  static_assert(
      detail::takes<A, Nothing, Nothing, Nothing, Nothing, Nothing, Nothing, Nothing, Nothing>() &&
          !detail::takes<A, Nothing, Nothing, Nothing, Nothing, Nothing, Nothing, Nothing, Nothing,
                         Nothing>(),
      "archive: Actor has other bases or members than those listed below");
  ar(static_cast<detail::ShapeOf<SceneT>&>(actor));
  ar(static_cast<
      detail::FeatureIf<SceneT::kRotation, detail::Controlled<typename SceneT::Controller>, 0>&>(
      actor));
  ar(static_cast<detail::FeatureIf<SceneT::kRestitution, detail::Bouncy<Scalar>, 1>&>(actor));
  ar(static_cast<detail::FeatureIf<SceneT::kFriction, detail::Rough<Scalar>, 2>&>(actor));
  ar(static_cast<detail::FeatureIf<SceneT::kRollingResistance, detail::Rolling<Scalar>, 5>&>(
      actor));
  ar(static_cast<detail::FeatureIf<SceneT::kOwners, detail::Owned, 3>&>(actor));
  ar(static_cast<detail::FeatureIf<SceneT::kFilters, detail::Filtered, 4>&>(actor));
  ar(actor.body);
}

template <class SceneT>
void archive(Archive& ar, WorldSettings<SceneT>& settings) {
  using Scalar = typename SceneT::Scalar;
  using detail::Nothing;
  static_assert(detail::takes<WorldSettings<SceneT>, Nothing, Nothing, Nothing>() &&
                    !detail::takes<WorldSettings<SceneT>, Nothing, Nothing, Nothing, Nothing>(),
                "archive: WorldSettings has other bases or members than those listed below");
  ar(static_cast<detail::FeatureIf<detail::kKnowsRest<SceneT>, detail::RestSettings<Scalar>, 0>&>(
      settings));
  ar(static_cast<detail::FeatureIf<SceneT::kGravity, detail::GravitySettings<Scalar>, 1>&>(
      settings));
  if constexpr (SceneT::Search::kForSpheres) {
    auto& [contact_tolerance] = settings.search;
    ar(contact_tolerance);
  } else {
    ar(settings.search);
  }
  if (!ar.reading() || validate(settings) == Status::kOk) return;
  ar.require(false);
  settings = {};  // a World relies on them
}

}  // namespace batuta
