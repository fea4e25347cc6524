// SPDX-License-Identifier: MIT
#pragma once
// What a scene costs in RAM, and the most that a step of it can take: constants, for a
// static_assert beside the scene. Flash, stack and instructions are measured in linked images
// (tests/measure/price).

#include "batuta/world/world.hpp"

namespace batuta {

/// What a scene costs, in bytes and in the most that a step can take.
struct SceneCost {
  std::size_t world = 0;     ///< bytes of World<Scene>, all that the scene needs
  std::size_t body = 0;      ///< of these, for one more body: actor, planned motion, boxes
  std::size_t pair = 0;      ///< for one more of max_pairs
  std::size_t event = 0;     ///< for one more of max_events
  std::uint64_t rounds = 0;  ///< most rounds of a step
  /// Most distance evaluations of a step.
  std::uint64_t evaluations = 0;
};

namespace detail {

/// The scene with one more body, pair or event.
template <class SceneT, int kBodies, int kPairs, int kEvents>
struct Enlarged : SceneT {
  /// The scene's, and kBodies more.
  static constexpr int kMaxBodies = SceneT::kMaxBodies + kBodies;
  /// The scene's, and kPairs more.
  static constexpr int kMaxPairs = SceneT::kMaxPairs + kPairs;
  /// The scene's, and kEvents more, if it keeps any.
  static constexpr int kMaxEvents = SceneT::kMaxEvents > 0 ? SceneT::kMaxEvents + kEvents : 0;
};

template <class SceneT, int kBodies, int kPairs, int kEvents>
struct SceneVerdict<Enlarged<SceneT, kBodies, kPairs, kEvents>> : SceneVerdict<SceneT> {
  using Seen = Enlarged<SceneT, kBodies, kPairs, kEvents>;
};

/// Bytes that the enlarged scene takes more, in a world of the same kind.
template <class SceneT, class Larger>
constexpr std::size_t more() {
  if constexpr (SceneT::kEngine == Engine::kSmall) {
    return sizeof(SmallWorld<Larger>) - sizeof(SmallWorld<SceneT>);
  } else {
    return sizeof(GeneralWorld<Larger>) - sizeof(GeneralWorld<SceneT>);
  }
}

/// The world of an enlarged scene, less that of the scene, a body over 32 bodies at a time: what a
/// world keeps per 16 or 32 bodies is shared out.
template <class SceneT>
constexpr SceneCost cost_of() {
  constexpr int kMany = 32;
  using Now = World<SceneT>;
  SceneCost cost;
  cost.world = sizeof(Now);
  cost.body = more<SceneT, Enlarged<SceneT, kMany, 0, 0>>() / kMany;
  cost.pair = more<SceneT, Enlarged<SceneT, 0, kMany, 0>>() / kMany;
  cost.event = more<SceneT, Enlarged<SceneT, 0, 0, kMany>>() / kMany;
  cost.rounds = static_cast<std::uint64_t>(Now::kMaxRounds);
  cost.evaluations =
      cost.rounds * static_cast<std::uint64_t>(Now::kPairsPerRound) * SceneT::kBudget;
  return cost;
}

}  // namespace detail

/// `static_assert(scene_cost<MyScene>.world <= 4096, "...");`
template <class SceneT>
inline constexpr SceneCost scene_cost = detail::cost_of<SceneT>();

}  // namespace batuta
