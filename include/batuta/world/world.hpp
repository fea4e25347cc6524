// SPDX-License-Identifier: MIT
#pragma once
// The world of a scene.

// First, so that few lines lie between the file that includes this one and what is said of a scene.
#include "batuta/world/detail/scene_check.hpp"

#include "batuta/world/detail/general_world.hpp"
#include "batuta/world/detail/small_world.hpp"

namespace batuta {

namespace detail {

template <class SceneT, WorldKind kKind>
struct WorldOf {
  using Type = detail::GeneralWorld<SceneT>;
};
template <class SceneT>
struct WorldOf<SceneT, WorldKind::kSmall> {
  using Type = detail::SmallWorld<SceneT>;
};
template <class SceneT>
struct WorldOf<SceneT, WorldKind::kRefused> {
  using Type = RefusedWorld<SceneT>;
};

}  // namespace detail

/// The world that the scene names (SceneOptions::engine). The members of both are the same but for
/// events(), and described in general_world.hpp.
template <class SceneT>
class World : public detail::WorldOf<SceneT, detail::SceneVerdict<SceneT>::kKind>::Type {
  using Base = typename detail::WorldOf<SceneT, detail::SceneVerdict<SceneT>::kKind>::Type;
  static_assert(!detail::kIsForDuel<SceneT>,
                "World: a DuelScene is for a Duel; a World takes a Scene<my_options>");

 public:
  World() = default;
  /// @param number  tells this world's ids from those of another world of the same scene
  explicit World(std::uint16_t number) : Base(number) {}
};

}  // namespace batuta
