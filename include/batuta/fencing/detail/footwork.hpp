// SPDX-License-Identifier: MIT
#pragma once
// The feet of both fencers on the strip: the part of a duel that a scene without feet leaves out.

#include "batuta/fencing/duel_scene.hpp"

namespace batuta::fencing {

/// In a scene whose fencers have feet.
template <class Scalar>
struct Footwork {
  BothFeet<Scalar> feet;

  /// Back to where both began.
  void stand_feet() {
    for (Feet<Scalar>& each : feet) each.stand();  // Bound: 2
  }

  /// @param orders  by index_of(side), each in [-1, 1]
  template <class Settings>
  void walk(const Vec2<Scalar>& orders, const Settings& settings, Scalar dt) {
    const Strip<Scalar>& strip = settings.strip;
    const Scalar distance = settings.salle.distance;
    const Vec2<Scalar> ways(feet[0].way(), feet[1].way());
    const Scalar between = distance - ways.x() - ways.y() - strip.least_distance;
    const Scalar to_end = (strip.length - distance) / Scalar(2) - strip.end_room;
    const Vec2<Scalar> behind = ways + Vec2<Scalar>::Constant(to_end);
    const auto rooms = rooms_of(feet, settings.feet, between, behind);
    for (int i = 0; i < 2; ++i) {  // Bound: 2
      const auto side = static_cast<std::size_t>(i);
      feet[side].advance(settings.feet, orders[i], rooms[side], dt);
    }
  }
};
template <class SceneT>
using FootworkOf = batuta::detail::FeatureIf<SceneT::kFeet, Footwork<typename SceneT::Scalar>, 19>;

}  // namespace batuta::fencing
