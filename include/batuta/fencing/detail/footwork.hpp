// SPDX-License-Identifier: MIT
#pragma once
// The feet of both fencers on the strip: the part of a duel that a scene without feet leaves out.

#include "batuta/fencing/bout.hpp"
#include "batuta/fencing/duel_scene.hpp"

namespace batuta::fencing {

namespace detail {

/// Two who have no more than this left to come nearer stand body to body, m.
template <class Scalar>
inline constexpr Scalar kBodyToBody = Scalar(0.05F);

/// Steps body to body after which there is a halt; 0: never. @pre valid
template <class Settings>
std::uint32_t corps_a_corps_steps(const Settings& settings) {
  return whole_steps(settings.strip.corps_a_corps_us, settings.step_us);
}

}  // namespace detail

/// In a scene whose fencers have feet.
template <class Scalar>
struct Footwork {
  BothFeet<Scalar> feet;
  std::uint32_t close_steps = 0;  ///< for how long both have stood body to body

  /// Back to where both began.
  void stand_feet() {
    for (Feet<Scalar>& each : feet) each.stand();  // Bound: 2
    close_steps = 0;
  }

  /// Counts a step. @returns whether both have stood body to body for as long as Strip says
  template <class Settings>
  bool count_body_to_body(const Settings& settings) {
    const std::uint32_t most = detail::corps_a_corps_steps(settings);
    const bool close = room_between(settings) <= detail::kBodyToBody<Scalar>;
    close_steps = close ? min_of(close_steps + 1, most) : 0;
    return most > 0 && close_steps == most;
  }

  /// What was read is a state that steps can go on from. @pre valid settings
  template <class Settings>
  bool is_footing_sound(const Settings& settings) const {
    return feet[0].is_within(settings.feet) && feet[1].is_within(settings.feet) &&
           close_steps <= detail::corps_a_corps_steps(settings);
  }

  /// @param orders  by index_of(side), each in [-1, 1]
  template <class Settings>
  void walk(const Vec2<Scalar>& orders, const Settings& settings, Scalar dt) {
    const Strip<Scalar>& strip = settings.strip;
    const Scalar to_end = (strip.length - settings.salle.distance) / Scalar(2) - strip.end_room;
    const Vec2<Scalar> behind = ways() + Vec2<Scalar>::Constant(to_end);
    const auto rooms = rooms_of(feet, settings.feet, room_between(settings), behind);
    for (int i = 0; i < 2; ++i) {  // Bound: 2
      const auto side = static_cast<std::size_t>(i);
      feet[side].advance(settings.feet, orders[i], rooms[side], dt);
    }
  }

 private:
  Vec2<Scalar> ways() const { return {feet[0].way(), feet[1].way()}; }

  /// How much nearer they may come to each other, m.
  template <class Settings>
  Scalar room_between(const Settings& settings) const {
    return settings.salle.distance - ways().x() - ways().y() - settings.strip.least_distance;
  }
};
template <class SceneT>
using FootworkOf = batuta::detail::FeatureIf<SceneT::kFeet, Footwork<typename SceneT::Scalar>, 19>;

}  // namespace batuta::fencing
