// SPDX-License-Identifier: MIT
#pragma once
// The world of a scene.

#include "batuta/world/detail/general_world.hpp"
#include "batuta/world/detail/lean_world.hpp"

namespace batuta {

/// The engine that runs a scene.
template <class SceneT>
using WorldOf = std::conditional_t<detail::kIsLean<SceneT>, detail::LeanWorld<SceneT>,
                                   detail::GeneralWorld<SceneT>>;

/// A LeanWorld where the scene is so small that all pairs can be searched in every round, else a
/// GeneralWorld. Their members are the same, and described in general_world.hpp.
template <class SceneT>
class World : public WorldOf<SceneT> {
 public:
  using WorldOf<SceneT>::WorldOf;
};

}  // namespace batuta
